// SPDX-License-Identifier: GPL-3.0-or-later
// A case judged by a truth that is not its own: figures without a word would mislead.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "core/tree/files/tree_io.h"
#include "tests/app/tour.h"

namespace hepatica {
namespace {

using test::answer;
using test::Json;
using test::Outcome;
using test::run_cli;

class CompareTruths : public test::Tour {
  protected:
    static std::vector<std::string> arguments(const std::string& tree, const std::string& mask) {
        return {"compare", path("p.hep"), "--truth-tree", path(tree), "--truth-mask", path(mask)};
    }
    static Outcome compared(const std::string& tree, const std::string& mask) {
        return run_cli(arguments(tree, mask));
    }
};

TEST_F(CompareTruths, TheOwnTruthIsJudgedWithoutAWarning) {
    const Json found = answer(arguments("p/truth_tree.vtp", "p/truth_mask.nii.gz"));
    EXPECT_TRUE(found.at("warnings").empty());
    ASSERT_EQ(found.at("systems").size(), 1u);
    EXPECT_EQ(found.at("systems")[0].at("system"), "unknown");  // a mask with a single label
    EXPECT_LT(found.at("centreline_median_mm"), 1.0);
    EXPECT_LT(found.at("truth_median_mm"), 1.0);
}

TEST_F(CompareTruths, AnotherPatientsTruthIsWarnedOf) {
    ASSERT_EQ(run_cli({"phantom", path("other"), "--seed", "3", "--dims", "128,128,96", "--spacing",
                       "1.6,1.6,1.7", "--generations", "4"})
                  .exit_code,
              0);
    const Outcome run = compared("other/truth_tree.vtp", "other/truth_mask.nii.gz");
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.errors.find("warning"), std::string::npos) << run.errors;
    EXPECT_NE(run.errors.find("other/truth_tree.vtp"), std::string::npos) << run.errors;
    EXPECT_NE(run.errors.find("same patient"), std::string::npos) << run.errors;
}

TEST_F(CompareTruths, ATruthThatLiesElsewhereIsRefused) {
    constexpr double away_mm = 400.0;
    VesselTree tree = read_tree_vtp(path("p/truth_tree.vtp"));
    for (VesselSegment& segment : tree.segments)
        for (Vec3& point : segment.points_mm) point.x() += away_mm;
    for (VesselNode& node : tree.nodes) node.position_mm.x() += away_mm;
    write_tree(path("away.vtp"), tree);
    Job job;
    Mask mask = read_mask(path("p/truth_mask.nii.gz"), job);
    mask.grid.origin_mm.x() += away_mm;
    write_nifti(path("away.nii.gz"), mask);

    for (const auto& [wrong_tree, wrong_mask, culprit] :
         {std::array<std::string, 3>{"away.vtp", "away.nii.gz", "away.vtp"},
          {"away.vtp", "p/truth_mask.nii.gz", "away.vtp"},
          {"p/truth_tree.vtp", "away.nii.gz", "away.nii.gz"}}) {
        const Outcome run = compared(wrong_tree, wrong_mask);
        EXPECT_EQ(run.exit_code, 1) << run.errors;
        EXPECT_EQ(run.output, "");
        EXPECT_NE(run.errors.find(culprit), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find("p.hep"), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find("mm apart"), std::string::npos) << run.errors;
    }
}

// A phantom of two systems whose labels the case keeps: each is judged by its own mask.
class CompareSystems : public test::Tour {
  protected:
    static void SetUpTestSuite() {
        std::filesystem::remove_all(folder());
        std::filesystem::create_directories(folder());
        answer({"phantom", path("p"), "--seed", "2", "--systems", "2", "--touch", "3", "--dims",
                "128,128,96", "--spacing", "1.6,1.6,1.7", "--format", "nifti"});
        answer({"reconstruct", path("p/ct.nii.gz"), "--vessel-mask", path("p/truth_mask.nii.gz"),
                "--vessel-label", "1=portal", "--vessel-label", "2=hepatic", "--out", path("p.hep"),
                "--tetrahedra", "3000"});
        Job job;
        const Mask both = narrow_labels(read_label_map(path("p/truth_mask.nii.gz"), job), "");
        for (const auto& [label, name] : {std::pair{1, "portal.nii.gz"}, {2, "hepatic.nii.gz"}}) {
            Mask one = both;
            for (std::uint8_t& voxel : one.voxels) voxel = voxel == label;
            write_nifti(path(name), one);
        }
    }
    static std::vector<std::string> arguments() {
        return {"compare",      path("p.hep"),
                "--truth-mask", "portal=" + path("portal.nii.gz"),
                "--truth-mask", "hepatic=" + path("hepatic.nii.gz")};
    }
    static std::vector<std::string> with(std::vector<std::string> more) {
        std::vector<std::string> all = arguments();
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

TEST_F(CompareSystems, EachIsJudgedByItsMask) {
    const Json found = answer(with({"--liver-mask", path("p/liver.nii.gz")}));
    for (const char* name : {"portal", "hepatic"}) {
        const Json& system = found.at("systems").at(name);
        for (const char* share : {"length_recall", "length_precision", "surface_dice", "dice"})
            EXPECT_GT(system.at(share), 0.85) << name << " " << share;
        EXPECT_LT(system.at("root_error_mm"), 12.0) << name;
        EXPECT_EQ(system.at("by_radius").size(), 4u);
    }
    EXPECT_GT(found.at("system_right"), 0.95);
    EXPECT_LT(found.at("false_joins"), 3);
    EXPECT_TRUE(found.at("breaks").is_number_integer());
    EXPECT_GT(found.at("vessels").at("length_recall"), 0.9);
}

TEST_F(CompareSystems, NamesInTheWrongOrderAreNowhereRight) {
    const Json found =
        answer({"compare", path("p.hep"), "--truth-mask", "hepatic=" + path("portal.nii.gz"),
                "--truth-mask", "portal=" + path("hepatic.nii.gz")});
    EXPECT_LT(found.at("system_right"), 0.05);
}

TEST_F(CompareSystems, AreReadableInTables) {
    const Outcome run = run_cli(arguments());
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    for (const char* word : {"portal", "hepatic", "all", "length_recall", "false_joins"})
        EXPECT_NE(run.output.find(word), std::string::npos) << run.output;
}

TEST_F(CompareSystems, WhatCannotBeMeantIsRefused) {
    const std::string mask = path("portal.nii.gz"), tree = path("p/truth_tree.vtp");
    for (const std::vector<std::string>& rest :
         {std::vector<std::string>{"--truth-mask", mask},
          {"--truth-mask", "vein=" + mask},
          {"--truth-mask", "unknown=" + mask},
          {"--truth-mask", "portal="},
          {"--truth-tree", tree, "--truth-mask", "portal=" + mask},
          {"--truth-tree", tree, "--truth-mask", mask, "--truth-mask", mask},
          {"--truth-tree", tree, "--truth-mask", mask, "--liver-mask", mask}}) {
        std::vector<std::string> call{"compare", path("p.hep")};
        call.insert(call.end(), rest.begin(), rest.end());
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 2) << run.errors;
        EXPECT_NE(run.errors.find("--"), std::string::npos) << run.errors;
        EXPECT_EQ(run.output, "");
    }
}

}  // namespace
}  // namespace hepatica
