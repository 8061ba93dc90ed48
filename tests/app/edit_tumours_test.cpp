// SPDX-License-Identifier: GPL-3.0-or-later
// Tumours that are painted and erased through the real program.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/base/text_file.h"
#include "tests/app/tour.h"
#include "tests/patient/parted_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::answer;
using test::Json;
using test::run_cli;

// In a liver of 60 mm a side.
class EditTumours : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(case_);
        PatientCase patient = test::patient_with_bridges();
        Grid grid;
        grid.dims = {60, 60, 60};
        grid.origin_mm = Vec3(-20, 0, -30);
        patient.organs = Mask(grid, organ_label::liver);
        patient.mask = Mask(grid);
        patient.mask.at(20, 20, 30) = 1;
        for (VesselSegment& segment : patient.tree.segments)
            segment.system = VascularSystem::portal;
        write_case(case_, patient);
    }
    void TearDown() override { fs::remove_all(case_); }

    Json edit(std::vector<std::string> options) const {
        options.insert(options.begin(), {"edit", case_.string()});
        return answer(options);
    }
    void refused(std::vector<std::string> options, const std::string& words) const {
        const std::string before = read_text_file(case_ / "case.json", "");
        options.insert(options.begin(), {"edit", case_.string()});
        const auto run = run_cli(options);
        EXPECT_NE(run.exit_code, 0);
        EXPECT_NE(run.errors.find(words), std::string::npos) << run.errors;
        EXPECT_EQ(read_text_file(case_ / "case.json", ""), before);
    }
    fs::path file(const std::string& text) const {
        const fs::path place = fs::path(testing::TempDir()) / "strokes.json";
        write_text_atomically(place, text);
        return place;
    }

    fs::path case_ = fs::path(testing::TempDir()) / "edit tumours.hep";
};

TEST_F(EditTumours, ArePaintedErasedListedAndTakenBack) {
    EXPECT_TRUE(edit({"--list"}).at("tumours").empty());
    const auto hash = hash_of(read_case(case_));
    Json said = edit({"--paint-tumour", "0,20,10,5", "--paint-tumour", "0,26,10,5"});
    ASSERT_EQ(said.at("tumours").size(), 1u);
    EXPECT_EQ(said.at("tumours")[0].at("tumour"), 1);
    EXPECT_NEAR(said.at("tumours")[0].at("middle_mm")[1].get<double>(), 23.0, 0.1);
    EXPECT_NEAR(said.at("tumours")[0].at("volume_ml").get<double>(), 0.94, 0.05);
    const auto cut_off = [&] {
        return said.at("warnings").dump().find("that a case keeps") != std::string::npos;
    };
    EXPECT_FALSE(cut_off());
    said = edit({"--paint-tumour", "20,40,10,4"});
    ASSERT_EQ(said.at("tumours").size(), 2u) << "a new one";
    EXPECT_EQ(said.at("tumours")[1].at("tumour"), 2);
    said = edit({"--paint-tumour", "20,50,10,4", "--tumour", "1"});
    EXPECT_EQ(said.at("tumours").size(), 2u);
    said = edit({"--erase-tumour", "0,23,10,20"});
    ASSERT_EQ(said.at("tumours").size(), 2u) << "of tumour 1 a part is elsewhere";
    said = edit({"--erase-tumour", "20,50,10,6", "--tumour", "1"});
    ASSERT_EQ(said.at("tumours").size(), 1u);
    EXPECT_EQ(said.at("tumours")[0].at("tumour"), 2) << "it keeps its number";
    EXPECT_EQ(hash_of(read_case(case_)), hash);
    EXPECT_EQ(said.at("edits").size(), 6u);
    said = edit({"--undo", "6"});
    EXPECT_TRUE(said.at("tumours").empty());
    EXPECT_FALSE(fs::exists(case_ / "organs_unpainted.nii.gz"));
    said = edit({"--paint-tumour", "39,1,29,45"});
    EXPECT_TRUE(cut_off()) << "a part of it lies where the case keeps nothing";
}

TEST_F(EditTumours, AreDrawnByRender) {
    const auto drawn = [&] {
        const fs::path picture = fs::path(testing::TempDir()) / "tumours.png";
        answer({"render", case_.string(), "--out", picture.string(), "--bare", "--size", "96,72"});
        return read_text_file(picture, "");
    };
    const std::string without = drawn();
    EXPECT_EQ(drawn(), without);
    edit({"--paint-tumour", "0,20,10,5"});
    const std::string with = drawn();
    EXPECT_NE(with, without);
    edit({"--erase-tumour", "0,20,10,9"});
    EXPECT_EQ(drawn(), without);
}

TEST_F(EditTumours, NothingToDoWritesNothing) {
    const auto written = fs::last_write_time(case_ / "case.json");
    refused({}, "is given nothing to do");
    EXPECT_EQ(fs::last_write_time(case_ / "case.json"), written);
}

TEST_F(EditTumours, AreTargetsOfFeeders) {
    edit({"--paint-tumour", "0,20,10,5"});
    const Json fed = answer({"feeders", case_.string(), "--tumour", "1"});
    ASSERT_FALSE(fed.at("feeders").empty());
    EXPECT_EQ(fed.at("feeders")[0].at("tumour"), 1);
    const auto run = run_cli({"feeders", case_.string(), "--tumour", "3"});
    EXPECT_NE(run.errors.find("The case holds 1"), std::string::npos) << run.errors;
}

TEST_F(EditTumours, ComeFromAFileOfEdits) {
    const Json said =
        edit({"--edits", file(R"([{"edit": "paint_tumour", "tumour": 3, "radius_mm": 4,
                                   "path_mm": [[0, 20, 10], [10, 20, 10]]},
                                  {"edit": "erase_tumour", "at_mm": [10, 20, 10], "radius_mm": 3}])")
                             .string()});
    ASSERT_EQ(said.at("tumours").size(), 1u);
    EXPECT_EQ(said.at("tumours")[0].at("tumour"), 3);
    EXPECT_EQ(edit({"--list"}).at("tumours"), said.at("tumours"));
}

// Whatever numbers the file has, they are steps of their own, and the case can be read again.
TEST_F(EditTumours, OfAFileBelongToNoStepOfTheCase) {
    const auto strokes_at = [this](const std::string& y) {
        const std::string begin =
            R"({"edit": "paint_tumour", "tumour": 1, "radius_mm": 2, "at_mm": [)";
        const std::string of_step = R"(], "step": 1000000}, )";
        return file("[" + begin + "0, " + y + ", 10" + of_step + begin + "5, " + y + ", 10" +
                    of_step + begin + "10, " + y + ", 10]}]")
            .string();
    };
    edit({"--edits", strokes_at("20")});
    edit({"--edits", strokes_at("30")});
    const Json listed = edit({"--list"});
    std::vector<int> steps;
    for (const Json& one : listed.at("edits")) steps.push_back(one.value("step", 0));
    EXPECT_EQ(steps, (std::vector<int>{1, 1, 0, 2, 2, 0}));
}

TEST_F(EditTumours, WhatCannotBePaintedIsRefusedInWords) {
    refused({"--paint-tumour", "1,2,3"}, "--paint-tumour");
    refused({"--paint-tumour", "1,2,3,0"}, "is no ball");
    refused({"--paint-tumour", "1,2,3,51"}, "is no ball");
    refused({"--erase-tumour", "0,20,10,5"}, "no such tumour to be erased");
    refused({"--paint-tumour", "900,20,10,5"}, "nothing that could become tumour");
    refused({"--tumour", "2"}, "is given nothing to do");
    refused({"--paint-tumour", "0,20,10,5", "--tumour", "247"}, "--tumour");
    const auto from = [&](const std::string& text) { return file("[" + text + "]").string(); };
    refused({"--edits", from(R"({"edit": "paint_tumour", "at_mm": [0, 20, 10], "radius_mm": 4})")},
            "tumour");
    refused({"--edits", from(R"({"edit": "paint_tumour", "tumour": 247, "at_mm": [0, 20, 10],
                                 "radius_mm": 4})")},
            "there can be no tumour 247");
    refused({"--edits", from(R"({"edit": "paint_tumour", "tumour": 1, "at_mm": [0, 20, 10],
                                 "radius_mm": -4})")},
            "Give a radius above 0");
    refused({"--edits", from(R"({"edit": "erase_tumour", "path_mm": [], "radius_mm": 4})")},
            "led nowhere");
    refused({"--edits",
             from(R"({"edit": "paint_tumour", "tumour": 1, "path_mm": [[1, 2, 3], [1e9, 0, 0]],
                                 "radius_mm": 4})")},
            "a brush");
}

TEST_F(EditTumours, ACaseWithoutVoxelsIsRefused) {
    fs::remove_all(case_);
    write_case(case_, test::patient_with_bridges());
    refused({"--paint-tumour", "0,20,10,5"}, "holds no voxels that could be tumour");
}

}  // namespace
}  // namespace hepatica
