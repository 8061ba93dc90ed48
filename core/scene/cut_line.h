// SPDX-License-Identifier: GPL-3.0-or-later
// Which joints of a body a cut line drawn on a vessel weakens, and what a blade drawn across it
// cuts, by positions on the tree.
#pragma once

#include <span>
#include <vector>

#include "core/scene/vertex_places.h"
#include "core/tear/torn_topology.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// The joints on the way along the tree between two places, given the place of every tetrahedron.
// Where the way is shorter than `section_mm`, the joints of the one cross section in its middle.
// Empty where the two places are not connected.
std::vector<int> joints_along(const VesselTree& tree, std::span<const Joint> joints,
                              std::span<const VertexPlace> tetrahedra, const TreePoint& from,
                              const TreePoint& to, double section_mm);

// The parallelogram that a blade sweeps on a straight way.
struct BladeSweep {
    Vec3 corner_mm = Vec3::Zero();
    Vec3 way_mm = Vec3::Zero();
    Vec3 edge_mm = Vec3::Zero();  // of the blade, from one end to the other
};

// The edge is perpendicular to the way and to `axis`, the direction of the vessel there, and
// extends `reach_mm` to both sides of the way.
BladeSweep blade_sweep(const Vec3& from_mm, const Vec3& to_mm, const Vec3& axis, double reach_mm);

}  // namespace hepatica
