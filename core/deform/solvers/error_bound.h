// SPDX-License-Identifier: GPL-3.0-or-later
// The error of conjugate gradients in the energy norm, from the coefficients of the iteration: the
// Gauss-Radau upper bound of Meurant and Tichy, with the smallest Ritz value of this and earlier
// solves in place of the unknown smallest eigenvalue. It uses scalars only, so that the vectors may
// be on any device.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace hepatica {

// Tracks the smallest Ritz value and the error bound of one solve. Not thread-safe.
class ErrorBound {
  public:
    // The smallest Ritz value of earlier solves is multiplied by this at each solve, because the
    // matrix has changed.
    static constexpr double relaxation = 1.02;

    // `known_smallest`: smallest Ritz value of earlier solves; 0 where there is none.
    explicit ErrorBound(double known_smallest) : known_(known_smallest) {}

    // Bound of the squared error before the first iteration, as a multiple of (r, z).
    double before() const;
    // The same after each iteration, given its alpha and beta. Infinite where there is no bound.
    double after(double step, double ratio);

    // Smallest Ritz value of this solve and of the earlier ones.
    double smallest() const { return known_ > 0.0 ? std::fmin(known_, ritz_) : ritz_; }

  private:
    void update_spectrum();

    double known_;
    double ritz_ = INFINITY;
    double eigenvalue_ = 0.0;
    std::size_t next_check_ = 1;
    std::vector<double> steps_, ratios_;
    std::vector<std::pair<std::size_t, double>> history_;  // iterations, Ritz value
    double factor_ = 0.0;
    std::size_t factor_size_ = 0;
};

}  // namespace hepatica
