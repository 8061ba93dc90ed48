// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson whose patient is corrected after it was made: the instructor is told, and no trainee
// meets it until he has looked at its places.
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <fstream>

#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_ties.h"
#include "core/lesson/lesson_writer.h"
#include "core/patient/patient_case.h"
#include "tests/patient/parted_patient.h"
#include "tests/ui/window_test.h"
#include "ui/lesson_dock.h"
#include "ui/lesson_editor/lesson_editor.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/review_dock.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using testing::wait_for;

const Vec3 on_loose_piece(37, 54.5, 4), on_trunk(0, 10, 1.5);

class LessonFit : public testing::WindowTest {
  protected:
    // Whatever is opened, the patient in two pieces lies there.
    LessonFit()
        : WindowTest(
              {[](const OpenRequest& request, Job& job) {
                   LoadedPatient loaded =
                       play(std::make_shared<const PatientCase>(test::patient_with_bridges()), job);
                   loaded.title = "p.hep";
                   loaded.folder = loaded.asked_for = request.reconstruct.ct;
                   return loaded;
               },
               [](const fs::path&, const PatientCase&) {}}) {
        fs::create_directory(case_);
        window_.open(to_text(case_));
        wait();
    }

    // As the editor saves it.
    fs::path save_lesson(const Vec3& mark) {
        Lesson lesson = new_lesson();
        lesson.name = "At the mark";
        lesson.patient = case_.string();
        lesson.marks[0].place = {mark, std::nullopt};
        tie(lesson, window_.workspace().patient()->tree);
        const fs::path file = case_.parent_path() / "lesson.json";
        write_lesson(file, lesson);
        return file;
    }
    void choose_to_delete_trees() {
        window_.actions()[ActionId::edit_mode].trigger();
        auto* tools = window_.findChild<QComboBox*>("EditTool");
        tools->setCurrentIndex(tools->findText("Delete a whole tree"));
    }
    void delete_loose_piece() {
        choose_to_delete_trees();
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(on_loose_piece));
        wait();
        ASSERT_EQ(roots(window_.workspace().patient()->tree).size(), 1u);
    }
    bool told(const char* what) { return window_.messages().text().contains(what); }
    void play_it(const fs::path& file) {
        window_.lessons().start_on(file.string(), to_text(case_));
        wait();
    }

    fs::path case_ = to_path(folder_.filePath("p.hep"));
};

TEST_F(LessonFit, who_corrects_is_told_which_lesson_fits_no_more_and_of_undo_that_it_does) {
    save_lesson(on_loose_piece);
    delete_loose_piece();
    ASSERT_TRUE(wait_for([&] { return told("1 lesson for this patient fits"); }))
        << window_.messages().text().toStdString();
    EXPECT_TRUE(told("At the mark: \"mark 1\" now lies"));
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_TRUE(wait_for([&] { return window_.messages().text().isEmpty(); }));
}

// The words are those that were told of him before he was opened once more.
TEST_F(LessonFit, who_corrects_a_patient_that_is_opened_again_is_told_again) {
    fs::remove(case_);
    write_case(case_, test::patient_with_bridges());  // who has unsaved work opens no empty folder
    save_lesson(on_loose_piece);
    for (int time = 0; time < 2; ++time) {
        delete_loose_piece();
        EXPECT_TRUE(wait_for([&] { return told("1 lesson for this patient fits"); })) << time;
        window_.open(to_text(case_));  // without saving
        wait();
        EXPECT_FALSE(told("fits"));
        ASSERT_EQ(roots(window_.workspace().patient()->tree).size(), 2u);
    }
}

// The vessels would arrive in the middle of the play, and end it without a verdict.
TEST_F(LessonFit, none_begins_while_the_vessels_are_corrected) {
    const fs::path file = to_path(folder_.filePath("any.json"));
    write_lesson(file, new_lesson());
    choose_to_delete_trees();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(on_loose_piece));
    ASSERT_TRUE(window_.busy());
    window_.lessons().start(file.string());
    EXPECT_FALSE(window_.lessons().playing());
    EXPECT_TRUE(told("No lesson begins while the vessels are corrected"));
    window_.review().open(case_.parent_path() / "play.hrec");
    EXPECT_TRUE(told("he vessels are being corrected, which would end the review"));
    wait();
    window_.lessons().start(file.string());
    EXPECT_TRUE(wait_for([&] { return window_.lessons().playing(); }));
}

// As one that was written by hand, or saved while another patient was shown.
TEST_F(LessonFit, who_corrects_is_told_of_a_lesson_that_was_never_tied) {
    for (const Vec3& mark : {on_loose_piece, on_trunk}) {
        Lesson lesson = read_lesson(save_lesson(mark));
        untie(lesson);
        lesson.name = mark == on_trunk ? "On the trunk" : "On what goes";
        write_lesson(case_.parent_path() / (lesson.name + ".json"), lesson);
        fs::remove(case_.parent_path() / "lesson.json");
    }
    delete_loose_piece();
    ASSERT_TRUE(wait_for([&] { return told("1 lesson for this patient fits"); }))
        << window_.messages().text().toStdString();
    EXPECT_TRUE(told("On what goes: \"mark 1\" now lies"));
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_TRUE(wait_for([&] { return window_.messages().text().isEmpty(); }));
}

TEST_F(LessonFit, who_corrects_is_told_that_nobody_knows_which_lessons_fit) {
    settings_.set_library_folder(folder_.filePath("no folder"));
    std::ofstream(to_path(folder_.filePath("no folder"))) << "a file";
    delete_loose_piece();
    ASSERT_TRUE(wait_for([&] { return told("Which lessons still fit"); }));
    EXPECT_TRUE(told("Cannot be read (Not a directory)"));
    EXPECT_TRUE(told("no folder"));
    EXPECT_TRUE(told("Choose another folder"));
}

TEST_F(LessonFit, nothing_is_said_of_a_lesson_that_still_fits) {
    const fs::path file = save_lesson(on_trunk);
    delete_loose_piece();
    EXPECT_FALSE(told("fits"));
    window_.actions()[ActionId::undo_edit].trigger();  // or the opening would ask about it
    wait();
    play_it(file);
    EXPECT_TRUE(wait_for([&] { return window_.lessons().playing(); }));
    EXPECT_FALSE(told("fits"));
}

TEST_F(LessonFit, a_lesson_that_fits_no_more_is_not_begun) {
    Lesson lesson = read_lesson(save_lesson(on_loose_piece));
    lesson.marks[0].tie->at_mm += Vec3(0, 0, 20);  // as if the vessel had been there
    const fs::path file = case_.parent_path() / "lesson.json";
    write_lesson(file, lesson);
    play_it(file);
    ASSERT_TRUE(wait_for([&] { return told("At the mark is not played"); }));
    EXPECT_TRUE(told("\"mark 1\" now lies 20 mm from where it was"));
    EXPECT_FALSE(window_.lessons().playing());
    EXPECT_TRUE(window_.lessons().isHidden());

    // What to do about it is one click away, and then it is played.
    window_.messages().findChild<QPushButton*>("offer")->click();
    LessonEditor& editor = window_.lesson_editor();
    ASSERT_TRUE(editor.isVisible());
    EXPECT_EQ(editor.document().file(), file);
    EXPECT_TRUE(editor.findChild<QLabel*>("lessonDoubts")->text().contains("now lies 20 mm"));
    auto* right = editor.findChild<QPushButton*>("lessonAcceptPlaces");
    ASSERT_TRUE(right->isVisible());
    editor.findChild<QPushButton*>("lessonSave")->click();
    EXPECT_FALSE(misfits(read_lesson(file), window_.workspace().patient()->tree).empty())
        << "to save something else is no consent";
    right->click();
    EXPECT_FALSE(right->isVisible());
    editor.findChild<QPushButton*>("lessonSave")->click();
    editor.hide();
    play_it(file);
    EXPECT_TRUE(wait_for([&] { return window_.lessons().playing(); }));
}

TEST_F(LessonFit, a_lesson_for_the_shown_case_is_tied_when_it_is_saved_and_anew_where_it_is_put) {
    Lesson lesson = new_lesson();
    lesson.patient = case_.string();
    lesson.marks[0].place = {on_loose_piece, std::nullopt};
    const fs::path file = case_.parent_path() / "lesson.json";
    write_lesson(file, lesson);
    LessonEditor& editor = window_.lesson_editor();
    editor.edit(file);
    editor.findChild<QPushButton*>("lessonSave")->click();
    ASSERT_TRUE(is_tied(read_lesson(file)));
    EXPECT_LT((read_lesson(file).marks[0].tie->at_mm - on_loose_piece).norm(), 1.0);
    editor.findChild<QTabWidget*>("lessonPages")->setCurrentIndex(1);
    editor.findChild<QPushButton*>("mark0click")->click();
    editor.place_clicked(on_trunk);
    EXPECT_FALSE(editor.document().lesson().marks[0].tie);
    editor.findChild<QPushButton*>("lessonSave")->click();
    EXPECT_LT((read_lesson(file).marks[0].tie->at_mm - on_trunk).norm(), 1.0);
    EXPECT_FALSE(editor.document().dirty());
}

}  // namespace
}  // namespace hepatica
