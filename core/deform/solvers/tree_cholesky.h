// SPDX-License-Identifier: GPL-3.0-or-later
// Multifrontal sparse Cholesky factorisation (Duff and Reid 1983). It keeps the update matrix that
// each front passes to its parent, so that after a change only the changed fronts and those between
// them and the root are eliminated again.
#pragma once

#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/deform/solvers/block_matrix.h"
#include "core/deform/solvers/elimination_tree.h"

namespace hepatica {

// Forces on a few vertices; zero on all others.
struct SparseLoad {
    std::vector<int> vertices;
    std::vector<Vec3> forces;  // one for each of `vertices`
};

// Gives the same bits for any number of threads. Not thread-safe. With T = float it serves as a
// preconditioner: it reads half the memory and stays positive definite in spite of rounding.
template <class T>
class TreeFactor {
  public:
    // Fixes the pattern and the order (a permutation of the vertices, see elimination_order.h).
    TreeFactor(const BlockMatrix& pattern, std::span<const int> order)
        : TreeFactor(pattern, analyse(pattern, order)) {}
    // The same with an existing analysis of that pattern.
    TreeFactor(const BlockMatrix& pattern, EliminationTree tree) { plan(pattern, std::move(tree)); }
    // Switches to another pattern and reuses the memory; factor() must be called next.
    void plan(const BlockMatrix& pattern, EliminationTree tree);

    // Factors a matrix with the planned pattern. In double, a pivot not above 1e-14 of its diagonal
    // entry is dropped: solves give zero for it. In float, a pivot not above 1e-6 of its diagonal
    // entry is raised to that entry. Throws Cancelled after a stop is requested; factor() must then
    // be called again.
    void factor(const BlockMatrix& matrix, const std::stop_token& stop = {});

    // The same for a matrix that differs from the last one only in blocks between two
    // `changed_vertices`; the factor equals that of factor() to the last bit.
    void refactor(const BlockMatrix& matrix, std::span<const int> changed_vertices,
                  const std::stop_token& stop = {});

    // Number of pivots dropped or raised in the present factor.
    int dropped_pivots() const;

    // x = A^-1 b. b and x may be the same.
    void solve(std::span<const Vec3> b, std::span<Vec3> x);

    // b . A^-1 b for half the work of a solve: the squared energy norm of an error with residual b.
    double inverse_form(std::span<const Vec3> b);

    // J A^-1 J^T with one row of J for each load: entry (i, j) is the displacement of the nodes of
    // load i along its forces under load j. Only fronts between the loaded vertices and the root
    // are visited.
    Eigen::MatrixXd inverse_block(std::span<const SparseLoad> loads) const;

    const EliminationTree& tree() const { return tree_; }
    // Supernodes eliminated by the last factor or refactor.
    int eliminated() const { return eliminated_; }
    std::size_t bytes() const;

  private:
    void lay_out_fronts();
    void factor_supernode(const BlockMatrix& matrix, int s, const std::stop_token& stop);
    void forward(std::span<const Vec3> b);
    void pass_up(const Supernode& child, const T* passed, T* parent_side) const;

    EliminationTree tree_;
    std::vector<std::size_t> panel_begin_, remainder_begin_;
    std::vector<T> panels_, remainders_;
    std::vector<int> block_row_;  // row of each block of A in its front; -1: above the diagonal
    std::vector<int> dropped_;    // per supernode
    // Right-hand side of each front: of its columns, then what it passes to its parent.
    std::vector<std::size_t> side_begin_;
    std::vector<T> sides_;
    std::vector<char> dirty_;
    int eliminated_ = 0;
};

using TreeCholesky = TreeFactor<double>;
using TreePreconditioner = TreeFactor<float>;

}  // namespace hepatica
