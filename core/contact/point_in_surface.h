// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a point lies within a closed surface: rays from it leave once more often than they enter.
#pragma once

#include <span>

#include "core/contact/surface_patches.h"

namespace hepatica {

// Of some of a surface's patches, which are closed together; `boxes` has one for each patch of the
// surface. The majority of three rays decides, so that one that grazes an edge does no harm.
bool lies_within(const Vec3& point, const SurfacePatches& surface, std::span<const int> patches,
                 std::span<const Box> boxes, std::span<const Vec3> positions_mm);

std::vector<Box> boxes_of_patches(const SurfacePatches& surface,
                                  std::span<const Vec3> positions_mm);

}  // namespace hepatica
