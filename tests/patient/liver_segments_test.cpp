// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/liver_segments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/mesh/surface.h"
#include "core/mesh/tetrahedralize.h"
#include "core/patient/corrections.h"
#include "core/patient/doubts_json.h"
#include "core/tree/territories/couinaud_segments.h"
#include "tests/tree/territories/textbook_portal.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

PatientCase patient_with_liver() {
    auto textbook =
        test::textbook_patient(test::PortalType::usual, true, test::liver_of_phantom(4.0));
    PatientCase patient;
    patient.tree = std::move(textbook.tree);
    patient.organs = std::move(textbook.liver);
    patient.doubts = doubts_of(patient.tree);
    patient.source.parameters_json = R"({"mesh":{"target_tetrahedra":1500}})";
    Job job;
    patient.mesh = tetrahedralize(patient.tree, {.target_tetrahedra = 1500}, job);
    patient.surface = surface_of(patient.mesh).mesh;
    return patient;
}

TEST(LiverSegments, AreKeptInTheCaseWithTheirVolumes) {
    PatientCase patient = patient_with_liver();
    patient.organs.at(20, 20, 20) = organ_label::first_tumour;
    patient.organs.at(0, 0, 0) = organ_label::cava;
    Job job;
    label_segments(patient, job);
    EXPECT_EQ(patient.couinaud.at(0, 0, 0), 0);  // the cava is no liver
    EXPECT_NE(patient.couinaud.at(20, 20, 20), 0);
    const fs::path folder = fs::path(testing::TempDir()) / "segments.hep";
    fs::remove_all(folder);
    write_case(folder, patient);
    std::ifstream file(folder / "case.json");
    const auto json = nlohmann::json::parse(file);
    const auto volumes = segment_volumes_ml(patient.couinaud);
    ASSERT_EQ(json.at("segments_ml").size(), 8u);
    for (int k = 1; k <= 8; ++k)
        EXPECT_EQ(json.at("segments_ml").at(std::to_string(k)).get<double>(), volumes[k - 1]);
    EXPECT_TRUE(json.at("sha256").contains("couinaud.nii.gz"));
    const PatientCase back = read_case(folder);
    EXPECT_EQ(back.couinaud.voxels, patient.couinaud.voxels);
    EXPECT_TRUE(same_grid(back.couinaud.grid, patient.organs.grid));
    ASSERT_TRUE(back.doubts->segments.has_value());
    EXPECT_EQ(json_of(*back.doubts), json_of(*patient.doubts));
    EXPECT_EQ(back.doubts->segments->veins_known, 3);
    fs::remove_all(folder);
}

TEST(LiverSegments, NeedALiverAndAPortalVein) {
    PatientCase patient = patient_with_liver();
    Job job;
    label_segments(patient, job);
    const Mask whole = patient.couinaud;
    const Mask organs = std::exchange(patient.organs, {});
    label_segments(patient, job);  // as read without voxels: nothing is known, nothing changes
    EXPECT_EQ(patient.couinaud.voxels, whole.voxels);
    patient.organs = organs;
    for (VesselSegment& segment : patient.tree.segments) segment.system = VascularSystem::unknown;
    label_segments(patient, job);
    EXPECT_TRUE(patient.couinaud.voxels.empty());
    EXPECT_FALSE(patient.doubts->segments.has_value());
}

// A branch that is taken away no longer supplies anything; undoing gives the same bytes again.
TEST(LiverSegments, FollowTheEdits) {
    PatientCase patient = patient_with_liver();
    Job job;
    label_segments(patient, job);
    TreeEdit edit;
    edit.kind = TreeEditKind::delete_branch;
    edit.at_mm = Vec3(-22, 12, 4);  // the caudate branch
    const PatientCase edited = with_edits(patient, {edit}, job);
    EXPECT_EQ(segment_volumes_ml(edited.couinaud)[0], 0.0);
    EXPECT_EQ(edited.doubts->segments->without_branch, std::vector<int>{1});
    EXPECT_EQ(with_edits(edited, {}, job).couinaud.voxels, patient.couinaud.voxels);
}

TEST(LiverSegments, WhatIsUnsureIsSaidInWords) {
    Doubts doubts;
    doubts.segments = SegmentDoubts{};
    doubts.segments->veins_known = 3;
    EXPECT_TRUE(sentences(doubts).empty());
    doubts.segments->unsure_share = 0.25;
    doubts.segments->without_branch = {1, 3};
    doubts.segments->veins_known = 2;
    const auto told = sentences(doubts);
    ASSERT_EQ(told.size(), 3u);
    EXPECT_NE(told[0].find("Not all three hepatic veins"), std::string::npos);
    EXPECT_NE(told[1].find("segments I and III"), std::string::npos);
    EXPECT_NE(told[2].find("25 % of the liver"), std::string::npos);
}

// Segments of a liver that nobody drew may reach into its neighbours.
TEST(LiverSegments, OfALiverThatTheProgramFoundAreDoubted) {
    for (const bool given : {true, false}) {
        PatientCase patient = patient_with_liver();
        patient.source.parameters_json =
            given ? R"({"liver_mask_given":true})" : R"({"liver_mask_given":false})";
        Job job;
        label_segments(patient, job);
        ASSERT_TRUE(patient.doubts->segments.has_value());
        EXPECT_EQ(patient.doubts->segments->liver_found, !given);
        const auto told = sentences(*patient.doubts);
        const auto names_it = [](const std::string& sentence) {
            return sentence.find("give a mask of the liver") != std::string::npos;
        };
        EXPECT_EQ(std::ranges::count_if(told, names_it), given ? 0 : 1);
        EXPECT_EQ(json_of(doubts_from(json_of(*patient.doubts))), json_of(*patient.doubts));
    }
}

TEST(LiverSegments, AParameterOfTheWrongTypeIsNamed) {
    PatientCase patient = patient_with_liver();
    patient.source.parameters_json = R"({"liver_mask_given":"perhaps"})";
    Job job;
    try {
        label_segments(patient, job);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "case.json");
        EXPECT_EQ(error.problem(),
                  "its parameter liver_mask_given is \"perhaps\", not true or false");
    }
}

}  // namespace
}  // namespace hepatica
