// SPDX-License-Identifier: GPL-3.0-or-later
// What a solve gives back is finite whatever went in: a matrix or a load that is not finite, or an
// iteration that overflowed, has no answer and the report says so.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "core/deform/solvers/linear_solver.h"

namespace hepatica {

// Where x or an error is not finite, x becomes zero and counts as not converged.
inline void own_up_unless_finite(SolveReport& report, std::span<Vec3> x) {
    const bool finite = std::ranges::all_of(x, [](const Vec3& v) { return v.allFinite(); });
    if (finite && std::isfinite(report.relative_residual) && std::isfinite(report.energy_error))
        return;
    std::ranges::fill(x, Vec3::Zero());
    report.converged = false;
    report.relative_residual = report.energy_error = 1.0;
}

}  // namespace hepatica
