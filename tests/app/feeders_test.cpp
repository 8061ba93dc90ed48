// SPDX-License-Identifier: GPL-3.0-or-later
// Liver segments and the branches that feed tumours, through the real program.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

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

std::string triple(const Vec3& at) {
    return std::to_string(at.x()) + "," + std::to_string(at.y()) + "," + std::to_string(at.z());
}

class Feeders : public test::Tour {
  protected:
    // A tumour of 8 mm in radius about the end of a branch.
    static void SetUpTestSuite() {
        Tour::SetUpTestSuite();
        const VesselTree tree = read_tree_vtp(path("p/truth_tree.vtp"));
        end_mm_ = tree.segments.back().points_mm.back();
        Job job;
        Mask tumour = read_mask(path("p/liver.nii.gz"), job);
        for (std::size_t i = 0; i < tumour.voxels.size(); ++i) {
            const auto [x, y, z] = tumour.grid.index_of(i);
            if ((tumour.grid.to_mm(x, y, z) - end_mm_).norm() > 8.0) tumour.voxels[i] = 0;
        }
        write_nifti(path("tumour.nii.gz"), tumour);
        made_ = answer({"reconstruct", path("p/ct"), "--vessel-mask", path("p/truth_mask.nii.gz"),
                        "--vessel-label", "1=portal", "--liver-mask", path("p/liver.nii.gz"),
                        "--tumour-mask", path("tumour.nii.gz"), "--out", path("t.hep"),
                        "--tetrahedra", "3000"});
    }
    static double sum_of_shares(const Json& found) {
        double sum = 0.0;
        for (const Json& feeder : found.at("feeders")) sum += feeder.at("share").get<double>();
        return sum;
    }

    static inline Vec3 end_mm_ = Vec3::Zero();
    static inline Json made_;
};

TEST_F(Feeders, TheCaseHoldsSegmentsThatSumToTheLiver) {
    Job job;
    const Mask liver = read_mask(path("p/liver.nii.gz"), job);
    const double voxels = static_cast<double>(std::ranges::count(liver.voxels, 1));
    double sum = 0.0;
    for (const auto& [segment, volume] : made_.at("segments_ml").items())
        sum += volume.get<double>();
    EXPECT_NEAR(sum, voxels * liver.grid.spacing_mm.prod() * 1e-3, 1e-6);
    const LabelMap labels = read_label_map(path("t.hep/couinaud.nii.gz"), job);
    EXPECT_LE(*std::ranges::max_element(labels.voxels), 8);
    EXPECT_EQ(run_cli({"render", path("t.hep"), "--segments", "--out", path("t.png"), "--size",
                       "200,150"})
                  .exit_code,
              0);
    EXPECT_EQ(run_cli({"render", path("t.hep"), "--liver", "--out", path("liver.png"), "--size",
                       "200,150"})
                  .exit_code,
              0);
    const auto bytes = [&](const char* name) {
        std::ifstream in(path(name), std::ios::binary);
        return std::string{std::istreambuf_iterator<char>(in), {}};
    };
    EXPECT_NE(bytes("liver.png"), bytes("t.png"));
}

TEST_F(Feeders, SharesOfATumourSumToOneAndAreNamed) {
    const Json found = answer({"feeders", path("t.hep")});
    EXPECT_NEAR(sum_of_shares(found), 1.0, 1e-9);
    double last = 1.0;
    for (const Json& feeder : found.at("feeders")) {
        EXPECT_EQ(feeder.at("system"), "portal");
        EXPECT_EQ(feeder.at("tumour"), 1);
        EXPECT_GE(feeder.at("segment").get<int>(), 0);
        EXPECT_LE(feeder.at("share").get<double>(), last);
        last = feeder.at("share");
    }
    EXPECT_EQ(answer({"feeders", path("t.hep"), "--tumour", "1"}), found);
    // The same ball, named by its place.
    const Json at =
        answer({"feeders", path("t.hep"), "--at-mm", triple(end_mm_), "--radius-mm", "8"});
    EXPECT_EQ(at.at("feeders")[0].at("segment"), found.at("feeders")[0].at("segment"));
    EXPECT_NEAR(sum_of_shares(at), 1.0, 1e-9);
}

TEST_F(Feeders, SayWhatIsMissingAndWhatToDo) {
    const Outcome no_liver = run_cli({"feeders", path("p.hep")});
    EXPECT_EQ(no_liver.exit_code, 1);
    EXPECT_NE(no_liver.errors.find("--liver-mask"), std::string::npos) << no_liver.errors;
    EXPECT_EQ(run_cli({"feeders", path("t.hep"), "--tumour", "2"}).exit_code, 2);
    EXPECT_EQ(run_cli({"feeders", path("t.hep"), "--at-mm", "9000,0,0"}).exit_code, 1);
    answer({"reconstruct", path("p/ct"), "--vessel-mask", path("p/truth_mask.nii.gz"),
            "--liver-mask", path("p/liver.nii.gz"), "--out", path("u.hep"), "--tetrahedra",
            "3000"});
    const Outcome no_tumour = run_cli({"feeders", path("u.hep")});
    EXPECT_EQ(no_tumour.exit_code, 1);
    EXPECT_NE(no_tumour.errors.find("--tumour-mask"), std::string::npos) << no_tumour.errors;
    const Outcome no_mask =
        run_cli({"reconstruct", path("p/ct"), "--vessel-mask", path("p/truth_mask.nii.gz"),
                 "--tumour-mask", path("tumour.nii.gz"), "--out", path("v.hep")});
    EXPECT_EQ(no_mask.exit_code, 1);
    EXPECT_NE(no_mask.errors.find("--liver-mask"), std::string::npos) << no_mask.errors;
}

}  // namespace
}  // namespace hepatica
