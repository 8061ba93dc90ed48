// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/false_line_threshold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "core/image/filters.h"
#include "core/segmentation/line_coherence.h"

namespace hepatica {
namespace {

Grid noise_grid() {
    Grid grid;
    grid.dims = {64, 64, 64};
    grid.spacing_mm = Vec3::Constant(0.65);
    return grid;
}

// Noise of about unit deviation, a little smooth as that of a scan is.
FloatVolume noise(std::uint64_t seed) {
    Job job;
    std::mt19937_64 random(seed);
    FloatVolume values(noise_grid());
    for (float& v : values.voxels)
        v = static_cast<float>(static_cast<double>(random()) / 0x1p63 - 1.0);
    gaussian_smooth(values, Vec3::Constant(0.7), job);
    double squares = 0.0;
    for (const float v : values.voxels) squares += static_cast<double>(v) * v;
    const auto scale =
        static_cast<float>(1.0 / std::sqrt(squares / static_cast<double>(values.voxels.size())));
    for (float& v : values.voxels) v *= scale;
    return values;
}

// Rods along x, `height` above what is there.
void add_rods(FloatVolume& values, float height) {
    for (int z = 8; z < 64; z += 16)
        for (int y = 8; y < 64; y += 16)
            for (int x = 0; x < 64; ++x)
                for (const int dy : {0, 1}) values.at(x, y + dy, z) += height;
}

double noise_of_lines(const FloatVolume& values, double deviation) {
    Job job;
    const Mask all(values.grid, 1);
    return false_line_threshold(values, deviation, all, all, job);
}

TEST(FalseLineThreshold, IsTheStrongestThereCanBeWhereAllLinesAreNoise) {
    // As many dark as bright: no strength makes the bright ones credible.
    EXPECT_GT(noise_of_lines(noise(1), 1.0), 1.8);
}

TEST(FalseLineThreshold, FallsWhereTrueLinesOutnumberTheFalseAndStaysAboveTheNoise) {
    FloatVolume few = noise(1);
    add_rods(few, 4.0f);
    const double limit = noise_of_lines(few, 1.0);
    EXPECT_LT(limit, noise_of_lines(noise(1), 1.0));
    EXPECT_GT(limit, 1.0);
}

TEST(FalseLineThreshold, LeavesFiftyBrightVoxelsToEachDarkOneAndOneStepLowerFewer) {
    FloatVolume values = noise(5);
    add_rods(values, 4.0f);
    FloatVolume negative = values;
    for (float& v : negative.voxels) v = -v;
    const auto above = [](const FloatVolume& image, double strength) {
        Mask candidates(image.grid);
        for (std::size_t i = 0; i < candidates.voxels.size(); ++i)
            candidates.voxels[i] = image.voxels[i] > 1.0f;
        Job job;
        const FloatVolume lines = line_coherence(image, candidates, LineOptions{}, job);
        return static_cast<double>(std::count_if(lines.voxels.begin(), lines.voxels.end(),
                                                 [&](float v) { return v >= strength; }));
    };
    const double limit = noise_of_lines(values, 1.0);
    ASSERT_GT(limit, 1.0);
    ASSERT_LT(limit, 4.0);
    EXPECT_GE(above(values, limit), 50.0 * above(negative, limit));
    EXPECT_LT(above(values, limit - 0.05), 50.0 * above(negative, limit - 0.05));
}

TEST(FalseLineThreshold, GrowsInProportionWithTheImage) {
    FloatVolume values = noise(2);
    add_rods(values, 4.0f);
    const double once = noise_of_lines(values, 1.0);
    for (float& v : values.voxels) v *= 8.0f;
    EXPECT_NEAR(noise_of_lines(values, 8.0), 8.0 * once, 1e-9);
}

TEST(FalseLineThreshold, DarkLinesRaiseIt) {
    FloatVolume values = noise(3);
    add_rods(values, 4.0f);
    const double before = noise_of_lines(values, 1.0);
    for (int y = 0; y < 64; ++y)
        for (int z : {16, 32, 48}) values.at(0, y, z) -= 5.0f;
    EXPECT_GT(noise_of_lines(values, 1.0), before);
}

TEST(FalseLineThreshold, CountsOnlyWhereItIsTold) {
    FloatVolume values = noise(4);
    add_rods(values, 4.0f);
    Mask left(values.grid), all(values.grid, 1);
    for (int z = 0; z < 64; ++z)
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 32; ++x) left.at(x, y, z) = 1;
    Job job;
    const double before = false_line_threshold(values, 1.0, all, left, job);
    for (int y = 0; y < 64; ++y)
        for (int z : {16, 32, 48}) values.at(60, y, z) -= 5.0f;
    EXPECT_EQ(false_line_threshold(values, 1.0, all, left, job), before);
}

}  // namespace
}  // namespace hepatica
