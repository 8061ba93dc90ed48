// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson that is being made is not lost: undo, its file, a copy to begin with, the end of the
// program, and what a crash leaves behind.
#include <sys/wait.h>
#include <unistd.h>

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
#include <memory>

#include "core/base/error.h"
#include "core/lesson/lesson_writer.h"
#include "tests/ui/lesson_editor_test.h"
#include "ui/lock_file.h"

namespace hepatica {
namespace {

using testing::LessonEditorTest;
using testing::wait_for;

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

TEST_F(LessonEditorTest, keeps_what_is_not_saved) {
    field<QLineEdit>("lessonName").setText("Mine");
    EXPECT_TRUE(wait_for([&] { return std::filesystem::exists(folder_.path() / "unsaved.json"); }));
    EXPECT_EQ(kept().name, "Mine");
}

// As where the program ends while one types: Qt takes the focus away when the editor's members are
// gone, so that no field may say any more what was typed.
TEST_F(LessonEditorTest, ends_while_a_value_is_typed) {
    auto editor = std::make_unique<LessonEditor>(ways(), folder_.path() / "other.json", nullptr);
    editor->show_editor();
    auto* flows = editor->findChild<QCheckBox*>("lessonFlows");
    if (!flows->isChecked()) flows->click();
    auto* speed = editor->findChild<QDoubleSpinBox*>("lessonDrugSpeed");
    editor->activateWindow();
    speed->setFocus();
    ASSERT_TRUE(wait_for([speed] { return speed->hasFocus(); }));
    speed->selectAll();
    QTest::keyClicks(speed, "7");
    bool heard = false;
    QObject::connect(speed, &QDoubleSpinBox::valueChanged, speed, [&] { heard = true; });
    editor.reset();
    EXPECT_FALSE(heard);
}

// What it left is offered at once, however long the desktop takes to ask how it ended.
TEST(LockFiles, of_a_killed_program_that_nobody_has_reaped_are_free) {
    const QTemporaryDir folder;
    const std::filesystem::path file = to_path(folder.filePath("lock"));
    auto lock = lock_file(file);
    ASSERT_TRUE(lock->tryLock(0));
    EXPECT_FALSE(lock_file(file)->tryLock(0)) << "this program lives";
    QFile written(folder.filePath("lock"));
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    const QByteArray own = written.readAll();
    written.close();
    lock.reset();
    const pid_t child = fork();
    if (child == 0) _exit(0);
    ASSERT_GT(child, 0);
    siginfo_t ended{};
    ASSERT_EQ(waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT), 0);
    ASSERT_TRUE(written.open(QIODevice::WriteOnly));
    written.write(QByteArray::number(child) + own.mid(own.indexOf('\n')));
    written.close();
    EXPECT_TRUE(lock_file(file)->tryLock(0));
    EXPECT_EQ(waitpid(child, nullptr, 0), child);
}

}  // namespace
}  // namespace hepatica
