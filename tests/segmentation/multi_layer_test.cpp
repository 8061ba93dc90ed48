// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's segmentation, layer by layer, of tubes whose radius is known.
#include "core/segmentation/multi_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "tests/support/falls_of_progress.h"
#include "tests/support/test_masks.h"

namespace hepatica {
namespace {

Grid layer_grid() {
    Grid grid;
    grid.dims = {56, 48, 40};
    grid.spacing_mm = Vec3::Constant(0.8);
    return grid;
}

// Noise of about 6 HU, 60 HU more where `vessel`.
TissueContrast tissue_with(const std::function<bool(const Vec3&)>& vessel) {
    TissueContrast tissue;
    tissue.excess = FloatVolume(layer_grid());
    tissue.interior = Mask(layer_grid(), 1);
    tissue.noise_hu = 6.0;
    std::mt19937_64 random(4);
    for (std::size_t i = 0; i < tissue.excess.voxels.size(); ++i) {
        const auto [x, y, z] = layer_grid().index_of(i);
        double noise = 0.0;
        for (int k = 0; k < 3; ++k) noise += 2.0 * test::uniform(random) - 1.0;  // deviation 1
        tissue.excess.voxels[i] =
            static_cast<float>(6.0 * noise + (vessel(layer_grid().to_mm(x, y, z)) ? 60.0 : 0.0));
    }
    return tissue;
}

// Along z but slanted, of 3 mm radius; and a short piece of the same width.
double from_tube(const Vec3& p) {
    return std::hypot(p.x() - 12.0 - 0.15 * p.z(), p.y() - 19.0);
}
bool in_short_piece(const Vec3& p) {
    return std::hypot(p.x() - 35.0, p.y() - 19.0) < 2.5 && p.z() > 12.0 && p.z() < 16.0;
}

TEST(MultiLayer, FindsATubeAndItsAxisAndNothingElse) {
    const TissueContrast tissue =
        tissue_with([](const Vec3& p) { return from_tube(p) < 3.0 || in_short_piece(p); });
    Job job;
    const Detection found = detect_by_layers(tissue, Mask(layer_grid(), 1), job);
    double both = 0, sum = 0;
    std::vector<int> layers(40, 0);
    for (std::size_t i = 0; i < found.vessels.voxels.size(); ++i) {
        const auto [x, y, z] = layer_grid().index_of(i);
        const double r = from_tube(layer_grid().to_mm(x, y, z));
        const bool vessel = found.vessels.voxels[i] != 0;
        both += vessel && r < 3.0;
        sum += vessel + (r < 3.0);
        if (found.centreline.voxels[i] == 0) continue;
        ASSERT_TRUE(vessel);
        layers[z] += r < 1.0;
    }
    EXPECT_GT(2.0 * both / sum, 0.9);  // the piece of 4 mm counts as none
    for (int z = 0; z < 40; ++z) EXPECT_GE(layers[z], 1) << z;
}

TEST(MultiLayer, ItsProgressRisesToItsEndAndNotBeyond) {
    Job job;
    std::vector<double> said;
    job.observe([&](JobEvent event) {
        if (event == JobEvent::progress) said.push_back(job.progress().fraction);
    });
    detect_by_layers(tissue_with([](const Vec3&) { return false; }), Mask(layer_grid(), 1), job);
    ASSERT_FALSE(said.empty());
    EXPECT_TRUE(std::ranges::is_sorted(said));
    EXPECT_EQ(said.front(), 0.0);
    EXPECT_GT(said.back(), 0.95);
    EXPECT_LE(said.back(), 1.0);
}

// The fronts of one layer that march through so many pixels report progress of their own.
TEST(MultiLayer, ItsProgressDoesNotFallBackInAWideSection) {
    Grid grid;
    grid.dims = {200, 200, 3};
    grid.spacing_mm = Vec3::Constant(0.8);
    TissueContrast tissue;
    tissue.excess = FloatVolume(grid, 50.0f);
    tissue.interior = Mask(grid, 1);
    tissue.noise_hu = 6.0;
    tissue.threshold_hu = 20.0;
    Mask liver(grid);
    for (std::size_t i = 0; i < liver.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        liver.voxels[i] = std::min(x, y) > 10 && std::max(x, y) < 190;
    }
    Job job;
    const test::FallsOfProgress falls(job);
    detect_by_layers(tissue, liver, job);
    EXPECT_TRUE(falls.stages().empty());
    EXPECT_GT(falls.reports(), 9) << "three layers are smoothed, searched, and marched through";
    EXPECT_NEAR(job.progress().fraction, 1.0, 1e-9);
}

// After the last layer the chains of all layers are looked for, in each of the liver's voxels.
TEST(MultiLayer, AsksAfterItsLastLayer) {
    Job job;
    JobEvent last = JobEvent::progress;
    job.observe([&](JobEvent event) { last = event; });  // a report ends with its progress
    detect_by_layers(tissue_with([](const Vec3&) { return false; }), Mask(layer_grid(), 1), job);
    EXPECT_EQ(last, JobEvent::check);
}

TEST(MultiLayer, TakesTheUsersThresholdAndStaysInTheLiver) {
    TissueContrast tissue = tissue_with([](const Vec3& p) { return from_tube(p) < 3.0; });
    Job job;
    Mask liver(layer_grid(), 1);
    for (std::size_t i = 0; i < liver.voxels.size(); ++i)
        if (layer_grid().index_of(i)[2] >= 20) liver.voxels[i] = 0;
    const Detection lower = detect_by_layers(tissue, liver, job);
    double inside = 0;
    for (std::size_t i = 0; i < liver.voxels.size(); ++i) {
        if (liver.voxels[i] == 0) {
            ASSERT_EQ(lower.vessels.voxels[i], 0);
        }
        inside += lower.vessels.voxels[i];
    }
    EXPECT_GT(inside, 20 * 30);
    tissue.threshold_hu = 100.0;  // more than any voxel has after smoothing
    const Detection none = detect_by_layers(tissue, liver, job);
    EXPECT_EQ(std::count(none.vessels.voxels.begin(), none.vessels.voxels.end(), 1), 0);
    EXPECT_EQ(std::count(none.centreline.voxels.begin(), none.centreline.voxels.end(), 1), 0);
}

}  // namespace
}  // namespace hepatica
