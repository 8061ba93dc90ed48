// SPDX-License-Identifier: GPL-3.0-or-later
// Making a lesson as an instructor does: the fields, its places, doubts and undo.
// it, its file, and what a crash leaves behind.
#include "ui/lesson_editor/lesson_editor.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
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
#include "tests/session/small_patient.h"
#include "tests/ui/window_test.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

using testing::wait_for;

class LessonEditorTest : public ::testing::Test {
  protected:
    LessonEditorTest() : editor_(ways(), folder_.path() / "unsaved.json", nullptr) {
        editor_.show_editor();
    }
    LessonEditor::Ways ways() {
        LessonEditor::Ways ways;
        ways.patient = [this] { return patient_; };
        ways.shown_patient = [this] { return shown_; };
        ways.ask_for_place = [this] { ++asked_for_place_; };
        ways.ask_no_more = [this] { ++asked_no_more_; };
        ways.places_changed = [this] { drawn_ = editor_.places(); };
        ways.try_out = [this](const Lesson& lesson) {
            tried_ = lesson;
            return can_try_;
        };
        ways.which_file = [this] { return file_; };
        ways.where_to_save = [this](const QString&) { return file_; };
        ways.unsaved = [this](bool kept) {
            asked_kept_ = kept;
            return answer_;
        };
        ways.failed = [this](const QString&, const std::exception_ptr&) { ++failures_; };
        return ways;
    }
    const Lesson& lesson() { return editor_.document().lesson(); }
    // The case that is shown lies in a folder, else the editor doubts that it is there.
    QString folder_of(const char* name) {
        std::filesystem::create_directory(folder_.path() / name);
        return to_text(folder_.path() / name);
    }
    // On the centreline of the patient who is shown, to a tenth.
    Vec3 on_vessel(std::size_t segment) {
        const Vec3& at = patient_->tree.segments.at(segment).points_mm.at(1);
        return (10.0 * at).array().round() / 10.0;
    }
    template <class T>
    T& field(const QString& name) {
        T* found = editor_.findChild<T*>(name);
        if (found == nullptr) throw std::runtime_error("no field " + name.toStdString());
        return *found;
    }
    void click(const QString& name) { field<QPushButton>(name).click(); }
    void turn_to(int page) { field<QTabWidget>("lessonPages").setCurrentIndex(page); }
    void choose(const QString& name, int item) {
        auto& box = field<QComboBox>(name);
        box.setCurrentIndex(item);
        emit box.activated(item);
    }
    // What is on disk of it.
    Lesson kept() {
        return draft_of(read_text_file(folder_.path() / "unsaved.json", ""), "copy").lesson;
    }
    QString doubts() {
        auto& label = field<QLabel>("lessonDoubts");
        return label.isVisible() ? label.text() : "";
    }

    TemporaryFolder folder_;
    std::shared_ptr<const PatientCase> patient_ = test::small_patient();
    std::optional<std::filesystem::path> file_ = folder_.path() / "made.json";
    std::optional<Lesson> tried_;
    UnsavedLesson answer_ = UnsavedLesson::stay;
    std::optional<bool> asked_kept_;  // whether there was a copy when it was asked
    bool can_try_ = true;
    QString shown_ = folder_of("shown.hep");
    int asked_for_place_ = 0, asked_no_more_ = 0, failures_ = 0;
    std::vector<Vec3> drawn_;
    LessonEditor editor_;
};

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
    EXPECT_EQ(made.scene.name, made.name) << "recordings of two lessons are told apart by it";
    EXPECT_EQ(made.about, "With a rod.");
    EXPECT_TRUE(made.scene.contact && made.scene.contact->tools && !made.scene.contact->self);
    EXPECT_EQ(made.tools, std::vector{LessonTool::capsule});
    ASSERT_EQ(made.mark_names(), (std::vector<std::string>{"mark 1", "the end"}));
    EXPECT_NEAR(*made.marks[1].place.share_of_longest_path, 0.9, 1e-12);
    ASSERT_EQ(made.steps.size(), 2u);
    EXPECT_EQ(made.steps[1].text, "Touch the end.");
    EXPECT_EQ(made.steps[1].hint, "From the side.");
    EXPECT_EQ(made.steps[1].hold_s, 2.5);
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
    for (const char* tick :
         {"lessonMoves", "lessonTouches", "lessonSelf", "lessonTears", "lessonFlows"}) {
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

TEST_F(LessonEditorTest, before_the_program_ends_what_is_not_saved_is_asked_about) {
    EXPECT_TRUE(editor_.may_end());
    EXPECT_FALSE(asked_kept_) << "nothing is unsaved";
    field<QLineEdit>("lessonName").setText("Mine");
    EXPECT_FALSE(editor_.may_end()) << "it stays";
    EXPECT_EQ(asked_kept_, true) << "a copy is on disk";
    EXPECT_EQ(kept().name, "Mine");
    turn_to(2);
    click("goal0remove");
    answer_ = UnsavedLesson::keep;
    EXPECT_TRUE(editor_.may_end());
    EXPECT_TRUE(kept().steps[0].goal.empty()) << "what is not finished is kept, too";
    field<QLineEdit>("lessonName").setText("Yours");
    std::filesystem::remove(folder_.path() / "unsaved.json");
    std::filesystem::create_directory(folder_.path() / "unsaved.json");  // nothing can be written
    answer_ = UnsavedLesson::stay;
    EXPECT_FALSE(editor_.may_end());
    EXPECT_EQ(asked_kept_, false);
    EXPECT_GT(failures_, 0);
}

TEST_F(LessonEditorTest, at_the_end_of_the_program_changes_are_saved_or_let_go) {
    field<QLineEdit>("lessonName").setText("Mine");
    answer_ = UnsavedLesson::save;
    EXPECT_TRUE(editor_.may_end());
    EXPECT_EQ(read_lesson(*file_).name, "Mine");
    field<QLineEdit>("lessonName").setText("Yours");
    file_.reset();
    answer_ = UnsavedLesson::discard;
    EXPECT_TRUE(editor_.may_end());
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "unsaved.json"));
}

TEST_F(LessonEditorTest, undoes_redoes_and_saves_by_keys) {
    QApplication::setActiveWindow(&editor_);
    turn_to(1);
    click("lessonAddMark");
    const auto marks = [&] { return lesson().marks.size(); };
    ASSERT_EQ(marks(), 2u);
    QTest::keyClick(&editor_, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(marks(), 1u);
    QTest::keyClick(&editor_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(marks(), 2u);
    QTest::keyClick(&editor_, Qt::Key_Z, Qt::ControlModifier);
    field<QLineEdit>("lessonName").setText("Mine");
    QTest::keyClick(&editor_, Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(read_lesson(*file_).name, "Mine");
}

TEST_F(LessonEditorTest, two_marks_cannot_have_one_name) {
    turn_to(1);
    click("lessonAddMark");
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

TEST_F(LessonEditorTest, begins_with_a_copy_unless_something_would_be_lost) {
    const auto begin_with = [&](const char* id) {
        field<QAction>(QString("beginWith_") + id).trigger();
    };
    begin_with("embolization");
    EXPECT_EQ(lesson().name, "Embolization");
    EXPECT_TRUE(editor_.document().file().empty());
    field<QLineEdit>("lessonName").setText("Mine");
    begin_with("gentle_pull");
    EXPECT_EQ(lesson().name, "Mine");
    answer_ = UnsavedLesson::discard;
    begin_with("gentle_pull");
    EXPECT_EQ(lesson().name, "Gentle pull");
}

// What is typed is on disk soon, without a save.
TEST_F(LessonEditorTest, keeps_what_is_not_saved) {
    field<QLineEdit>("lessonName").setText("Mine");
    EXPECT_TRUE(wait_for([&] { return std::filesystem::exists(folder_.path() / "unsaved.json"); }));
    EXPECT_EQ(kept().name, "Mine");
}

}  // namespace
}  // namespace hepatica
