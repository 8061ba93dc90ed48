// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps that are offered, decided one by one or by their confidence through the real program.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/app/tour.h"
#include "tests/patient/parted_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::answer;
using test::Json;
using test::run_cli;

// Two bridges over one gap: the first with a confidence of 0.22, the second with 0.1.
class EditBridges : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(case_);
        write_case(case_, test::patient_with_bridges());
    }
    void TearDown() override { fs::remove_all(case_); }

    // What `edit` with these options says of the bridges afterwards.
    std::vector<std::string> states(std::vector<std::string> options) const {
        options.insert(options.begin(), {"edit", case_.string()});
        std::vector<std::string> found;
        const Json said = answer(options);
        for (const Json& bridge : said.at("bridges")) {
            EXPECT_EQ(bridge.at("number"), found.size() + 1);
            found.push_back(bridge.at("state"));
        }
        return found;
    }
    using States = std::vector<std::string>;

    fs::path case_ = fs::path(testing::TempDir()) / "edit bridges.hep";
};

TEST_F(EditBridges, AreAcceptedOneByOne) {
    EXPECT_EQ(states({"--list"}), (States{"open", "open"}));
    EXPECT_EQ(states({"--accept", "2"}), (States{"needless", "accepted"}));
    EXPECT_EQ(read_case(case_).corrections.edits.size(), 1u);
    EXPECT_EQ(states({"--undo", "1"}), (States{"open", "open"}));
}

// The vessel apart, from the far end of the trunk.
TEST_F(EditBridges, ALinkOverALongWayIsMadeAndWarnedOf) {
    const fs::path edits = fs::path(testing::TempDir()) / "long link.json";
    std::ofstream(edits) << R"([{"edit": "add_link", "at_mm": [0, 4, 0.6],
                                 "to_mm": [37, 54.5, 4]}])";
    std::string said;
    const Json edited = answer({"edit", case_.string(), "--edits", edits.string()});
    for (const Json& warning : edited.at("warnings")) said += warning.get<std::string>() + "\n";
    fs::remove(edits);
    EXPECT_NE(said.find("Link from 0.0, 4.0, 0.6 mm to 37.0, 54.5, 4.0 mm: The link leads over"),
              std::string::npos)
        << said;
    EXPECT_NE(said.find("take the edit back (--undo)"), std::string::npos);
    EXPECT_EQ(roots(read_case(case_).tree).size(), 1u);
}

// A list beside a correction would leave the correction out, and name a case that was not written.
TEST_F(EditBridges, AreNotDecidedByAList) {
    const fs::path other = case_.string() + ".other.hep";
    for (const std::vector<std::string>& also :
         {std::vector<std::string>{"--accept", "2"}, {"--out", other.string()}}) {
        std::vector<std::string> call{"edit", case_.string(), "--list"};
        call.insert(call.end(), also.begin(), also.end());
        const test::Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 2) << also[0];
        EXPECT_EQ(run.output, "");
        EXPECT_NE(run.errors.find("--list"), std::string::npos) << run.errors;
        EXPECT_FALSE(fs::exists(other));
    }
    EXPECT_EQ(states({"--list"}), (States{"open", "open"}));
}

TEST_F(EditBridges, AreRefusedOneByOneAndOfferedAgain) {
    EXPECT_EQ(states({"--refuse", "1"}), (States{"refused", "open"}));
    EXPECT_EQ(states({"--list"}), (States{"refused", "open"}));  // the case remembers
    EXPECT_EQ(states({"--accept-bridges", "0"}), (States{"refused", "accepted"}));
    EXPECT_EQ(states({"--undo", "1"}), (States{"refused", "open"}));
    EXPECT_EQ(states({"--offer", "1"}), (States{"open", "open"}));
}

// Nobody loses them without a word.
TEST_F(EditBridges, ThatAReconstructionWouldLoseAreSaidBeforeIt) {
    const std::vector<std::string> call{"reconstruct", (case_ / "none.nii.gz").string(), "--out",
                                        case_.string()};
    EXPECT_EQ(run_cli(call).errors.find("holds corrections"), std::string::npos);
    EXPECT_EQ(states({"--accept", "2"}), (States{"needless", "accepted"}));
    const test::Outcome run = run_cli(call);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.errors.find(case_.string() + " holds corrections (1)"), std::string::npos)
        << run.errors;
    EXPECT_EQ(read_case(case_).corrections.edits.size(), 1u);
}

// Nor by verbs that choose their case's name themselves.
TEST_F(EditBridges, ThatAPlayOrABenchmarkWouldLoseAreSaidBeforeIt) {
    EXPECT_EQ(states({"--accept", "2"}), (States{"needless", "accepted"}));
    const fs::path folder = case_.parent_path() / "played before", older = folder / "patient.hep";
    fs::create_directories(folder);
    fs::copy(case_, older, fs::copy_options::recursive);
    const std::string none = (case_ / "none.nii.gz").string();
    std::vector<std::vector<std::string>> calls{{"bench", "reconstruct", none}};
#ifdef HEPATICA_WINDOW_PROGRAM
    calls.push_back({"play", none});
#endif
    for (std::vector<std::string> call : calls) {
        call.insert(call.end(), {"--out", folder.string()});
        const test::Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 1) << call[0];
        EXPECT_NE(run.errors.find(older.string() + " holds corrections (1)"), std::string::npos)
            << call[0] << ": " << run.errors;
        EXPECT_EQ(read_case(older).corrections.edits.size(), 1u);
    }
    fs::remove_all(folder);
}

TEST_F(EditBridges, AreRefusedBelowAConfidence) {
    EXPECT_EQ(states({"--refuse-bridges", "0.2"}), (States{"open", "refused"}));
    EXPECT_EQ(answer({"edit", case_.string(), "--list"}).at("open_bridges").size(), 1u);
    EXPECT_EQ(states({"--refuse-bridges", "0.3", "--accept", "2"}),
              (States{"refused", "accepted"}));
}

TEST_F(EditBridges, AreDecidedAsTheyAreOnceEditsAreTakenBack) {
    EXPECT_EQ(states({"--accept", "1"}), (States{"accepted", "needless"}));
    EXPECT_EQ(states({"--undo", "1", "--refuse", "1"}), (States{"refused", "open"}));
    EXPECT_EQ(read_case(case_).corrections.edits.size(), 1u);
    EXPECT_EQ(states({"--accept", "2"}), (States{"refused", "accepted"}));
    EXPECT_EQ(states({"--undo", "1", "--accept", "1"}), (States{"accepted", "needless"}));
    EXPECT_EQ(read_case(case_).corrections.edits.size(), 1u);
}

// Like gaps, by the same options.
TEST_F(EditBridges, BranchesAreTakenAndRefusedLikewise) {
    PatientCase patient = test::patient_with_bridges();
    Bridge branch;
    branch.path_mm = {Vec3(0.05, 10, 1.5), Vec3(5, 9.5, 1.3), Vec3(12, 9, 1), Vec3(20, 8, 1)};
    branch.radii_mm.assign(branch.path_mm.size(), 0.8);
    branch.confidence = 0.7;
    branch.gap_mm = 20.0;
    patient.corrections.bridges.push_back(branch);
    write_case(case_, patient);
    EXPECT_EQ(states({"--list"}), (States{"open", "open", "open"}));
    const Json listed = answer({"edit", case_.string(), "--list"}).at("bridges").at(2);
    EXPECT_EQ(listed.at("kind"), "branch");
    EXPECT_EQ(listed.at("length_mm"), 20.0);
    EXPECT_EQ(states({"--accept-bridges", "0.5"}), (States{"open", "open", "accepted"}));
    EXPECT_EQ(read_case(case_).corrections.edits.at(0).kind, TreeEditKind::draw_vessel);
    EXPECT_EQ(states({"--undo", "1", "--refuse", "3"}), (States{"open", "open", "refused"}));
    EXPECT_EQ(states({"--offer", "3"}), (States{"open", "open", "open"}));
}

TEST_F(EditBridges, AreNotAcceptedAndRefusedAtOnce) {
    const auto both = run_cli({"edit", case_.string(), "--accept", "1", "--refuse", "1"});
    EXPECT_EQ(both.exit_code, 2);
    EXPECT_NE(both.errors.find("bridge 1 is accepted"), std::string::npos) << both.errors;
    EXPECT_EQ(states({"--list"}), (States{"open", "open"}));
}

TEST_F(EditBridges, WhatCannotBeDecidedIsSaid) {
    EXPECT_EQ(run_cli({"edit", case_.string(), "--accept", "3"}).exit_code, 2);
    EXPECT_EQ(run_cli({"edit", case_.string(), "--refuse", "0"}).exit_code, 2);
    answer({"edit", case_.string(), "--accept", "1"});
    const auto taken = run_cli({"edit", case_.string(), "--refuse", "1"});
    EXPECT_EQ(taken.exit_code, 2);
    EXPECT_NE(taken.errors.find("--undo"), std::string::npos) << taken.errors;
}

}  // namespace
}  // namespace hepatica
