// SPDX-License-Identifier: GPL-3.0-or-later
// The solve of a coarse system as weighted sums in stages (see RunStages): a Cholesky factor whose
// nodes are eliminated from the tips of a bisected tree inward, four stages for each level. A chain
// of n nodes has about log2 n levels, not n.
#pragma once

#include <vector>

#include "core/deform/solvers/block_matrix.h"
#include "core/deform/solvers/coarse_skeleton.h"

namespace hepatica::gpu {

// Places in `value`: the load first, and from `solution` on the answer, both as the matrix has it.
struct CoarseProgram {
    std::vector<int> stage_begin{0};  // rows
    std::vector<int> target, begin{0};
    std::vector<int> source;
    std::vector<double> factor;
    int solution = 0;
    int values = 0;
};

// Nodes in the order of elimination: those that cut the forest in halves come last.
std::vector<int> bisecting_order(const CoarseSkeleton& skeleton);

// `coarse` is P^T A P, four vectors a node; `order` has its nodes. Rows without a positive diagonal
// entry (nodes that move no vertex) answer 0 to a load of 0. Where rounding has made the matrix
// indefinite its diagonal is raised until it is not: the program is for preconditioning.
CoarseProgram program_of(const BlockMatrix& coarse, const std::vector<int>& order);

}  // namespace hepatica::gpu
