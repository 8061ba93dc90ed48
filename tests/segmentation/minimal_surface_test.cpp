// SPDX-License-Identifier: GPL-3.0-or-later
// The wall of a vessel where the intensity says it is, and what the surface's area makes of noise.
#include "core/segmentation/minimal_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr double spacing_mm = 0.5;
constexpr double deviation = 5.0;

Grid surface_grid() {
    Grid grid;
    grid.dims = {28, 28, 24};
    grid.spacing_mm = Vec3::Constant(spacing_mm);
    return grid;
}

double from_axis(const Grid& grid, std::size_t i) {
    const Index3 at = grid.index_of(i);
    return spacing_mm * std::hypot(at[0] - 13.5, at[1] - 13.5);
}

Mask tube(double radius_mm) {
    Mask mask(surface_grid());
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        mask.voxels[i] = from_axis(mask.grid, i) < radius_mm;
    return mask;
}

// A vessel of 100 HU and 2.5 mm radius whose wall is blurred.
FloatVolume blurred_vessel() {
    FloatVolume volume(surface_grid());
    for (std::size_t i = 0; i < volume.voxels.size(); ++i)
        volume.voxels[i] =
            static_cast<float>(50.0 * (1.0 - std::tanh(from_axis(volume.grid, i) - 2.5)));
    return volume;
}

double radius_of(const Mask& mask) {
    const double layers = mask.grid.dims[2];
    const auto voxels =
        static_cast<double>(std::ranges::count_if(mask.voxels, [](auto v) { return v != 0; }));
    return spacing_mm * std::sqrt(voxels / layers / M_PI);
}

// So that the image decides and not the area.
SurfaceOptions by_the_image() {
    SurfaceOptions options;
    options.data_weight = 50.0;
    options.pull_deviations = 0.0;
    return options;
}

Mask fitted(const FloatVolume& intensity, double rise, const Mask& start,
            const SurfaceOptions& options, double noise = deviation) {
    Job job;
    return fit_surface(intensity, FloatVolume(surface_grid(), static_cast<float>(rise)), start,
                       Mask(surface_grid(), 1), noise, options, job);
}

TEST(FitSurface, PutsTheWallAtItsShareOfThePeakFromEitherSide) {
    for (const double share : {0.3, 0.5, 0.7}) {
        SurfaceOptions options = by_the_image();
        options.level_share = share;
        const double wall = 2.5 + std::atanh(1.0 - 2.0 * share);
        // Outwards by up to one voxel, inwards any way.
        for (const double start : {wall - 0.3, wall + 0.2, 4.5}) {
            const Mask found = fitted(blurred_vessel(), 100.0, tube(start), options);
            EXPECT_EQ(found.voxels, tube(wall).voxels) << share << " from " << start;
        }
    }
}

TEST(FitSurface, MovesOutwardsByOneVoxelAtMost) {
    const Mask found = fitted(blurred_vessel(), 100.0, tube(0.6), by_the_image());
    for (std::size_t i = 0; i < found.voxels.size(); ++i) {
        const Index3 at = found.grid.index_of(i);
        // The start holds the four voxels around the axis.
        const bool beside = at[0] >= 12 && at[0] <= 15 && at[1] >= 12 && at[1] <= 15;
        ASSERT_EQ(found.voxels[i] != 0, beside) << at[0] << " " << at[1];
    }
}

TEST(FitSurface, TakesTheLevelFromThePeakLessThePullButNeverBelowTheNoise) {
    SurfaceOptions options = by_the_image();
    options.level_share = 0.5;
    options.pull_deviations = 2.0;  // of 5 HU: the level is 40 HU
    options.least_deviations = 1.0;
    EXPECT_EQ(fitted(blurred_vessel(), 100.0, tube(3.0), options).voxels,
              tube(2.5 + std::atanh(0.2)).voxels);
    options.least_deviations = 14.0;  // 70 HU
    EXPECT_EQ(fitted(blurred_vessel(), 100.0, tube(3.0), options).voxels,
              tube(2.5 + std::atanh(-0.4)).voxels);
    EXPECT_EQ(fitted(blurred_vessel(), 0.0, tube(3.0), options).voxels,
              tube(2.5 + std::atanh(-0.4)).voxels);
}

// The peak is that of the vessel within reach, not one further off and not one beside the vessel.
TEST(FitSurface, LooksForThePeakWithinItsReachAndInsideTheVessel) {
    SurfaceOptions options = by_the_image();
    options.level_share = 0.5;
    options.peak_reach_mm = 3.0;
    FloatVolume rise(surface_grid(), 60.0f);
    for (int z = 0; z < 24; ++z) rise.at(0, 0, z) = 1000.0f;  // beside the vessel
    for (int y = 0; y < 28; ++y)
        for (int x = 0; x < 28; ++x) rise.at(x, y, 0) = 160.0f;
    Job job;
    const Mask found = fit_surface(blurred_vessel(), rise, tube(3.0), Mask(surface_grid(), 1),
                                   deviation, options, job);
    const Mask low = tube(2.5 + std::atanh(1.0 - 2.0 * 0.3)),
               high = tube(2.5 + std::atanh(1.0 - 2.0 * 0.8));
    for (const int z : {0, 6, 7, 23}) {
        const Mask& expected = z <= 6 ? high : low;  // 3 mm are six voxels
        for (int y = 0; y < 28; ++y)
            for (int x = 0; x < 28; ++x)
                ASSERT_EQ(found.at(x, y, z), expected.at(x, y, z)) << x << " " << y << " " << z;
    }
}

// What lies a layer of high peaks aside of the axis changes, mirrored or turned, with it.
TEST(FitSurface, LooksEquallyFarToEverySide) {
    SurfaceOptions options = by_the_image();
    options.level_share = 0.5;
    options.peak_reach_mm = 1.0;  // two voxels
    const auto found_beside = [&](int axis, int layer) {
        FloatVolume rise(surface_grid(), 60.0f);
        for (std::size_t i = 0; i < rise.voxels.size(); ++i)
            if (rise.grid.index_of(i)[static_cast<std::size_t>(axis)] == layer)
                rise.voxels[i] = 160.0f;
        Job job;
        return fit_surface(blurred_vessel(), rise, tube(3.0), Mask(surface_grid(), 1), deviation,
                           options, job);
    };
    const Mask low = found_beside(0, 11), high = found_beside(0, 16), turned = found_beside(1, 11),
               turned_high = found_beside(1, 16);
    for (int z = 0; z < 24; ++z)
        for (int y = 0; y < 28; ++y)
            for (int x = 0; x < 28; ++x) {
                ASSERT_EQ(high.at(27 - x, y, z), low.at(x, y, z)) << x << " " << y << " " << z;
                ASSERT_EQ(turned.at(y, x, z), low.at(x, y, z)) << x << " " << y << " " << z;
                ASSERT_EQ(turned_high.at(y, 27 - x, z), low.at(x, y, z)) << x << " " << y;
            }
    EXPECT_NE(low.voxels, high.voxels);
}

TEST(FitSurface, StaysInTheLiver) {
    Mask liver(surface_grid(), 1);
    for (std::size_t i = 0; i < liver.voxels.size(); ++i)
        if (liver.grid.index_of(i)[0] > 15) liver.voxels[i] = 0;
    Job job;
    Mask start = tube(2.0);
    for (std::size_t i = 0; i < start.voxels.size(); ++i) start.voxels[i] &= liver.voxels[i];
    const Mask found = fit_surface(blurred_vessel(), FloatVolume(surface_grid(), 100.0f), start,
                                   liver, deviation, by_the_image(), job);
    for (std::size_t i = 0; i < liver.voxels.size(); ++i)
        if (liver.voxels[i] == 0) {
            ASSERT_EQ(found.voxels[i], 0);
        }
    EXPECT_NEAR(radius_of(found), radius_of(start), 0.6);
}

// Single bright voxels beside the wall and dark ones inside cost more surface than they are worth.
TEST(FitSurface, SmoothsWhatSingleVoxelsSay) {
    FloatVolume noisy = blurred_vessel();
    for (int z = 3; z < 24; z += 5) {
        noisy.at(13, 13, z) = 25.0f;  // below the level, by 3 deviations or less
        noisy.at(13, 20, z) = 55.0f;  // above it
    }
    SurfaceOptions options;  // as they are used
    const Mask found = fitted(noisy, 100.0, tube(3.5), options);
    for (int z = 3; z < 24; z += 5) {
        EXPECT_EQ(found.at(13, 13, z), 1);
        EXPECT_EQ(found.at(13, 20, z), 0);
    }
    // The area pulls the wall in by less than a voxel from where the level lies.
    const double wall = 2.5 + std::atanh(1.0 - 2.0 * (0.39 - 0.7 * deviation / 100.0));
    EXPECT_NEAR(radius_of(found), wall, 0.5 * spacing_mm);
    SurfaceOptions literal = by_the_image();
    const Mask rough = fitted(noisy, 100.0, tube(3.5), literal);
    EXPECT_EQ(rough.at(13, 13, 3), 0);
    EXPECT_EQ(rough.at(13, 20, 3), 1);
}

// A flat wall has no curvature: it neither moves nor is rounded, at the border of the grid either.
TEST(FitSurface, LeavesAFlatWallWhereItIs) {
    FloatVolume half(surface_grid());
    Mask left(surface_grid());
    for (std::size_t i = 0; i < half.voxels.size(); ++i) {
        const bool bright = half.grid.index_of(i)[0] < 14;
        half.voxels[i] = bright ? 100.0f : 0.0f;
        left.voxels[i] = bright;
    }
    EXPECT_EQ(fitted(half, 100.0, left, SurfaceOptions{}).voxels, left.voxels);
}

TEST(FitSurface, IsTheSameForAnyNumberOfThreadsAndStopsWhenCancelled) {
    const Mask whole = fitted(blurred_vessel(), 100.0, tube(3.0), {});
    {
        const ThreadLimit one(1);
        EXPECT_EQ(fitted(blurred_vessel(), 100.0, tube(3.0), {}).voxels, whole.voxels);
    }
    Job job;
    job.cancel();
    EXPECT_THROW(fit_surface(blurred_vessel(), blurred_vessel(), tube(3.0), Mask(surface_grid(), 1),
                             deviation, {}, job),
                 Cancelled);
}

}  // namespace
}  // namespace hepatica
