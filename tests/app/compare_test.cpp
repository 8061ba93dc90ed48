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

}  // namespace
}  // namespace hepatica
