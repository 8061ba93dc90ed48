// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/vessel_segmentation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/patient/doubts.h"
#include "core/phantom/phantom.h"
#include "core/phantom/phantom_growth.h"
#include "core/segmentation/liver_region.h"
#include "core/segmentation/tissue_contrast.h"
#include "tests/reconstruction/segmentation_score.h"

namespace hepatica {
namespace {

using namespace testing_support;

PhantomOptions small_phantom() {
    PhantomOptions options;
    options.dims = {128, 128, 80};
    options.spacing_mm = Vec3(1.4, 1.4, 1.6);
    options.generations = 5;
    return options;
}

Segmentation segment(const Patient& patient, bool with_liver = true,
                     SegmentationMethod method = SegmentationMethod::coherent) {
    SegmentationOptions options;
    options.method = method;
    if (with_liver) options.liver = patient.liver;
    Job job;
    return segment_vessels(patient.ct, options, job);
}

TEST(VesselSegmentation, FindsThePhantomsTree) {
    Job job;
    const Patient patient = phantom_patient(1, 1.0, job);
    const Segmentation found = segment(patient);
    const Score s = score(found.mask, patient, job);
    EXPECT_GE(s.dice, 0.88);
    EXPECT_GE(s.cldice, 0.93);
    EXPECT_NEAR(found.statistics.parenchyma_hu, 110.0, 3.0);
    EXPECT_NEAR(found.statistics.contrast_hu(), 65.0, 10.0);
    EXPECT_TRUE(found.warnings.empty());
}

TEST(VesselSegmentation, FindsTheTreeOnAScanOfHardlyAnyNoiseOrNone) {
    Job job;
    for (const double noise : {0.0, 3.0}) {
        SCOPED_TRACE(noise);
        PhantomOptions options;
        options.noise_hu = noise;
        const Patient patient = phantom_patient(options, job);
        EXPECT_GE(score(segment(patient).mask, patient, job).dice, 0.88);
    }
}

TEST(VesselSegmentation, WarnsWhereThinBranchesDrownInNoise) {
    Job job;
    PhantomOptions options = small_phantom();
    options.noise_hu = 40.0;
    const Phantom phantom = make_phantom(options, job);
    SegmentationOptions choice;
    choice.liver = phantom.liver;
    const Segmentation found = segment_vessels(phantom.ct, choice, job);
    const auto told = sentences(
        {.contrast_hu = found.statistics.contrast_hu(), .noise_hu = found.statistics.noise_hu});
    EXPECT_TRUE(std::ranges::any_of(told, [](const std::string& sentence) {
        return sentence.find("thin branches are missing") != std::string::npos;
    }));
}

TEST(VesselSegmentation, NamesTheWindowWhereItHoldsNoVessels) {
    Job job;
    const Phantom phantom = make_phantom(small_phantom(), job);
    SegmentationOptions options;
    options.liver = phantom.liver;
    options.window_hu = {200.0, 210.0};
    try {
        segment_vessels(phantom.ct, options, job);
        FAIL() << "a window above all vessels was taken";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("between 200 and 210 HU"), std::string::npos)
            << error.what();
    }
}

// Half of the liver and more would be vessels, a tangle that takes minutes.
TEST(VesselSegmentation, RefusesAWindowThatTakesInTheTissueBeforeItLooksForVessels) {
    Job setup;
    const Phantom phantom = make_phantom(small_phantom(), setup);
    SegmentationOptions options;
    options.liver = phantom.liver;
    options.spacing_mm = 1.4;
    options.window_hu = {90.0, 300.0};  // the tissue has 110 HU
    Job job;
    try {
        segment_vessels(phantom.ct, options, job);
        FAIL() << "tissue was taken for vessels";
    } catch (const InputError& error) {
        EXPECT_TRUE(error.problem().starts_with(
            "the window from 90 to 300 HU takes in the liver's own tissue, which has 1"))
            << error.problem();
        EXPECT_EQ(error.place(), "window");
    }
    EXPECT_EQ(job.progress().stage, "Measuring the contrast");
}

TEST(VesselSegmentation, LeavesOutOtherOrgansWhereTheLiverIsNotGiven) {
    Job job;
    const Patient patient = phantom_patient(1, 1.0, job);
    const Segmentation found = segment(patient, false);
    EXPECT_EQ(found.components, 1);
    EXPECT_GE(score(found.mask, patient, job).dice, 0.85);
}

// A liver of 48 mm in radius and a spleen of the same intensity that touches it, in fat, with a
// vessel in each that stays clear of the other organ.
struct LiverAndSpleen {
    Volume ct;
    Vec3 liver_mm{115, 75, 80};
    Vec3 spleen_mm = liver_mm + 76.0 * Vec3(0.862, 0.431, -0.259);
};

LiverAndSpleen liver_and_spleen(Job& job) {
    LiverAndSpleen body;
    Grid grid;
    grid.dims = {150, 110, 105};
    grid.spacing_mm = Vec3::Constant(1.5);
    body.ct = Volume(grid, -100);
    const Vec3 liver = body.liver_mm, spleen = body.spleen_mm, up(0, 0, 1), across(1, 0, 0);
    for (std::size_t i = 0; i < body.ct.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p = grid.to_mm(x, y, z);
        if ((p - liver).norm() < 48.0 || (p - spleen).norm() < 28.0 ||
            distance_between(p, p, liver, spleen) < 13.0)
            body.ct.voxels[i] = 110;
        if (distance_between(p, p, liver - 30.0 * up, liver + 30.0 * up) < 4.0 ||
            distance_between(p, p, liver, liver - 30.0 * across) < 3.0 ||
            distance_between(p, p, spleen - 18.0 * up, spleen + 18.0 * up) < 3.0)
            body.ct.voxels[i] = 180;
    }
    add_noise(body.ct, 6.0, 1, job);
    return body;
}

TEST(VesselSegmentation, LeavesOutLooseVesselsOfAnOrganThatTouchesTheLiver) {
    Job job;
    const LiverAndSpleen body = liver_and_spleen(job);
    const FoundLiver region = find_liver(body.ct, job);
    ASSERT_EQ(value_at(region.vessel_region, body.spleen_mm), 1) << "it is looked at";
    ASSERT_EQ(value_at(region.liver, body.spleen_mm), 0) << "and is no liver";
    const Segmentation found = segment_vessels(body.ct, SegmentationOptions{}, job);
    EXPECT_NE(value_at(found.mask, body.liver_mm), 0);
    EXPECT_EQ(value_at(found.mask, body.spleen_mm), 0);
    SegmentationOptions given;
    given.liver = region.vessel_region;
    EXPECT_NE(value_at(segment_vessels(body.ct, given, job).mask, body.spleen_mm), 0)
        << "whoever gives a liver means all of it";
}

TEST(VesselSegmentation, KeepsTheTreeTogetherWhereSlicesAreThreeMillimetresApart) {
    Job job;
    const Patient patient = phantom_patient(1, 3.0, job);
    const Segmentation found = segment(patient);
    EXPECT_GE(length_found(found.mask, patient, 1.2, 2.0, job), 0.95);
    ASSERT_EQ(found.warnings.size(), 1u);
    EXPECT_NE(found.warnings[0].find("3.0 mm"), std::string::npos);
}

TEST(VesselSegmentation, ByLayersFindsTheTreeAndItsCentreline) {
    Job job;
    const Patient patient = phantom_patient(2, 1.0, job);
    const Segmentation found = segment(patient, true, SegmentationMethod::multi_layer);
    EXPECT_GE(score(found.mask, patient, job).dice, 0.70);
    EXPECT_GE(length_found(found.mask, patient, 1.2, 2.0, job), 0.95);
    std::size_t points = 0;
    for (std::size_t i = 0; i < found.mask.voxels.size(); ++i) {
        points += found.centreline.voxels[i] != 0;
        EXPECT_LE(found.centreline.voxels[i], found.mask.voxels[i]);
    }
    EXPECT_GT(points, 500u);
}

TEST(VesselSegmentation, ReachesItsFloorsOnARealPatient) {
    if (!std::filesystem::exists(data_folder() / "ircadb01_case01"))
        GTEST_SKIP() << "no test data in " << data_folder();
    Job job;
    const Patient patient = ircadb_patient(job);
    const Score s = score(segment(patient).mask, patient, job);
    EXPECT_GE(s.dice, 0.705);
    EXPECT_GE(s.cldice, 0.70);
}

TEST(VesselSegmentation, FindsTheLiverOfARealPatientAndItsVesselsByItself) {
    if (!std::filesystem::exists(data_folder() / "ircadb01_case01"))
        GTEST_SKIP() << "no test data in " << data_folder();
    Job job;
    const Patient patient = ircadb_patient(job);
    const Segmentation found = segment(patient, false);
    EXPECT_GE(score(found.mask, patient, job).dice, 0.70);
    Patient organ = patient;
    organ.truth = patient.judged;
    organ.judged = Mask(patient.ct.grid, 1);
    EXPECT_GE(score(found.liver, organ, job).dice, 0.87);
}

TEST(VesselSegmentation, ReachesItsFloorsOnThePhantomOfAnotherHand) {
    if (!std::filesystem::exists(data_folder() / "vascusynth"))
        GTEST_SKIP() << "no test data in " << data_folder();
    Job job;
    const Patient patient = vascusynth_patient(job);
    const Segmentation found = segment(patient);
    EXPECT_GE(score(found.mask, patient, job).dice, 0.85);
    EXPECT_GE(length_found(found.mask, patient, 1.2, 2.0, job), 0.97);
}

TEST(VesselSegmentation, RefusesAScanWithoutContrastInWords) {
    for (const double noise : {5.0, 10.0, 25.0}) {
        PhantomOptions options = small_phantom();
        options.contrast_hu = 0.0;
        options.noise_hu = noise;
        Job job;
        const Phantom phantom = make_phantom(options, job);
        SegmentationOptions how;
        how.liver = phantom.liver;
        how.spacing_mm = 1.4;
        for (const auto method : {SegmentationMethod::coherent, SegmentationMethod::multi_layer,
                                  SegmentationMethod::vesselness}) {
            how.method = method;
            try {
                segment_vessels(phantom.ct, how, job);
                ADD_FAILURE() << "a tree of noise at " << noise << " HU";
            } catch (const InputError& error) {
                EXPECT_NE(error.problem().find("do not stand out"), std::string::npos);
                EXPECT_NE(error.problem().find("noise is"), std::string::npos);
                EXPECT_NE(error.remedy().find("contrast medium"), std::string::npos);
            }
        }
    }
}

TEST(VesselSegmentation, IsTheSameForAnyNumberOfThreads) {
    Job job;
    const Phantom phantom = make_phantom(small_phantom(), job);
    SegmentationOptions options;
    options.liver = phantom.liver;
    options.spacing_mm = 1.4;
    for (const auto method : {SegmentationMethod::coherent, SegmentationMethod::multi_layer,
                              SegmentationMethod::vesselness}) {
        options.method = method;
        std::vector<std::uint8_t> one;
        {
            const ThreadLimit limit(1);
            one = segment_vessels(phantom.ct, options, job).mask.voxels;
        }
        EXPECT_EQ(one, segment_vessels(phantom.ct, options, job).mask.voxels);
    }
}

TEST(VesselSegmentation, TakesTheUsersWindowAndRefusesAnEmptyOne) {
    Job job;
    const Phantom phantom = make_phantom(small_phantom(), job);
    SegmentationOptions options;
    options.liver = phantom.liver;
    options.spacing_mm = 1.4;
    options.window_hu = {{140.0, 300.0}};
    EXPECT_GT(segment_vessels(phantom.ct, options, job).components, 0);
    options.window_hu = {{300.0, 140.0}};
    EXPECT_THROW(segment_vessels(phantom.ct, options, job), InputError);
}

// Cancelled at the first, the last and some of the times between at which it asks; it asks hardly
// once more.
TEST(VesselSegmentation, StopsWhereverItIsCancelled) {
    Job setup;
    const Phantom phantom = make_phantom(small_phantom(), setup);
    SegmentationOptions options;
    options.liver = phantom.liver;
    options.spacing_mm = 1.4;
    std::atomic<int> asked{0};
    Job whole;
    whole.observe([&](JobEvent) { ++asked; });
    segment_vessels(phantom.ct, options, whole);
    const int all = asked;
    ASSERT_GT(all, 20);
    for (const int last : {1, all / 4, all / 2, 3 * all / 4, all - 1}) {
        Job job;
        asked = 0;
        job.observe([&](JobEvent) {
            if (++asked == last) job.cancel();
        });
        EXPECT_THROW(segment_vessels(phantom.ct, options, job), Cancelled) << last << " of " << all;
        EXPECT_LT(asked, last + 20) << "threads beside it may ask once each";
    }
}

TEST(TissueContrast, MeasuresTheNoiseAndAnUnevenParenchyma) {
    Grid grid;
    grid.dims = {80, 80, 80};
    FloatVolume intensity(grid);
    Mask liver(grid);
    std::uint32_t state = 1;
    for (std::size_t i = 0; i < intensity.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        double noise = -6.0;  // twelve uniform numbers: normal enough
        for (int k = 0; k < 12; ++k) {
            state = state * 1664525u + 1013904223u;
            noise += (state >> 8) * 0x1p-24;
        }
        const bool vessel = (at[0] - 40) * (at[0] - 40) + (at[1] - 40) * (at[1] - 40) < 16;
        intensity.voxels[i] =
            static_cast<float>(100.0 + 0.5 * at[0] + 8.0 * noise + (vessel ? 60.0 : 0.0));
        liver.voxels[i] =
            std::min({at[0], at[1], at[2]}) > 3 && std::max({at[0], at[1], at[2]}) < 76;
    }
    Job job;
    const TissueContrast tissue = measure_tissue(intensity, liver, job);
    EXPECT_NEAR(tissue.noise_hu, 8.0, 0.5);
    EXPECT_NEAR(tissue.parenchyma_hu, 120.0, 2.0);
    double in_vessel = 0.0;
    for (int z = 20; z < 60; ++z) in_vessel += tissue.excess.at(40, 40, z) / 40.0;
    EXPECT_NEAR(in_vessel, 60.0, 5.0);
}

}  // namespace
}  // namespace hepatica
