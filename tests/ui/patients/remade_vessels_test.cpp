// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of corrections, strokes and undo when the vessels are made anew of painted voxels.
#include <gtest/gtest.h>

#include <QTest>

#include "core/patient/painted_tumours.h"
#include "tests/ui/patients/keeper_test.h"
#include "ui/patient_keeper.h"

namespace hepatica {
namespace {

using testing::edit;
using testing::FakeWard;
using testing::numbers_of;
using Numbers = std::vector<int>;

class RemadeVessels : public testing::KeeperTest {};

TEST_F(RemadeVessels, vessels_made_anew_keep_the_corrections_that_still_can_be_made) {
    for (const int number : {1, 100, 2}) add(number);
    ASSERT_TRUE(ward.finish());
    ward.keeper().save();
    remake(7);
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(label(), 7);
    EXPECT_EQ(edits(), (Numbers{1, 2}));
    EXPECT_EQ(ward.shown.back(), "+");
    EXPECT_TRUE(ward.workspace().dirty()) << "the voxels are not on disk";
    ward.keeper().save();
    ASSERT_TRUE(ward.finish());
    EXPECT_FALSE(ward.workspace().dirty());
    EXPECT_EQ(ward.on_disk("a.hep"), (Numbers{1, 2}));
}

TEST_F(RemadeVessels, undo_goes_back_over_what_was_made_anew) {
    add(1);
    ASSERT_TRUE(ward.finish());
    ward.keeper().save();
    remake(7);
    ASSERT_TRUE(ward.finish());
    EXPECT_TRUE(ward.workspace().dirty()) << "although its corrections are those on disk";
    add(2);
    ASSERT_TRUE(ward.finish());
    ward.keeper().undo();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(label(), 7);
    EXPECT_EQ(edits(), Numbers{1});
    ward.keeper().undo();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(label(), 1);
    EXPECT_EQ(edits(), Numbers{1});
    EXPECT_FALSE(ward.workspace().dirty()) << "that is what lies on disk";
    ward.keeper().undo();
    ASSERT_TRUE(ward.finish());
    EXPECT_TRUE(edits().empty());
    EXPECT_FALSE(ward.workspace().next_undo());
}

TEST_F(RemadeVessels, a_correction_while_vessels_are_made_anew_is_made_on_them) {
    add(1);
    ASSERT_TRUE(ward.finish());
    ward.hold_remakings = true;
    remake(7);
    add(2);
    ward.keeper().undo();
    EXPECT_EQ(edits(), (Numbers{1, 2})) << "undo waits";
    EXPECT_NE(ward.said.back().find("being rebuilt"), std::string::npos);
    ward.hold_remakings = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(label(), 7);
    EXPECT_EQ(edits(), (Numbers{1, 2}));
    EXPECT_EQ(numbers_of(ward.workspace().patient()->corrections.edits), (Numbers{1, 2}));
}

TEST_F(RemadeVessels, vessels_that_cannot_be_made_anew_leave_the_patient_as_he_is) {
    add(1);
    ASSERT_TRUE(ward.finish());
    ward.keeper().remake(std::make_shared<const Volume>(), Mask());
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.failures, std::vector<std::string>{"Rebuilding the vessels: no vessel is left"});
    ward.hold_remakings = true;
    remake(7);
    ward.keeper().cancel();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(label(), 1);
    EXPECT_EQ(edits(), Numbers{1});
    EXPECT_NE(ward.said.back().find("still there"), std::string::npos);
    // Another patient drops it.
    remake(7);
    ward.answer = UnsavedAnswer::discard;
    ward.open("ct of another");
    ward.hold_remakings = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(label(), 1);
    EXPECT_FALSE(ward.workspace().next_undo());
}

TEST_F(RemadeVessels, what_was_painted_on_one_patient_is_not_made_into_the_next) {
    ward.hold_openings = true;
    ward.open("ct of another");
    remake(7);
    ward.hold_openings = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.workspace().title(), "ct of another");
    EXPECT_EQ(label(), 1);
}

TEST_F(RemadeVessels, a_stroke_is_not_taken_back_through_a_rebuilding) {
    const auto stroke = [&](int number) {
        TreeEdit one = edit(number);
        one.kind = TreeEditKind::paint_tumour;
        one.path_mm = {Vec3::Zero()};
        one.radii_mm = {1.0};
        one.tumour = 1;
        ward.keeper().add(one);
    };
    stroke(1);
    ASSERT_TRUE(ward.finish());
    remake(7);
    ASSERT_TRUE(ward.finish());
    ward.keeper().undo_tumour_stroke();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(label(), 7);
    EXPECT_EQ(edits().size(), 1u);
}

TEST_F(RemadeVessels, a_rebuilding_that_was_taken_back_is_done_again_with_what_followed_it) {
    add(1);
    ASSERT_TRUE(ward.finish());
    ward.keeper().add_stroke({{Vec3::Zero()}, 2.0, false});
    remake(7);
    ASSERT_TRUE(ward.finish());
    add(2);
    ASSERT_TRUE(ward.finish());
    const auto undo = [&] {
        ward.keeper().undo();
        return ward.finish();
    };
    const auto redo = [&] {
        ward.keeper().redo();
        return ward.finish();
    };
    ASSERT_TRUE(undo() && undo());
    EXPECT_NE(label(), 7);
    EXPECT_EQ(ward.workspace().strokes().size(), 1u) << "it waits for a rebuilding again";
    ASSERT_TRUE(redo());
    EXPECT_EQ(label(), 7);
    EXPECT_TRUE(ward.workspace().strokes().empty());
    EXPECT_EQ(edits(), std::vector{1});
    ASSERT_TRUE(redo());
    EXPECT_EQ(edits(), (std::vector{1, 2}));
    EXPECT_FALSE(ward.workspace().next_redo().has_value());
    ASSERT_TRUE(undo() && undo());
    EXPECT_NE(label(), 7) << "and taken back once more";
    // What was undone before it is redone before it.
    ASSERT_TRUE(undo() && undo());
    EXPECT_TRUE(edits().empty());
    EXPECT_TRUE(ward.workspace().strokes().empty());
    ASSERT_TRUE(redo() && redo() && redo() && redo());
    EXPECT_EQ(label(), 7);
    EXPECT_EQ(edits(), (std::vector{1, 2}));
}

TEST_F(RemadeVessels, a_rebuilding_that_was_taken_back_is_gone_once_something_else_is_done) {
    remake(7);
    ASSERT_TRUE(ward.finish());
    ward.keeper().undo();
    ASSERT_TRUE(ward.finish());
    ASSERT_TRUE(ward.workspace().next_redo().has_value());
    add(3);
    ASSERT_TRUE(ward.finish());
    ward.keeper().undo();
    ASSERT_TRUE(ward.finish());
    ward.keeper().redo();
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(edits(), std::vector{3});
    EXPECT_FALSE(ward.workspace().next_redo().has_value());
}

// A case keeps no vessels from before a rebuilding: what undo cannot take back it does not pass
// over without a word.
TEST_F(RemadeVessels, undo_says_that_a_rebuilding_from_before_the_case_was_opened_stays) {
    add(1);
    ASSERT_TRUE(ward.finish());
    remake(7);
    ASSERT_TRUE(ward.finish());
    add(2);
    ASSERT_TRUE(ward.finish());
    save_as("a.hep");
    ASSERT_TRUE(ward.finish());
    ward.open("a.hep");
    ASSERT_TRUE(ward.finish());
    ward.said.clear();
    ward.keeper().undo();
    EXPECT_EQ(edits(), (std::vector<int>{1}));
    EXPECT_TRUE(ward.said.empty());
    ward.keeper().undo();
    EXPECT_EQ(edits(), (std::vector<int>{1})) << "it was made before";
    ASSERT_EQ(ward.said.size(), 1u);
    EXPECT_NE(ward.said[0].find("rebuilding stays"), std::string::npos);
    ward.keeper().undo();
    EXPECT_EQ(edits(), (std::vector<int>{})) << "now that is known";
    ASSERT_TRUE(ward.finish());
}

}  // namespace
}  // namespace hepatica
