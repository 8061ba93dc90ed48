// SPDX-License-Identifier: GPL-3.0-or-later
// Conjugate gradients that stop on the energy norm of the error, against matrices whose solution
// and error are known: diagonal ones.
#include "core/deform/solvers/error_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/deform/solvers/conjugate_gradient.h"

namespace hepatica {
namespace {

// Eigenvalues over decades, and few that lie far below, so that the smallest Ritz value falls late
// and by much at once. Entry j of an eigenvector of eigenvalue e has sqrt(e) in the right-hand
// side.
struct LateSpectrum {
    int size, decades, low;
    double lowest_first;
};

std::vector<double> eigenvalues_of(const LateSpectrum& spectrum) {
    std::vector<double> all;
    for (int k = 0; k < spectrum.low; ++k)
        all.push_back(spectrum.lowest_first * std::pow(100.0, -k));
    for (int k = 0; k < spectrum.size - spectrum.low; ++k)
        all.push_back(std::pow(10.0, spectrum.decades * std::fmod(0.6180339887498949 * k, 1.0)));
    return all;
}

TEST(ErrorBound, HoldsWhereTheSmallestRitzValueFallsLate) {
    constexpr double tolerance = 1e-3;
    for (const LateSpectrum& spectrum :
         {LateSpectrum{60, 2, 2, 0.1}, LateSpectrum{60, 2, 3, 0.1}, LateSpectrum{60, 2, 3, 0.01},
          LateSpectrum{60, 5, 2, 0.1}, LateSpectrum{90, 2, 2, 0.001}}) {
        const std::vector<double> diagonal = eigenvalues_of(spectrum);
        const int nodes = spectrum.size / 3;
        std::vector<Vec3> rhs(nodes), x(nodes, Vec3::Zero());
        for (int j = 0; j < spectrum.size; ++j)
            rhs[j / 3][j % 3] =
                std::sqrt(diagonal[j]) * (j < spectrum.low ? std::pow(10.0, -j) : 1.0);
        const auto apply = [&](const std::vector<Vec3>& d, std::vector<Vec3>& product) {
            product.resize(d.size());
            for (int j = 0; j < spectrum.size; ++j)
                product[j / 3][j % 3] = diagonal[j] * d[j / 3][j % 3];
        };
        const auto precondition = [](const std::vector<Vec3>& r, std::vector<Vec3>& z) { z = r; };
        ConjugateGradient solver;
        const SolveReport report = solver.solve(
            apply, precondition, rhs, x,
            {.energy_tolerance = tolerance, .residual_tolerance = 0.0, .max_iterations = 2000});
        EXPECT_TRUE(report.converged);
        double error_squared = 0.0, size_squared = 0.0;
        for (int j = 0; j < spectrum.size; ++j) {
            const double exact = rhs[j / 3][j % 3] / diagonal[j];
            error_squared += diagonal[j] * std::pow(exact - x[j / 3][j % 3], 2);
            size_squared += diagonal[j] * exact * exact;
        }
        const double error = std::sqrt(error_squared / size_squared);
        EXPECT_LT(error, tolerance) << spectrum.size << " of which " << spectrum.low;
        EXPECT_LE(error, report.energy_error);
        EXPECT_GT(report.energy_error, 0.0);
    }
}

// Rounding has made the Lanczos matrix indefinite: 1 + 1e17 - 1e17 is 0. What was known stays.
TEST(ErrorBound, EndsWhereRoundingLeavesNoEigenvalue) {
    ErrorBound bound(0.0);
    bound.after(1.0, 1e17);
    EXPECT_GE(bound.after(1.0, 0.5), 0.0);
    EXPECT_GT(bound.smallest(), 0.9);
    EXPECT_LE(bound.smallest(), 1.0);
}

TEST(ErrorBound, EndsWhateverTheCoefficientsAre) {
    const double odd[] = {1e-300, 1e-200, 1.0, 1e200, 1e300, INFINITY, NAN};
    for (const double step : odd)
        for (const double ratio : odd) {
            ErrorBound bound(0.0);
            for (int k = 0; k < 6; ++k) {
                EXPECT_GE(bound.after(k % 2 == 0 ? step : 1.0, ratio), 0.0) << step << ' ' << ratio;
                EXPECT_GE(bound.smallest(), 0.0) << step << ' ' << ratio;
            }
        }
}

}  // namespace
}  // namespace hepatica
