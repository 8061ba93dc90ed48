// SPDX-License-Identifier: GPL-3.0-or-later
// Making a lesson as an instructor does: the fields, its places, doubts and undo.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <algorithm>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"
#include "core/base/text_file.h"
#include "core/lesson/draft_file.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_writer.h"
#include "core/lesson/target_region.h"
#include "tests/session/small_patient.h"
#include "tests/ui/lesson_editor_test.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

using testing::LessonEditorTest;

TEST_F(LessonEditorTest, makes_a_lesson_that_its_file_holds) {
    field<QLineEdit>("lessonName").setText("Probe it free");
    field<QPlainTextEdit>("lessonAbout").setPlainText("With a rod.");
    field<QCheckBox>("lessonTouches").click();
    field<QCheckBox>("lessonTool_pull").click();
    field<QCheckBox>("lessonTool_capsule").click();
    turn_to(1);
    click("lessonAddMark");
    field<QLineEdit>("mark1name").setText("the end");
    emit field<QLineEdit>("mark1name").editingFinished();
    field<QDoubleSpinBox>("mark1share").setValue(90.0);
    turn_to(2);
    click("stepAdd");
    field<QPlainTextEdit>("stepText").setPlainText("Touch the end.");
    field<QLineEdit>("stepHint").setText("From the side.");
    field<QDoubleSpinBox>("stepHold").setValue(2.5);
    choose("stepTool", field<QComboBox>("stepTool").findText("Rod"));
    choose("goal0quantity", static_cast<int>(Quantity::touch_mm));
    choose("goal0mark", 1);
    choose("goal0side", 1);
    field<QDoubleSpinBox>("goal0bound").setValue(6.0);
    click("stepLimitAdd");
    turn_to(3);
    click("limitAdd");
    click("pass0remove");
    click("lessonSave");

    EXPECT_FALSE(editor_.document().dirty());
    const Lesson made = read_lesson(*file_);
    EXPECT_EQ(made.name, "Probe it free");
    EXPECT_EQ(made.scene.name, made.name);
    EXPECT_EQ(made.about, "With a rod.");
    EXPECT_TRUE(made.scene.contact && made.scene.contact->tools && !made.scene.contact->self);
    EXPECT_EQ(made.tools, std::vector{LessonTool::capsule});
    ASSERT_EQ(made.mark_names(), (std::vector<std::string>{"mark 1", "the end"}));
    EXPECT_NEAR(*made.marks[1].place.share_of_longest_path, 0.9, 1e-12);
    ASSERT_EQ(made.steps.size(), 2u);
    EXPECT_EQ(made.steps[1].text, "Touch the end.");
    EXPECT_EQ(made.steps[1].hint, "From the side.");
    EXPECT_EQ(made.steps[1].hold_s, 2.5);
    EXPECT_EQ(made.steps[1].tool, LessonTool::capsule);
    EXPECT_FALSE(made.steps[0].tool) << "the first step asks for none";
    EXPECT_EQ(made.steps[1].goal, (std::vector<Predicate>{{Quantity::touch_mm, 1, false, 6.0}}));
    EXPECT_EQ(made.steps[1].limits.size(), 1u);
    EXPECT_EQ(made.limits.size(), 2u);
    EXPECT_TRUE(made.pass.empty());
    EXPECT_EQ(failures_, 0);
}

TEST_F(LessonEditorTest, says_what_can_hardly_be_meant_and_what_cannot_be_played) {
    EXPECT_EQ(doubts(), "");
    field<QCheckBox>("lessonTool_forceps").click();
    EXPECT_TRUE(doubts().contains("forceps"));
    field<QCheckBox>("lessonTouches").click();
    EXPECT_EQ(doubts(), "");
    turn_to(2);
    click("goal0remove");
    EXPECT_TRUE(doubts().contains("has no goal")) << doubts().toStdString();
    click("lessonUndo");
    EXPECT_EQ(doubts(), "");
    EXPECT_NO_THROW(field<QComboBox>("goal0quantity")) << "the page shows what is back";
}

TEST_F(LessonEditorTest, what_needs_moving_vessels_goes_with_them) {
    field<QCheckBox>("lessonTouches").click();
    field<QCheckBox>("lessonTears").click();
    ASSERT_TRUE(lesson().scene.contact && lesson().scene.tear);
    field<QCheckBox>("lessonMoves").click();
    EXPECT_FALSE(lesson().scene.deform || lesson().scene.contact || lesson().scene.tear);
    EXPECT_FALSE(field<QCheckBox>("lessonTears").isEnabled());
    EXPECT_TRUE(doubts().contains("is of nothing")) << "a scene of nothing";
    field<QCheckBox>("lessonFlows").click();
    EXPECT_NO_THROW(lesson_of(text_of(lesson()), "lesson"));
}

TEST_F(LessonEditorTest, a_place_that_is_clicked_on_is_a_mark_or_the_target) {
    EXPECT_EQ(drawn_.size(), 1u) << "as soon as the editor is there";
    turn_to(1);
    editor_.place_clicked(Vec3(1, 2, 3));
    EXPECT_TRUE(lesson().marks[0].place.share_of_longest_path) << "nobody asked";
    click("mark0click");
    EXPECT_EQ(asked_for_place_, 1);
    editor_.place_clicked(on_vessel(0) + Vec3(0.03, 0, 0));
    EXPECT_EQ(lesson().marks[0].place.point_mm, on_vessel(0)) << "to a tenth";
    EXPECT_EQ(asked_no_more_, 0) << "the click itself has ended the asking";
    EXPECT_TRUE(doubts().contains("any")) << "a point is of one patient";
    turn_to(0);
    choose("lessonPatient", 2);
    EXPECT_EQ(lesson().patient, shown_.toStdString());
    EXPECT_EQ(doubts(), "");
    turn_to(1);
    click("lessonAddTarget");
    click("targetclick");
    editor_.place_clicked(on_vessel(1));
    EXPECT_EQ(lesson().target->point_mm, on_vessel(1));
    EXPECT_EQ(drawn_, (std::vector<Vec3>{on_vessel(0), on_vessel(1)}));
    click("targetremove");
    EXPECT_FALSE(lesson().target);
    editor_.hide();
    EXPECT_TRUE(drawn_.empty());
}

TEST_F(LessonEditorTest, a_tumour_is_chosen_as_the_target) {
    turn_to(1);
    auto& button = field<QPushButton>("lessonTumour");
    EXPECT_TRUE(button.isHidden()) << "this patient has none";
    tumours_ = {{1, 0.5, on_vessel(0)}, {4, 2.25, on_vessel(1)}};
    editor_.tumours_changed();
    EXPECT_FALSE(button.isHidden());
    const QList<QAction*> offered = button.menu()->actions();
    ASSERT_EQ(offered.size(), 2);
    EXPECT_TRUE(offered[1]->text().startsWith("Tumour 4 (2")) << offered[1]->text().toStdString();
    offered[1]->trigger();
    ASSERT_TRUE(lesson().target && lesson().target->point_mm);
    const Vec3 feeds = place_that_feeds(patient_->tree, on_vessel(1));
    EXPECT_LT((*lesson().target->point_mm - feeds).norm(), 0.1);
    EXPECT_EQ(drawn_.size(), 2u) << "it is seen on the vessels";
    // Far from every branch that may feed it, its own may be missing.
    tumours_ = {{1, 0.5, on_vessel(0)}, {4, 2.25, on_vessel(1) + Vec3(0, 300, 0)}};
    editor_.tumours_changed();
    const double aside_mm =
        (place_that_feeds(patient_->tree, tumours_[1].middle_mm) - tumours_[1].middle_mm).norm();
    EXPECT_GT(aside_mm, 100.0);
    EXPECT_TRUE(button.menu()->actions()[1]->text().contains(
        QString("branch %L1 mm from").arg(aside_mm, 0, 'f', 0)));
    field<QPushButton>("lessonTumour").menu()->actions()[0]->trigger();
    EXPECT_LT((*lesson().target->point_mm - place_that_feeds(patient_->tree, on_vessel(0))).norm(),
              0.1);
    click("lessonUndo");
    EXPECT_LT((*lesson().target->point_mm - feeds).norm(), 0.1);
}

TEST_F(LessonEditorTest, is_closed_by_escape_as_by_its_button) {
    QApplication::setActiveWindow(&editor_);
    field<QLineEdit>("lessonName").setText("Half done");
    QTest::keyClick(&editor_, Qt::Key_Escape);
    EXPECT_TRUE(editor_.isHidden());
    EXPECT_EQ(kept().name, "Half done") << "nothing is lost";
}

TEST_F(LessonEditorTest, doubts_a_place_of_another_patient) {
    turn_to(1);
    click("mark0click");
    editor_.place_clicked(on_vessel(0));
    turn_to(0);
    choose("lessonPatient", 1);
    EXPECT_TRUE(doubts().contains("the lesson is for another one")) << doubts().toStdString();
    choose("lessonPatient", 2);
    EXPECT_EQ(doubts(), "");
    turn_to(1);
    click("mark0click");
    editor_.place_clicked(on_vessel(0) + Vec3(0, 0, 300));
    EXPECT_TRUE(doubts().contains("beside the vessels of this patient"));
}

TEST_F(LessonEditorTest, offers_the_patient_who_comes_while_it_is_open) {
    auto& patients = field<QComboBox>("lessonPatient");
    shown_ = folder_of("other.hep");
    editor_.patient_shown();
    EXPECT_GE(patients.findData(shown_), 0);
    EXPECT_LT(patients.findData(to_text(folder_.path() / "shown.hep")), 0);
    shown_ = "built-in";
    editor_.patient_shown();
    EXPECT_EQ(patients.count(), 2) << "he is there already";
}

// The steps keep what they asked for, and say that they miss the mark, until it is back.

TEST_F(LessonEditorTest, a_mark_that_is_removed_changes_no_step_unasked) {
    field<QLineEdit>("lessonName").setText("Mine");
    const Lesson before = lesson();
    turn_to(1);
    click("mark0remove");
    ASSERT_EQ(lesson().steps[0].goal.size(), 1u);
    EXPECT_EQ(lesson().steps[0].goal[0].quantity, Quantity::moved_mm);
    EXPECT_EQ(lesson().steps[0].goal[0].bound, before.steps[0].goal[0].bound);
    EXPECT_TRUE(doubts().contains("Step 1 \"Pull the vessel")) << doubts().toStdString();
    EXPECT_TRUE(doubts().contains("no mark"));
    EXPECT_FALSE(doubts().contains("[0]")) << "that is how files speak";
    click("lessonTry");
    click("lessonSave");
    EXPECT_EQ(failures_, 2);
    EXPECT_FALSE(tried_);
    EXPECT_FALSE(std::filesystem::exists(*file_));
    click("lessonAddMark");
    turn_to(2);
    EXPECT_EQ(field<QComboBox>("goal0mark").currentIndex(), -1);
    choose("goal0mark", 0);
    EXPECT_EQ(doubts(), "");
    for (int i = 0; i < 3; ++i) click("lessonUndo");
    EXPECT_EQ(text_of(lesson()), text_of(before));
}

TEST_F(LessonEditorTest, asks_for_no_place_of_a_row_that_is_gone) {
    turn_to(1);
    click("mark0remove");
    EXPECT_EQ(asked_no_more_, 0) << "nobody asked";
    click("lessonUndo");
    click("mark0click");
    click("mark0remove");
    EXPECT_EQ(asked_no_more_, 1);
    click("lessonUndo");
    click("mark0click");
    turn_to(2);
    EXPECT_EQ(asked_no_more_, 2);
    turn_to(1);
    click("mark0click");
    editor_.hide();
    EXPECT_EQ(asked_no_more_, 3);
}

TEST_F(LessonEditorTest, settings_that_no_page_shows_outlive_their_tick) {
    answer_ = UnsavedLesson::discard;
    field<QAction>("beginWith_probe_free").trigger();
    const Lesson before = lesson();
    for (const char* tick : {"lessonMoves", "lessonTouches", "lessonSelf", "lessonObstacles",
                             "lessonTears", "lessonFlows"}) {
        field<QCheckBox>(tick).click();
        EXPECT_NE(text_of(lesson()), text_of(before)) << tick;
        field<QCheckBox>(tick).click();
        EXPECT_EQ(text_of(lesson()), text_of(before)) << tick;
    }
    field<QCheckBox>("lessonMoves").click();
    field<QAction>("beginWith_selective_injection").trigger();
    const bool moves = lesson().scene.deform.has_value();
    if (!moves) field<QCheckBox>("lessonMoves").click();
    EXPECT_FALSE(lesson().scene.tear) << "that was of the lesson before";
}

TEST_F(LessonEditorTest, fits_on_a_small_screen) {
    turn_to(1);
    for (int i = 0; i < 14; ++i) click("lessonAddMark");
    turn_to(3);
    for (int i = 0; i < 14; ++i) click("limitAdd");
    QApplication::processEvents();
    for (int page = 0; page < 4; ++page) {
        turn_to(page);
        QWidget* shown = field<QTabWidget>("lessonPages").currentWidget();
        EXPECT_TRUE(qobject_cast<QScrollArea*>(shown) || shown->findChild<QScrollArea*>()) << page;
        const QSize least = editor_.minimumSizeHint().expandedTo(editor_.minimumSize());
        EXPECT_LE(least.width(), 1024) << page;
        EXPECT_LE(least.height(), 700) << page << ": 768 without the desktop's and its own title";
    }
}

TEST_F(LessonEditorTest, a_place_that_was_asked_for_is_forgotten_with_its_mark) {
    turn_to(1);
    click("lessonAddMark");
    click("mark1click");
    turn_to(2);
    click("lessonUndo");  // of the second mark
    editor_.place_clicked(Vec3(1, 2, 3));
    ASSERT_EQ(lesson().marks.size(), 1u);
    EXPECT_FALSE(lesson().marks[0].place.point_mm);
    turn_to(1);
    click("mark0click");
    turn_to(2);
    answer_ = UnsavedLesson::discard;
    field<QAction>("beginWith_look_around").trigger();
    const Lesson begun = lesson();
    editor_.place_clicked(Vec3(1, 2, 3));
    EXPECT_EQ(text_of(lesson()), text_of(begun)) << "it was a mark of the lesson before";
}

// A key presses Undo while a field that goes by it still has the focus.

TEST_F(LessonEditorTest, what_is_being_typed_into_a_row_that_goes_harms_nothing) {
    QApplication::setActiveWindow(&editor_);
    turn_to(1);
    click("lessonAddMark");
    auto& name = field<QLineEdit>("mark1name");
    name.setFocus();
    QTest::keyClicks(&name, "!");
    click("lessonUndo");  // of what was typed
    EXPECT_EQ(lesson().mark_names(), (std::vector<std::string>{"mark 1", "mark 2"}));
    field<QLineEdit>("mark1name").setFocus();
    click("lessonUndo");  // of the mark
    EXPECT_EQ(lesson().mark_names(), (std::vector<std::string>{"mark 1"}));
    turn_to(2);
    click("goalAdd");
    ASSERT_EQ(lesson().steps[0].goal.size(), 2u);
    field<QDoubleSpinBox>("goal1bound").setFocus();
    QTest::keyClicks(&field<QDoubleSpinBox>("goal1bound"), "7");
    click("goal1remove");
    EXPECT_EQ(lesson().steps[0].goal.size(), 1u);
    click("lessonUndo");
    EXPECT_EQ(lesson().steps[0].goal.size(), 2u);
    field<QDoubleSpinBox>("goal1bound").setFocus();
    for (int i = 0; i < 4; ++i) click("lessonUndo");
    EXPECT_EQ(text_of(lesson()), text_of(new_lesson()));
}

TEST_F(LessonEditorTest, each_bound_is_undone_by_itself) {
    turn_to(2);
    click("goalAdd");
    field<QDoubleSpinBox>("goal0bound").setValue(21.0);
    field<QDoubleSpinBox>("goal1bound").setValue(22.0);
    click("goal0remove");
    ASSERT_EQ(lesson().steps[0].goal.size(), 1u);
    click("lessonUndo");
    ASSERT_EQ(lesson().steps[0].goal.size(), 2u);
    EXPECT_EQ(lesson().steps[0].goal[0].bound, 21.0);
    EXPECT_EQ(lesson().steps[0].goal[1].bound, 22.0);
    click("lessonUndo");
    EXPECT_EQ(lesson().steps[0].goal[0].bound, 21.0);
    EXPECT_NE(lesson().steps[0].goal[1].bound, 22.0);
}

TEST_F(LessonEditorTest, small_bounds_can_be_typed_and_another_unit_begins_anew) {
    turn_to(2);
    field<QDoubleSpinBox>("goal0bound").setValue(25.0);
    const auto words = quantities();
    const auto bleeding = std::ranges::find(words, Quantity::leak_g_s, &QuantityWords::quantity);
    choose("goal0quantity", static_cast<int>(bleeding - words.begin()));
    EXPECT_EQ(lesson().steps[0].goal[0].bound, 1.0) << "25 were millinewtons";
    field<QDoubleSpinBox>("goal0bound").setValue(0.05);
    EXPECT_EQ(lesson().steps[0].goal[0].bound, 0.05);
}

TEST_F(LessonEditorTest, what_cannot_be_tried_stays_to_be_mended) {
    turn_to(2);
    click("goal0remove");
    click("lessonTry");
    EXPECT_EQ(failures_, 1);
    EXPECT_FALSE(tried_);
    EXPECT_TRUE(editor_.isVisible());
    click("lessonUndo");
    can_try_ = false;
    click("lessonTry");
    EXPECT_TRUE(tried_);
    EXPECT_TRUE(editor_.isVisible()) << "its patient does not come";
    can_try_ = true;
    click("lessonTry");
    EXPECT_FALSE(editor_.isVisible());
}

TEST_F(LessonEditorTest, a_new_mark_is_put_where_no_vessel_hides_it) {
    const Vec3 end = point_on_longest_path(patient_->tree, 0.9);
    hides_ = [&](const Vec3& place) { return (place - end).norm() < 1e-9; };
    turn_to(1);
    click("lessonAddMark");
    EXPECT_NE(lesson().marks[1].place.share_of_longest_path, 0.9);
    EXPECT_NEAR(lesson().marks[1].place.share_of_longest_path.value(), 0.85, 1e-9);
}

TEST_F(LessonEditorTest, two_marks_cannot_have_one_name) {
    turn_to(1);
    click("lessonAddMark");
    EXPECT_NE(lesson().marks[0].place.share_of_longest_path,
              lesson().marks[1].place.share_of_longest_path)
        << "nor one place";
    auto& name = field<QLineEdit>("mark1name");
    name.setText("mark 1");
    emit name.editingFinished();
    EXPECT_EQ(name.text(), "mark 2");
    EXPECT_EQ(lesson().mark_names(), (std::vector<std::string>{"mark 1", "mark 2"}));
}

TEST_F(LessonEditorTest, steps_change_their_order_and_go) {
    turn_to(2);
    click("stepAdd");
    field<QPlainTextEdit>("stepText").setPlainText("B");
    click("stepAdd");
    field<QPlainTextEdit>("stepText").setPlainText("C");
    click("stepUp");
    EXPECT_EQ(lesson().steps[1].text, "C");
    auto& list = field<QListWidget>("lessonSteps");
    EXPECT_EQ(list.currentRow(), 1);
    list.setCurrentRow(0);
    EXPECT_FALSE(field<QPushButton>("stepUp").isEnabled());
    EXPECT_TRUE(field<QPlainTextEdit>("stepText").toPlainText().startsWith("Pull"));
    click("stepRemove");
    click("stepRemove");
    ASSERT_EQ(lesson().steps.size(), 1u);
    EXPECT_EQ(lesson().steps[0].text, "B");
    EXPECT_FALSE(field<QPushButton>("stepRemove").isEnabled()) << "the last one stays";
}

// What is typed is on disk soon, without a save.

}  // namespace
}  // namespace hepatica
