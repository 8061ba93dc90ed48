// SPDX-License-Identifier: GPL-3.0-or-later
// Nested dissection of a vessel tree's nodes (George 1973): they are parted in halves, again and
// again, by those that are coupled with the other half. The tree says where to part; what is
// coupled is the matrix's affair: nodes that are no neighbours in the tree share elements where
// branches meet, touch or are thin.
#pragma once

#include <array>
#include <vector>

#include "core/deform/solvers/coarse_skeleton.h"

namespace hepatica::gpu {

// Of each node the others that it is coupled with; both hear of it. A node may name itself.
using Couplings = std::vector<std::vector<int>>;

// Every node once, in cuts of two and in the order of elimination: those that divide most come
// last. The second node of a cut is -1 where there is no other to take.
std::vector<std::array<int, 2>> bisecting_cuts(const CoarseSkeleton& skeleton,
                                               const Couplings& coupled);

}  // namespace hepatica::gpu
