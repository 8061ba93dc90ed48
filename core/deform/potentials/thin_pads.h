// SPDX-License-Identifier: GPL-3.0-or-later
// Pads of faces that a tear lays bare within a tool's pad. At the tool's full thickness they would
// store energy that nothing has done work for. Each of them begins as thin as its gap, where it
// stores none, and grows with the gap, which costs none, until it is as thick as the tool's.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/contact/surface_patches.h"
#include "core/deform/potentials/tool.h"

namespace hepatica {

// The pad of the triangle with these corners, in any order [mm].
double pad_of_triangle_mm(const Tool& tool, const std::array<int, 3>& corners);

// The triangles of the surface in the tool's pad, each with its own pad; ascending by corners.
std::vector<ThinPad> pads_before_split(const Tool& tool, const SurfacePatches& surface,
                                       std::span<const Vec3> positions_mm);

// The thin pads after a split, from the pads before it. `node_before` is the former node of each
// vertex; no position has changed. A triangle that was on the surface keeps its pad; one that was
// not gets the thickest in which it stores nothing.
std::vector<ThinPad> thin_pads_after_split(std::span<const ThinPad> before, const Tool& tool,
                                           const SurfacePatches& surface,
                                           std::span<const int> node_before,
                                           std::span<const Vec3> positions_mm);

// Lets thin pads grow to the gaps at these positions; removes those that are as thick as the
// tool's. Costs nothing where there are none.
void grow_thin_pads(Tool& tool, const SurfacePatches& surface, std::span<const Vec3> positions_mm);

}  // namespace hepatica
