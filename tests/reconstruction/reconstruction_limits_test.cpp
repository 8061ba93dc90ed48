// SPDX-License-Identifier: GPL-3.0-or-later
// Seeds, labels, tumours, stages and parameters at their limits, and the words that say so.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/base/error.h"
#include "core/image/volume_writer.h"
#include "core/patient/patient_case.h"
#include "core/reconstruction/built_in_patient.h"
#include "core/reconstruction/detected_vessels.h"
#include "core/reconstruction/from_voxels.h"
#include "core/reconstruction/given_vessels.h"
#include "core/reconstruction/plausible_skeleton.h"
#include "core/reconstruction/reconstruct_parameters.h"
#include "core/reconstruction/seed_checks.h"
#include "core/reconstruction/tumours.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

// A voxel reaches half its edge beyond its middle.
TEST(ReconstructionLimits, ASeedMayLieAtTheImagesVeryBorder) {
    Grid grid;
    grid.dims = {8, 6, 4};
    grid.spacing_mm = Vec3(1.0, 2.0, 4.0);
    grid.origin_mm = Vec3(10.0, 20.0, 40.0);
    const auto taken = [&](const Vec3& at) {
        try {
            require_seeds_in_image(
                {{Vec3(12, 24, 44), VascularSystem::portal}, {at, VascularSystem::portal}}, grid);
            return true;
        } catch (const InputError&) {
            return false;
        }
    };
    const Vec3 low(9.5, 19.0, 38.0), high(17.5, 31.0, 54.0);
    EXPECT_TRUE(taken(low) && taken(high));
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 below = low, above = high;
        below[axis] -= 0.01;
        above[axis] += 0.01;
        EXPECT_FALSE(taken(below)) << axis;
        EXPECT_FALSE(taken(above)) << axis;
    }
    try {
        require_seeds_in_image({{Vec3(0, 24, 44.5), VascularSystem::portal}}, grid);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(),
                  "0,24,44.5 lies outside the image, which reaches from 10,20,40 to 17,30,52");
        EXPECT_EQ(error.place(), "--seed-mm X,Y,Z,portal");
    }
}

TEST(ReconstructionLimits, ASeedMayLieTenMillimetresFromTheLiver) {
    Mask liver{Grid{{40, 3, 3}}};
    liver.at(5, 1, 1) = 1;
    liver.at(6, 1, 1) = 1;
    const auto check = [&](double x) {
        require_seeds_near_liver(
            {{Vec3(5, 1, 1), VascularSystem::portal}, {Vec3(x, 1, 1), VascularSystem::hepatic}},
            liver, "liver.nii");
    };
    EXPECT_NO_THROW(check(16.0));
    EXPECT_NO_THROW(check(-5.0));
    EXPECT_THROW(check(16.001), InputError);
    try {
        check(18.4);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "18.4,1,1 lies 12 mm from the liver of liver.nii");
        EXPECT_EQ(error.place(), "--seed-mm X,Y,Z,hepatic") << "the one that is wrong";
    }
}

std::string refusal_of(const std::vector<std::uint16_t>& labels) {
    LabelMap map{Grid{{static_cast<int>(labels.size()), 1, 1}}};
    map.voxels = labels;
    std::vector<std::string> warnings;
    try {
        systems_of_labels(map, {}, "m", warnings);
    } catch (const InputError& error) {
        return error.problem();
    }
    return "";
}

TEST(ReconstructionLimits, NoMoreThanEightLabelsAreListed) {
    EXPECT_TRUE(refusal_of({11, 12, 13, 14, 15, 16, 17, 18})
                    .starts_with("holds the labels 11, 12, 13, 14, 15, 16, 17, 18, and 11 is no"));
    EXPECT_TRUE(
        refusal_of({11, 12, 13, 14, 15, 16, 17, 18, 19})
            .starts_with("holds the labels 11, 12, 13, 14, 15, 16, 17, 18 and others, and 11 is"));
}

// Lines along x, as many voxels long, in every other row of every other slice.
Mask lines_of(int rows, int voxels, double edge_mm) {
    Grid grid;
    grid.dims = {voxels + 2, 2 * rows + 1, 2 * rows + 1};
    grid.spacing_mm = Vec3(2.0 * edge_mm, edge_mm, 3.0 * edge_mm);
    Mask lines(grid);
    for (int z = 0; z < rows; ++z)
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < voxels; ++x) lines.at(x + 1, 2 * y + 1, 2 * z + 1) = 1;
    return lines;
}

// A hundred lines of 160 voxels of 5 mm at least are 80 m; pieces that are too short for a tree do
// not count.
TEST(ReconstructionLimits, ASkeletonMayBeEightyMetresLong) {
    Job job;
    Mask lines = lines_of(10, 160, 5.0);
    EXPECT_NO_THROW(require_plausible_skeleton(lines, job));
    EXPECT_NO_THROW(require_plausible_skeleton(Mask(lines.grid), job));
    EXPECT_NO_THROW(require_plausible_skeleton(lines_of(90, 2, 5.0), job));
    lines.at(0, 1, 1) = 1;
    try {
        require_plausible_skeleton(lines, job);
        FAIL() << "five millimetres more";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(),
                  "the vessels found are 80 m long together, more than a liver shows");
        EXPECT_EQ(error.place(), "vessels");
    }
    EXPECT_THROW(require_plausible_skeleton(lines_of(90, 3, 5.0), job), InputError);
}

// Before paths are searched through its crossings, and long before a tree is made.
TEST(ReconstructionLimits, NoiseTakenForVesselsIsRefusedOnceItIsThin) {
    PatientCase patient;
    patient.mask = lines_of(24, 160, 1.0);
    const Volume ct(patient.mask.grid, 100);
    std::vector<std::string> warnings;
    Job job;
    EXPECT_THROW(make_tree({}, ct, patient, warnings, job), InputError);
    EXPECT_EQ(job.progress().stage, "Thinning to the skeleton");
}

TEST(ReconstructionLimits, GivenVesselsAreCutWithFiveMillimetresAround) {
    const fs::path folder = fs::path(testing::TempDir()) / "hepatica given limits";
    fs::create_directories(folder);
    Grid grid;
    grid.dims = {40, 40, 40};
    Mask vessels(grid);
    for (int x = 15; x < 22; ++x) vessels.at(x, 20, 3) = 1;
    write_nifti(folder / "vessels.nii.gz", vessels);
    std::vector<std::string> warnings;
    Job job;
    const Mask cut = read_given_vessels(folder / "vessels.nii.gz", {}, grid, warnings, job);
    EXPECT_EQ(cut.grid.dims, (Index3{17, 11, 9}));
    EXPECT_EQ(cut.grid.origin_mm, Vec3(10, 15, 0));
    EXPECT_TRUE(warnings.empty());
    fs::remove_all(folder);
}

// A voxel holds numbers to 255: the smallest of too many tumours are left out.
TEST(ReconstructionLimits, OfTheNumberOfTumours) {
    const fs::path folder = fs::path(testing::TempDir()) / "hepatica tumour limits";
    fs::create_directories(folder);
    Mask many{Grid{{40, 40, 3}}};
    for (int y = 0; y < 40; y += 2)
        for (int x = 0; x < 40; x += 2) many.at(x, y, 1) = 1;
    write_nifti(folder / "many.nii.gz", many);
    Job job;
    std::vector<std::string> warnings;
    const Mask tumours = read_tumours({folder / "many.nii.gz"}, many.grid, warnings, job);
    const int most = 256 - organ_label::first_tumour;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("400 separate pieces"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find("the 154 smallest are left out, 0.154 ml"), std::string::npos)
        << warnings[0];
    EXPECT_EQ(*std::max_element(tumours.voxels.begin(), tumours.voxels.end()), most);
    EXPECT_EQ(std::count(tumours.voxels.begin(), tumours.voxels.end(), most), 1);
    EXPECT_EQ(
        std::count_if(tumours.voxels.begin(), tumours.voxels.end(), [](auto v) { return v != 0; }),
        most);
    Mask organs(many.grid);
    add_tumours(tumours, organs);
    EXPECT_EQ(*std::max_element(organs.voxels.begin(), organs.voxels.end()), 255);
    fs::remove_all(folder);
}

TEST(ReconstructionLimits, StagesAreCountedForEveryWay) {
    ReconstructOptions options;
    EXPECT_EQ(stage_count(options), 12);
    options.liver_mask = "liver";
    EXPECT_EQ(stage_count(options), 12);
    options.tumour_masks = {"one", "two"};
    EXPECT_EQ(stage_count(options), 14);
    options.vessel_mask = "vessels";
    EXPECT_EQ(stage_count(options), 11);
    options.liver_mask.reset();
    options.tumour_masks.clear();
    EXPECT_EQ(stage_count(options), 8);
    EXPECT_EQ(built_in_stage_count(), 15);
}

TEST(ReconstructionLimits, TheParametersInFull) {
    EXPECT_EQ(
        parameters_json({}),
        R"({"liver_mask_given":false,"vessel_mask_given":false,"method":"coherent",)"
        R"("thinning":"queue","bridge_confidence":)" +
            [] {
                std::string number = std::to_string(BridgeOptions{}.confidence);
                return number.substr(0, number.find_last_not_of('0') + 1);
            }() +
            R"(,"refinement_recursions":0,"spacing_mm":0.0,"mesh":{)"
            R"("facet_size_in_radii":0.9,"cell_size_in_radii":1.0,)"
            R"("target_tetrahedra":20000,"minimum_radius_mm":0.0}})");
    ReconstructOptions options;
    options.liver_mask = "a";
    options.vessel_mask = "b";
    options.tumour_masks = {"c", "d"};
    options.method = SegmentationMethod::vesselness;
    options.window_hu = {120.0, 300.5};
    options.seeds = {{Vec3(1, -2, 3.5), VascularSystem::hepatic}};
    options.liver_labels = {5, 6};
    options.vessel_labels = {{64, VascularSystem::portal}};
    options.thinning = ThinningMethod::parallel;
    options.bridge_confidence = 0.75;
    options.refinement_recursions = 2;
    options.spacing_mm = 0.5;
    options.mesh.target_tetrahedra = 100;
    EXPECT_EQ(parameters_json(options),
              R"({"liver_mask_given":true,"vessel_mask_given":true,"tumour_masks_given":2,)"
              R"("method":"vesselness","window_hu":[120.0,300.5],"seeds":[{"position_mm":)"
              R"([1.0,-2.0,3.5],"system":"hepatic"}],"liver_labels":[5,6],"vessel_labels":)"
              R"([{"label":64,"system":"portal"}],"thinning":"parallel",)"
              R"("bridge_confidence":0.75,"refinement_recursions":2,"spacing_mm":0.5,"mesh":{)"
              R"("facet_size_in_radii":0.9,"cell_size_in_radii":1.0,)"
              R"("target_tetrahedra":100,"minimum_radius_mm":0.0}})");
    const GivenParts given = given_parts(parameters_json(options));
    EXPECT_TRUE(given.liver_mask);
    EXPECT_TRUE(given.vessel_mask);
    EXPECT_EQ(given.tumour_masks, 2u);
    EXPECT_EQ(given.window_hu, options.window_hu);
    EXPECT_EQ(given.seeds, options.seeds);
    for (const std::string& nothing :
         {parameters_json({}), std::string("[]"), std::string("no JSON"),
          std::string(R"({"liver_mask_given":1,"vessel_mask_given":"x","tumour_masks_given":-2,)"
                      R"("window_hu":[1],"seeds":[{"position_mm":[1,2]}]})")}) {
        const GivenParts none = given_parts(nothing);
        EXPECT_FALSE(none.liver_mask || none.vessel_mask || none.window_hu) << nothing;
        EXPECT_EQ(none.tumour_masks, 0u) << nothing;
        EXPECT_TRUE(none.seeds.empty()) << nothing;
    }
    ReconstructOptions built_in;
    built_in.liver_mask = "x";
    built_in.seeds = {{Vec3::Zero(), VascularSystem::portal}};
    EXPECT_EQ(built_in_parameters(), parameters_json(built_in));
}

// What is odd about the image is told with what is wrong.
TEST(ReconstructionLimits, TumoursWithoutALiverAreRefused) {
    const fs::path folder = fs::path(testing::TempDir()) / "hepatica tumours alone";
    fs::create_directories(folder);
    Volume ct(Grid{{32, 32, 16}}, 100);
    ct.voxels[0] = 50;
    Mask vessels(ct.grid);
    for (int y = 4; y < 28; ++y) vessels.at(16, y, 8) = 1;
    write_nifti(folder / "ct.nii.gz", ct);
    write_nifti(folder / "vessels.nii.gz", vessels);
    ReconstructOptions options;
    options.ct = folder / "ct.nii.gz";
    options.vessel_mask = folder / "vessels.nii.gz";
    options.tumour_masks = {folder / "vessels.nii.gz"};
    Job job;
    try {
        reconstruct(options, job);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_TRUE(error.problem().starts_with("tumours are given without a liver"));
        EXPECT_EQ(error.place(), (folder / "vessels.nii.gz").string());
    }
    fs::remove_all(folder);
}

// A liver of 1000 voxels, so many of which are vessels, in a window.
std::string problem_of_window(std::size_t vessels, double vessel_hu) {
    DetectedVessels found;
    const Grid grid{{10, 10, 10}};
    found.tissue.interior = Mask(grid, 1);
    found.detection.vessels = Mask(grid);
    std::fill_n(found.detection.vessels.voxels.begin(), vessels, std::uint8_t{1});
    try {
        require_contrast({110.0, 5.0, vessel_hu}, found, std::pair{114.0, 125.0});
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "window");
        return error.problem();
    }
    return "";
}

// Vessels that were enough, but too faint, were once told to be too few.
TEST(ReconstructionLimits, AWindowIsToldWhetherItsVesselsAreTooFewOrTooFaint) {
    EXPECT_EQ(problem_of_window(18, 114.0),
              "what lies between 114 and 125 HU and hangs together as vessels do rises only 4 HU "
              "above the tissue, which has 110 HU");
    EXPECT_EQ(problem_of_window(18, 90.0),
              "what lies between 114 and 125 HU is darker than the tissue, which has 110 HU");
    EXPECT_EQ(problem_of_window(1, 114.0),
              "only 0.10 % of the liver lie between 114 and 125 HU and hang together as vessels "
              "do; the tissue itself has 110 HU");
    EXPECT_EQ(problem_of_window(1, 170.0), problem_of_window(1, 114.0));
    EXPECT_EQ(problem_of_window(18, 170.0), "");
}

}  // namespace
}  // namespace hepatica
