// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/tissue_contrast.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "core/base/error.h"
#include "core/image/morphology.h"

namespace hepatica {
namespace {

TEST(RobustSpread, IsTheMedianAndWhatTheLowerHalfSaysOfTheDeviation) {
    Grid grid;
    grid.dims = {7, 1, 1};
    FloatVolume values(grid);
    values.voxels = {4, 1, 100, 3, 2, -999, 999};
    Mask where(grid, 1);
    where.voxels[5] = where.voxels[6] = 0;  // not looked at
    const RobustSpread spread = robust_spread(values, where);
    EXPECT_EQ(spread.median, 3.0);                // of 1 2 3 4 100
    EXPECT_NEAR(spread.deviation, 1.4826, 1e-6);  // 0, 1 and 2 below it
    EXPECT_EQ(robust_spread(values, Mask(grid)).deviation, 0.0);
    EXPECT_EQ(robust_spread(values, Mask(grid)).median, 0.0);
}

double normal(std::mt19937_64& random) {
    const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1.0p-53; };
    return std::sqrt(-2.0 * std::log(uniform())) * std::cos(2.0 * M_PI * uniform());
}

TEST(RobustSpread, MeasuresNormalNoiseWhateverIsBrighter) {
    Grid grid;
    grid.dims = {100, 100, 50};  // more than are sampled
    FloatVolume values(grid);
    std::mt19937_64 random(1);
    for (float& v : values.voxels) v = static_cast<float>(20.0 + 6.0 * normal(random));
    const RobustSpread plain = robust_spread(values, Mask(grid, 1));
    EXPECT_NEAR(plain.median, 20.0, 0.1);
    EXPECT_NEAR(plain.deviation, 6.0, 0.1);
    for (std::size_t i = 0; i < values.voxels.size(); i += 20) values.voxels[i] = 500.0f;
    const RobustSpread vessels = robust_spread(values, Mask(grid, 1));
    EXPECT_NEAR(vessels.median, 20.0, 0.6);
    EXPECT_NEAR(vessels.deviation, 6.0, 0.4);
}

// A liver of 72 x 48 x 48 mm whose parenchyma rises from left to right by 15 HU, with a vessel 60
// HU brighter and a tumour 50 HU darker.
struct Liver {
    Liver() {
        Grid grid;
        grid.dims = {80, 56, 56};
        intensity = FloatVolume(grid, -50.0f);
        mask = vessel = tumour = Mask(grid);
        std::mt19937_64 random(2);
        for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
            const auto [x, y, z] = grid.index_of(i);
            if (x < 4 || x >= 76 || y < 4 || y >= 52 || z < 4 || z >= 52) continue;
            mask.voxels[i] = 1;
            vessel.voxels[i] = std::hypot(y - 20, z - 28) < 3.0;
            tumour.voxels[i] = std::hypot(std::hypot(x - 40, y - 38), z - 28) < 6.0;
            intensity.voxels[i] =
                static_cast<float>(level_at(x) + noise_hu * normal(random) +
                                   60.0 * vessel.voxels[i] - 50.0 * tumour.voxels[i]);
        }
    }
    static double level_at(int x) { return 100.0 + 15.0 * (x - 39.5) / 72.0; }

    static constexpr double noise_hu = 8.0;
    FloatVolume intensity;
    Mask mask, vessel, tumour;
};

TEST(MeasureTissue, SubtractsTheLocalParenchymaOnly) {
    const Liver liver;
    Job job;
    const TissueContrast tissue = measure_tissue(liver.intensity, liver.mask, job);
    EXPECT_NEAR(tissue.parenchyma_hu, 100.0, 1.0);
    EXPECT_NEAR(tissue.noise_hu, Liver::noise_hu, 0.4);
    EXPECT_FALSE(tissue.threshold_hu.has_value());
    double left = 0, right = 0, left_count = 0, right_count = 0, bright = 0, bright_count = 0,
           dark = 0, dark_count = 0;
    for (std::size_t i = 0; i < liver.mask.voxels.size(); ++i) {
        const float excess = tissue.excess.voxels[i];
        if (!liver.mask.voxels[i]) {
            ASSERT_EQ(excess, 0.0f);
            continue;
        }
        if (!tissue.interior.voxels[i]) continue;
        const int x = liver.mask.grid.index_of(i)[0];
        if (liver.vessel.voxels[i]) {
            bright += excess;
            ++bright_count;
        } else if (liver.tumour.voxels[i]) {
            dark += excess;
            ++dark_count;
        } else if (x < 24) {
            left += excess;
            ++left_count;
        } else if (x >= 56) {
            right += excess;
            ++right_count;
        }
    }
    // The level at the ends of the liver is a mean over less than around, so that a part of the
    // slope is left there: 15 HU from end to end are two.
    EXPECT_NEAR(left / left_count, 0.0, 1.2);
    EXPECT_NEAR(right / right_count, 0.0, 1.2);
    EXPECT_NEAR(bright / bright_count, 60.0, 1.5);
    EXPECT_NEAR(dark / dark_count, -50.0, 1.5);
}

TEST(MeasureTissue, LeavesTheRimOutOfTheInterior) {
    const Liver liver;
    Job job;
    EXPECT_EQ(measure_tissue(liver.intensity, liver.mask, job).interior.voxels,
              erode(liver.mask, 3.0, job).voxels);
}

// Adding a constant to the image adds it to the parenchyma and to nothing else.
TEST(MeasureTissue, FollowsTheWindow) {
    Liver liver;
    Job job;
    const TissueContrast before = measure_tissue(liver.intensity, liver.mask, job);
    for (float& v : liver.intensity.voxels) v += 64.0f;
    const TissueContrast after = measure_tissue(liver.intensity, liver.mask, job);
    EXPECT_NEAR(after.parenchyma_hu, before.parenchyma_hu + 64.0, 1e-3);
    EXPECT_NEAR(after.noise_hu, before.noise_hu, 1e-3);
    for (std::size_t i = 0; i < liver.mask.voxels.size(); i += 97)
        ASSERT_NEAR(after.excess.voxels[i], before.excess.voxels[i], 1e-2);
}

// Nothing of a plate 4 mm thick is 3 mm inside it: there is no tissue to measure.
TEST(MeasureTissue, RefusesALiverThatIsAllRim) {
    Liver liver;
    Job job;
    for (std::size_t i = 0; i < liver.mask.voxels.size(); ++i) {
        const int z = liver.mask.grid.index_of(i)[2];
        if (z < 28 || z >= 32) liver.mask.voxels[i] = 0;
    }
    std::string problem;
    try {
        measure_tissue(liver.intensity, liver.mask, job);
    } catch (const InputError& error) {
        problem = error.problem();
    }
    EXPECT_EQ(problem, "the liver mask is so thin that nothing of it is further than 3 mm inside");
}

TEST(MeasureTissue, RefusesAnEmptyLiver) {
    const Liver liver;
    Job job;
    EXPECT_THROW(measure_tissue(liver.intensity, Mask(liver.mask.grid), job), InputError);
    job.cancel();
    EXPECT_THROW(measure_tissue(liver.intensity, liver.mask, job), Cancelled);
}

}  // namespace
}  // namespace hepatica
