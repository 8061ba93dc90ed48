// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/error_bound.h"

#include <algorithm>
#include <span>

namespace hepatica {

namespace {

// Whether the Lanczos matrix of the iteration so far, minus `shift` I, is positive definite.
bool all_above(double shift, std::span<const double> steps, std::span<const double> ratios) {
    double pivot = 1.0 / steps[0] - shift;
    for (std::size_t k = 1; k < steps.size() && pivot > 0.0; ++k) {
        const double coupling_squared = ratios[k - 1] / (steps[k - 1] * steps[k - 1]);
        pivot = 1.0 / steps[k] + ratios[k - 1] / steps[k - 1] - shift - coupling_squared / pivot;
    }
    return pivot > 0.0;
}

// Smallest eigenvalue of that matrix, a lower estimate within 1 %. It is at most `upper`, and that
// where there is none: rounding may have made the matrix indefinite, or a coefficient is not
// finite. The number of evaluations is bounded whatever the coefficients are.
double smallest_eigenvalue(double upper, std::span<const double> steps,
                           std::span<const double> ratios) {
    constexpr int most_falls = 200;           // 0.7^200 = 1e-31, far below what rounding leaves
    constexpr int halvings_to_1_percent = 6;  // (1 / 0.7)^(1 / 2^6) = 1.006
    if (all_above(upper, steps, ratios) || !all_above(1e-30 * upper, steps, ratios)) return upper;
    double lower = 0.7 * upper;
    for (int k = 1; k < most_falls && !all_above(lower, steps, ratios); ++k) lower *= 0.7;
    upper = lower / 0.7;
    for (int k = 0; k < halvings_to_1_percent; ++k) {
        const double middle = std::sqrt(lower * upper);
        (all_above(middle, steps, ratios) ? lower : upper) = middle;
    }
    return lower;
}

// The bound after one more iteration. Zero where the assumed eigenvalue is too large for a bound to
// exist, and then also in all later iterations.
double next_factor(double factor, double eigenvalue, double step, double ratio) {
    const double excess = std::max(factor - step, 0.0);
    return excess > 0.0 ? excess / (eigenvalue * excess + ratio) : 0.0;
}

// Upper bound of the squared error in the energy norm after steps.size() iterations, in units of
// (r, z).
double radau_factor(double eigenvalue, std::span<const double> steps,
                    std::span<const double> ratios) {
    double factor = 1.0 / eigenvalue;
    for (std::size_t k = 0; k < steps.size(); ++k)
        factor = next_factor(factor, eigenvalue, steps[k], ratios[k]);
    return factor;
}

// The smallest eigenvalue is assumed to be this times the smallest Ritz value.
constexpr double eigenvalue_margin = 0.8;

}  // namespace

double ErrorBound::before() const {
    return known_ > 0.0 ? 1.0 / (eigenvalue_margin * known_) : INFINITY;
}

double ErrorBound::after(double step, double ratio) {
    steps_.push_back(step);
    ratios_.push_back(ratio);
    if (steps_.size() >= next_check_) update_spectrum();
    factor_ = factor_size_ > 0 ? next_factor(factor_, eigenvalue_, step, ratio)
                               : radau_factor(eigenvalue_, steps_, ratios_);
    if (!(factor_ > 0.0)) {
        // The smallest Ritz value has fallen since it was last computed.
        update_spectrum();
        factor_ = radau_factor(eigenvalue_, steps_, ratios_);
    }
    factor_size_ = factor_ > 0.0 ? steps_.size() : 0;
    return factor_ > 0.0 ? factor_ : INFINITY;
}

void ErrorBound::update_spectrum() {
    // After many iterations the Ritz value changes little, so it is computed less often.
    next_check_ = steps_.size() + 1 + steps_.size() / 16;
    const double upper = std::min(ritz_, 1.0 / steps_[0]);
    ritz_ = smallest_eigenvalue(upper, steps_, ratios_);
    history_.push_back({steps_.size(), ritz_});
    double eigenvalue = eigenvalue_margin * smallest();
    if (known_ == 0.0 || ritz_ < known_) {
        // While the Ritz value falls, it is assumed to fall again as much as since half the
        // iterations.
        const auto half = std::lower_bound(
            history_.begin(), history_.end(), steps_.size() / 2,
            [](const auto& entry, std::size_t size) { return entry.first < size; });
        const double fall = steps_.size() < 4 ? 0.3 : ritz_ / half->second;
        eigenvalue *= fall * fall;
    }
    if (eigenvalue == eigenvalue_) return;
    eigenvalue_ = eigenvalue;
    factor_size_ = 0;
}

}  // namespace hepatica
