// SPDX-License-Identifier: GPL-3.0-or-later
// Bends hepatic veins until they touch portal ones, across each other or side by side, as they
// appear to in patients at the limit of a CT's resolution.
#pragma once

#include <cstdint>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Bends hepatic segments, one place each, so that their lumens overlap those of portal segments.
// Nodes, roots, radii and the topology stay; no two systems share a node. Crossings and side
// contacts alternate where the tree has both. The distance of the axes becomes the larger radius
// plus 0.4 to 0.9 of the smaller one. A bent segment keeps clear of every other vessel. Returns the
// places of contact, fewer than `count` where no more fit. Costs segments squared times points
// squared.
std::vector<Vec3> bend_to_touch(VesselTree& tree, int count, std::uint64_t seed);

}  // namespace hepatica
