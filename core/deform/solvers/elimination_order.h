// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which the vertices of a body are eliminated.
#pragma once

#include <span>
#include <vector>

#include "core/deform/solvers/block_matrix.h"
#include "core/deform/solvers/coarse_skeleton.h"

namespace hepatica {

// A fill-reducing order for any pattern: approximate minimum degree (Amestoy, Davis and Duff 1996).
// On vessel trees with loops a factorisation takes a third to a quarter of the multiplications that
// order_from_ends gives.
std::vector<int> fill_reducing_order(const BlockMatrix& pattern);

// Extends an order to a body whose nodes were split: node i comes from parents[i], a smaller
// number, or is an original node where parents[i] == i. New nodes follow the original node that
// they come from, which keeps the fill below that of the whole body.
std::vector<int> order_of_split(std::span<const int> order, std::span<const int> parents);

// The vertices of `binding` in the order of their skeleton nodes, from the ends of the tree towards
// the node that halves the body. On the graph of a tree this order gives no fill.
std::vector<int> order_from_ends(const CoarseSkeleton& skeleton, const SkeletonBinding& binding);

}  // namespace hepatica
