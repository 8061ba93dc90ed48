// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/filters.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace hepatica {
namespace {

Grid oblique_grid(Index3 dims, Vec3 spacing) {
    Grid grid;
    grid.dims = dims;
    grid.spacing_mm = spacing;
    grid.origin_mm = Vec3(-31.0, 17.5, 402.0);
    grid.direction = Eigen::AngleAxisd(0.2, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
    return grid;
}

FloatVolume random_image(const Grid& grid, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    FloatVolume image(grid);
    for (float& voxel : image.voxels) voxel = static_cast<float>(engine() >> 40) * 1e-4f - 500.0f;
    return image;
}

// The definition, in double precision: sampled and normalised kernel, border value continued.
FloatVolume smooth_directly(const FloatVolume& image, const Vec3& sigma_mm) {
    FloatVolume from = image;
    for (int axis = 0; axis < 3; ++axis) {
        const double sigma = sigma_mm[axis] / image.grid.spacing_mm[axis];
        if (sigma == 0.0) continue;
        const int reach = static_cast<int>(std::ceil(6.0 * sigma));
        FloatVolume to(image.grid);
        for (std::size_t i = 0; i < to.voxels.size(); ++i) {
            const Index3 at = image.grid.index_of(i);
            double sum = 0.0;
            double weights = 0.0;
            for (int k = -reach; k <= reach; ++k) {
                Index3 near = at;
                near[axis] = std::clamp(at[axis] + k, 0, image.grid.dims[axis] - 1);
                const double w = std::exp(-0.5 * k * k / (sigma * sigma));
                sum += w * static_cast<double>(from.at(near[0], near[1], near[2]));
                weights += w;
            }
            to.voxels[i] = static_cast<float>(sum / weights);
        }
        from = to;
    }
    return from;
}

double greatest_difference(const FloatVolume& a, const FloatVolume& b) {
    double greatest = 0.0;
    for (std::size_t i = 0; i < a.voxels.size(); ++i)
        greatest = std::max(greatest, std::abs(static_cast<double>(a.voxels[i]) -
                                               static_cast<double>(b.voxels[i])));
    return greatest;
}

class Gaussian : public testing::TestWithParam<double> {};

// A point of light shows the filter's whole answer. Deriche's fit of order 4 is good to 5e-4 of
// the peak; the sampled kernel below 2 voxels is exact to its cut at 4 sigma.
TEST_P(Gaussian, AnswersAPointLikeTheSampledGaussian) {
    const double sigma = GetParam();
    Job job;
    FloatVolume image(oblique_grid({61, 67, 63}, {1, 1, 1}));
    image.at(30, 33, 31) = 1000.0f;
    FloatVolume smooth = image;
    gaussian_smooth(smooth, {sigma, sigma, sigma}, job);
    const FloatVolume direct = smooth_directly(image, {sigma, sigma, sigma});
    const double peak = direct.at(30, 33, 31);
    EXPECT_LT(greatest_difference(smooth, direct), 1.5e-3 * peak);
}

TEST_P(Gaussian, AgreesWithDirectConvolutionOnNoiseUpToTheBorders) {
    const double sigma = GetParam();
    Job job;
    const FloatVolume image = random_image(oblique_grid({33, 40, 29}, {0.7, 0.7, 1.4}), 5);
    const Vec3 sigma_mm(0.7 * sigma, 0.35 * sigma, 1.4 * sigma);
    FloatVolume smooth = image;
    gaussian_smooth(smooth, sigma_mm, job);
    // The image spans 1700; noise after smoothing differs by the filter's error times that.
    EXPECT_LT(greatest_difference(smooth, smooth_directly(image, sigma_mm)), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Widths, Gaussian, testing::Values(0.5, 1.0, 1.9, 2.0, 2.5, 4.0, 7.0));

TEST(GaussianSmooth, KeepsAConstantAndItsMeanOnWideFilters) {
    Job job;
    FloatVolume image(oblique_grid({50, 3, 20}, {1, 1, 1}), 1024.0f);
    gaussian_smooth(image, {25.0, 3.0, 9.0}, job);
    for (const float voxel : image.voxels) ASSERT_NEAR(voxel, 1024.0f, 0.05f);
}

TEST(GaussianSmooth, LeavesAnAxisOfWidthZeroAsItIs) {
    Job job;
    FloatVolume image(oblique_grid({9, 9, 9}, {1, 1, 1}));
    image.at(4, 4, 4) = 1.0f;
    gaussian_smooth(image, {2.5, 0.0, 0.0}, job);
    EXPECT_EQ(image.at(4, 3, 4), 0.0f);
    EXPECT_EQ(image.at(4, 4, 5), 0.0f);
    EXPECT_GT(image.at(3, 4, 4), 0.0f);
    EXPECT_THROW(gaussian_smooth(image, {-1.0, 0.0, 0.0}, job), InputError);
}

TEST(GaussianSmooth, GivesTheSameBytesForAnyNumberOfThreads) {
    const auto smoothed = [](int threads) {
        const ThreadLimit limit(threads);
        Job job;
        FloatVolume image = random_image(oblique_grid({45, 70, 40}, {1, 1, 2}), 11);
        gaussian_smooth(image, {3.0, 1.0, 5.0}, job);
        return image.voxels;
    };
    const auto one = smoothed(1);
    EXPECT_EQ(one, smoothed(2));
    EXPECT_EQ(one, smoothed(4));
}

TEST(Crop, KeepsEveryVoxelInItsPlace) {
    const Grid grid = oblique_grid({12, 9, 7}, {0.8, 0.9, 2.0});
    const FloatVolume image = random_image(grid, 3);
    const FloatVolume part = crop(image, {{3, 2, 1}, {10, 9, 5}});
    ASSERT_EQ(part.grid.dims, (Index3{7, 7, 4}));
    for (std::size_t i = 0; i < part.voxels.size(); ++i) {
        const Index3 at = part.grid.index_of(i);
        EXPECT_EQ(part.voxels[i], image.at(at[0] + 3, at[1] + 2, at[2] + 1));
        EXPECT_LT(
            (part.grid.to_mm(at[0], at[1], at[2]) - grid.to_mm(at[0] + 3, at[1] + 2, at[2] + 1))
                .norm(),
            1e-9);
    }
    EXPECT_THROW(crop(image, {{20, 0, 0}, {25, 5, 5}}), InputError);
}

// What crop() took comes back to its place, and what lies around it stays.
TEST(Paste, UndoesACrop) {
    const FloatVolume image = random_image(oblique_grid({7, 6, 5}, Vec3(0.7, 0.8, 1.5)), 4);
    const IndexBox box{{2, 0, 1}, {6, 3, 5}};
    FloatVolume whole(image.grid, -1.0f);
    paste(crop(image, box), box.begin, whole);
    for (std::size_t i = 0; i < whole.voxels.size(); ++i) {
        const auto [x, y, z] = whole.grid.index_of(i);
        const bool inside = x >= 2 && x < 6 && y < 3 && z >= 1;
        EXPECT_EQ(whole.voxels[i], inside ? image.voxels[i] : -1.0f) << x << " " << y << " " << z;
    }
}

TEST(BoundingBox, HoldsExactlyTheObject) {
    Mask mask(oblique_grid({10, 11, 12}, {1, 1, 2}));
    EXPECT_TRUE(bounding_box(mask).empty());
    // More than half the grid, so that both borders would pass each other.
    EXPECT_TRUE(grow_box(bounding_box(mask), mask.grid, 20.0).empty());
    mask.at(3, 4, 5) = 1;
    mask.at(7, 2, 9) = 1;
    const IndexBox box = bounding_box(mask);
    EXPECT_EQ(box.begin, (Index3{3, 2, 5}));
    EXPECT_EQ(box.end, (Index3{8, 5, 10}));
    const IndexBox grown = grow_box(box, mask.grid, 3.5);
    EXPECT_EQ(grown.begin, (Index3{0, 0, 3}));
    EXPECT_EQ(grown.end, (Index3{10, 9, 12}));
}

TEST(Respaced, CoversTheSameExtentAroundTheSameCentre) {
    const Grid grid = oblique_grid({40, 30, 20}, {0.7, 0.9, 3.0});
    const Grid fine = respaced(grid, {1.0, 1.0, 1.0});
    EXPECT_EQ(fine.dims, (Index3{28, 27, 60}));
    const Vec3 old_centre = grid.to_mm(Vec3(19.5, 14.5, 9.5));
    const Vec3 new_centre = fine.to_mm(Vec3(13.5, 13.0, 29.5));
    EXPECT_LT((old_centre - new_centre).norm(), 1e-9);
    EXPECT_THROW(respaced(grid, {0.0, 1.0, 1.0}), InputError);
    EXPECT_THROW(respaced(grid, {1.0, std::nan(""), 1.0}), InputError);
}

double linear_field(const Vec3& p) {
    return 3.0 * p[0] - 2.0 * p[1] + 0.5 * p[2];
}
double cubic_field(const Vec3& p) {
    return linear_field(p) + 0.04 * p[0] * p[0] - 0.03 * p[2] * p[1];
}

template <class Field>
FloatVolume sampled(const Grid& grid, const Field& field) {
    FloatVolume image(grid);
    for (std::size_t i = 0; i < image.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        image.voxels[i] = static_cast<float>(field(grid.to_mm(at[0], at[1], at[2])));
    }
    return image;
}

// Linear interpolation reproduces linear fields, Catmull-Rom quadratic ones, on any grid that
// lies inside (a voxel from the border for the cubic's outer taps).
TEST(Respaced, SaysTheSpacingThatMakesTooManyVoxels) {
    std::string problem;
    try {
        respaced(oblique_grid({40, 30, 20}, {1.0, 1.0, 1.0}), Vec3::Constant(1e-7));
    } catch (const InputError& error) {
        problem = error.problem();
    }
    EXPECT_EQ(problem, "is 1e-07, which makes 400000000 voxels along an axis");
}

TEST(Resample, ReproducesPolynomialsOfItsOrder) {
    Grid source;
    source.dims = {20, 22, 18};
    source.spacing_mm = {1.0, 0.8, 1.5};
    Grid aligned = source;
    aligned.dims = {24, 20, 30};
    aligned.spacing_mm = {0.6, 0.7, 0.7};
    aligned.origin_mm = {2.0, 1.5, 2.5};
    Grid turned = aligned;
    turned.dims = {10, 10, 10};
    turned.origin_mm = {6.0, 6.0, 10.0};
    turned.direction = Eigen::AngleAxisd(0.4, Vec3::UnitZ()).toRotationMatrix();
    Job job;
    for (const Grid& target : {aligned, turned}) {
        const FloatVolume linear =
            resample(sampled(source, linear_field), target, Interpolation::linear, job);
        EXPECT_LT(greatest_difference(linear, sampled(target, linear_field)), 1e-4);
        const FloatVolume cubic =
            resample(sampled(source, cubic_field), target, Interpolation::cubic, job);
        EXPECT_LT(greatest_difference(cubic, sampled(target, cubic_field)), 1e-4);
    }
}

TEST(Resample, OntoItsOwnGridChangesNothing) {
    const Grid grid = oblique_grid({15, 14, 13}, {0.8, 0.8, 2.5});
    const FloatVolume image = random_image(grid, 8);
    Job job;
    for (const auto how : {Interpolation::nearest, Interpolation::linear, Interpolation::cubic})
        EXPECT_LT(greatest_difference(resample(image, grid, how, job), image), 1e-3);
}

// Next to a step the cubic overshoots; above 32767 it must not wrap to air.
TEST(Resample, ClampsHounsfieldUnitsThatOvershoot) {
    Grid grid;
    grid.dims = {8, 4, 4};
    Volume volume(grid, 32767);
    for (int y = 0; y < 4; ++y)
        for (int z = 0; z < 4; ++z) volume.at(3, y, z) = -32768;
    Job job;
    const Volume fine =
        resample(volume, respaced(grid, Vec3(0.25, 1, 1)), Interpolation::cubic, job);
    for (int x = 0; x < fine.grid.dims[0]; ++x) {
        const double source = grid.to_index(fine.grid.to_mm(x, 1, 1))[0];
        if (std::abs(source - 3.0) > 1.0) {
            EXPECT_EQ(fine.at(x, 1, 1), 32767) << source;
        }
    }
}

// The borders of a mask are the same whatever number its label has.
TEST(Resample, AMaskDoesNotDependOnTheNumbersOfItsLabels) {
    Grid grid;
    grid.dims = {12, 12, 12};
    Mask one(grid), many(grid);
    for (int i = 3; i < 8; ++i) {
        one.at(i, 5, 5) = one.at(i, 6, 5) = 1;
        many.at(i, 5, 5) = 255;
        many.at(i, 6, 5) = 2;
    }
    Grid fine = grid;
    fine.dims = {30, 30, 30};
    fine.spacing_mm = Vec3::Constant(0.4);
    Job job;
    const Mask expected = resample(one, fine, Interpolation::linear, job);
    EXPECT_EQ(resample(many, fine, Interpolation::linear, job).voxels, expected.voxels);
    EXPECT_GT(std::ranges::count(expected.voxels, 1), 20);
}

TEST(Resample, StopsWhenCancelled) {
    Job job;
    job.cancel();
    const FloatVolume image = random_image(oblique_grid({8, 8, 8}, {1, 1, 1}), 1);
    EXPECT_THROW(resample(image, image.grid, Interpolation::linear, job), Cancelled);
}

}  // namespace
}  // namespace hepatica
