// SPDX-License-Identifier: GPL-3.0-or-later
// The stages in the log: numbered from 1 to the count that was announced, all of them, by every
// verb that has stages.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "core/tree/files/tree_io.h"
#include "tests/app/tour.h"

namespace hepatica {
namespace {

using test::Outcome;
using test::run_cli;

class Stages : public test::Tour {
  protected:
    static void expect_all_stages(const std::vector<std::string>& call) {
        const Outcome run = run_cli(call);
        ASSERT_EQ(run.exit_code, 0) << call[0] << ": " << run.errors;
        const std::regex stage(R"(info: \[(\d+)/(\d+)\] \S)");
        std::istringstream log(run.errors);
        int number = 0, count = 0;
        for (std::string line; std::getline(log, line);) {
            if (line.find("info: [") == std::string::npos) continue;
            std::smatch found;
            ASSERT_TRUE(std::regex_search(line, found, stage)) << call[0] << ": " << line;
            EXPECT_EQ(std::stoi(found[1]), ++number) << call[0] << ": " << line;
            if (number == 1) count = std::stoi(found[2]);
            EXPECT_EQ(std::stoi(found[2]), count) << call[0] << ": " << line;
        }
        EXPECT_GT(number, 0) << call[0];
        EXPECT_EQ(number, count) << call[0] << "\n" << run.errors;
    }
    static std::string seed_in_vessel() {
        const Vec3 at = read_tree_vtp(path("p/truth_tree.vtp")).segments[0].points_mm[2];
        return std::to_string(at.x()) + "," + std::to_string(at.y()) + "," + std::to_string(at.z());
    }
};

TEST_F(Stages, OfAReconstructionComeAsAnnounced) {
    const std::vector<std::string> small{"--tetrahedra", "3000", "--out", path("r.hep")};
    for (std::vector<std::string> call :
         {std::vector<std::string>{"reconstruct", path("p/ct"), "--vessel-mask",
                                   path("p/truth_mask.nii.gz")},
          {"reconstruct", path("p/ct"), "--liver-mask", path("p/liver.nii.gz"), "--spacing-mm",
           "1.5", "--seed-mm", seed_in_vessel()},
          {"reconstruct", path("p/ct"), "--liver-mask", path("p/liver.nii.gz"), "--spacing-mm",
           "1.5", "--model", "shipped"},
          {"reconstruct", path("p/ct"), "--spacing-mm", "1.5"}}) {
        call.insert(call.end(), small.begin(), small.end());
        expect_all_stages(call);
    }
}

TEST_F(Stages, OfEveryOtherVerbComeAsAnnounced) {
    const std::string tree = path("p/truth_tree.vtp"), mask = path("p/truth_mask.nii.gz");
    const std::string drag = HEPATICA_ASSETS "/scripts/drag.json";
    std::ofstream(path("edits.json")) << "[]";
    for (const std::vector<std::string>& call :
         {std::vector<std::string>{"phantom", path("q"), "--dims", "32,32,32", "--spacing", "5,5,5",
                                   "--generations", "2"},
          {"phantom", path("q"), "--dims", "32,32,32", "--spacing", "5,5,5", "--generations", "2",
           "--format", "nifti"},
          {"compare", path("p.hep"), "--truth-tree", tree, "--truth-mask", mask},
          {"edit", path("p.hep"), "--list"},
          {"edit", path("p.hep"), "--edits", path("edits.json"), "--out", path("e.hep")},
          {"inject", tree},
          {"embolize", tree, "--count", "10", "--blood-flow-ml-min", "945", "--inlet-pressure-mmhg",
           "10", "--outlet-pressure-mmhg", "4"},
          {"skeleton", mask},
          {"simulate", path("p.hep"), "--script", drag, "--steps", "3", "--record", path("s.hrec")},
          {"replay", path("s.hrec")},
          {"bench", "drag", path("p.hep"), "--motion", "jerk", "--motion", "pull"},
          {"bench", "drag", path("p.hep"), "--motion", "jerk", "--no-error"},
          {"dial", path("p.hep"), "--budget", "1"},
          {"render", path("p.hep"), "--size", "64,48", "--out", path("a.png")},
          {"render", path("p.hep"), "--size", "64,48", "--out", path("a.png"), "--recording",
           path("s.hrec")},
          {"scene", path("p.hep")},
          {"play", path("p.hep"), "--out", path("played")}})
        expect_all_stages(call);
}

// A lesson on the built-in patient, whom no file beside the recording holds: he is made first.
TEST_F(Stages, OfALessonOnTheBuiltInPatientComeAsAnnounced) {
    const std::string drag = HEPATICA_ASSETS "/scripts/drag.json";
    const Outcome played = run_cli({"play", "--out", path("built_in")});
    ASSERT_EQ(played.exit_code, 0) << played.errors;
    const std::string patient = path("built_in/built_in_patient.hep");
    ASSERT_EQ(run_cli({"simulate", patient, "--script", drag, "--steps", "3", "--record",
                       path("alone/b.hrec")})
                  .exit_code,
              0);
    expect_all_stages({"review", path("alone/b.hrec")});
    expect_all_stages({"review", path("alone/b.hrec"), "--patient", patient});
    expect_all_stages({"replay", path("alone/b.hrec"), "--patient", patient});
}

}  // namespace
}  // namespace hepatica
