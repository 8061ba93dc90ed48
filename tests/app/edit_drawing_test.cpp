// SPDX-License-Identifier: GPL-3.0-or-later
// A vessel that the tree lacks, drawn by places in the CT through the real program.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/image/volume_writer.h"
#include "tests/app/tour.h"
#include "tests/patient/parted_patient.h"
#include "tests/support/tube_ct.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::answer;
using test::Json;
using test::run_cli;

class EditDrawing : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        write_case(case_, test::patient_with_bridges());
        write_nifti(ct_, test::tube_ct());
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_ = fs::path(testing::TempDir()) / "edit drawing";
    fs::path case_ = folder_ / "p.hep";
    fs::path ct_ = folder_ / "ct.nii.gz";
};

TEST_F(EditDrawing, PutsTheVesselIntoTheTreeAndTakesItBack) {
    const std::size_t before = read_case(case_).tree.segments.size();
    const Json said = answer(
        {"edit", case_.string(), "--draw", "1,10,1.5,18,7,1.5,34,4,1.5", "--ct", ct_.string()});
    ASSERT_EQ(said.at("edits").size(), 1u);
    EXPECT_EQ(said.at("edits")[0].at("edit"), "draw_vessel");
    const PatientCase drawn = read_case(case_);
    EXPECT_EQ(drawn.tree.segments.size(), before + 2);  // the trunk has a fork more
    const TreePoint tip = nearest_point(drawn.tree, test::tube_end_mm);
    EXPECT_LT(tip.distance_mm, 0.6);
    for (const double radius : drawn.tree.segments[static_cast<std::size_t>(tip.segment)].radii_mm)
        EXPECT_NEAR(radius, 1.8, 0.4);
    answer({"edit", case_.string(), "--undo", "1"});
    EXPECT_EQ(read_case(case_).tree.segments.size(), before);
}

TEST_F(EditDrawing, WhatCannotBeDrawnIsSaidAndTheCaseStays) {
    const auto refused = [&](const std::string& places, const std::string& words) {
        const auto run = run_cli({"edit", case_.string(), "--draw", places, "--ct", ct_.string()});
        EXPECT_NE(run.exit_code, 0) << places;
        EXPECT_NE(run.errors.find(words), std::string::npos) << run.errors;
        EXPECT_TRUE(read_case(case_).corrections.edits.empty());
    };
    refused("1,10,1.5,18", "no places");
    refused("1,10,1.5", "two places");
    refused("1,10,1.5,18,7,400", "outside of the CT");
    refused("30,20,1.5,38,20,1.5", "15 HU");
    const auto alone = run_cli({"edit", case_.string(), "--ct", ct_.string()});
    EXPECT_EQ(alone.exit_code, 2);
    const auto no_ct = run_cli({"edit", case_.string(), "--draw", "1,10,1.5,18,7,1.5"});
    EXPECT_NE(no_ct.exit_code, 0);
    EXPECT_NE(no_ct.errors.find("not known where this patient's CT lies"), std::string::npos)
        << no_ct.errors;
}

}  // namespace
}  // namespace hepatica
