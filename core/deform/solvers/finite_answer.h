// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the results of a solve finite. A matrix or load that is not finite, or an iteration that
// overflowed, has no solution; the report then says so.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "core/deform/solvers/linear_solver.h"

namespace hepatica {

inline bool all_finite(std::span<const Vec3> x) {
    return std::ranges::all_of(x, [](const Vec3& v) { return v.allFinite(); });
}

// Where x or an error estimate is not finite, sets x to zero and reports "not converged".
inline void own_up_unless_finite(SolveReport& report, std::span<Vec3> x) {
    if (all_finite(x) && std::isfinite(report.relative_residual) &&
        std::isfinite(report.energy_error))
        return;
    std::ranges::fill(x, Vec3::Zero());
    report.converged = false;
    report.relative_residual = report.energy_error = 1.0;
}

}  // namespace hepatica
