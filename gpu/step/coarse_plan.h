// SPDX-License-Identifier: GPL-3.0-or-later
// Plan for the factorisation and solution of the coarse matrix P^T A P on a device by nested
// dissection of the vessel tree. A cut takes two neighbouring nodes and halves the rest; cuts of
// one level are independent, and a chain of n nodes has about log2 n levels, not n. The factor is N
// D N^T in blocks of two nodes: D is inverted, and N has a unit diagonal. N^-1 has a block for each
// cut and each of its ancestors, about log2 n per cut.
#pragma once

#include <vector>

#include "core/deform/solvers/block_matrix.h"
#include "core/deform/solvers/coarse_skeleton.h"
#include "gpu/kernels/cut_kernels.h"

namespace hepatica::gpu {

// See InverseListsView.
struct InversePlan {
    std::vector<int> level_begin, by_level;
    std::vector<int> column;
    std::vector<int> product_begin{0};
    std::vector<InverseListsView::Product> product;
    std::vector<int> chunk_begin{0}, first_chunk{0};
    std::vector<int> above_begin{0};
    std::vector<InverseListsView::Above> above;
};

// Cuts are numbered in the order of elimination. Blocks of the factor are stored column by column,
// the diagonal block first.
struct CoarsePlan {
    std::vector<int> slot_of_node;  // two slots per cut; the second may be empty
    std::vector<int> level_begin;   // first place of each level in by_level
    std::vector<int> by_level;      // cuts, leaves of the elimination tree first
    std::vector<int> column_begin;  // first block of each cut
    std::vector<int> row;           // cut of each block's row
    // Elimination subtracts from block (i, p) the products of blocks (i, k) and (p, k), for every
    // k.
    std::vector<int> update_begin;
    std::vector<CutListsView::Update> update;
    InversePlan inverse;

    int cuts() const { return static_cast<int>(column_begin.size()) - 1; }
    int slots() const { return 2 * cuts(); }
    int blocks() const { return static_cast<int>(row.size()); }
    int levels() const { return static_cast<int>(level_begin.size()) - 1; }
    int find(int row_cut, int column_cut) const;
};

// `coarse` has the pattern of P^T A P, with four vectors per node.
CoarsePlan plan_coarse(const CoarseSkeleton& skeleton, const BlockMatrix& coarse);

}  // namespace hepatica::gpu
