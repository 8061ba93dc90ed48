// SPDX-License-Identifier: GPL-3.0-or-later
// Hepatic veins that are bent until they touch portal ones, as they do in patients at the limit of
// a CT's resolution: across each other, or side by side.
#pragma once

#include <cstdint>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Bends hepatic segments, one place each, so that their lumens overlap those of portal segments;
// nodes, roots and radii stay, and so does the tree: no two systems share a node. As many crossings
// as side contacts where the tree has both. The axes come to within the larger radius and 0.4 to
// 0.9 of the smaller one of each other. What is bent keeps clear of every other vessel.
// Returns where lumens touch now: fewer than `count` places where no more fit. Cost: segments
// squared times points squared, once.
std::vector<Vec3> bend_to_touch(VesselTree& tree, int count, std::uint64_t seed);

}  // namespace hepatica
