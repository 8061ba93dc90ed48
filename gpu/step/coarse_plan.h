// SPDX-License-Identifier: GPL-3.0-or-later
// How the coarse matrix P^T A P is factored and solved on a device: nested dissection of the vessel
// tree. A cut takes two neighbouring nodes and halves what is left; cuts of one level know nothing
// of each other, and a chain of n nodes has about log2 n levels, not n. The factor is N D N^T in
// blocks of two nodes: D inverted, N with ones on its diagonal.
#pragma once

#include <array>
#include <vector>

#include "core/deform/solvers/block_matrix.h"
#include "core/deform/solvers/coarse_skeleton.h"

namespace hepatica::gpu {

// What one block of threads does in sequence: stage s has the cuts
// cut[begin[row * (stages + 1) + s] ...], row by row a block of threads.
struct CutStages {
    int stages = 0;
    std::vector<int> begin, cut;

    int rows() const { return stages > 0 ? static_cast<int>(begin.size()) / (stages + 1) : 0; }
};

// Cuts are numbered by level. Blocks of the factor lie column by column, the diagonal one first.
struct CoarsePlan {
    std::vector<int> slot_of_node;  // two slots a cut; the second may be empty
    std::vector<int> level_begin;   // cuts
    std::vector<int> column_begin;  // blocks of each cut
    std::vector<int> row, column;   // the cuts of each block
    // Blocks beside the diagonal in the row of each cut.
    std::vector<int> row_begin, in_row;
    // What elimination takes from block (i, p): the products of (i, k) and (p, k), for every k.
    std::vector<int> update_begin;
    std::vector<std::array<int, 2>> update;
    CutStages below, top;  // independent subtrees, and what stands above them all

    int cuts() const { return static_cast<int>(column_begin.size()) - 1; }
    int slots() const { return 2 * cuts(); }
    int blocks() const { return static_cast<int>(row.size()); }
    int levels() const { return static_cast<int>(level_begin.size()) - 1; }
    // -1 where there is none; row >= column.
    int find(int row_cut, int column_cut) const;
};

// `coarse` has the pattern of P^T A P, four vectors a node.
CoarsePlan plan_coarse(const CoarseSkeleton& skeleton, const BlockMatrix& coarse);

}  // namespace hepatica::gpu
