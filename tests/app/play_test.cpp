// SPDX-License-Identifier: GPL-3.0-or-later
// The session that is played without a window: its report is whole or not there, and what it tells
// of the injection is the injection of its pictures.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/tree/files/tree_io.h"
#include "tests/app/tour.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::answer;
using test::Json;
using test::Outcome;
using test::run_cli;

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

class Play : public test::Tour {};

TEST_F(Play, InjectsWhatTheOtherVerbsInject) {
    const Json played = answer({"play", path("p.hep"), "--out", path("played")})["injection"];
    const Json injected = answer({"inject", path("p.hep")});
    EXPECT_EQ(played["void_fraction"], injected["drug"]["void_fraction"]);
    EXPECT_EQ(played["pressure_law"], injected["model"]);
    EXPECT_NEAR(played["inlet_pressure_begin_pa"], injected["inlet_pressure_begin_pa"],
                1e-9 * injected["inlet_pressure_begin_pa"].get<double>());
}

// The last picture of the front stands in the report with its time.
TEST_F(Play, DrawsTheCurvesToTheLastPicture) {
    const Json played = answer({"play", path("p.hep"), "--out", path("played")});
    const std::string report = text_of(path("played/report.html"));
    const std::size_t last = report.rfind("The drug front ");
    ASSERT_NE(last, std::string::npos);
    const double picture_s = std::stod(report.substr(last + std::string("The drug front ").size()));
    for (const char* curve : {"played/5_filled.csv", "played/6_delivered.csv"}) {
        std::istringstream rows(text_of(path(curve)));
        std::string row, end;
        while (std::getline(rows, row)) end = row;
        const std::string x_and_y = end.substr(end.rfind("\",") + 2);
        EXPECT_NEAR(std::stod(x_and_y), picture_s, 0.01 * picture_s) << curve;  // 3 digits shown
    }
    EXPECT_NEAR(played["injection"]["duration_s"], picture_s, 0.01 * picture_s);
}

TEST_F(Play, CountsTheStepsThatTheBodySleptThroughApart) {
    std::ofstream(path("rest.json")) << R"({"name": "rest", "actions": []})";
    const Json rest =
        answer({"simulate", path("p.hep"), "--script", path("rest.json"), "--steps", "300"});
    const int asleep = rest["steps_asleep"];
    EXPECT_GT(asleep, 0);
    EXPECT_LE(asleep, rest["steps"]);
    EXPECT_EQ(rest["step_ms"]["median"].is_null(), rest["steps"] == asleep);
    EXPECT_EQ(rest["frames_in_time"].is_null(), rest["steps"] == asleep);
    const Json drag = answer({"simulate", path("p.hep"), "--script",
                              HEPATICA_ASSETS "/scripts/drag.json", "--steps", "60"});
    EXPECT_LT(drag["steps_asleep"], 60);
    EXPECT_GT(drag["step_ms"]["median"], 0.0);
    const Json played = answer({"play", path("p.hep"), "--out", path("played")})["simulation"];
    EXPECT_TRUE(played.contains("steps_asleep"));
    EXPECT_GT(played["step_ms_median"], 0.0);
    EXPECT_GE(played["frames_in_time"], 0.0);
    EXPECT_LE(played["frames_in_time"], 1.0);
}

// What reconstruct would have said, the report says too.
TEST_F(Play, TellsWhatTheReconstructionWarnedOf) {
    const Json played = answer({"play", path("p/ct"), "--out", path("from_ct")});
    ASSERT_FALSE(played["warnings"].empty());
    const std::string warning = played["warnings"][0];
    EXPECT_NE(warning.find("1.7 mm apart"), std::string::npos) << warning;
    EXPECT_NE(text_of(path("from_ct/report.html")).find(warning), std::string::npos);
    EXPECT_TRUE(fs::exists(path("from_ct/patient.hep/case.json")));
}

// Whatever the window opens, play opens too; what was not reconstructed leaves no case behind.
TEST_F(Play, PlaysATreeThatIsNoCase) {
    const Json played = answer({"play", path("p/truth_tree.vtp"), "--out", path("from_tree")});
    EXPECT_GT(played["tree"]["tetrahedra"], 100);
    EXPECT_TRUE(played["accuracy"].is_null());
    EXPECT_TRUE(fs::exists(path("from_tree/report.html")));
    for (const auto& entry : fs::directory_iterator(path("from_tree")))
        EXPECT_NE(entry.path().extension(), ".hep") << entry.path();
}

// The same vessels as portal and as hepatic veins.
TEST_F(Play, ShowsEachSystemInItsColour) {
    VesselTree tree = read_tree(path("p/truth_tree.vtp"));
    std::set<std::string> pictures;
    for (const VascularSystem system : {VascularSystem::portal, VascularSystem::hepatic}) {
        for (VesselSegment& segment : tree.segments) segment.system = system;
        write_tree_vtp(path("systems.vtp"), tree);
        ASSERT_EQ(run_cli({"play", path("systems.vtp"), "--out", path("systems")}).exit_code, 0);
        pictures.insert(text_of(path("systems/1_patient.png")));
    }
    EXPECT_EQ(pictures.size(), 2u);
}

TEST_F(Play, LeavesNoFolderWhereThereIsNothingToOpen) {
    const Outcome run = run_cli({"play", path("nothing.hep"), "--out", path("from_nothing")});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.errors.find("nothing.hep"), std::string::npos) << run.errors;
    EXPECT_FALSE(fs::exists(path("from_nothing")));
}

TEST_F(Play, LeavesNoFolderWhereItIsInterrupted) {
    const Outcome run =
        run_cli({"play", path("p.hep"), "--out", path("none")}, {.interrupt_at = "] Playing"});
    ASSERT_EQ(run.exit_code, 130) << run.errors;
    EXPECT_FALSE(fs::exists(path("none")));
}

TEST_F(Play, LeavesAnOlderReportWholeWhereItIsInterrupted) {
    fs::create_directories(path("kept"));
    for (const char* name : {"kept/report.html", "kept/1_patient.png", "kept/mine.txt"})
        std::ofstream(path(name)) << "older";
    const Outcome run =
        run_cli({"play", path("p.hep"), "--out", path("kept")}, {.interrupt_at = "] Playing"});
    ASSERT_EQ(run.exit_code, 130) << run.errors;
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(path("kept"))) {
        EXPECT_EQ(text_of(entry.path()), "older") << entry.path();
        ++files;
    }
    EXPECT_EQ(files, 3);
    ASSERT_EQ(run_cli({"play", path("p.hep"), "--out", path("kept")}).exit_code, 0);
    EXPECT_EQ(text_of(path("kept/mine.txt")), "older");
    EXPECT_NE(text_of(path("kept/report.html")), "older");
}

TEST_F(Play, SaysWhyTheDialStandsElsewhereThanWasAskedFor) {
    std::ofstream(path("rest.json")) << R"({"name": "rest", "actions": []})";
    const auto told = [&](const char* quality) {
        return test::run_cli({"simulate", path("p.hep"), "--script", path("rest.json"), "--steps",
                              "1", "--quality", quality})
            .errors;
    };
    EXPECT_NE(told("0.4321").find("--quality 0.4321: the dial has"), std::string::npos);
    EXPECT_EQ(told("1").find("the dial has"), std::string::npos) << "its last setting is there";
}

}  // namespace
}  // namespace hepatica
