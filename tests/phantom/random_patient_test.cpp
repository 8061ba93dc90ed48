// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phantom/random_patient.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/image/morphology.h"

namespace hepatica {
namespace {

TEST(RandomPatient, IsWithinItsRangesAndReachesTheirEnds) {
    double least_contrast = 1e9, most_contrast = 0.0, thinnest = 1e9, thickest = 0.0;
    int with_arteries = 0, with_tumours = 0;
    constexpr int patients = 300;
    for (std::uint64_t seed = 1; seed <= patients; ++seed) {
        const PhantomOptions patient = random_patient(seed);
        EXPECT_NO_THROW(validate(patient.disturbances)) << seed;
        EXPECT_GE(patient.noise_hu, 5.0);
        EXPECT_LE(patient.noise_hu, 30.0);
        const double ratio = *patient.hepatic_contrast_hu / patient.contrast_hu;
        EXPECT_GE(ratio, 0.3);
        EXPECT_LE(ratio, 1.1);
        least_contrast = std::min(least_contrast, patient.contrast_hu);
        most_contrast = std::max(most_contrast, patient.contrast_hu);
        thinnest = std::min(thinnest, patient.spacing_mm[2]);
        thickest = std::max(thickest, patient.spacing_mm[2]);
        with_arteries += patient.disturbances.artery_share > 0.0;
        with_tumours += patient.disturbances.tumours > 0;
    }
    EXPECT_LT(least_contrast, 25.0);
    EXPECT_GT(most_contrast, 105.0);
    EXPECT_GE(least_contrast, 20.0);
    EXPECT_LE(most_contrast, 110.0);
    EXPECT_LT(thinnest, 0.8);
    EXPECT_GT(thickest, 4.5);
    EXPECT_NEAR(with_arteries, patients / 2, 40);
    EXPECT_NEAR(with_tumours, patients / 2, 40);
}

TEST(RandomPatient, IsTheSameForOneSeedAndAnotherForTheNext) {
    EXPECT_EQ(random_patient(5).contrast_hu, random_patient(5).contrast_hu);
    EXPECT_EQ(random_patient(5).disturbances, random_patient(5).disturbances);
    EXPECT_NE(random_patient(5).contrast_hu, random_patient(6).contrast_hu);
}

TEST(SloppyLiver, IsOffByAFewMillimetres) {
    Grid grid;
    grid.dims = {80, 80, 80};
    grid.spacing_mm = Vec3::Constant(1.5);
    Mask liver(grid);
    for (std::size_t i = 0; i < liver.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        liver.voxels[i] = (Vec3(at[0], at[1], at[2]) - Vec3::Constant(40.0)).norm() < 28.0;
    }
    Job job;
    const FloatVolume border = signed_distance(liver, job);
    double most = 0.0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Mask drawn = sloppy_liver(liver, seed, job);
        std::size_t different = 0;
        for (std::size_t i = 0; i < drawn.voxels.size(); ++i) {
            if (drawn.voxels[i] == liver.voxels[i]) continue;
            ++different;
            most = std::max(most, static_cast<double>(std::abs(border.voxels[i])));
        }
        EXPECT_GT(different, 500u) << seed;
    }
    EXPECT_LT(most, 8.0);
}

}  // namespace
}  // namespace hepatica
