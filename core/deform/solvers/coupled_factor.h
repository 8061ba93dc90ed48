// SPDX-License-Identifier: GPL-3.0-or-later
// Solves (A + C) x = b by a Cholesky factor that knows C: of A and the blocks of C between pairs of
// nodes that were coupled when the pattern was analysed last. Ordering and analysis are kept while
// contacts come and go; blocks of pairs that are not in the pattern are left to conjugate
// gradients, whose iterations grow with their number alone, and not with that of all contacts.
// Once these iterations have cost as much as an analysis, the next solve makes one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/deform/solvers/cholesky_solver.h"
#include "core/deform/solvers/coupling_blocks.h"
#include "core/deform/solvers/linear_solver.h"

namespace hepatica {

// What it carries from solve to solve. The factor is always of the latest matrix, so that the
// pattern and these numbers determine all later bits.
struct CoupledMemory {
    std::vector<int> pairs{};  // first, second, first, second ... of the pattern; ascending
    std::vector<double> numbers{};
    bool operator==(const CoupledMemory&) const = default;
};

// Not thread-safe; the same bits for any number of threads.
class CoupledFactor {
  public:
    void heed(const std::stop_token& stop);
    void bound_below(std::span<const double> least, double share) {
        factor_.bound_below(least, share);
    }

    // Whether solve() is worth its while: there are many couplings, and a factorisation with them
    // costs less than the iterations of a solver that does not know them, by a count of both.
    bool pays(const BlockMatrix& matrix, const CouplingBlocks& coupling);

    // A + C must be symmetric positive definite; of held rows all blocks beside the diagonal are
    // zero. `changed_rows` names every row of A in which a block differs from that of the last
    // solve. On exit x is the solution within the limits; where no row is held, the residual's sum
    // vanishes to rounding, as of solve_coupled. Throws Cancelled after a stop was asked for; only
    // restore() may then be called next.
    SolveReport solve(const BlockMatrix& matrix, std::span<const int> changed_rows,
                      const CouplingBlocks& coupling, std::span<const std::uint8_t> held,
                      std::span<const Vec3> rhs, std::span<Vec3> x, const SolveLimits& limits);

    // The next solve takes all rows as changed.
    void forget_matrix() { stale_ = true; }

    // A pattern without pairs, or these. restore() throws InputError, and changes nothing, where
    // the memory cannot be of matrices with A's pattern; the next solve must name all rows.
    CoupledMemory memory() const;
    void restore(const BlockMatrix& pattern, const CoupledMemory& memory);

    // Analyses so far, and the size of matrix and factor.
    int analyses() const { return analyses_; }
    std::size_t bytes() const;

  private:
    bool of_pattern(const BlockMatrix& matrix) const {
        return rows_ == matrix.row_begin && columns_ == matrix.column;
    }
    void plan(const BlockMatrix& pattern);
    void analyse_pattern();
    void part(const CouplingBlocks& coupling);
    void analyse_if_worn(const BlockMatrix& matrix, const CouplingBlocks& coupling);
    void find_changed(const BlockMatrix& matrix, std::span<const int> changed_rows);
    void fill(const BlockMatrix& matrix);

    std::vector<int> rows_, columns_;  // A's pattern
    std::vector<int> pairs_;           // see CoupledMemory
    std::vector<int> place_;           // of each block of A in united_
    BlockMatrix united_;               // A and what of C is in the pattern
    CouplingBlocks inside_, outside_;  // of the last solve: in the pattern, and not
    std::vector<int> coupled_rows_;    // of inside_
    std::vector<int> changed_;         // rows, since the last solve
    bool stale_ = true;                // no row is known
    CholeskySolver factor_;
    std::stop_token stop_;
    int spent_ = 0;  // iterations for what was outside, since the pattern was analysed
    int analyses_ = 0;
    double multiplications_ = 0.0;  // of a factorisation
    std::size_t factor_blocks_ = 0;
};

}  // namespace hepatica
