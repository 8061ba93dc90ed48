// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/gaussian_refinement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "core/base/error.h"
#include "core/image/morphology.h"

namespace hepatica {
namespace {

using std::numbers::pi;

Mask ball(double radius_mm, double spacing_mm, double roughness_mm = 0.0) {
    Grid grid;
    const int n = static_cast<int>(std::ceil(2.0 * (radius_mm + 4.0) / spacing_mm));
    grid.dims = {n, n, n};
    grid.spacing_mm = Vec3::Constant(spacing_mm);
    grid.origin_mm = Vec3::Constant(-0.5 * (n - 1) * spacing_mm);
    Mask mask(grid);
    std::mt19937_64 engine(7);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        const double noise = roughness_mm * (static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0);
        mask.voxels[i] = grid.to_mm(at[0], at[1], at[2]).norm() + noise < radius_mm;
    }
    return mask;
}

TEST(SurfaceMeasure, MeetsTheAreaAndVolumeOfABall) {
    for (const double spacing : {0.5, 1.0}) {
        const SurfaceMeasure m = measure_surface(ball(10.0, spacing));
        EXPECT_NEAR(m.area_mm2, 4.0 * pi * 100.0, 0.02 * 4.0 * pi * 100.0);
        EXPECT_NEAR(m.volume_mm3, 4000.0 * pi / 3.0, 0.01 * 4000.0 * pi / 3.0);
    }
}

// Value at distance r from the centre of a ball of radius R blurred by a Gaussian of deviation s.
double blurred_ball(double r, double R, double s) {
    const auto bell = [&](double d) { return std::exp(-d * d / (2.0 * s * s)); };
    const double w = std::sqrt(2.0) * s;
    return 0.5 * (std::erf((R - r) / w) + std::erf((R + r) / w)) -
           s / (r * std::sqrt(2.0 * pi)) * (bell(R - r) - bell(R + r));
}

TEST(GaussianRefinement, ShrinksABallAsTheClosedFormSays) {
    const double radius = 6.0;
    const Mask object = ball(radius, 0.4);
    RefinementOptions options;
    options.sigma_mm = 0.9;
    options.keep_thin_branches = false;
    Job job;
    for (int n = 1; n <= 6; ++n) {
        options.recursions = n;
        const double volume = measure_surface(refine(object, options, job)).volume_mm3;
        double inner = 1.0;
        double outer = radius;
        while (outer - inner > 1e-6) {
            const double middle = 0.5 * (inner + outer);
            (blurred_ball(middle, radius, std::sqrt(n) * 0.9) > 0.5 ? inner : outer) = middle;
        }
        EXPECT_NEAR(std::cbrt(3.0 * volume / (4.0 * pi)), inner, 0.15 * 0.4) << n << " recursions";
    }
}

TEST(GaussianRefinement, MoreRecursionsLeaveLessSurfaceNoise) {
    const Mask rough = ball(8.0, 0.5, 1.0);
    RefinementOptions options;
    options.keep_thin_branches = false;
    Job job;
    double area = measure_surface(rough).area_mm2;
    EXPECT_GT(area, 1.3 * 4.0 * pi * 64.0);
    for (int n = 1; n <= 4; ++n) {
        options.recursions = n;
        const double smoother = measure_surface(refine(rough, options, job)).area_mm2;
        EXPECT_LT(smoother, area) << n << " recursions";
        area = smoother;
    }
    EXPECT_NEAR(area, 4.0 * pi * 64.0, 0.05 * 4.0 * pi * 64.0);
}

TEST(GaussianRefinement, KeepsAThinBranchThatTheLevelSetWouldLose) {
    Mask two_balls = ball(8.0, 0.5);
    const Grid& grid = two_balls.grid;
    for (std::size_t i = 0; i < two_balls.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        const Vec3 p = grid.to_mm(at[0], at[1], at[2]);
        two_balls.voxels[i] = (p - Vec3(0, 0, 6)).norm() < 3.0 ||
                              (p + Vec3(0, 0, 6)).norm() < 3.0 ||
                              (std::abs(p[2]) < 6.0 && std::hypot(p[0], p[1]) < 0.6);
    }
    Job job;
    RefinementOptions options;
    options.recursions = 4;
    EXPECT_EQ(
        connected_components(refine(two_balls, options, job), Connectivity::all26).sizes.size(),
        1u);
    options.keep_thin_branches = false;
    EXPECT_EQ(
        connected_components(refine(two_balls, options, job), Connectivity::all26).sizes.size(),
        2u);
}

TEST(GaussianRefinement, KeepsTheLabelsOfSystems) {
    Mask systems = ball(6.0, 0.5, 0.8);
    for (std::size_t i = 0; i < systems.voxels.size(); ++i)
        if (systems.voxels[i] && systems.grid.index_of(i)[0] * 2 > systems.grid.dims[0])
            systems.voxels[i] = 2;
    Job job;
    const Mask refined = refine(systems, 2, job);
    for (std::size_t i = 0; i < systems.voxels.size(); ++i) {
        if (systems.voxels[i] && refined.voxels[i]) {
            EXPECT_EQ(refined.voxels[i], systems.voxels[i]);
        }
    }
}

TEST(GaussianRefinement, LeavesTheMaskAloneAtZeroAndRefusesNonsense) {
    const Mask object = ball(4.0, 0.5);
    Job job;
    EXPECT_EQ(refine(object, 0, job).voxels, object.voxels);
    EXPECT_THROW(refine(object, -1, job), InputError);
    RefinementOptions options;
    options.sigma_mm = 0.0;
    EXPECT_THROW(refine(object, options, job), InputError);
    options = {};
    options.level = 1.0;
    EXPECT_THROW(refine(object, options, job), InputError);
}

TEST(GaussianRefinement, SaysSmallNumbersAsTheyAre) {
    Job job;
    RefinementOptions options;
    options.level = -1e-9;
    std::string problem;
    try {
        refine(ball(4.0, 0.5), options, job);
    } catch (const InputError& error) {
        problem = error.problem();
    }
    EXPECT_EQ(problem, "the refinement's level is -1e-09");
}

}  // namespace
}  // namespace hepatica
