// SPDX-License-Identifier: GPL-3.0-or-later
// A case made anew from painted voxels, through the real program.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/image/brush.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "core/patient/patient_case.h"
#include "core/tree/station.h"
#include "tests/app/tour.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::answer;
using test::Json;
using test::run_cli;

class Remake : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        fs::remove_all(folder());
        fs::create_directories(folder());
        answer({"phantom", (folder() / "p").string(), "--seed", "1", "--dims", "88,88,64",
                "--spacing", "2,2,2", "--generations", "3", "--format", "nifti"});
        answer({"reconstruct", ct().string(), "--liver-mask",
                (folder() / "p" / "liver.nii.gz").string(), "--out", made().string(),
                "--tetrahedra", "1500", "--spacing-mm", "1"});  // voxels of 2 mm hold no more
    }
    static void TearDownTestSuite() { fs::remove_all(folder()); }
    static fs::path folder() { return fs::path(testing::TempDir()) / "remake verb"; }
    static fs::path ct() { return folder() / "p" / "ct.nii.gz"; }
    static fs::path made() { return folder() / "p.hep"; }
};

// The half of a long end branch that lies towards its tip.
std::string balls_over_a_twig(const VesselTree& tree, std::vector<std::string>& arguments) {
    const auto below = children(tree);
    for (std::size_t s = 0; s < below.size(); ++s) {
        const VesselSegment& twig = tree.segments[s];
        const double length = length_mm(twig);
        if (!below[s].empty() || length < 10.0) continue;
        for (double along = 0.5 * length; along <= length; along += 2.0) {
            const Station at = station_at(twig, along);
            std::string ball;
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                ball += std::to_string(at.position_mm[axis]) + ",";
            arguments.insert(arguments.end(),
                             {"--erase", ball + std::to_string(2.0 * at.radius_mm + 1.0)});
        }
        return "";
    }
    return "there is no long twig";
}

TEST_F(Remake, ErasesATwigAndTakesTheMaskOfAnotherProgram) {
    const fs::path other = folder() / "other.hep";
    std::vector<std::string> arguments{"remake",      made().string(), "--ct",
                                       ct().string(), "--out",         other.string()};
    ASSERT_EQ(balls_over_a_twig(read_case(made()).tree, arguments), "");
    const Json said = answer(arguments);
    EXPECT_LT(said.at("vessel_voxels"), said.at("vessel_voxels_before"));
    const PatientCase before = read_case(made()), after = read_case(other);
    EXPECT_LT(length_mm(after.tree), length_mm(before.tree) - 3.0);
    EXPECT_EQ(after.source.image_sha256, before.source.image_sha256);
    // The mask of the first case brings its vessels back.
    answer({"remake", other.string(), "--ct", ct().string(), "--vessels",
            (made() / "mask.nii.gz").string()});
    const PatientCase back = read_case(other);
    EXPECT_EQ(back.mask.voxels, before.mask.voxels);
    EXPECT_EQ(hash_of(back), hash_of(before)) << "tree and body, to the bit";
}

// Of a system that was given and is not found anew.
TEST_F(Remake, TheMaskOfACaseOfOneSystemKeepsIt) {
    const fs::path given = folder() / "given.hep";
    answer({"reconstruct", ct().string(), "--vessel-mask",
            (folder() / "p" / "truth_mask.nii.gz").string(), "--vessel-label", "1=portal", "--out",
            given.string(), "--tetrahedra", "1500"});
    const PatientCase before = read_case(given);
    answer({"remake", given.string(), "--ct", ct().string(), "--vessels",
            (given / "mask.nii.gz").string()});
    const PatientCase after = read_case(given);
    EXPECT_EQ(after.mask.voxels, before.mask.voxels);
    for (const VesselSegment& segment : after.tree.segments)
        EXPECT_EQ(segment.system, VascularSystem::portal);
}

// Within the grid, as far from all vessels as there is room.
Vec3 far_from_vessels(const PatientCase& patient) {
    const Grid& grid = patient.mask.grid;
    Vec3 place = Vec3::Zero();
    double farthest = 0.0;
    for (std::size_t i = 0; i < patient.mask.voxels.size(); i += 97) {
        const Index3 at = grid.index_of(i);
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis)
            inside = inside && at[axis] >= 14 && at[axis] + 14 < grid.dims[axis];
        const Vec3 here = grid.to_mm(at[0], at[1], at[2]);
        if (!inside) continue;
        const double away = nearest_point(patient.tree, here).distance_mm;
        if (away <= farthest) continue;
        farthest = away;
        place = here;
    }
    return place;
}

// A piece of 10 mm that nothing joins: a person who paints it says that it is a vessel; a file is
// only what some program took for vessels.
TEST_F(Remake, KeepsWhatIsPaintedAndJudgesWhatAFileHolds) {
    const PatientCase before = read_case(made());
    const Vec3 place = far_from_vessels(before);
    ASSERT_GT(nearest_point(before.tree, place).distance_mm, 12.0);
    const fs::path painted = folder() / "painted.hep", drawn = folder() / "drawn.hep";
    std::vector<std::string> arguments{"remake",      made().string(), "--ct",
                                       ct().string(), "--out",         painted.string()};
    BrushStroke stroke;
    stroke.radius_mm = 1.5;
    for (int along = -5; along <= 5; ++along) {
        const Vec3 at = place + Vec3(along, 0, 0);
        stroke.path_mm.push_back(at);
        arguments.insert(arguments.end(),
                         {"--paint", std::to_string(at.x()) + "," + std::to_string(at.y()) + "," +
                                         std::to_string(at.z()) + ",1.5"});
    }
    const Json said = answer(arguments);
    EXPECT_GT(said.at("vessel_voxels"), said.at("vessel_voxels_before"));
    const PatientCase after = read_case(painted);
    EXPECT_LT(nearest_point(after.tree, place).distance_mm, 2.0);
    ASSERT_EQ(after.corrections.rebuilt.size(), 1u);
    EXPECT_EQ(after.corrections.rebuilt[0].strokes, 11u);

    Mask voxels = before.mask;
    apply(stroke, static_cast<std::uint8_t>(number_of(VascularSystem::unknown)), voxels);
    write_nifti(folder() / "drawn.nii.gz", voxels);
    answer({"remake", made().string(), "--ct", ct().string(), "--vessels",
            (folder() / "drawn.nii.gz").string(), "--out", drawn.string()});
    EXPECT_GT(nearest_point(read_case(drawn).tree, place).distance_mm, 8.0);
}

TEST_F(Remake, ABallOutsideOfTheVoxelsIsSaid) {
    const fs::path other = folder() / "outside.hep";
    const Json said = answer({"remake", made().string(), "--ct", ct().string(), "--erase",
                              "9000,0,0,1", "--out", other.string()});
    EXPECT_NE(said.at("warnings").dump().find("lies outside of the vessels' voxels"),
              std::string::npos);
    EXPECT_EQ(hash_of(read_case(other)), hash_of(read_case(made())));
}

TEST_F(Remake, WhatCannotBeMadeIsSaidAndTheCaseStays) {
    const auto hash = hash_of(read_case(made()));
    const auto refused = [&](std::vector<std::string> more, const std::string& words) {
        std::vector<std::string> arguments{"remake", made().string(), "--ct", ct().string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto run = run_cli(arguments);
        EXPECT_NE(run.exit_code, 0);
        EXPECT_NE(run.errors.find(words), std::string::npos) << run.errors;
        EXPECT_EQ(hash_of(read_case(made())), hash);
    };
    refused({}, "nothing to change");
    refused({"--paint", "1,2,3"}, "--paint");
    refused({"--paint", "1,2,3,0"}, "is no ball");
    refused({"--erase", "1,2,3,x"}, "is no ball");
    refused({"--erase", "1,2,3,4x"}, "is no ball");
    refused({"--erase", "7"}, "--erase");
    refused({"--erase", "88,88,64,50", "--vessels", (folder() / "none.nii.gz").string()},
            "none.nii.gz");
    const Mask mask = read_case(made()).mask;
    write_nifti(folder() / "empty.nii.gz", Mask(mask.grid));
    refused({"--vessels", (folder() / "empty.nii.gz").string()}, "empty.nii.gz");
    const auto no_ct = run_cli({"remake", made().string(), "--paint", "1,2,3,4"});
    EXPECT_NE(no_ct.errors.find("not known where this patient's CT lies"), std::string::npos)
        << no_ct.errors;
}

}  // namespace
}  // namespace hepatica
