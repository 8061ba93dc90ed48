// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workspace.h"

#include <gtest/gtest.h>

#include "core/mesh/manifold_attempts.h"
#include "core/patient/painted_tumours.h"
#include "tests/support/test_trees.h"
#include "tests/ui/patients/fake_ward.h"
#include "ui/standing_warnings.h"

namespace hepatica {
namespace {

using testing::edit;
using testing::numbers_of;
using Numbers = std::vector<int>;

OpenedPatient case_on_disk() {
    OpenedPatient opened;
    opened.title = "a.hep";
    opened.folder = "/disk/a.hep";
    opened.patient = std::make_shared<const PatientCase>();
    return opened;
}

std::shared_ptr<const PatientCase> body_of(const Workspace::Edits& edits) {
    auto patient = std::make_shared<PatientCase>();
    patient->corrections.edits = edits;
    return patient;
}

TEST(Workspace, is_dirty_while_its_corrections_are_not_those_on_disk) {
    Workspace workspace;
    EXPECT_FALSE(workspace.has_patient());
    EXPECT_FALSE(workspace.dirty());
    workspace.open(case_on_disk());
    EXPECT_FALSE(workspace.dirty());
    workspace.add(edit(1));
    EXPECT_TRUE(workspace.dirty()) << "also before its body is there";
    workspace.show_body(body_of({edit(1)}));
    EXPECT_TRUE(workspace.dirty());
    workspace.saved("/disk/b.hep", {edit(1)}, {});
    EXPECT_FALSE(workspace.dirty());
    EXPECT_EQ(workspace.title(), "b.hep");
    EXPECT_EQ(workspace.folder(), "/disk/b.hep");
    workspace.undo();
    EXPECT_TRUE(workspace.dirty());
    workspace.redo();
    EXPECT_FALSE(workspace.dirty()) << "what is on disk again is not lost";
}

TEST(Workspace, a_reconstruction_is_worth_saving_and_a_patient_made_at_will_is_not) {
    Workspace workspace;
    OpenedPatient opened = case_on_disk();
    opened.folder.clear();
    workspace.open(opened);
    EXPECT_FALSE(workspace.dirty());
    opened.worth_saving = true;
    workspace.open(opened);
    EXPECT_TRUE(workspace.dirty());
    workspace.saved("/disk/a.hep", {}, {});
    EXPECT_FALSE(workspace.dirty());
}

TEST(Workspace, warnings_of_the_image_outlast_a_rebuilding_and_all_come_back_with_what_was_before) {
    Workspace workspace;
    OpenedPatient opened = case_on_disk();
    opened.warnings = {"thick slices", "a loop"};
    opened.warnings_of_image = {"thick slices"};
    workspace.open(opened);
    EXPECT_EQ(workspace.warnings(), opened.warnings);
    workspace.show_remade(body_of({}), body_of({}), 0, {"a piece is left out"});
    EXPECT_EQ(workspace.warnings(),
              (std::vector<std::string>{"a piece is left out", "thick slices"}));
    workspace.take_back_remaking();
    EXPECT_EQ(workspace.warnings(), opened.warnings);
    EXPECT_FALSE(workspace.dirty());
    workspace.redo_remaking();
    EXPECT_EQ(workspace.warnings(),
              (std::vector<std::string>{"a piece is left out", "thick slices"}));
    EXPECT_TRUE(workspace.dirty());
}

// A rebuilding that is asked for once more takes the place of the first, and of corrections that
// wait behind it.
TEST(Workspace, a_correction_that_waits_for_a_rebuilding_outlasts_it_beside_a_tumour) {
    Workspace workspace;
    workspace.open(case_on_disk());
    TreeEdit tumour = edit(2);
    tumour.kind = TreeEditKind::paint_tumour;
    workspace.add(edit(1));
    workspace.add(tumour);
    const Workspace::Edits begun_with = workspace.made_edits();
    ASSERT_EQ(begun_with, Workspace::Edits{tumour});
    workspace.add(edit(3));
    workspace.show_remade(body_of(begun_with), body_of(begun_with));
    EXPECT_EQ(workspace.edits(), (Workspace::Edits{tumour, edit(1), edit(3)}));
    EXPECT_TRUE(workspace.awaits_body());
}

TEST(StandingWarnings, FollowWhatIsSaidOfTheVessels) {
    const std::vector<std::string> told{"a", "image", "b"};
    EXPECT_EQ(still_standing(told, {"a", "b"}, {"b", "c"}),
              (std::vector<std::string>{"c", "image", "b"}));
    EXPECT_EQ(still_standing(told, {}, {}), told);
    EXPECT_EQ(still_standing({}, {"never told"}, {"never told"}), std::vector<std::string>());
}

TEST(StandingWarnings, SayThatABodyMeetsItself) {
    PatientCase patient;
    patient.tree = test::forked_tree();
    const std::size_t others = said_of_vessels(patient).size();
    report_unclosed(1, 1, &patient.warnings);
    EXPECT_EQ(said_of_vessels(patient).size(), others + 1);
}

// A journal of a program that noted none says nothing of measurements.
TEST(Workspace, takes_up_the_measurements_that_an_earlier_run_left_where_it_knew_them) {
    const std::vector<KeptMeasurement> in_case{
        {MeasurementKind::distance, {Vec3(1, 2, 3), Vec3(1, 2, 8)}}};
    const std::vector<KeptMeasurement> left{
        {MeasurementKind::distance, {Vec3(0, 0, 0), Vec3(0, 0, 4)}}};
    OpenedPatient opened = case_on_disk();
    auto patient = std::make_shared<PatientCase>();
    patient->measured = in_case;
    opened.patient = patient;
    Workspace workspace;
    workspace.open(opened);
    workspace.take_up({{}, {}, 0, "edits.jsonl"});
    EXPECT_EQ(workspace.measured(), in_case);
    EXPECT_FALSE(workspace.dirty());
    workspace.take_up({{}, {}, 0, "edits.jsonl", left});
    EXPECT_EQ(workspace.measured(), left);
    EXPECT_TRUE(workspace.dirty());
    workspace.take_up({{}, {}, 0, "edits.jsonl", std::vector<KeptMeasurement>{}});
    EXPECT_TRUE(workspace.measured().empty()) << "they had all been removed";
}

TEST(Workspace, undo_and_redo_walk_over_what_is_wanted) {
    Workspace workspace;
    workspace.open(case_on_disk());
    workspace.undo();
    workspace.redo();
    EXPECT_FALSE(workspace.awaits_body());
    for (const int number : {1, 2, 3}) workspace.add(edit(number));
    workspace.undo();
    workspace.undo();
    EXPECT_EQ(numbers_of(workspace.edits()), Numbers{1});
    workspace.redo();
    EXPECT_EQ(numbers_of(workspace.edits()), (Numbers{1, 2}));
    workspace.add(edit(4));
    EXPECT_FALSE(workspace.next_redo()) << "another way was taken";
    EXPECT_EQ(numbers_of(workspace.edits()), (Numbers{1, 2, 4}));
    EXPECT_TRUE(workspace.patient()->corrections.edits.empty()) << "none has a body yet";
}

TEST(Workspace, what_was_added_together_is_one_step_of_undo_and_redo) {
    Workspace workspace;
    workspace.open(case_on_disk());
    workspace.add(edit(1));
    workspace.add_all({edit(2), edit(3)});
    workspace.add_all({edit(4), edit(5)});
    ASSERT_TRUE(workspace.next_undo());
    EXPECT_EQ(numbers_of(workspace.next_undo()->edits), (Numbers{4, 5}));
    EXPECT_TRUE(workspace.undo());
    EXPECT_EQ(numbers_of(workspace.edits()), (Numbers{1, 2, 3}));
    ASSERT_TRUE(workspace.next_redo());
    EXPECT_EQ(numbers_of(workspace.next_redo()->edits), (Numbers{4, 5}));
    workspace.undo();
    EXPECT_EQ(numbers_of(workspace.edits()), Numbers{1});
    EXPECT_TRUE(workspace.redo());
    EXPECT_EQ(numbers_of(workspace.edits()), (Numbers{1, 2, 3}));
    workspace.redo();
    EXPECT_EQ(numbers_of(workspace.edits()), (Numbers{1, 2, 3, 4, 5}));
}

// Also after one of them was refused, which makes none of the others part of another step.
TEST(Workspace, a_step_stays_one_when_its_first_correction_was_refused) {
    Workspace workspace;
    workspace.open(case_on_disk());
    workspace.add_all({edit(1), edit(2)});
    workspace.add_all({edit(-3), edit(4), edit(5)});
    Workspace::Edits made = workspace.edits();
    made.erase(made.begin() + 2);
    workspace.show_body(body_of(made));
    workspace.undo();
    EXPECT_EQ(numbers_of(workspace.edits()), (Numbers{1, 2}));
}

TEST(Workspace, an_edit_undone_before_it_had_a_body_needs_none) {
    Workspace workspace;
    workspace.open(case_on_disk());
    workspace.add(edit(1));
    EXPECT_TRUE(workspace.awaits_body());
    workspace.undo();
    EXPECT_FALSE(workspace.awaits_body());
    EXPECT_TRUE(workspace.next_redo());
}

TEST(Workspace, what_a_body_leaves_out_was_refused) {
    Workspace workspace;
    workspace.open(case_on_disk());
    for (const int number : {1, -2, 3}) workspace.add(edit(number));
    const std::uint64_t before = workspace.version();
    workspace.show_body(body_of({edit(1), edit(3)}));
    EXPECT_EQ(numbers_of(workspace.edits()), (Numbers{1, 3}));
    EXPECT_FALSE(workspace.awaits_body());
    EXPECT_NE(workspace.version(), before) << "something else is wanted now";
}

// Strokes at tumours need no body, whatever happens to corrections of the tree among them.
TEST(Workspace, strokes_at_tumours_are_corrections_that_are_made_at_once) {
    const TreeEdit stroke = tumour_edit({{Vec3::Zero()}, 2.0, false}, 1);
    const TreeEdit other = tumour_edit({{Vec3::Zero()}, 1.0, true}, 1);
    Workspace workspace;
    workspace.open(case_on_disk());
    workspace.add(stroke);
    EXPECT_TRUE(workspace.dirty());
    EXPECT_FALSE(workspace.awaits_body());
    EXPECT_EQ(workspace.made_edits(), Workspace::Edits{stroke});
    workspace.add(edit(1));
    workspace.add(other);
    EXPECT_TRUE(workspace.awaits_body());
    EXPECT_EQ(workspace.made_edits(), (Workspace::Edits{stroke, other})) << "what can be written";
    workspace.show_body(body_of({stroke, edit(1)}));
    EXPECT_FALSE(workspace.awaits_body());
    EXPECT_EQ(workspace.edits(), (Workspace::Edits{stroke, edit(1), other}));
    EXPECT_FALSE(workspace.undo()) << "the tree stays";
    EXPECT_TRUE(workspace.undo());
    EXPECT_EQ(workspace.made_edits(), (Workspace::Edits{stroke, edit(1)})) << "of the body";
    workspace.give_up_edits();
    EXPECT_EQ(workspace.edits(), (Workspace::Edits{stroke, edit(1)}));
    workspace.add(edit(-1));
    workspace.add(other);
    workspace.show_body(body_of({stroke, edit(1)}));
    EXPECT_EQ(workspace.edits(), (Workspace::Edits{stroke, edit(1), other})) << "-1 was refused";
}

TEST(Workspace, giving_up_goes_back_to_what_is_shown) {
    Workspace workspace;
    workspace.open(case_on_disk());
    workspace.add(edit(1));
    workspace.show_body(body_of({edit(1)}));
    workspace.undo();
    workspace.give_up_edits();
    EXPECT_EQ(numbers_of(workspace.edits()), Numbers{1});
    EXPECT_FALSE(workspace.next_redo());
    EXPECT_EQ(workspace.give_up_edits().steps, 0u) << "nothing waits";
}

TEST(Workspace, what_is_given_up_before_its_body_can_be_redone_step_by_step) {
    const TreeEdit stroke = tumour_edit({{Vec3::Zero()}, 2.0, false}, 1);
    Workspace workspace;
    workspace.open(case_on_disk());
    workspace.add(edit(1));
    workspace.show_body(body_of({edit(1)}));
    workspace.add(edit(2));
    workspace.add(stroke);
    workspace.add_all({edit(3), edit(4)});
    workspace.add(edit(5));
    workspace.undo();
    EXPECT_EQ(workspace.give_up_edits().steps, 2u);
    EXPECT_EQ(workspace.edits(), (Workspace::Edits{edit(1), stroke}));
    std::vector<Numbers> redone;
    while (workspace.next_redo()) {
        redone.push_back(numbers_of(workspace.next_redo()->edits));
        workspace.redo();
    }
    EXPECT_EQ(redone, (std::vector<Numbers>{{2}, {3, 4}, {5}}));
}

}  // namespace
}  // namespace hepatica
