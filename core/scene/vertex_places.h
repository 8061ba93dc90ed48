// SPDX-License-Identifier: GPL-3.0-or-later
// The place on the vessel tree that each vertex of a body or surface belongs to.
#pragma once

#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

struct VertexPlace {
    TreePoint on_tree;       // nearest centreline point
    double radius_mm = 0.0;  // of the lumen there
};

// One per vertex. Throws InputError if the tree is empty. O(vertices), in parallel; the same for
// any number of threads.
std::vector<VertexPlace> places_of(const std::vector<Vec3>& vertices_mm, const VesselTree& tree);

}  // namespace hepatica
