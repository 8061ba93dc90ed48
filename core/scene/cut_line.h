// SPDX-License-Identifier: GPL-3.0-or-later
// Where a line drawn on a vessel lets it tear, and what a blade drawn across it cuts: joints of a
// body by their places on the tree.
#pragma once

#include <span>
#include <vector>

#include "core/scene/vertex_places.h"
#include "core/tear/torn_topology.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// The joints on the way along the tree between two places, by the places of the tetrahedra, one
// each. Where the way is shorter than `section_mm`, those of the one section across the vessel in
// its middle: between tetrahedra before and behind it. Empty where no way leads from one to the
// other.
std::vector<int> joints_along(const VesselTree& tree, std::span<const Joint> joints,
                              std::span<const VertexPlace> tetrahedra, const TreePoint& from,
                              const TreePoint& to, double section_mm);

// What a blade passes on a straight way.
struct BladeSweep {
    Vec3 corner_mm = Vec3::Zero();
    Vec3 way_mm = Vec3::Zero();
    Vec3 edge_mm = Vec3::Zero();  // of the blade, from one end to the other
};

// The edge stands across the way and across `axis`, the vessel's direction there, and reaches
// `reach_mm` to both sides of the way.
BladeSweep blade_sweep(const Vec3& from_mm, const Vec3& to_mm, const Vec3& axis, double reach_mm);

}  // namespace hepatica
