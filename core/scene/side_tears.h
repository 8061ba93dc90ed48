// SPDX-License-Identifier: GPL-3.0-or-later
// Where the side of a vessel is open: joints have come apart from its surface to its lumen, but its
// pieces still hang together.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/scene/through_tears.h"

namespace hepatica {

struct SideTear {
    TreePoint at;  // the middle of the stretch that it lies in
    // 2 f A: both sides of what has parted, f as a share of the lumen's area A, at most 1.
    double most_mm2 = 0.0;
    // The gap between the sides of each edge on the surface: its four vertices, in turn.
    std::vector<std::array<int, 4>> gaps;
};

// Everything of a body that may bleed.
struct TornPlaces {
    std::vector<ThroughTear> through;
    std::vector<SideTear> sides;
};

// One per stretch of `stretch_mm` at most, ascending. Joints that have come apart at a common
// corner are one crack. It opens the side where a joint of it has come apart wholly, as for the
// body to count as torn, where it reaches the surface and, by a joint's centre, farther than
// through the wall, and where none of it lies within a stretch of a vessel that is torn through.
// What has parted is the area of its joints projected onto their mean plane, a third of a joint for
// each corner that has come apart. `tetrahedra` has the place of each tetrahedron.
std::vector<SideTear> side_tears(const VesselTree& tree, const Tearing& tearing,
                                 std::span<const VertexPlace> tetrahedra, double stretch_mm,
                                 std::span<const ThroughTear> through);

// The area of the gaps at these positions of the vertices.
double gape_mm2(const SideTear& tear, std::span<const Vec3> positions_mm);

// The length of the crack on the surface at these positions.
double slit_length_mm(const SideTear& tear, std::span<const Vec3> positions_mm);

// min(2 f A, gape), but at least what blood holds open (slit_mm2() in core/flow/tube_law.h).
// Rounded to steps of a factor of 2^(1/4), so that a vessel that moves does not cause a new
// solution of its flow at every step; 0 below 0.01 mm2.
double opening_mm2(const SideTear& tear, std::span<const Vec3> positions_mm,
                   double held_open_mm2 = 0.0);

// The area that blood holds open of a slit of this length in the wall of a segment.
using HeldOpen = std::function<double(int segment, double length_mm)>;

// What is torn through, then the sides that are open at these positions.
std::vector<ThroughTear> open_tears(
    const TornPlaces& torn, std::span<const Vec3> positions_mm,
    const HeldOpen& held_open_mm2 = [](int, double) { return 0.0; });

}  // namespace hepatica
