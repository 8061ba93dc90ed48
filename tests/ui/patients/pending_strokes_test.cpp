// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes at vessels that wait for a remaking: nobody loses them without a question, and one order
// of undo holds for them and the corrections.
#include "ui/pending_strokes.h"

#include <QTest>

#include "tests/ui/patients/keeper_test.h"

namespace hepatica {
namespace {

using testing::numbers_of;
using Numbers = std::vector<int>;

BrushStroke stroke(int number) {
    return {{Vec3(number, 0, 0)}, 2.0, false};
}

class Strokes : public testing::KeeperTest {
  protected:
    Strokes() {
        ward.remake_painted = [this] { remake(7); };
    }
    void paint(int number) { ward.keeper().add_stroke(stroke(number)); }
    Numbers painted() const {
        Numbers numbers;
        for (const PendingStroke& one : ward.workspace().strokes())
            numbers.push_back(static_cast<int>(one.stroke.path_mm.front().x()));
        return numbers;
    }
    void undo() {
        ward.keeper().undo();
        EXPECT_TRUE(ward.finish());
    }
    void redo() {
        ward.keeper().redo();
        EXPECT_TRUE(ward.finish());
    }
};

TEST_F(Strokes, are_asked_about_where_a_patient_is_left) {
    ward.leave();
    EXPECT_TRUE(ward.left) << "nothing waits";
    ward.left = false;
    for (const int number : {1, 2}) paint(number);
    EXPECT_TRUE(ward.workspace().unsaved());
    EXPECT_FALSE(ward.workspace().dirty()) << "no case could hold them";
    ward.leave();
    EXPECT_EQ(ward.strokes_asked, std::vector<std::size_t>{2});
    EXPECT_FALSE(ward.left);
    ward.strokes_answer = StrokesAnswer::drop;
    ward.leave();
    EXPECT_TRUE(ward.left);
    EXPECT_EQ(ward.questions, 0) << "the case itself lies on disk";
}

TEST_F(Strokes, are_asked_about_once_where_another_case_is_opened) {
    paint(1);
    ward.strokes_answer = StrokesAnswer::drop;
    ward.open("ct of another");
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.strokes_asked.size(), 1u);
    EXPECT_EQ(ward.workspace().title(), "ct of another");
    EXPECT_TRUE(painted().empty());
    ward.strokes_answer = StrokesAnswer::cancel;
    paint(1);
    ward.open("a.hep");
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(ward.workspace().title(), "ct of another");
    EXPECT_EQ(painted(), Numbers{1});
}

TEST_F(Strokes, are_made_into_vessels_and_saved_before_one_goes) {
    paint(1);
    ward.strokes_answer = StrokesAnswer::rebuild;
    ward.answer = UnsavedAnswer::save;
    ward.leave();
    EXPECT_FALSE(ward.left);
    ASSERT_TRUE(ward.finish());
    EXPECT_TRUE(ward.left);
    EXPECT_EQ(label(), 7);
    EXPECT_TRUE(painted().empty());
    EXPECT_EQ(ward.questions, 1) << "remade vessels are not on disk";
    EXPECT_FALSE(ward.workspace().unsaved());
}

TEST_F(Strokes, keep_one_here_where_they_cannot_be_made_into_vessels) {
    paint(1);
    ward.strokes_answer = StrokesAnswer::rebuild;
    ward.remake_painted = [] {};  // as during a review
    ward.leave();
    EXPECT_FALSE(ward.left);
    ward.remake_painted = [this] {
        ward.keeper().remake(std::make_shared<const Volume>(), Mask());  // no vessel is left
    };
    ward.leave();
    ASSERT_TRUE(ward.finish());
    EXPECT_FALSE(ward.left);
    EXPECT_EQ(painted(), Numbers{1});
}

TEST_F(Strokes, are_asked_about_while_they_are_being_made_into_vessels) {
    paint(1);
    ward.hold_remakings = true;
    remake(7);
    ward.leave();
    EXPECT_FALSE(ward.left);
    ward.strokes_answer = StrokesAnswer::rebuild;
    ward.remake_painted = [] { FAIL() << "that is being done"; };
    ward.answer = UnsavedAnswer::discard;
    ward.leave();
    EXPECT_FALSE(ward.left);
    ward.hold_remakings = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_TRUE(ward.left);
    EXPECT_EQ(label(), 7);
}

TEST_F(Strokes, and_corrections_are_undone_and_redone_in_one_order) {
    add(1);
    paint(10);
    paint(11);
    add(2);
    ASSERT_TRUE(ward.finish());
    undo();
    EXPECT_EQ(edits(), Numbers{1});
    EXPECT_EQ(painted(), (Numbers{10, 11}));
    undo();
    EXPECT_EQ(edits(), Numbers{1});
    EXPECT_EQ(painted(), Numbers{10});
    undo();
    undo();
    EXPECT_EQ(edits(), Numbers{});
    EXPECT_EQ(painted(), Numbers{});
    EXPECT_FALSE(ward.workspace().next_undo());
    redo();
    EXPECT_EQ(edits(), Numbers{1});
    EXPECT_EQ(painted(), Numbers{});
    redo();
    redo();
    EXPECT_EQ(edits(), Numbers{1});
    EXPECT_EQ(painted(), (Numbers{10, 11}));
    redo();
    EXPECT_EQ(edits(), (Numbers{1, 2}));
    EXPECT_FALSE(ward.workspace().next_redo());
}

TEST_F(Strokes, and_corrections_each_end_what_could_be_done_again) {
    paint(10);
    undo();
    add(1);
    ASSERT_TRUE(ward.finish());
    EXPECT_FALSE(ward.workspace().next_redo());
    undo();
    paint(11);
    EXPECT_FALSE(ward.workspace().next_redo());
    redo();
    EXPECT_EQ(edits(), Numbers{});
    EXPECT_EQ(painted(), Numbers{11});
}

// What was led while vessels were made is none of them, and an undo of that brings the others back.
TEST_F(Strokes, that_are_vessels_now_wait_again_after_an_undo) {
    add(1);
    ASSERT_TRUE(ward.finish());
    paint(10);
    ward.hold_remakings = true;
    remake(7);
    paint(11);
    ward.keeper().take_strokes_back(1);
    EXPECT_EQ(painted(), (Numbers{10, 11})) << "not while they are made into vessels";
    ward.hold_remakings = false;
    ASSERT_TRUE(ward.finish());
    EXPECT_EQ(painted(), Numbers{11});
    ASSERT_EQ(ward.workspace().patient()->corrections.rebuilt.size(), 1u);
    EXPECT_EQ(ward.workspace().patient()->corrections.rebuilt[0].after_edits, 1u);
    EXPECT_EQ(ward.workspace().patient()->corrections.rebuilt[0].strokes, 1u);
    undo();
    EXPECT_EQ(label(), 7);
    EXPECT_EQ(painted(), Numbers{});
    undo();
    EXPECT_EQ(label(), 1);
    EXPECT_TRUE(ward.workspace().patient()->corrections.rebuilt.empty());
    EXPECT_EQ(painted(), Numbers{10});
    EXPECT_EQ(edits(), Numbers{1});
    undo();
    EXPECT_EQ(painted(), Numbers{});
    EXPECT_EQ(edits(), Numbers{1});
}

}  // namespace
}  // namespace hepatica
