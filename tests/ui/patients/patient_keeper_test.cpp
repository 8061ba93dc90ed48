// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/patient_keeper.h"

#include <gtest/gtest.h>

#include <QDate>
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "core/patient/painted_tumours.h"
#include "tests/session/small_patient.h"
#include "tests/ui/patients/keeper_test.h"
#include "ui/edit_journal.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

using testing::edit;
using testing::FakeWard;
using testing::numbers_of;
using Numbers = std::vector<int>;

class Keeper : public testing::KeeperTest {};
// The patient plays on: nobody is shown anew.
TEST_F(Keeper, strokes_at_tumours_make_no_body_and_are_saved_and_undone_like_all_else) {
    const TreeEdit stroke = tumour_edit({{Vec3::Zero()}, 2.0, false}, 1);
    add(1);
    ASSERT_TRUE(ward.finish());
    const std::size_t shown = ward.shown.size();
    ward.keeper().add(stroke);
    EXPECT_FALSE(ward.keeper().jobs().busy());
    EXPECT_TRUE(ward.workspace().dirty());
    ward.keeper().save();
    ASSERT_TRUE(ward.finish());
    EXPECT_FALSE(ward.workspace().dirty());
    EXPECT_EQ(ward.edits_on_disk("a.hep").back(), stroke);
    ward.keeper().undo_tumour_stroke();
    EXPECT_TRUE(ward.workspace().dirty());
    EXPECT_EQ(edits(), Numbers{1});
    ward.keeper().undo_tumour_stroke();
    EXPECT_EQ(edits(), Numbers{1}) << "that is no stroke";
    ward.keeper().redo();
    EXPECT_FALSE(ward.keeper().jobs().busy());
    EXPECT_FALSE(ward.workspace().dirty());
    EXPECT_EQ(ward.shown.size(), shown);
}

// One that comes while a body is being made does not begin that anew.
TEST_F(Keeper, strokes_at_tumours_leave_the_body_that_is_being_made_alone) {
    const TreeEdit stroke = tumour_edit({{Vec3::Zero()}, 2.0, false}, 1);
    ward.hold_corrections = true;
    add(1);
    ASSERT_TRUE(QTest::qWaitFor([this] { return ward.corrections_begun == 1; }, 60000));
    ward.keeper().add(stroke);
    ward.hold_corrections = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.corrections_begun, 1);
    EXPECT_EQ(ward.workspace().edits().back(), stroke);
    EXPECT_EQ(ward.workspace().edits().size(), 2u);
    EXPECT_FALSE(ward.workspace().awaits_body());
    ward.keeper().save();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.edits_on_disk("a.hep").size(), 2u);
}

TEST_F(Keeper, what_was_saved_before_an_undo_is_not_taken_for_what_was_before) {
    remake(7);
    ASSERT_TRUE(ward.finish());
    ward.keeper().save();
    ASSERT_TRUE(ward.finish());
    ward.keeper().undo();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(label(), 1);
    EXPECT_TRUE(ward.workspace().dirty());
}

TEST_F(Keeper, saving_while_a_correction_is_made_saves_the_correction) {
    ward.hold_corrections = true;
    add(1);
    ward.keeper().save();
    ward.hold_corrections = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{1});
    EXPECT_EQ(numbers_of(ward.workspace().patient()->corrections.edits), Numbers{1});
    EXPECT_FALSE(ward.workspace().dirty());
}

TEST_F(Keeper, correcting_while_a_case_is_written_disturbs_neither) {
    ward.hold_saves = true;
    add(1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !ward.workspace().awaits_body(); }));
    ward.keeper().save();
    add(2);
    ward.hold_saves = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{1});
    EXPECT_EQ(numbers_of(ward.workspace().patient()->corrections.edits), (Numbers{1, 2}));
    EXPECT_TRUE(ward.workspace().dirty());
}

TEST_F(Keeper, a_newer_correction_does_not_push_the_save_before_it_aside) {
    ward.hold_corrections = true;
    add(1);
    save_as("b.hep");
    add(2);
    ward.hold_corrections = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.on_disk("b.hep"), (Numbers{1, 2}));
    EXPECT_FALSE(ward.workspace().dirty());
    EXPECT_EQ(ward.workspace().folder(), FakeWard::path_of("b.hep"));
}

TEST_F(Keeper, an_impossible_correction_is_refused_with_a_word_and_takes_no_other_with_it) {
    ward.hold_corrections = true;
    for (const int number : {1, -2, 3}) add(number);
    ward.hold_corrections = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(numbers_of(ward.workspace().patient()->corrections.edits), (Numbers{1, 3}));
    EXPECT_EQ(ward.failures, std::vector<std::string>{"Correcting the tree: cannot be made"});
}

TEST_F(Keeper, takes_all_that_is_offered_by_one_body_and_one_step) {
    ward.offered = {edit(2), edit(3), edit(4)};
    ward.hold_corrections = true;
    add(1);
    ward.keeper().accept_offers(0.5);
    EXPECT_TRUE(ward.keeper().makes_vessels());
    ward.hold_corrections = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(numbers_of(ward.offers_asked), Numbers{1}) << "after the corrections before it";
    EXPECT_EQ(numbers_of(ward.workspace().patient()->corrections.edits), (Numbers{1, 2, 3, 4}));
    EXPECT_EQ(ward.corrections_begun, 2);
    ASSERT_GE(ward.titles.size(), 2u);
    EXPECT_EQ(*(ward.titles.end() - 2), "Taking what is offered");
    ward.keeper().save();
    ASSERT_TRUE(ward.finish());
    ward.open("a.hep");
    ASSERT_TRUE(ward.finish());
    ward.keeper().undo();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(numbers_of(ward.workspace().edits()), Numbers{1}) << "also of an earlier run";
}

TEST_F(Keeper, saves_what_is_being_taken_and_asks_about_it_before_it_leaves) {
    ward.offered = {edit(2), edit(3)};
    ward.hold_offers = true;
    ward.keeper().accept_offers(0.5);
    ward.keeper().save();
    ward.hold_offers = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_FALSE(ward.workspace().dirty());
    EXPECT_EQ(numbers_of(ward.workspace().patient()->corrections.edits), (Numbers{2, 3}));
    ward.offered = {edit(4), edit(5)};
    ward.hold_offers = true;
    ward.keeper().accept_offers(0.5);
    const int asked = ward.questions;
    ward.leave();
    EXPECT_FALSE(ward.left);
    EXPECT_EQ(ward.questions, asked) << "it is not known yet what will be taken";
    ward.hold_offers = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.questions, asked + 1);
    EXPECT_FALSE(ward.left);
}

// What is measured meanwhile is no correction.
TEST_F(Keeper, takes_what_is_offered_while_somebody_measures) {
    ward.offered = {edit(2), edit(3)};
    ward.hold_offers = true;
    ward.keeper().accept_offers(0.5);
    ward.keeper().measure({{.points_mm = {Vec3(0, 0, 0), Vec3(1, 0, 0)}}});
    ward.hold_offers = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(numbers_of(ward.workspace().edits()), (Numbers{2, 3}));
}

TEST_F(Keeper, takes_nothing_that_was_looked_for_before_another_correction_or_a_cancel) {
    ward.offered = {edit(2), edit(3)};
    ward.hold_offers = true;
    ward.keeper().accept_offers(0.5);
    add(1);
    ward.hold_offers = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(numbers_of(ward.workspace().edits()), Numbers{1});
    EXPECT_EQ(ward.said.back(), "Nothing was taken, because something was corrected meanwhile");
    ward.hold_offers = true;
    ward.keeper().accept_offers(0.5);
    ward.keeper().cancel();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(numbers_of(ward.workspace().edits()), Numbers{1});
    EXPECT_EQ(ward.said.back(), "Nothing was taken");
    ward.hold_offers = false;
    ward.offered.clear();
    ward.keeper().accept_offers(0.5);
    ASSERT_TRUE(ward.finish());
    EXPECT_TRUE(ward.said.back().starts_with("None of them fits")) << ward.said.back();
}

TEST_F(Keeper, cancel_takes_the_correction_back_and_lets_the_save_go_on) {
    ward.hold_corrections = true;
    add(1);
    save_as("b.hep");
    ward.keeper().cancel();
    ASSERT_TRUE(ward.finish());
    EXPECT_TRUE(ward.workspace().edits().empty());
    EXPECT_EQ(ward.on_disk("b.hep"), Numbers{});
    EXPECT_EQ(ward.said,
              (std::vector<std::string>{"Saved /disk/a.hep",
                                        "1 correction(s) taken back; Redo makes them again",
                                        "Saved /disk/b.hep"}));
}

// Each click makes the body anew, so that many may wait when the person has enough of waiting.
TEST_F(Keeper, cancel_leaves_what_waited_to_be_redone) {
    add(1);
    ASSERT_TRUE(ward.finish());
    ward.hold_corrections = true;
    ward.keeper().add_all({edit(2), edit(3)});
    add(4);
    ward.keeper().cancel();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(numbers_of(ward.workspace().edits()), Numbers{1});
    EXPECT_EQ(ward.said.back(), "2 correction(s) taken back; Redo makes them again");
    ward.hold_corrections = false;
    ward.keeper().redo();
    ward.keeper().redo();
    ward.keeper().redo();  // nothing is left
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(numbers_of(ward.workspace().edits()), (Numbers{1, 2, 3, 4}));
    EXPECT_FALSE(ward.workspace().awaits_body());
    ward.hold_corrections = true;
    ward.keeper().undo();
    ward.keeper().cancel();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(numbers_of(ward.workspace().edits()), (Numbers{1, 2, 3, 4}));
    EXPECT_EQ(ward.said.back(), "Cancelled: what was undone is there again");
}

TEST_F(Keeper, leaves_without_a_question_what_is_saved) {
    ward.leave();
    EXPECT_TRUE(ward.left);
    EXPECT_EQ(ward.questions, 0);
}

TEST_F(Keeper, asks_before_unsaved_corrections_are_left_also_while_they_are_made) {
    for (const bool body_is_there : {false, true}) {
        ward.hold_corrections = !body_is_there;
        ward.questions = 0;
        ward.left = false;
        add(1);
        if (body_is_there) {
            ASSERT_TRUE(ward.finish());
        }
        ward.answer = UnsavedAnswer::cancel;
        ward.leave();
        EXPECT_EQ(ward.questions, 1);
        EXPECT_FALSE(ward.left);
        ward.answer = UnsavedAnswer::discard;
        ward.leave();
        EXPECT_EQ(ward.questions, 2) << "the last answer was for the last time";
        EXPECT_TRUE(ward.left);
    }
}

TEST_F(Keeper, leaves_after_saving_and_not_before) {
    ward.hold_corrections = true;
    add(1);
    ward.answer = UnsavedAnswer::save;
    ward.leave();
    EXPECT_FALSE(ward.left);
    ward.hold_corrections = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_TRUE(ward.left);
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{1});
}

TEST_F(Keeper, stays_where_the_save_fails_is_cancelled_or_has_no_place) {
    add(1);
    ASSERT_TRUE(ward.finish());
    ward.answer = UnsavedAnswer::save;
    ward.disk_full = true;
    ward.leave();
    ASSERT_TRUE(ward.finish());
    EXPECT_FALSE(ward.left);
    EXPECT_EQ(ward.failures, std::vector<std::string>{"Saving a.hep: the disk is full"});
    EXPECT_TRUE(ward.workspace().dirty());

    ward.disk_full = false;
    ward.hold_corrections = true;
    add(2);
    ward.leave();
    ward.keeper().cancel();  // the correction, so that not all would be saved
    ASSERT_TRUE(ward.finish());
    EXPECT_FALSE(ward.left);

    ward.answer = UnsavedAnswer::discard;
    ward.open("ct2");
    ASSERT_TRUE(ward.finish());
    ASSERT_EQ(ward.workspace().title(), "ct2");
    ward.answer = UnsavedAnswer::save;
    ward.leave();
    EXPECT_EQ(ward.places_asked, 1);
    EXPECT_FALSE(ward.left);
}

TEST_F(Keeper, a_reconstruction_that_was_never_saved_is_asked_about) {
    ward.open("ct2");
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.questions, 0) << "the one before was saved";
    ward.place = "c.hep";
    ward.answer = UnsavedAnswer::save;
    ward.open_built_in();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.questions, 1);
    EXPECT_TRUE(ward.disk_holds("c.hep"));
    EXPECT_EQ(ward.workspace().title(), "built-in");
    ward.leave();
    EXPECT_EQ(ward.questions, 1) << "it can be made again at will";
}

TEST_F(Keeper, what_was_corrected_while_another_patient_was_made_ready_is_asked_about) {
    ward.hold_openings = true;
    ward.open("ct2");
    add(1);
    ward.answer = UnsavedAnswer::save;
    ward.hold_openings = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.questions, 1);
    EXPECT_EQ(ward.on_disk("a.hep"), Numbers{1});
    EXPECT_EQ(ward.workspace().title(), "ct2");
}

TEST_F(Keeper, what_was_discarded_for_another_patient_is_asked_about_once) {
    add(1);
    ASSERT_TRUE(ward.finish());
    ward.answer = UnsavedAnswer::discard;
    ward.open("ct2");
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.questions, 1);
    EXPECT_EQ(ward.workspace().title(), "ct2");
    EXPECT_TRUE(ward.workspace().edits().empty());
}

TEST_F(Keeper, a_discarded_patient_stays_as_he_is_where_the_other_cannot_be_opened) {
    add(1);
    ward.answer = UnsavedAnswer::discard;
    ward.open("missing.hep");
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.workspace().title(), "a.hep");
    EXPECT_EQ(numbers_of(ward.workspace().patient()->corrections.edits), Numbers{1});
    EXPECT_TRUE(ward.workspace().dirty());
    ward.answer = UnsavedAnswer::cancel;
    ward.leave();
    EXPECT_EQ(ward.questions, 2);
    EXPECT_FALSE(ward.left);
}

TEST_F(Keeper, asks_once_which_of_several_series_is_meant_and_reads_that_one) {
    ward.series = 2;
    ward.open("ct of two");
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.series_asked, 1);
    EXPECT_EQ(ward.shown.back(), "ct of two, series 2");
    EXPECT_EQ(ward.titles.back(), "Opening ct of two 2") << "which of them is read";
    EXPECT_EQ(ward.workspace().series(), 2);
    ward.answer = UnsavedAnswer::discard;
    ward.open("ct");
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.workspace().series(), 0) << "nothing was asked of this one";
}

TEST_F(Keeper, stays_where_none_of_the_series_is_meant) {
    ward.open("ct of two");
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.series_asked, 1);
    EXPECT_EQ(ward.shown, std::vector<std::string>{"ct"});
    EXPECT_EQ(ward.said.back(), "Cancelled");
    EXPECT_FALSE(ward.workspace().dirty());
}

TEST_F(Keeper, a_newer_opening_takes_the_place_of_an_older_one) {
    ward.hold_openings = true;
    ward.open("ct2");
    ward.open("ct3");
    ward.hold_openings = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.shown, (std::vector<std::string>{"ct", "ct3"}));
}

TEST_F(Keeper, a_case_that_is_being_written_is_finished_before_the_end) {
    ward.hold_saves = true;
    add(1);
    save_as("b.hep");
    ASSERT_TRUE(QTest::qWaitFor([&] { return !ward.workspace().awaits_body(); }));
    ward.leave();
    EXPECT_FALSE(ward.left);
    EXPECT_EQ(ward.questions, 0) << "it is being saved already";
    ward.hold_saves = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_TRUE(ward.left);
    EXPECT_EQ(ward.on_disk("b.hep"), Numbers{1});
}

TEST_F(Keeper, a_case_saved_over_while_it_was_opened_is_read_again) {
    save_as("c.hep");
    ASSERT_TRUE(ward.finish());
    save_as("a.hep");
    ASSERT_TRUE(ward.finish());
    ward.hold_openings = true;
    ward.open("c.hep");
    add(1);
    save_as("c.hep");
    save_as("b.hep");
    ward.hold_openings = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.workspace().title(), "c.hep");
    EXPECT_EQ(ward.on_disk("c.hep"), ward.on_disk("b.hep"));
    EXPECT_EQ(numbers_of(ward.workspace().edits()), ward.on_disk("c.hep"));
}

// As a program left them that ended without a word.
TEST_F(Keeper, makes_the_edits_again_that_another_program_left) {
    OpenRequest request;
    request.reconstruct.ct = FakeWard::path_of("a.hep");
    request.left_edits =
        LeftEdits{{edit(1), edit(2)}, {{{{Vec3::Zero()}, 2.0, false}, 1}}, 0, "edits.jsonl"};
    ward.keeper().open(request);
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.shown.back(), "+");
    EXPECT_EQ(edits(), (std::vector<int>{1, 2}));
    EXPECT_EQ(numbers_of(ward.workspace().patient()->corrections.edits), edits());
    EXPECT_TRUE(ward.workspace().dirty());
    // The stroke came before the second of them.
    EXPECT_EQ(ward.workspace().strokes(), request.left_edits->strokes);
    EXPECT_FALSE(ward.workspace().undo_is_of_stroke());
    ward.keeper().undo();
    ASSERT_TRUE(ward.finish());
    EXPECT_TRUE(ward.workspace().undo_is_of_stroke());
}

}  // namespace
}  // namespace hepatica
