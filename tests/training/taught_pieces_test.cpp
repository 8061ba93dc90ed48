// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/training/taught_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

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

// Real livers are found in one case and drawn in another: a model that was taught with one kind
// alone would choose otherwise.
TEST(TaughtPieces, AreOfTwoDrawnLiversForEachOneThatIsFound) {
    Job job;
    Phantom patient;
    patient.liver = Mask(Grid{{30, 30, 30}});
    const Grid& grid = patient.liver.grid;
    for (std::size_t i = 0; i < patient.liver.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        patient.liver.voxels[i] = (grid.to_mm(x, y, z) - grid.to_mm(14, 15, 15)).norm() < 10.0;
    }
    std::vector<Mask> drawn;
    for (std::uint64_t number = 1; number <= 6; ++number) {
        const SegmentationOptions options = options_taught_with(number, patient, job);
        ASSERT_EQ(options.liver.has_value(), number % 3 != 0) << number;
        EXPECT_FALSE(options.window_hu.has_value()) << number;
        if (options.liver) drawn.push_back(*options.liver);
    }
    for (const Mask& liver : drawn) {
        EXPECT_TRUE(same_grid(liver.grid, grid));
        EXPECT_NE(liver.voxels, patient.liver.voxels) << "it was not drawn sloppily";
        EXPECT_GT(std::ranges::count(liver.voxels, 1), 1000);
        EXPECT_EQ(std::ranges::count(drawn, liver.voxels, &Mask::voxels), 1)
            << "two patients have the same drawing";
    }
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

// Another patient, or one liver drawn like another's, would teach a model that is not of its seed.
TEST(TaughtPieces, AreOfThePatientAndTheLiverOfTheirNumber) {
    Job job;
    std::vector<PhantomOptions> asked;
    const PatientMaker make = [&](const PhantomOptions& options, Job& making) {
        asked.push_back(options);
        return make_phantom(small_patient(options.seed), making);
    };
    const auto taught = taught_by_made(make, 5, 0.75, job);
    const PhantomOptions chosen = random_patient(5);
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].seed, 5u);
    EXPECT_EQ(asked[0].contrast_hu, chosen.contrast_hu);
    EXPECT_EQ(asked[0].dims, chosen.dims);
    EXPECT_EQ(asked[0].disturbances, chosen.disturbances);
    const Phantom patient = make_phantom(small_patient(5), job);
    SegmentationOptions options;
    options.liver = sloppy_liver(patient.liver, 5, job);
    const auto expected = taught_on(patient, options, 0.75, job);
    ASSERT_EQ(taught.size(), expected.size());
    ASSERT_FALSE(taught.empty());
    for (std::size_t i = 0; i < taught.size(); ++i) {
        EXPECT_EQ(taught[i].features, expected[i].features);
        EXPECT_EQ(taught[i].share, expected[i].share);
    }
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
