// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which the vertices of a body are eliminated.
#pragma once

#include <span>
#include <vector>

#include "core/deform/solvers/block_matrix.h"
#include "core/deform/solvers/coarse_skeleton.h"

namespace hepatica {

// Vertices in an order of little fill for any pattern: approximate minimum degree (Amestoy, Davis
// and Duff 1996). On vessel trees with loops a factorisation takes a third to a quarter of the
// multiplications that it takes from the ends inwards.
std::vector<int> fill_reducing_order(const BlockMatrix& pattern);

// That order of a body of which nodes were split: node i from parents[i], a smaller number, or from
// none where that is i. New nodes stand behind the one of `order` that they come from, which keeps
// the fill below that of the whole body.
std::vector<int> order_of_split(std::span<const int> order, std::span<const int> parents);

// The vertices of `binding` in the order of their skeleton nodes, from the ends of the tree towards
// the node that halves the body. On the graph of a tree this order gives no fill.
std::vector<int> order_from_ends(const CoarseSkeleton& skeleton, const SkeletonBinding& binding);

}  // namespace hepatica
