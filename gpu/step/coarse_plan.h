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

// What blocks of threads that know nothing of each other do in stages: those of row r and stage s
// are the cuts from begin[r * (stages + 1) + s] to the next.
struct CutStages {
    int stages = 0;
    std::vector<int> begin;

    int rows() const { return stages > 0 ? static_cast<int>(begin.size()) / (stages + 1) : 0; }
};

// A block and the cut that it couples another one with.
struct CutTerm {
    int block = 0, cut = 0;
};

// Cuts are numbered as a solve goes through them: by tier, row and stage. Blocks of the factor lie
// column by column, the diagonal one first.
struct CoarsePlan {
    std::vector<int> slot_of_node;  // two slots a cut; the second may be empty
    std::vector<int> level_begin;   // places in by_level
    std::vector<int> by_level;      // cuts, those first that hear of no other
    std::vector<int> column_begin;  // blocks of each cut
    std::vector<int> row;           // the row's cut of each block
    // Blocks beside the diagonal in the row of each cut, with their columns.
    std::vector<int> row_begin;
    std::vector<CutTerm> in_row;
    // What elimination takes from block (i, p): the products of (i, k) and (p, k), for every k.
    std::vector<int> update_begin;
    std::vector<std::array<int, 2>> update;
    // Small subtrees first, then those of what stands above them; one row at last.
    std::vector<CutStages> tiers;

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
