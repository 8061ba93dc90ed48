// SPDX-License-Identifier: GPL-3.0-or-later
// Where a report goes: into the folder that is named, which need not be there.
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>

#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_writer.h"
#include "tests/ui/lesson_window_test.h"
#include "ui/message_bar.h"

namespace hepatica {
namespace {

using testing::wait_for;
namespace fs = std::filesystem;

class ReportPlace : public testing::LessonWindowTest {
  protected:
    // An attempt that is over, and a program that writes an empty report.
    void SetUp() override {
        Lesson lesson = new_lesson();
        lesson.name = "Short";
        lesson.limits = {{Quantity::time_s, -1, false, 0.2}};
        const std::string file = folder_.filePath("short.json").toStdString();
        write_lesson(file, lesson);
        window_.lessons().start(file);
        start_clock();
        ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
        const fs::path program = to_path(folder_.filePath("sh"));
        std::ofstream(program) << "#!/bin/sh\necho done > \"$4/report.html\"\n";
        fs::permissions(program, fs::perms::owner_all);
        window_.set_report_program(to_text(program));
    }
    // Answers the question where to write it; returns what was proposed.
    QString write_into(const fs::path& place) {
        QString proposed;
        QTimer answering;
        QObject::connect(&answering, &QTimer::timeout, [&] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr || !proposed.isEmpty()) return;
            auto* name = dialog->findChild<QLineEdit*>();
            proposed = name->text();
            name->setText(to_text(place));
            QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
        });
        answering.start(20);
        window_.lessons().findChild<QPushButton*>("lessonReport")->click();
        answering.stop();
        EXPECT_TRUE(wait_for([this] { return !window_.busy(); }));
        return proposed;
    }
};

TEST_F(ReportPlace, is_said_until_the_next_lesson_begins) {
    write_into(to_path(folder_.filePath("rep7")));
    ASSERT_TRUE(window_.messages().text().startsWith("The report is in"));
    window_.lessons().findChild<QPushButton*>("lessonAgain")->click();
    ASSERT_TRUE(wait_for([&] { return window_.lessons().running() != nullptr; }));
    EXPECT_EQ(window_.messages().text(), "");
}

TEST_F(ReportPlace, is_the_new_folder_whose_name_is_typed) {
    const fs::path place = to_path(folder_.filePath("rep7"));
    const QString proposed = write_into(place);
    EXPECT_TRUE(proposed.startsWith("Short 20")) << proposed.toStdString();
    EXPECT_TRUE(fs::exists(place / "report.html"));
    // It is there now: the next gets a folder of its own in it.
    write_into(place);
    int reports = 0;
    for (const auto& entry : fs::recursive_directory_iterator(place))
        reports += entry.path().filename() == "report.html" ? 1 : 0;
    EXPECT_EQ(reports, 2);
}

}  // namespace
}  // namespace hepatica
