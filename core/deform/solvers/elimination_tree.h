// SPDX-License-Identifier: GPL-3.0-or-later
// Symbolic analysis of a sparse Cholesky factor: the supernodes (columns of equal structure that
// are eliminated as one dense front), their tree, and which of them may be eliminated in parallel.
#pragma once

#include <span>
#include <vector>

#include "core/deform/solvers/block_matrix.h"

namespace hepatica {

// Columns first .. first + count - 1 in the order of elimination, and the rows below them.
struct Supernode {
    int first = 0;
    int count = 0;
    int rows_begin = 0;  // into EliminationTree::rows, ascending
    int rows_end = 0;
    int parent = -1;         // supernode of the first row below; comes later in the order
    int children_begin = 0;  // into EliminationTree::children, ascending
    int children_end = 0;

    int rest() const { return rows_end - rows_begin; }
};

// Number of scalar multiplications that the elimination of a supernode takes.
double multiplications(const Supernode& supernode);

// All indices count vertices (3x3 blocks).
struct EliminationTree {
    std::vector<int> vertex_at;         // vertex eliminated at each position
    std::vector<int> position_of;       // its inverse
    std::vector<Supernode> supernodes;  // children before parents
    std::vector<int> supernode_of;      // of each position
    std::vector<int> rows;
    std::vector<int>
        place_in_parent;  // for each of `rows`: index among the parent's columns and rows
    std::vector<int> children;

    // Stages of the elimination, one after the other. The chains of a stage may run in parallel;
    // the supernodes of a chain are eliminated in sequence.
    struct Chain {
        int begin = 0;  // into chain_supernodes
        int end = 0;
    };
    std::vector<std::vector<Chain>> stages;
    std::vector<int> chain_supernodes;

    double multiplications = 0.0;   // scalar ones, of one factorisation
    std::size_t factor_blocks = 0;  // 3x3 blocks in L, including zeros of merged supernodes
};

// `order` is the desired order of elimination, a permutation of the vertices; the result may
// permute it where that does not change the fill. Time is proportional to the blocks of the factor,
// memory to the rows of its supernodes.
EliminationTree analyse(const BlockMatrix& pattern, std::span<const int> order);

// The analysis of a body whose nodes were split, from that of the whole body: node i comes from
// parents[i], a smaller number, or is an original node where parents[i] == i. Each new node stands
// next to the one that it comes from, among columns and rows alike: every block of the torn body
// has a place, and some places hold zeros. Time is proportional to the rows of the supernodes.
EliminationTree tree_of_split(const EliminationTree& whole, std::span<const int> parents);

}  // namespace hepatica
