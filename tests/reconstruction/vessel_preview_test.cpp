// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/vessel_preview.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "core/base/error.h"
#include "core/image/morphology.h"
#include "core/segmentation/gaussian_refinement.h"
#include "tests/reconstruction/noisy_patient.h"
#include "tests/support/falls_of_progress.h"

namespace hepatica {
namespace {

constexpr std::uint8_t gained = 200;

class Preview : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        Job job;
        patient_ =
            std::make_unique<testing_support::NoisyPatient>(testing_support::noisy_patient());
        preview_ = std::make_unique<VesselPreview>(patient_->truth.ct, patient_->organs, job);
    }
    static void TearDownTestSuite() {
        preview_.reset();
        patient_.reset();
    }

    static const Mask& present() { return patient_->found; }
    static const Phantom& truth() { return patient_->truth; }
    static Mask vessels(const ThresholdChoice& choice, const Mask& present = Preview::present()) {
        Job job;
        return preview_->vessels(present, choice, gained, job);
    }
    static std::size_t count(const Mask& mask) {
        return static_cast<std::size_t>(
            std::ranges::count_if(mask.voxels, [](auto voxel) { return voxel != 0; }));
    }

    static inline std::unique_ptr<testing_support::NoisyPatient> patient_;
    static inline std::unique_ptr<VesselPreview> preview_;
};

TEST_F(Preview, ChangesNothingAtTheUsualThreshold) {
    EXPECT_EQ(vessels({}).voxels, present().voxels);
}

TEST_F(Preview, BringsMoreBelowTheUsualAndMarksIt) {
    std::size_t before = count(present());
    Mask smaller = present();
    for (const double share : {0.95, 0.85, 0.75}) {
        const Mask found = vessels({share, 0});
        for (std::size_t i = 0; i < found.voxels.size(); ++i) {
            ASSERT_EQ(found.voxels[i], present().voxels[i] ? present().voxels[i] : found.voxels[i]);
            ASSERT_TRUE(found.voxels[i] == 0 || found.voxels[i] == gained || present().voxels[i]);
            ASSERT_TRUE(found.voxels[i] || !smaller.voxels[i]) << "less than at a higher share";
        }
        EXPECT_GT(count(found), before) << share;
        before = count(found);
        smaller = found;
    }
}

TEST_F(Preview, DropsTheFaintestAboveTheUsual) {
    std::size_t before = count(present());
    for (const double share : {1.1, 1.2, 1.35}) {
        const Mask found = vessels({share, 0});
        for (std::size_t i = 0; i < found.voxels.size(); ++i)
            ASSERT_TRUE(found.voxels[i] == 0 || found.voxels[i] == present().voxels[i]);
        EXPECT_LT(count(found), before) << share;
        EXPECT_GT(count(found), 0u);
        const auto smallest = connected_components(found, Connectivity::all26).sizes.back();
        EXPECT_GE(static_cast<double>(smallest) * found.grid.spacing_mm.prod(), 20.0) << "a crumb";
        before = count(found);
    }
}

// No wall grows by a lower threshold: whatever comes in lies at a piece of it beyond the walls.
TEST_F(Preview, BringsNoSkins) {
    Job job;
    const Mask found = vessels({0.75, 0});
    const Mask about = dilate(present(), 1.3, job);
    Mask beyond = found;
    for (std::size_t i = 0; i < beyond.voxels.size(); ++i)
        beyond.voxels[i] = found.voxels[i] == gained && !about.voxels[i];
    const Mask near = dilate(beyond, 2.0, job);
    std::size_t come_in = 0, skin = 0;
    for (std::size_t i = 0; i < found.voxels.size(); ++i) {
        if (found.voxels[i] != gained) continue;
        ++come_in;
        skin += !near.voxels[i];
    }
    EXPECT_GT(come_in, 1000u);
    EXPECT_EQ(skin, 0u);
}

// Judged by the truth: the share of the centrelines that lie in vessels rises, and what comes in
// lies at one more often than by chance.
TEST_F(Preview, WhatComesInAreVessels) {
    const auto covered = [](const Mask& mask) {
        std::size_t inside = 0, all = 0;
        for (const VesselSegment& vessel : truth().tree.segments)
            for (const Vec3& place : vessel.points_mm) {
                ++all;
                inside += value_at(mask, place) != 0;
            }
        return static_cast<double>(inside) / static_cast<double>(all);
    };
    const double usual = covered(present());
    EXPECT_GT(covered(vessels({0.75, 0})), usual + 0.02);
    EXPECT_LT(covered(vessels({1.35, 0})), usual - 0.02);
    // What is found already is most of this patient: chance is what is left of him in the liver.
    Job job;
    const Mask vicinity = dilate(truth().vessels, 1.0, job);
    const Mask found = vessels({0.75, 0});
    std::size_t right = 0, all = 0, missed = 0, tissue = 0;
    for (std::size_t i = 0; i < found.voxels.size(); ++i) {
        const Index3 at = found.grid.index_of(i);
        const Vec3 place = found.grid.to_mm(at[0], at[1], at[2]);
        if (present().voxels[i] || !value_at(truth().liver, place)) continue;
        const bool vessel = value_at(vicinity, place) != 0;
        ++tissue;
        missed += vessel;
        all += found.voxels[i] == gained;
        right += found.voxels[i] == gained && vessel;
    }
    const double chance = static_cast<double>(missed) / static_cast<double>(tissue);
    EXPECT_GT(static_cast<double>(right), 3.0 * chance * static_cast<double>(all))
        << right << " of " << all << ", by chance " << chance;
}

// A dab of the brush that is smaller than any crumb, where no vessel was ever found.
TEST_F(Preview, KeepsADabThatItDoesNotDrop) {
    Job job;
    const Mask about = dilate(preview_->vessels(present(), {0.75, 0}, gained, job), 8.0, job);
    Mask dabbed = present();
    std::size_t dab = dabbed.voxels.size();
    for (std::size_t i = 0; i < about.voxels.size() && dab == dabbed.voxels.size(); ++i)
        if (!about.voxels[i]) dab = i;
    ASSERT_LT(dab, dabbed.voxels.size());
    dabbed.voxels[dab] = 3;
    Mask expected = vessels({1.2, 0});
    expected.voxels[dab] = 3;
    EXPECT_EQ(vessels({1.2, 0}, dabbed).voxels, expected.voxels);
}

TEST_F(Preview, SmoothsAsTheReconstructionDoes) {
    Job job;
    EXPECT_EQ(vessels({1.0, 2}).voxels, refine(present(), 2, job).voxels);
}

// A person's voxels may lie on another grid, and hold what no search finds.
TEST_F(Preview, KeepsWhatSomebodyPaintedOnAnyGrid) {
    Grid coarse = present().grid;
    coarse.spacing_mm *= 2.0;
    for (int& dim : coarse.dims) dim = (dim + 1) / 2;
    const Mask painted(coarse, 3);
    EXPECT_EQ(vessels({0.75, 0}, painted).voxels, painted.voxels);
    const Mask found = vessels({0.75, 0}, Mask(coarse));
    EXPECT_GT(count(found), 0u);
    const Mask fine = vessels({0.75, 0}, Mask(present().grid));
    for (std::size_t i = 0; i < found.voxels.size(); ++i) {
        const Index3 at = coarse.index_of(i);
        ASSERT_EQ(found.voxels[i], fine.at(2 * at[0], 2 * at[1], 2 * at[2]));
    }
}

TEST_F(Preview, RefusesWhatNoThresholdCanBe) {
    for (const double share : {0.74, 1.36, -1.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(vessels({share, 0}), InputError) << share;
    for (const int recursions : {-1, 11}) EXPECT_THROW(vessels({1.0, recursions}), InputError);
}

TEST_F(Preview, ItsProgressNeverFallsBack) {
    for (const double share : {0.8, 1.2}) {
        Job job;
        const test::FallsOfProgress falls(job);
        preview_->vessels(present(), {share, 2}, gained, job);
        EXPECT_TRUE(falls.stages().empty()) << share;
        EXPECT_GT(falls.reports(), 10) << share;
    }
}

TEST_F(Preview, HearsACancel) {
    Job job;
    job.cancel();
    EXPECT_THROW(preview_->vessels(present(), {0.8, 0}, gained, job), Cancelled);
    EXPECT_THROW(VesselPreview(truth().ct, Mask(), job), Cancelled);
}

}  // namespace
}  // namespace hepatica
