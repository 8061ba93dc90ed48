// SPDX-License-Identifier: GPL-3.0-or-later
// Courses are made in the window: each change is in the file at once, and can be undone.
#include "ui/lesson_editor/course_editor.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_writer.h"
#include "tests/ui/window_test.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class CourseEditing : public ::testing::Test {
  protected:
    CourseEditing()
        : editor_({[this] { return lesson_file_; },
                   [this](const QString&, const std::string&) { return copy_; },
                   [this](const QString&, const std::exception_ptr& error) {
                       failures_.push_back(failure_of(error).problem);
                   },
                   [this](const fs::path& file) { written_.push_back(file); }},
                  nullptr) {}

    void click(const char* name) { editor_.findChild<QPushButton*>(name)->click(); }
    void add(const char* lesson) {
        for (QAction* action : editor_.findChild<QToolButton*>("courseAdd")->menu()->actions())
            if (action->objectName() == lesson) action->trigger();
    }
    QListWidget& list() { return *editor_.findChild<QListWidget*>("courseLessons"); }
    std::vector<std::string> lessons() const {
        std::vector<std::string> names;
        for (const CourseEntry& entry : read_course(file_).lessons) names.push_back(entry.lesson);
        return names;
    }
    using Names = std::vector<std::string>;

    TemporaryFolder folder_;
    fs::path file_ = folder_.path() / "mine" / "course.json";
    std::optional<fs::path> lesson_file_, copy_;
    std::vector<std::string> failures_;
    std::vector<fs::path> written_;
    CourseEditor editor_;
};

TEST_F(CourseEditing, begins_with_a_copy_of_the_programs_own_where_the_person_says) {
    editor_.edit({});
    EXPECT_FALSE(editor_.isVisible()) << "not after all";
    fs::create_directories(file_.parent_path());
    copy_ = file_;
    editor_.edit({});
    EXPECT_TRUE(editor_.isVisible());
    EXPECT_EQ(read_course(file_), course_of(built_in_course(), "course"));
    EXPECT_EQ(list().count(), 7);
    EXPECT_EQ(written_, std::vector<fs::path>{file_});
}

// As where the program ends while one types: the field that loses the focus shows the course.
TEST_F(CourseEditing, ends_while_its_name_has_the_focus) {
    fs::create_directories(file_.parent_path());
    auto editor = std::make_unique<CourseEditor>(
        CourseEditor::Ways{[] { return std::nullopt; },
                           [this](const QString&, const std::string&) { return file_; },
                           [](const QString&, const std::exception_ptr&) {},
                           [](const fs::path&) {}},
        nullptr);
    editor->edit({});
    auto* name = editor->findChild<QLineEdit*>("courseName");
    editor->activateWindow();
    name->setFocus();
    ASSERT_TRUE(QTest::qWaitFor([name] { return name->hasFocus(); }, testing::patience_ms));
    bool shown_anew = false;
    QObject::connect(editor->findChild<QListWidget*>("courseLessons")->model(),
                     &QAbstractItemModel::rowsInserted, editor.get(), [&] { shown_anew = true; });
    editor.reset();
    EXPECT_EQ(read_course(file_).lessons.size(), 7u);
    EXPECT_TRUE(shown_anew) << "before the editor was gone";
}

TEST_F(CourseEditing, every_change_is_in_the_file_and_can_be_undone) {
    fs::create_directories(file_.parent_path());
    write_course(file_, {"Two", {{"gentle_pull", {}}, {"cut_line", {}}}});
    editor_.edit(file_);
    add("embolization");
    EXPECT_EQ(lessons(), (Names{"gentle_pull", "embolization", "cut_line"})) << "after the chosen";
    EXPECT_EQ(list().currentRow(), 1);
    click("courseDown");
    EXPECT_EQ(lessons(), (Names{"gentle_pull", "cut_line", "embolization"}));
    click("courseUp");
    click("courseUp");
    EXPECT_EQ(lessons(), (Names{"embolization", "gentle_pull", "cut_line"}));
    EXPECT_FALSE(editor_.findChild<QPushButton*>("courseUp")->isEnabled());
    list().setCurrentRow(1);
    click("courseRemove");
    EXPECT_EQ(lessons(), (Names{"embolization", "cut_line"}));
    for (int i = 0; i < 5; ++i) click("courseUndo");
    EXPECT_EQ(lessons(), (Names{"gentle_pull", "cut_line"}));
    EXPECT_FALSE(editor_.findChild<QPushButton*>("courseUndo")->isEnabled());
    for (int i = 0; i < 5; ++i) click("courseRedo");
    EXPECT_EQ(lessons(), (Names{"embolization", "cut_line"}));
    click("courseRemove");
    click("courseRemove");
    EXPECT_TRUE(lessons().empty());
    EXPECT_FALSE(editor_.findChild<QPushButton*>("courseRemove")->isEnabled());
    click("courseUndo");
    EXPECT_EQ(lessons().size(), 1u);
    EXPECT_TRUE(failures_.empty());
}

TEST_F(CourseEditing, a_new_one_is_empty_called_as_its_file_and_filled_then) {
    editor_.begin_new();
    EXPECT_FALSE(editor_.isVisible()) << "not after all";
    fs::create_directories(file_.parent_path());
    copy_ = file_.parent_path() / "First year.json";
    editor_.begin_new();
    EXPECT_TRUE(editor_.isVisible());
    EXPECT_EQ(read_course(*copy_), (Course{"First year", {}}));
    EXPECT_EQ(editor_.findChild<QLineEdit*>("courseName")->text(), "First year");
    EXPECT_EQ(list().count(), 0);
    add("gentle_pull");
    add("cut_line");
    EXPECT_EQ(read_course(*copy_).lessons.size(), 2u);
    EXPECT_EQ(read_course(*copy_).lessons[1].lesson, "cut_line");
    EXPECT_EQ(written_.back(), *copy_);
    EXPECT_TRUE(failures_.empty());
}

TEST_F(CourseEditing, pass_marks_belong_to_the_lesson_that_is_chosen) {
    fs::create_directories(file_.parent_path());
    write_course(file_, {"Two", {{"gentle_pull", {}}, {"cut_line", {}}}});
    editor_.edit(file_);
    list().setCurrentRow(1);
    click("coursePassAdd");
    const Predicate mark{Quantity::time_s, -1, false, 60.0};
    EXPECT_EQ(read_course(file_).lessons[1].pass, std::vector<Predicate>{mark});
    EXPECT_TRUE(read_course(file_).lessons[0].pass.empty());
    EXPECT_TRUE(list().item(1)->text().contains("1 pass mark"))
        << list().item(1)->text().toStdString();
    list().setCurrentRow(0);
    EXPECT_EQ(editor_.findChild<QPushButton*>("coursePass0remove"), nullptr);
    list().setCurrentRow(1);
    ASSERT_NE(editor_.findChild<QPushButton*>("coursePass0remove"), nullptr);
    click("coursePass0remove");
    EXPECT_TRUE(read_course(file_).lessons[1].pass.empty());
}

TEST_F(CourseEditing, a_name_is_typed_and_undone_at_once_and_is_never_empty) {
    fs::create_directories(file_.parent_path());
    write_course(file_, {"Two", {{"gentle_pull", {}}}});
    editor_.edit(file_);
    auto* name = editor_.findChild<QLineEdit*>("courseName");
    name->selectAll();
    QTest::keyClicks(name, "Wards");
    EXPECT_EQ(read_course(file_).name, "Wards");
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_TRUE(editor_.isVisible()) << "Enter presses no button";
    EXPECT_TRUE(read_course(file_).lessons[0].pass.empty());
    name->selectAll();
    QTest::keyClick(name, Qt::Key_Delete);
    EXPECT_EQ(read_course(file_).name, "Wards");
    EXPECT_TRUE(failures_.empty());
    click("courseUndo");
    EXPECT_EQ(read_course(file_).name, "Two");
    EXPECT_EQ(name->text(), "Two");
}

TEST_F(CourseEditing, a_lesson_from_a_file_is_named_from_where_the_course_lies) {
    fs::create_directories(file_.parent_path());
    write_course(file_, {"Two", {{"gentle_pull", {}}}});
    editor_.edit(file_);
    lesson_file_ = folder_.path() / "own.json";
    add("courseAddFile");
    ASSERT_EQ(failures_.size(), 1u) << "it is not there";
    EXPECT_EQ(lessons().size(), 1u);
    write_lesson(*lesson_file_, find_lesson("cut_line"));
    add("courseAddFile");
    EXPECT_EQ(lessons(), (Names{"gentle_pull", "../own.json"}));
    copy_ = folder_.path() / "copy.json";
    click("courseCopy");
    EXPECT_EQ(read_course(*copy_).lessons[1].lesson, "own.json") << "the same from another folder";
    EXPECT_EQ(editor_.document().file(), *copy_);
}

// The change stands, is said not to be in the file, and goes there with the next one.
TEST_F(CourseEditing, what_cannot_be_written_is_said_and_not_lost) {
    fs::create_directories(file_.parent_path());
    write_course(file_, {"Two", {{"gentle_pull", {}}}});
    editor_.edit(file_);
    fs::rename(file_.parent_path(), folder_.path() / "away");
    std::ofstream(file_.parent_path()) << "a file where the folder was";
    add("cut_line");
    EXPECT_EQ(failures_.size(), 1u);
    EXPECT_EQ(list().count(), 2);
    EXPECT_FALSE(editor_.document().written());
    fs::remove(file_.parent_path());
    fs::rename(folder_.path() / "away", file_.parent_path());
    add("embolization");
    EXPECT_TRUE(editor_.document().written());
    EXPECT_EQ(lessons(), (Names{"gentle_pull", "cut_line", "embolization"}));
    editor_.edit(folder_.path() / "none.json");
    EXPECT_EQ(failures_.size(), 2u);
    EXPECT_EQ(editor_.document().file(), file_);
}

}  // namespace
}  // namespace hepatica
