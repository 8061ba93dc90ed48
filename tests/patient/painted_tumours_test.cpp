// SPDX-License-Identifier: GPL-3.0-or-later
// Tumours painted and erased as corrections of a patient: voxels of the organs, and nothing else.
#include "core/patient/painted_tumours.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "core/base/error.h"
#include "core/patient/corrections.h"
#include "tests/patient/parted_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

constexpr int z_middle = 20;

// In a CT of 80 mm a side a liver of 40 x 40 x 40 voxels of 1 mm, with a vena cava along one edge
// and tumour 1 of two voxels in a corner.
PatientCase patient_to_paint() {
    PatientCase patient = test::patient_with_bridges();
    Grid liver;
    liver.dims = {40, 40, 40};
    liver.origin_mm = Vec3(-20, 10, -20);
    patient.organs = Mask(liver, organ_label::liver);
    for (int z = 0; z < 40; ++z) patient.organs.at(39, 39, z) = organ_label::cava;
    for (int x : {0, 1}) patient.organs.at(x, 0, 0) = organ_label::first_tumour;
    patient.mask = Mask(liver);
    patient.mask.at(20, 20, z_middle) = 1;
    patient.source.image_grid = liver;
    patient.source.image_grid.dims = {80, 80, 80};
    patient.source.image_grid.origin_mm = Vec3(-40, -5, -40);
    return patient;
}

const Vec3 inside(0, 30, 0);  // the middle of the liver

TreeEdit painted(const Vec3& at, double radius, int tumour) {
    return tumour_edit({{at}, radius, false}, tumour);
}
TreeEdit erased(const Vec3& at, double radius, int tumour = 0) {
    return tumour_edit({{at}, radius, true}, tumour);
}

PatientCase with(const PatientCase& patient, const std::vector<TreeEdit>& edits) {
    Job job;
    return with_edits(patient, edits, job);
}

std::vector<int> numbers(const PatientCase& patient) {
    std::vector<int> found;
    for (const Tumour& tumour : tumours_in(patient.organs)) found.push_back(tumour.number);
    return found;
}

TEST(PaintedTumours, AreBallsOfTheirVolumeWhereTheyWerePainted) {
    const PatientCase after = with(patient_to_paint(), {painted(inside, 8.0, 2)});
    const std::vector<Tumour> tumours = tumours_in(after.organs);
    ASSERT_EQ(tumours.size(), 2u);
    EXPECT_EQ(tumours[0].number, 1);
    EXPECT_EQ(tumours[0].volume_ml, 0.002);
    EXPECT_EQ(tumours[1].number, 2);
    const double ball_ml = 4.0 / 3.0 * std::numbers::pi * 8.0 * 8.0 * 8.0 / 1000.0;
    EXPECT_NEAR(tumours[1].volume_ml, ball_ml, 0.02 * ball_ml);
    EXPECT_NEAR((tumours[1].middle_mm - inside).norm(), 0.0, 1e-9);
}

TEST(PaintedTumours, ChangeNoVesselAndAreUndoneToTheBit) {
    const PatientCase before = patient_to_paint();
    const TreeEdit stroke = painted(inside, 8.0, 2);
    const PatientCase after = with(before, {stroke});
    EXPECT_EQ(hash_of(after), hash_of(before));
    EXPECT_EQ(after.mask.voxels, before.mask.voxels);
    EXPECT_EQ(after.corrections.edits, std::vector{stroke});
    const PatientCase back = with(after, {});
    EXPECT_EQ(back.organs.voxels, before.organs.voxels);
    EXPECT_TRUE(same_grid(back.organs.grid, before.organs.grid));
    EXPECT_TRUE(back.corrections.unpainted.voxels.empty());
    EXPECT_TRUE(back.corrections.extracted.segments.empty());
    EXPECT_EQ(hash_of(back), hash_of(before));
}

// A vessel may run through a tumour, which keeps to itself what another tumour or the cava is.
TEST(PaintedTumours, EncloseVesselsAndSpareTheCavaAndOtherTumours) {
    const PatientCase before = patient_to_paint();
    const Grid& grid = before.organs.grid;
    const Vec3 cava = grid.to_mm(39, 39, z_middle), first = grid.to_mm(0, 0, 0);
    const PatientCase after =
        with(before, {painted(inside, 3.0, 2), painted(cava, 4.0, 3), painted(first, 4.0, 4)});
    EXPECT_EQ(tumour_of(value_at(after.organs, grid.to_mm(20, 20, z_middle))), 2);
    EXPECT_EQ(after.mask.at(20, 20, z_middle), 1) << "and it is a vessel still";
    EXPECT_EQ(value_at(after.organs, cava), organ_label::cava);
    EXPECT_EQ(tumour_of(value_at(after.organs, cava - Vec3(2, 0, 0))), 3);
    EXPECT_EQ(tumour_of(value_at(after.organs, first)), 1);
    EXPECT_EQ(tumour_of(value_at(after.organs, first + Vec3(0, 2, 0))), 4);
}

TEST(PaintedTumours, StickOutOfTheLiverAsFarAsThereIsACt) {
    const PatientCase before = patient_to_paint();
    const Grid& grid = before.organs.grid;
    const Vec3 outside = grid.to_mm(-6, 20, 20), beyond = grid.to_mm(-21, 20, 20);
    ASSERT_FALSE(holds(grid, outside));
    ASSERT_FALSE(holds(before.source.image_grid, beyond));
    const PatientCase after = with(before, {painted(outside, 30.0, 2)});
    EXPECT_EQ(tumour_of(value_at(after.organs, outside)), 2);
    EXPECT_FALSE(holds(after.organs.grid, beyond));
    const Grid canvas = tumour_canvas(before).grid;
    EXPECT_TRUE(reaches_beyond({{outside}, 30.0, false}, canvas)) << "part of it is cut off";
    EXPECT_FALSE(reaches_beyond({{inside}, 10.0, false}, canvas));
    EXPECT_TRUE(reaches_beyond({{inside, beyond}, 1.0, false}, canvas)) << "its end is cut off";
    EXPECT_TRUE(holds(after.organs.grid, grid.to_mm(-20, 20, 20)));
    const PatientCase partly = with(after, {painted(outside, 30.0, 2), erased(outside, 10.0)});
    EXPECT_EQ(value_at(partly.organs, outside), 0) << "outside it was no liver before";
    EXPECT_EQ(value_at(partly.organs, grid.to_mm(2, 20, 20)), organ_label::liver);
}

TEST(PaintedTumours, KeepTheirNumbersWhenOneIsErased) {
    const Vec3 left = inside - Vec3(12, 0, 0), right = inside + Vec3(12, 0, 0);
    const std::vector<TreeEdit> edits{painted(left, 3.0, 2), painted(right, 3.0, 3)};
    PatientCase patient = with(patient_to_paint(), edits);
    EXPECT_EQ(numbers(patient), (std::vector{1, 2, 3}));
    EXPECT_EQ(number_for_new(tumours_in(patient.organs)), 4);
    EXPECT_EQ(numbers_of(tumours_in(patient.organs)), "1, 2, 3");
    // Of one number, although the ball meets two; then of any.
    const TreeEdit of_two = erased(inside, 30.0, 2);
    patient = with(patient, {edits[0], edits[1], of_two});
    EXPECT_EQ(numbers(patient), (std::vector{1, 3}));
    EXPECT_EQ(number_for_new(tumours_in(patient.organs)), 4);
    patient = with(patient, {edits[0], edits[1], of_two, erased(inside, 45.0)});
    EXPECT_TRUE(numbers(patient).empty()) << "that of a mask, too";
    EXPECT_EQ(value_at(patient.organs, patient.organs.grid.to_mm(20, 0, 20)), 0);
    EXPECT_EQ(value_at(patient.organs, left), organ_label::liver);
    EXPECT_EQ(value_at(patient.organs, Vec3(-20, 10, -20)), organ_label::liver)
        << "what a mask called tumour is liver";
    EXPECT_EQ(numbers(with(patient, {})), std::vector{1});
}

TEST(PaintedTumours, AreKeptWithTheCaseAndCanBeTakenBackThere) {
    const fs::path folder = fs::path(testing::TempDir()) / "painted.hep";
    fs::remove_all(folder);
    const PatientCase before = patient_to_paint();
    const std::vector<TreeEdit> edits{painted(inside, 8.0, 2), erased(inside, 4.0, 2)};
    const PatientCase after = with(before, edits);
    write_case(folder, after);
    const PatientCase back = read_case(folder);
    EXPECT_EQ(back.organs.voxels, after.organs.voxels);
    EXPECT_EQ(back.corrections.edits, edits);
    EXPECT_EQ(with(back, {edits[0]}).organs.voxels, with(before, {edits[0]}).organs.voxels);
    EXPECT_EQ(with(back, {}).organs.voxels, before.organs.voxels);
    EXPECT_TRUE(may_hold_tumours(read_case_without_voxels(folder)));
    const auto version = [&] {
        std::ifstream in(folder / "case.json");
        return nlohmann::json::parse(in).at("version").get<int>();
    };
    EXPECT_EQ(version(), 3) << "for programs that know no strokes";
    write_case(folder, before);
    EXPECT_EQ(version(), 2);
    EXPECT_FALSE(fs::exists(folder / "organs_unpainted.nii.gz"));
    EXPECT_FALSE(may_hold_tumours(read_case_without_voxels(folder)));
    fs::remove_all(folder);
}

// A play reads the organs from the case, which lacks what was painted since.
TEST(PaintedTumours, ThatNoCaseHoldsYetAreAmongThePatientsOrgans) {
    const fs::path folder = fs::path(testing::TempDir()) / "organs_since.hep";
    const TreeEdit first = painted(inside, 4.0, 2), second = painted(Vec3(12, 30, 0), 4.0, 3);
    for (const bool with_liver : {true, false}) {
        PatientCase patient = patient_to_paint();
        if (!with_liver) patient.organs = {};
        for (const auto& saved : {std::vector<TreeEdit>{}, std::vector{first}}) {
            write_case(folder, with(patient, saved));
            const PatientCase read = read_case_without_voxels(folder);
            EXPECT_EQ(organs_of(read).voxels, with(patient, saved).organs.voxels);
            const PatientCase since = with(read, {first, second});
            ASSERT_TRUE(since.organs.voxels.empty());
            const Mask expected = with(patient, {first, second}).organs;
            EXPECT_EQ(organs_of(since).voxels, expected.voxels);
            EXPECT_TRUE(same_grid(organs_of(since).grid, expected.grid));
        }
    }
    fs::remove_all(folder);
}

// Whatever strokes the case on disk has: the first was saved and is taken back, or another took its
// place, or a second one was saved while a play went on with the first alone.
TEST(PaintedTumours, ThatTheCaseOnDiskHasAloneAreNoOrgans) {
    const fs::path folder = fs::path(testing::TempDir()) / "organs_taken_back.hep";
    const TreeEdit first = painted(inside, 4.0, 2), second = painted(Vec3(12, 30, 0), 4.0, 3);
    const PatientCase patient = patient_to_paint();
    write_case(folder, with(patient, {first}));
    const PatientCase read = read_case_without_voxels(folder);
    EXPECT_EQ(organs_of(with(read, {})).voxels, with(patient, {}).organs.voxels);
    EXPECT_EQ(organs_of(with(read, {second})).voxels, with(patient, {second}).organs.voxels);
    write_case(folder, with(patient, {first, second}));
    EXPECT_EQ(organs_of(read).voxels, with(patient, {first}).organs.voxels);
    fs::remove_all(folder);
}

TEST(PaintedTumours, OfACaseWithoutALiverLieOnTheGridOfItsVessels) {
    const fs::path folder = fs::path(testing::TempDir()) / "no liver.hep";
    fs::remove_all(folder);
    PatientCase before = patient_to_paint();
    before.organs = {};
    const TreeEdit stroke = painted(inside, 5.0, 1);
    write_case(folder, with(before, {stroke}));
    PatientCase after = read_case(folder);
    EXPECT_TRUE(same_grid(after.organs.grid, before.mask.grid));
    EXPECT_EQ(numbers(after), std::vector{1});
    EXPECT_TRUE(after.couinaud.voxels.empty()) << "a tumour is no liver";
    EXPECT_EQ(numbers(with(after, {stroke, painted(inside + Vec3(0, 12, 0), 4.0, 2)})),
              (std::vector{1, 2}));
    EXPECT_TRUE(with(after, {}).organs.voxels.empty());
    fs::remove_all(folder);
}

TEST(PaintedTumours, AStrokeThatTouchesNothingIsRefusedByItsNumber) {
    const auto refused = [](const std::vector<TreeEdit>& edits, const std::string& words) {
        try {
            with(patient_to_paint(), edits);
            ADD_FAILURE() << words;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
            EXPECT_NE(error.place().find("edit 2 at"), std::string::npos) << error.place();
        }
    };
    const TreeEdit first = painted(inside, 5.0, 2);
    refused({first, erased(inside, 2.0, 1)}, "no such tumour");
    refused({first, erased(inside + Vec3(0, 0, 15), 2.0)}, "no such tumour");
    refused({first, painted(inside, 2.0, 3)}, "nothing that could become tumour");
    refused({first, painted(Vec3(500, 0, 0), 2.0, 3)}, "nothing that could become tumour");
}

TEST(PaintedTumours, StandAmongEditsOfTheTree) {
    const PatientCase before = patient_to_paint();
    const TreeEdit link = acceptance_of(before.corrections.bridges[0]);
    const TreeEdit stroke = painted(inside, 5.0, 2);
    const PatientCase both = with(before, {stroke, link});
    EXPECT_EQ(hash_of(both), hash_of(with(before, {link})));
    EXPECT_EQ(numbers(both), (std::vector{1, 2}));
    EXPECT_EQ(hash_of(with(both, {stroke})), hash_of(before));
    EXPECT_EQ(tree_edits(both.corrections.edits), std::vector{link});
    EXPECT_EQ(tumour_strokes(both.corrections.edits), std::vector{stroke});
}

TEST(PaintedTumours, ThereAreAtMostAsManyAsLabels) {
    Mask organs(Grid{{256, 1, 1}});
    for (int n = 1; n <= most_tumours; ++n) organs.at(n, 0, 0) = label_of_tumour(n);
    std::vector<Tumour> all = tumours_in(organs);
    EXPECT_EQ(static_cast<int>(all.size()), most_tumours);
    EXPECT_EQ(number_for_new(all), 0);
    all.erase(all.begin() + 6);
    EXPECT_EQ(number_for_new(all), 7) << "a free one between them";
    EXPECT_EQ(number_for_new({}), 1);
}

}  // namespace
}  // namespace hepatica
