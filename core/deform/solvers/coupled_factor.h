// SPDX-License-Identifier: GPL-3.0-or-later
// Solves (A + C) x = b by a Cholesky factor of A and of those blocks of C whose pairs of nodes were
// coupled when the pattern was last analysed. Ordering and analysis are kept while contacts come
// and go; blocks of new pairs are left to conjugate gradients, whose iterations grow with the
// number of these blocks only, not with that of all contacts. Once these iterations have cost as
// much as an analysis, the next solve analyses again.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/deform/solvers/cholesky_solver.h"
#include "core/deform/solvers/coupling_blocks.h"
#include "core/deform/solvers/linear_solver.h"

namespace hepatica {

// The state that is carried from solve to solve. The factor is always that of the latest matrix, so
// that the pattern and these numbers determine all later bits.
struct CoupledMemory {
    std::vector<int> pairs{};  // flattened pairs of the pattern, ascending
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

    // Whether solve() is likely faster than a solver without couplings: there are many couplings,
    // and a factorisation with them costs less than that solver's iterations, by a count of both.
    // A pattern that does not pay is analysed again only once fewer pairs of nodes are coupled.
    bool pays(const BlockMatrix& matrix, const CouplingBlocks& coupling);

    // A + C must be symmetric positive definite; the off-diagonal blocks of held rows must be zero.
    // `changed_rows` must name every row of A with a block that differs from the last solve. On
    // exit x is the solution within the limits; where no row is held, the sum of the residual
    // vanishes up to rounding, as in solve_coupled. Throws Cancelled after a stop is requested;
    // then only restore() may be called next.
    SolveReport solve(const BlockMatrix& matrix, std::span<const int> changed_rows,
                      const CouplingBlocks& coupling, std::span<const std::uint8_t> held,
                      std::span<const Vec3> rhs, std::span<Vec3> x, const SolveLimits& limits);

    // Makes the next solve treat all rows as changed.
    void forget_matrix() { stale_ = true; }

    // memory() is empty before the first analysis. restore() throws InputError and changes nothing
    // where the memory cannot be of matrices with this pattern; the next solve must name all rows.
    CoupledMemory memory() const;
    void restore(const BlockMatrix& pattern, const CoupledMemory& memory);

    // Number of analyses so far; size of matrix and factor.
    int analyses() const { return analyses_; }
    std::size_t bytes() const;

  private:
    bool of_pattern(const BlockMatrix& matrix) const {
        return rows_ == matrix.row_begin && columns_ == matrix.column;
    }
    void plan(const BlockMatrix& pattern);
    void analyse_pattern();
    void part(const CouplingBlocks& coupling);
    bool worth(std::size_t couplings) const;
    void analyse_if_worn(const BlockMatrix& matrix, const CouplingBlocks& coupling);
    void find_changed(const BlockMatrix& matrix, std::span<const int> changed_rows);
    void fill(const BlockMatrix& matrix);

    std::vector<int> rows_, columns_;  // A's pattern
    std::vector<int> pairs_;           // see CoupledMemory
    std::vector<int> place_;           // index in united_ of each block of A
    BlockMatrix united_;               // A and the part of C in the pattern
    CouplingBlocks inside_, outside_;  // C of the last solve: in the pattern or not
    std::vector<int> coupled_rows_;    // rows of inside_
    std::vector<int> changed_;         // rows that differ from the last solve
    bool stale_ = true;                // every row is to be written
    CholeskySolver factor_;
    std::stop_token stop_;
    int spent_ = 0;  // iterations spent on outside_ since the last analysis
    int analyses_ = 0;
    double multiplications_ = 0.0;  // of one factorisation
    std::size_t factor_blocks_ = 0;
};

}  // namespace hepatica
