// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/chosen_vessels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/morphology.h"
#include "core/phantom/phantom.h"

namespace hepatica {
namespace {

// Says the same of every piece.
LinkModel model_of(double share, double line_share = 0.8) {
    LinkModel model;
    model.line_share = line_share;
    model.kept_share = 0.5;
    model.forest.trees = {{{-1, share, -1, -1}}};
    return model;
}

// Keeps what rises by so many deviations of the noise.
LinkModel model_of_rise(double deviations) {
    LinkModel model = model_of(0.0);
    model.forest.trees = {{{0, deviations, 1, 2}, {-1, 0.0, -1, -1}, {-1, 1.0, -1, -1}}};
    return model;
}

class ChosenVessels : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        PhantomOptions options;
        options.dims = {128, 128, 80};
        options.spacing_mm = Vec3(1.4, 1.4, 1.6);
        options.generations = 5;
        options.noise_hu = 16.0;
        Job job;
        phantom_ = new Phantom(make_phantom(options, job));
    }
    static void TearDownTestSuite() {
        delete phantom_;
        phantom_ = nullptr;
    }

    static Segmentation segment(std::optional<LinkModel> model) {
        SegmentationOptions options;
        options.liver = phantom_->liver;
        options.spacing_mm = 1.0;
        options.model = std::move(model);
        Job job;
        return segment_vessels(phantom_->ct, options, job);
    }
    static Segmentation segment_and_offer(const LinkModel& offers) {
        SegmentationOptions options;
        options.liver = phantom_->liver;
        options.spacing_mm = 1.0;
        options.offers = offers;
        Job job;
        return segment_vessels(phantom_->ct, options, job);
    }
    static std::size_t size(const Mask& mask) {
        return static_cast<std::size_t>(
            std::ranges::count_if(mask.voxels, [](auto v) { return v != 0; }));
    }

    static inline Phantom* phantom_ = nullptr;
};

TEST_F(ChosenVessels, AModelThatKeepsAllFindsWhatIsDetected) {
    const Segmentation plain = segment(std::nullopt);
    const Segmentation all = segment(model_of(1.0, 1.0));
    EXPECT_EQ(all.mask.voxels, plain.mask.voxels);
    EXPECT_EQ(all.statistics.vessel_hu, plain.statistics.vessel_hu);
}

TEST_F(ChosenVessels, FainterLinesAreFoundWhereTheModelKeepsThem) {
    EXPECT_GT(size(segment(model_of(1.0, 0.8)).mask), size(segment(model_of(1.0, 1.0)).mask));
}

TEST_F(ChosenVessels, AModelThatKeepsNothingLeavesAScanWithoutVessels) {
    try {
        segment(model_of(0.0));
        ADD_FAILURE() << "was not refused";
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("do not stand out"), std::string::npos);
    }
}

TEST_F(ChosenVessels, DropsWhatTheModelSays) {
    const std::size_t all = size(segment(model_of(1.0)).mask);
    const std::size_t bright = size(segment(model_of_rise(7.0)).mask);
    EXPECT_LT(bright, all);
    EXPECT_GT(bright, all / 4);
}

TEST_F(ChosenVessels, WhatIsOfferedChangesNothingOfWhatIsFound) {
    const Segmentation plain = segment(std::nullopt);
    EXPECT_TRUE(plain.offered.empty());
    const Segmentation asked = segment_and_offer(model_of(0.9, 0.7));
    EXPECT_EQ(asked.mask.voxels, plain.mask.voxels);
    EXPECT_EQ(asked.statistics.vessel_hu, plain.statistics.vessel_hu);
    EXPECT_FALSE(asked.offered.empty());
    EXPECT_TRUE(segment_and_offer(model_of(0.1, 0.7)).offered.empty()) << "taken for noise";
}

TEST_F(ChosenVessels, WhatIsOfferedLiesOutsideOfWhatIsFoundAndLeadsOutOfIt) {
    const Segmentation asked = segment_and_offer(model_of(0.9, 0.7));
    const auto is_in = [&](const Vec3& point_mm) {
        const auto voxel = voxel_at(asked.mask.grid, point_mm);
        return voxel && asked.mask.at((*voxel)[0], (*voxel)[1], (*voxel)[2]) != 0;
    };
    Job job;
    const Mask around = dilate(asked.mask, 2.0, job);
    int outside = 0, all = 0;
    for (const Bridge& branch : asked.offered) {
        const auto begin = voxel_at(around.grid, branch.path_mm.front());
        const bool on_another = std::ranges::any_of(asked.offered, [&](const Bridge& other) {
            return &other != &branch && std::ranges::any_of(other.path_mm, [&](const Vec3& p) {
                return (p - branch.path_mm.front()).norm() < 2.0;
            });
        });
        EXPECT_TRUE(on_another || around.at((*begin)[0], (*begin)[1], (*begin)[2]) != 0);
        for (const Vec3& point_mm : branch.path_mm) outside += is_in(point_mm) ? 0 : 1;
        all += static_cast<int>(branch.path_mm.size());
    }
    ASSERT_GT(all, 300);
    EXPECT_GT(outside, all * 3 / 4);
}

TEST_F(ChosenVessels, AreTheSameWithOneThread) {
    const Segmentation many = segment(model_of_rise(5.0));
    const std::string offered = bridges_to_json(segment_and_offer(model_of_rise(5.0)).offered);
    const ThreadLimit one(1);
    EXPECT_EQ(segment(model_of_rise(5.0)).mask.voxels, many.mask.voxels);
    EXPECT_EQ(bridges_to_json(segment_and_offer(model_of_rise(5.0)).offered), offered);
}

}  // namespace
}  // namespace hepatica
