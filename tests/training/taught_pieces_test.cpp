// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/training/taught_pieces.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/phantom/random_patient.h"
#include "core/segmentation/organ_surroundings.h"

namespace hepatica {
namespace {

// A random patient's tissue and noise in a small field of view.
PhantomOptions small_patient(std::uint64_t seed) {
    PhantomOptions options = random_patient(seed);
    options.dims = {110, 90, 60};
    options.spacing_mm = {1.2, 1.2, 1.6};
    options.generations = 5;
    options.contrast_hu = 80.0;
    options.noise_hu = 9.0;
    return options;
}

TEST(SharesOfTruth, CountPointsWithinTwoMillimetres) {
    VesselTree truth;
    truth.nodes = {{Vec3(0, 0, 0), 1.0}, {Vec3(20, 0, 0), 1.0}};
    VesselSegment line;
    line.proximal_node = 0;
    line.distal_node = 1;
    line.points_mm = {Vec3(0, 0, 0), Vec3(20, 0, 0)};
    line.radii_mm = {1.0, 1.0};
    truth.segments = {line};
    LinePiece along, leaving, apart;
    for (int i = 0; i < 10; ++i) {
        along.points_mm.push_back(Vec3(i, 1.9, 0));
        leaving.points_mm.push_back(Vec3(10, 0.5 * i + 0.1, 0));  // four within 2 mm
        apart.points_mm.push_back(Vec3(i, 2.1, 0));
    }
    const auto shares = shares_of_truth({along, leaving, apart}, truth);
    EXPECT_FLOAT_EQ(shares[0], 1.0f);
    EXPECT_FLOAT_EQ(shares[1], 0.4f);
    EXPECT_FLOAT_EQ(shares[2], 0.0f);
}

TEST(TaughtPieces, HoldVesselsAndWhatIsNone) {
    Job job;
    const Phantom patient = make_phantom(small_patient(3), job);
    SegmentationOptions options;
    options.liver = patient.liver;
    const auto taught = taught_on(patient, options, 0.6, job);
    ASSERT_GT(taught.size(), 60u);
    int vessels = 0, none = 0;
    for (const TaughtPiece& piece : taught) {
        vessels += piece.share > 0.8f;
        none += piece.share < 0.2f;
    }
    EXPECT_GT(vessels, 30);
    EXPECT_GT(none, 5);
}

TEST(TaughtPieces, AreRefusedWithoutALiver) {
    Job job;
    Phantom patient;
    patient.ct = Volume(Grid{{40, 40, 40}}, -100);
    EXPECT_THROW(taught_on(patient, {}, 0.6, job), NoLiverFound);
    SegmentationOptions options;
    options.liver = Mask(patient.ct.grid);
    EXPECT_THROW(taught_on(patient, options, 0.6, job), InputError) << "the given one is empty";
}

TEST(TaughtPieces, AreTheSameWithOneThread) {
    Job job;
    const auto teach = [&] {
        const Phantom patient = make_phantom(small_patient(4), job);
        SegmentationOptions options;
        options.liver = sloppy_liver(patient.liver, 4, job);
        return taught_on(patient, options, 0.75, job);
    };
    const auto many = teach();
    const ThreadLimit one(1);
    const auto single = teach();
    ASSERT_EQ(many.size(), single.size());
    ASSERT_FALSE(many.empty());
    for (std::size_t i = 0; i < many.size(); ++i) {
        EXPECT_EQ(many[i].features, single[i].features);
        EXPECT_EQ(many[i].share, single[i].share);
    }
}

}  // namespace
}  // namespace hepatica
