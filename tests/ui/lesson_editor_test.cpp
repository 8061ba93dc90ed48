// SPDX-License-Identifier: GPL-3.0-or-later
// Making a lesson as an instructor does: the fields, places clicked on in the view, a play to try
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
#include <QTabWidget>
#include <algorithm>
#include <fstream>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"
#include "core/base/text_file.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_writer.h"
#include "tests/session/small_patient.h"
#include "tests/ui/window_test.h"
#include "ui/lesson_dock.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

using testing::wait_for;

TEST(LessonDocument, UndoesWhatWasTypedInOneFieldAtOnce) {
    LessonDocument document({});
    EXPECT_FALSE(document.dirty() || document.can_undo());
    for (const char* name : {"P", "Pu", "Pull"})
        document.change("name", [&](Lesson& lesson) { lesson.name = name; });
    document.change("about", [](Lesson& lesson) { lesson.about = "why"; });
    document.change("", [](Lesson& lesson) { lesson.tools.clear(); });
    document.change("", [](Lesson& lesson) { lesson.tools = {LessonTool::hook}; });
    EXPECT_FALSE(document.change("", [](Lesson& lesson) { lesson.about = "why"; }));
    document.undo();
    EXPECT_TRUE(document.lesson().tools.empty()) << "two changes without a field are two";
    document.undo();
    document.undo();
    EXPECT_EQ(document.lesson().about, "");
    EXPECT_EQ(document.lesson().name, "Pull");
    document.undo();
    EXPECT_EQ(document.lesson().name, "A new lesson");
    EXPECT_FALSE(document.can_undo() || document.dirty());
    document.redo();
    EXPECT_EQ(document.lesson().name, "Pull");
    document.change("name", [](Lesson& lesson) { lesson.name = "Push"; });
    EXPECT_FALSE(document.can_redo());
    document.undo();
    EXPECT_EQ(document.lesson().name, "Pull") << "typing after a redo is a change of its own";
}

TEST(LessonDocument, NamesAPatientBelowTheFileRelativeToIt) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "lesson.json";
    const std::string inside = (folder.path() / "cases" / "a.hep").string();
    for (const auto& [patient, written] :
         {std::pair(inside, std::string("cases/a.hep")),
          std::pair(std::string("any"), std::string("any")),
          std::pair(std::string("/elsewhere/b.hep"), std::string("/elsewhere/b.hep"))}) {
        LessonDocument document({});
        document.change("", [&](Lesson& lesson) { lesson.patient = patient; });
        document.save(file);
        EXPECT_FALSE(patient != "any" && document.dirty());
        EXPECT_EQ(read_lesson(file).patient, written);
        LessonDocument again({});
        again.open(file);
        EXPECT_EQ(again.lesson().patient, patient);
        EXPECT_EQ(again.file(), file);
        EXPECT_FALSE(again.dirty());
    }
}

TEST(LessonDocument, NamesAPatientAboveTheFileAsItDidBefore) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "course" / "lesson.json";
    std::filesystem::create_directories(file.parent_path());
    Lesson lesson = new_lesson();
    lesson.patient = "../cases/a.hep";
    write_lesson(file, lesson);
    LessonDocument document({});
    document.open(file);
    EXPECT_EQ(document.lesson().patient, (folder.path() / "cases" / "a.hep").string());
    document.change("", [](Lesson& changed) { changed.name = "Other"; });
    document.save(file);
    EXPECT_EQ(read_lesson(file).patient, "../cases/a.hep");
    document.save(folder.path() / "lesson.json");  // from there the path would be another
    EXPECT_EQ(read_lesson(folder.path() / "lesson.json").patient, "cases/a.hep");
}

TEST(LessonDocument, LeavesWhatIsNotSavedBehindUntilItIs) {
    const TemporaryFolder folder;
    const std::filesystem::path copy = folder.path() / "data" / "unsaved.json";
    LessonDocument document(copy);
    document.keep_copy();
    EXPECT_FALSE(std::filesystem::exists(copy)) << "nothing is unsaved";
    document.change("", [](Lesson& lesson) { lesson.name = "Mine"; });
    document.keep_copy();
    document.change("", [](Lesson& lesson) { lesson.steps[0].goal.clear(); });
    document.keep_copy();  // cannot be read so: the copy before stays
    {
        const LessonDocument after_a_crash(copy);
        EXPECT_EQ(after_a_crash.lesson().name, "Mine");
        EXPECT_TRUE(after_a_crash.left_behind());
        EXPECT_TRUE(after_a_crash.dirty()) << "or the next start would throw it away";
    }
    EXPECT_THROW(document.save(folder.path() / "lesson.json"), InputError);
    EXPECT_TRUE(document.dirty());
    document.undo();
    document.save(folder.path() / "lesson.json");
    EXPECT_FALSE(std::filesystem::exists(copy));
    EXPECT_FALSE(LessonDocument(copy).left_behind());
    std::ofstream(copy) << "{half";
    EXPECT_EQ(LessonDocument(copy).lesson().name, new_lesson().name);
    EXPECT_EQ(read_text_file(copy.string() + ".unreadable", ""), "{half");
}

class LessonEditorTest : public ::testing::Test {
  protected:
    LessonEditorTest() : editor_(ways(), folder_.path() / "unsaved.json", nullptr) {
        editor_.show_editor();
    }
    LessonEditor::Ways ways() {
        LessonEditor::Ways ways;
        ways.patient = [this] { return patient_; };
        ways.shown_case = [] { return QString("/cases/shown.hep"); };
        ways.ask_for_place = [this] { ++asked_for_place_; };
        ways.places_changed = [this] { drawn_ = editor_.places(); };
        ways.try_out = [this](const Lesson& lesson) {
            tried_ = lesson;
            return can_try_;
        };
        ways.which_file = [this] { return file_; };
        ways.where_to_save = [this](const QString&) { return file_; };
        ways.may_discard = [this] { return may_discard_; };
        ways.failed = [this](const std::string&, const std::exception_ptr&) { ++failures_; };
        return ways;
    }
    const Lesson& lesson() { return editor_.document().lesson(); }
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
    QString doubts() {
        auto& label = field<QLabel>("lessonDoubts");
        return label.isVisible() ? label.text() : "";
    }

    TemporaryFolder folder_;
    std::shared_ptr<const PatientCase> patient_ = test::small_patient();
    std::optional<std::filesystem::path> file_ = folder_.path() / "made.json";
    std::optional<Lesson> tried_;
    bool may_discard_ = false;
    bool can_try_ = true;
    int asked_for_place_ = 0, failures_ = 0;
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
    EXPECT_TRUE(doubts().contains("names no part")) << "a scene of nothing";
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
    editor_.place_clicked(Vec3(1.234, -2.0, 3.0));
    EXPECT_EQ(lesson().marks[0].place.point_mm, Vec3(1.2, -2.0, 3.0));
    EXPECT_TRUE(doubts().contains("any")) << "a point is of one patient";
    turn_to(0);
    choose("lessonPatient", 2);
    EXPECT_EQ(lesson().patient, "/cases/shown.hep");
    EXPECT_EQ(doubts(), "");
    turn_to(1);
    click("lessonAddTarget");
    click("targetclick");
    editor_.place_clicked(Vec3(4, 5, 6));
    EXPECT_EQ(lesson().target->point_mm, Vec3(4, 5, 6));
    EXPECT_EQ(drawn_, (std::vector<Vec3>{Vec3(1.2, -2, 3), Vec3(4, 5, 6)}));
    click("targetremove");
    EXPECT_FALSE(lesson().target);
    editor_.hide();
    EXPECT_TRUE(drawn_.empty());
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
    may_discard_ = true;
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

TEST_F(LessonEditorTest, the_program_ends_unasked_only_where_all_is_kept) {
    EXPECT_TRUE(editor_.may_end()) << "nothing is unsaved";
    field<QLineEdit>("lessonName").setText("Mine");
    EXPECT_TRUE(editor_.may_end()) << "a copy is on disk";
    EXPECT_EQ(read_lesson(folder_.path() / "unsaved.json").name, "Mine");
    turn_to(2);
    click("goal0remove");
    EXPECT_FALSE(editor_.may_end()) << "this cannot be read back";
    may_discard_ = true;
    EXPECT_TRUE(editor_.may_end());
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
    may_discard_ = true;
    begin_with("gentle_pull");
    EXPECT_EQ(lesson().name, "Gentle pull");
}

// What is typed is on disk soon, without a save.
TEST_F(LessonEditorTest, keeps_what_is_not_saved) {
    field<QLineEdit>("lessonName").setText("Mine");
    EXPECT_TRUE(wait_for([&] { return std::filesystem::exists(folder_.path() / "unsaved.json"); }));
    EXPECT_EQ(read_lesson(folder_.path() / "unsaved.json").name, "Mine");
}

class LessonEditorWindowTest : public testing::WindowTest {
  protected:
    LessonEditorWindowTest()
        : WindowTest({[](const OpenRequest& request, Job& job) {
                          if (!request.built_in)
                              throw InputError("is not there", "nowhere", "Give another");
                          return play(test::small_patient(), job);
                      },
                      [](const std::filesystem::path&, const PatientCase&) {}}) {
        open_built_in();
    }
    LessonEditor& editor() { return window_.lesson_editor(); }
    void click(const char* name) { editor().findChild<QPushButton*>(name)->click(); }
};

TEST_F(LessonEditorWindowTest, a_click_on_a_vessel_sets_the_place) {
    editor().show_editor();
    editor().findChild<QTabWidget*>("lessonPages")->setCurrentIndex(1);
    click("mark0click");
    const Vec3 aim = editor().places().at(0);
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(aim));
    const auto& place = editor().document().lesson().marks[0].place;
    ASSERT_TRUE(place.point_mm);
    // The nearest vertex of the wall decides: within a few millimetres along the vessel.
    EXPECT_LT((*place.point_mm - aim).norm(), 8.0);
    const TreePoint on_tree = nearest_point(test::small_patient()->tree, *place.point_mm);
    EXPECT_LT(on_tree.distance_mm, 0.1) << "on the centreline, to the rounding";
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(aim) + QPoint(0, 3));
    EXPECT_TRUE(window_.view().mouse().mode() == MouseMode::pull) << "one click, one place";
}

TEST_F(LessonEditorWindowTest, a_lesson_is_tried_and_leaves_no_attempt) {
    editor().show_editor();
    editor().findChild<QLineEdit*>("lessonName")->setText("Tried");
    click("lessonTry");
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    EXPECT_TRUE(editor().isHidden());
    // Another opening that comes to nothing does not end the try.
    window_.open(QString("/nowhere/at/all.hep"));
    ASSERT_TRUE(wait_for([&] { return !window_.busy(); }));
    EXPECT_TRUE(editor().isHidden());
    EXPECT_EQ(window_.lessons().findChild<QLabel*>("lessonTitle")->text(), "<b>Tried</b>");
    // A tool that it does not allow ends it, so that its recording is whole.
    window_.actions()[ActionId::reset].trigger();
    ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
    wait_for_figures();
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    EXPECT_TRUE(editor().isVisible());
    const Attempts attempts = all_attempts(to_path(settings_.recordings_folder()));
    EXPECT_TRUE(attempts.list.empty());
    const std::filesystem::path tried = to_path(settings_.recordings_folder()) / "tried";
    for (const auto& entry : std::filesystem::directory_iterator(tried))
        EXPECT_EQ(entry.path().string().find(".result."), std::string::npos) << entry.path();
    EXPECT_EQ(editor().places().size(), 1u);
}

}  // namespace
}  // namespace hepatica
