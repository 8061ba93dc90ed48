// SPDX-License-Identifier: GPL-3.0-or-later
// Nested dissection of a vessel tree's nodes (George 1973): they are halved recursively by
// separators, the nodes coupled with the other half. The tree suggests where to split; the matrix
// decides what is coupled, because nodes that are not neighbours in the tree share elements where
// branches meet, touch or are thin.
#pragma once

#include <array>
#include <vector>

#include "core/deform/solvers/coarse_skeleton.h"

namespace hepatica::gpu {

// For each node, the nodes it is coupled with; symmetric. A node may name itself.
using Couplings = std::vector<std::vector<int>>;

// Each node once, in cuts of two in the order of elimination: the top-level separators come last.
// The second node of a cut is -1 where no other was left.
std::vector<std::array<int, 2>> bisecting_cuts(const CoarseSkeleton& skeleton,
                                               const Couplings& coupled);

}  // namespace hepatica::gpu
