// SPDX-License-Identifier: GPL-3.0-or-later
// After an attempt: whose it was where he gave a name, and the way to the next lesson.
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QFileDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QTableWidget>
#include <QTimer>
#include <algorithm>
#include <fstream>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>

#include "core/lesson/attempts.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_writer.h"
#include "tests/ui/lesson_window_test.h"
#include "ui/attempts_dialog.h"
#include "ui/course_dialog.h"
#include "ui/message_bar.h"
#include "ui/recording_guard.h"
#include "ui/review_dock.h"
#include "ui/second_view.h"

namespace hepatica {
namespace {

using testing::wait_for;

// Looks at the moment at which a widget is hidden.
class SeesHiding : public QObject {
  public:
    explicit SeesHiding(std::function<void()> see) : see_(std::move(see)) {}
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Hide) see_();
        return QObject::eventFilter(watched, event);
    }

  private:
    std::function<void()> see_;
};

class LessonAttemptsTest : public testing::LessonWindowTest {
  protected:
    // It is over after a fifth of a second.
    std::string short_lesson(const char* name) {
        Lesson lesson = new_lesson();
        lesson.name = name;
        lesson.limits = {{Quantity::time_s, -1, false, 0.2}};
        const std::string file =
            folder_.filePath(QString("%1.json").arg(name).toLower()).toStdString();
        write_lesson(file, lesson);
        return file;
    }
    void play(const std::string& file) {
        window_.lessons().start(file);
        start_clock();
        ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
        wait_for_figures();
    }
    // Asks for reports into this folder, so many times, by a program that waits for the file `go`.
    void ask_for_reports(const std::filesystem::path& go, const std::filesystem::path& into,
                         int times) {
        namespace fs = std::filesystem;
        const fs::path program = to_path(folder_.filePath("sh"));
        std::ofstream(program) << "#!/bin/sh\nuntil [ -e '" << go.string()
                               << "' ]; do sleep 0.02; done\necho done > \"$4/report.html\"\n";
        fs::permissions(program, fs::perms::owner_all);
        window_.set_report_program(to_text(program));
        QTimer answering;  // the question where to write it
        QObject::connect(&answering, &QTimer::timeout, [&into] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) return;
            dialog->findChild<QLineEdit*>()->setText(to_text(into));
            QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
        });
        answering.start(20);
        for (int time = 0; time < times; ++time)
            window_.lessons().findChild<QPushButton*>("lessonReport")->click();
    }
    QLineEdit& name() { return *window_.lessons().findChild<QLineEdit*>("lessonName"); }
    Attempts kept() { return all_attempts(to_path(settings_.recordings_folder())); }
    void type_name(const char* text) {
        name().setText(text);
        QTest::keyClick(&name(), Qt::Key_Return);
    }
};

TEST_F(LessonAttemptsTest, nobody_is_named_who_gave_no_name) {
    const std::string file = short_lesson("First");
    play(file);
    ASSERT_EQ(kept().list.size(), 1u);
    EXPECT_EQ(kept().list[0].name, "");
    EXPECT_EQ(settings_.trainee(), "");
    AttemptsDialog& dialog = window_.lessons().attempts();
    window_.lessons().findChild<QPushButton*>("lessonAttempts")->click();
    EXPECT_TRUE(dialog.findChild<QComboBox*>("attemptsWhose")->isHidden());
    EXPECT_TRUE(dialog.findChild<QTableWidget*>("attempts")->isColumnHidden(4));
    dialog.hide();
    type_name("  Nr.  7 ");
    EXPECT_EQ(settings_.trainee(), "Nr. 7");
    EXPECT_EQ(kept().list[0].name, "Nr. 7") << "who has just ended says who he is";
    type_name("Nr. 8");
    EXPECT_EQ(kept().list[0].name, "Nr. 7") << "nobody takes another's attempt";
    window_.lessons().findChild<QPushButton*>("lessonAgain")->click();
    start_clock();
    ASSERT_TRUE(wait_for([&] { return kept().list.size() == 2; }));
    EXPECT_EQ(kept().list[0].name, "Nr. 7") << "of before";
    EXPECT_EQ(kept().list[1].name, "Nr. 8");
    wait_for_figures();
    // His own first, and everybody's where they are asked for.
    window_.lessons().findChild<QPushButton*>("lessonAttempts")->click();
    auto& whose = *dialog.findChild<QComboBox*>("attemptsWhose");
    EXPECT_FALSE(whose.isHidden());
    EXPECT_EQ(whose.currentText(), "of Nr. 8");
    EXPECT_EQ(dialog.attempts().size(), 1u);
    const auto* title = dialog.findChild<QLabel*>("attemptsTitle");
    EXPECT_TRUE(title->text().contains("Of all 2 attempts these are shown: of Nr. 8."))
        << title->text().toStdString();
    EXPECT_EQ(dialog.findChild<QTableWidget*>("attempts")->item(0, 4)->text(), "Nr. 8");
    whose.setCurrentIndex(0);
    EXPECT_EQ(dialog.attempts().size(), 2u);
    EXPECT_FALSE(title->text().contains("Of all"));
    dialog.hide();
    type_name("");
    EXPECT_EQ(settings_.trainee(), "");
    EXPECT_EQ(kept().list[1].name, "Nr. 8");
}

// The list of attempts may stand open meanwhile.
TEST_F(LessonAttemptsTest, a_name_that_is_given_outlasts_a_reference_that_is_ticked) {
    play(short_lesson("First"));
    window_.lessons().findChild<QPushButton*>("lessonAttempts")->click();
    AttemptsDialog& dialog = window_.lessons().attempts();
    type_name("Nr. 7");
    dialog.findChild<QTableWidget*>("attempts")->item(0, 3)->setCheckState(Qt::Checked);
    ASSERT_EQ(kept().list.size(), 1u);
    EXPECT_TRUE(kept().list[0].reference);
    EXPECT_EQ(kept().list[0].name, "Nr. 7");
}

TEST_F(LessonAttemptsTest, marks_of_a_course_belong_to_what_was_begun_from_it_alone) {
    const std::string file = short_lesson("First");
    const std::vector<Predicate> marks{{Quantity::path_mm, -1, false, 5.0}};
    window_.lessons().start(file, marks);
    start_clock();
    ASSERT_TRUE(wait_for([&] { return kept().list.size() == 1; }));
    EXPECT_EQ(kept().list[0].course_pass, marks);
    // From the library, on a case.
    window_.lessons().start_on(file, folder_.filePath("other.hep"));
    ASSERT_TRUE(wait_for(
        [&] { return window_.lessons().playing() && window_.lessons().running() != nullptr; }));
    start_clock();
    ASSERT_TRUE(wait_for([&] { return kept().list.size() == 2; }));
    EXPECT_TRUE(kept().list[1].course_pass.empty());
    EXPECT_EQ(window_.lessons().standing().pass.size(), new_lesson().pass.size());
}

// A mark that the lesson asks for stays the lesson's own where a course names it as well.
TEST_F(LessonAttemptsTest, a_mark_of_the_lesson_is_not_taken_for_the_courses) {
    Lesson lesson = new_lesson();
    lesson.name = "Own";
    lesson.limits = {{Quantity::time_s, -1, false, 0.2}};
    const Predicate own{Quantity::path_mm, -1, false, 5.0}, more{Quantity::time_s, -1, false, 60.0};
    lesson.pass = {own};
    const std::string file = folder_.filePath("own.json").toStdString();
    write_lesson(file, lesson);
    window_.lessons().start(file, {own, more});
    start_clock();
    ASSERT_TRUE(wait_for([&] { return kept().list.size() == 1; }));
    EXPECT_EQ(kept().list[0].course_pass, std::vector{more});
    EXPECT_EQ(window_.lessons().standing().pass.size(), 2u);
}

TEST_F(LessonAttemptsTest, a_new_window_knows_the_name) {
    settings_.set_trainee("A. B.");
    MainWindow other(settings_, {});
    EXPECT_EQ(other.lessons().findChild<QLineEdit*>("lessonName")->text(), "A. B.");
}

TEST_F(LessonAttemptsTest, the_next_lesson_of_the_course_is_one_click_away) {
    const std::string first = short_lesson("First");
    short_lesson("Second");
    const std::string course = folder_.filePath("course.json").toStdString();
    std::ofstream(course) << R"({"format": "hepatica-course", "version": 1, "name": "Two",
        "lessons": [{"lesson": "first.json"}, {"lesson": "second.json"}]})";
    window_.lessons().show_course(course);
    play(first);
    auto* next = window_.lessons().findChild<QPushButton*>("lessonNext");
    EXPECT_FALSE(next->isHidden());
    EXPECT_EQ(next->text(), "&Next lesson");
    EXPECT_EQ(next->toolTip(), "Second");
    next->click();
    EXPECT_TRUE(wait_for([&] { return shown("lessonTitle").contains("Second"); }));
    start_clock();
    ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
    wait_for_figures();
    EXPECT_TRUE(next->isHidden()) << "the last one";
}

// An instructor's table: everybody's attempts by the lessons of the course.
TEST_F(LessonAttemptsTest, what_was_left_before_anything_was_done_leaves_no_recording) {
    const auto recordings = [this] {
        return recordings_in(to_path(settings_.recordings_folder())).size();
    };
    window_.lessons().start(lesson_file(R"({"what": "holding", "at_least": 1})"));
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && recordings() == 1; }));
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    ASSERT_TRUE(wait_for([&] { return !window_.lessons().playing(); }));
    EXPECT_EQ(recordings(), 0u);
    window_.lessons().start(lesson_file(R"({"what": "holding", "at_least": 1})"));
    start_clock();
    paint();
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    ASSERT_TRUE(wait_for([&] { return !window_.lessons().playing(); }));
    EXPECT_EQ(recordings(), 1u) << "the clock ran";
}

// Nothing stays out of the learning curve.
TEST_F(LessonAttemptsTest, what_was_begun_and_given_up_counts_as_an_attempt) {
    const std::string endless = lesson_file(R"({"what": "time_s", "at_least": 1000})");
    window_.lessons().start(endless);
    start_clock();
    ASSERT_TRUE(wait_for([&] { return window_.lessons().standing().metrics.time_s > 0.0; }));
    EXPECT_TRUE(kept().list.empty());
    window_.lessons().findChild<QPushButton*>("lessonAgain")->click();
    ASSERT_EQ(kept().list.size(), 1u);
    EXPECT_FALSE(kept().list[0].passed);
    EXPECT_EQ(kept().list[0].reasons, std::vector<std::string>{"given up before the end"});
    EXPECT_GT(kept().list[0].value(Quantity::time_s), 0.0);
    // Begun again, but nothing was done yet.
    window_.lessons().findChild<QPushButton*>("lessonAgain")->click();
    EXPECT_EQ(kept().list.size(), 1u);
    start_clock();
    ASSERT_TRUE(wait_for([&] { return window_.lessons().standing().metrics.time_s > 0.0; }));
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    EXPECT_EQ(kept().list.size(), 2u);
}

TEST_F(LessonAttemptsTest, what_is_compared_has_the_marks_of_the_lesson_too) {
    play(short_lesson("Short"));
    window_.lessons().findChild<QPushButton*>("lessonLookBack")->click();
    ASSERT_TRUE(wait_for([&] { return window_.review().complete(); }));
    window_.review().compare(only_recording());
    ASSERT_TRUE(wait_for([&] { return window_.second_view().shown(); }));
    EXPECT_EQ(window_.second_view().view().scene().marks().size(), 1u);
}

TEST_F(LessonAttemptsTest, the_table_is_seen_as_far_as_the_screen_has_room) {
    play(short_lesson("Short"));
    ASSERT_EQ(kept().list.size(), 1u);
    Attempt attempt = kept().list[0];
    attempt.metrics.fill(1e4);
    write_attempt(attempt);
    window_.lessons().findChild<QPushButton*>("lessonAttempts")->click();
    AttemptsDialog& dialog = window_.lessons().attempts();
    const auto* table = dialog.findChild<QTableWidget*>("attempts");
    const int columns = table->horizontalHeader()->length();
    ASSERT_GT(columns, 860) << "more than the window's usual width";
    EXPECT_GE(dialog.width(), std::min(columns, dialog.screen()->availableSize().width()));
}

// Of a long play that takes minutes.
TEST_F(LessonAttemptsTest, a_patient_is_opened_while_a_report_is_written) {
    namespace fs = std::filesystem;
    play(short_lesson("Short"));
    const fs::path go = to_path(folder_.filePath("go"));
    ask_for_reports(go, to_path(folder_.path()), 1);
    ASSERT_TRUE(window_.busy());
    const fs::path other = to_path(folder_.filePath("other.hep"));
    window_.open(to_text(other));
    EXPECT_TRUE(wait_for([&] { return window_.workspace().folder() == other; }));
    EXPECT_TRUE(window_.busy()) << "the report is still being written";
    std::ofstream{go};
    ASSERT_TRUE(wait_for([this] { return !window_.busy(); }));
    EXPECT_TRUE(window_.messages().text().startsWith("The report is in"))
        << window_.messages().text().toStdString();
    EXPECT_EQ(window_.messages().findChild<QPushButton*>("offer")->text(), "Open");
}

// Who presses the button once more before the first is there gets two.
TEST_F(LessonAttemptsTest, reports_that_wait_for_each_other_have_folders_of_their_own) {
    namespace fs = std::filesystem;
    play(short_lesson("Short"));
    const fs::path go = to_path(folder_.filePath("go"));
    const fs::path reports = to_path(folder_.filePath("reports"));
    fs::create_directory(reports);
    ask_for_reports(go, reports, 2);
    const auto* strip = window_.findChild<QWidget*>("progressStrip");
    EXPECT_TRUE(strip->findChild<QPushButton*>()->toolTip().contains("the report on Short ("));
    std::ofstream{go};
    ASSERT_TRUE(wait_for([this] { return !window_.busy(); }));
    EXPECT_EQ(std::distance(fs::directory_iterator(reports), fs::directory_iterator()), 2);
}

// Ctrl + Q is quickly pressed for Ctrl + W.
TEST_F(LessonAttemptsTest, the_window_asks_before_it_closes_on_a_lesson_that_is_played) {
    lesson_may_end_ = false;
    window_.lessons().start(lesson_file(R"({"what": "holding", "at_least": 1})"));
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing(); }));
    start_clock();
    bool stood = false;
    while_asked_ = [&] { stood = wait_for([&] { return window_.frame().statistics.paused; }); };
    EXPECT_FALSE(window_.close());
    EXPECT_EQ(lesson_ends_asked_, 1);
    EXPECT_TRUE(window_.lessons().running() != nullptr);
    EXPECT_TRUE(stood) << "thinking about the question costs no time";
    EXPECT_TRUE(wait_for([&] { return !window_.frame().statistics.paused; })) << "it goes on";
    ASSERT_TRUE(wait_for([&] { return window_.lessons().standing().metrics.time_s > 0.0; }));
    EXPECT_TRUE(kept().list.empty());
    lesson_may_end_ = true;
    EXPECT_TRUE(window_.close());
    ASSERT_EQ(kept().list.size(), 1u) << "closing hides no attempt";
    EXPECT_FALSE(kept().list[0].passed);
    EXPECT_EQ(kept().list[0].reasons, std::vector<std::string>{"given up before the end"});
}

TEST_F(LessonAttemptsTest, closing_on_a_lesson_in_which_nothing_was_done_keeps_nothing) {
    window_.lessons().start(lesson_file(R"({"what": "holding", "at_least": 1})"));
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing(); }));
    only_recording();
    EXPECT_TRUE(window_.close());
    EXPECT_EQ(lesson_ends_asked_, 0);
    EXPECT_TRUE(kept().list.empty());
    EXPECT_TRUE(recordings_in(to_path(settings_.recordings_folder())).empty());
}

// The panel still shows the first lesson while the second one's patient is being opened.
TEST_F(LessonAttemptsTest, to_begin_again_is_the_lesson_of_the_panel_and_none_that_waits) {
    Lesson own = new_lesson();
    own.name = "Own";
    own.patient = folder_.filePath("own.hep").toStdString();
    const std::string of_another = folder_.filePath("own.json").toStdString();
    write_lesson(of_another, own);
    window_.lessons().start(short_lesson("First"));
    start_clock();
    window_.lessons().start(of_another);
    window_.lessons().findChild<QPushButton*>("lessonAttempts")->click();
    AttemptsDialog& attempts = window_.lessons().attempts();
    EXPECT_TRUE(attempts.findChild<QLabel*>("attemptsTitle")->text().contains("First"));
    attempts.hide();
    window_.lessons().findChild<QPushButton*>("lessonAgain")->click();
    ASSERT_NE(window_.lessons().running(), nullptr);
    EXPECT_EQ(window_.lessons().running()->name, "First") << "else on a patient who is not its own";
    wait();
    EXPECT_TRUE(wait_for([&] { return !window_.lessons().playing(); })) << "another is shown";
}

// The patient who is on his way is that of a lesson that was chosen before.
TEST_F(LessonAttemptsTest, a_lesson_of_the_built_in_patient_begins_on_no_other_who_comes_later) {
    std::unique_ptr<Simulation> held;
    LessonDock::Ways ways;
    ways.patient = [] { return test::small_patient(); };
    ways.use = [&](std::unique_ptr<Simulation> simulation) { held = std::move(simulation); };
    ways.open_case = [](const QString&) {};
    ways.failed = [](const QString& doing, const std::exception_ptr&) {
        ADD_FAILURE() << doing.toStdString();
    };
    auto* dock = new LessonDock(std::move(ways), to_path(folder_.filePath("other")), &window_);
    Lesson own = new_lesson();
    own.patient = folder_.filePath("own.hep").toStdString();
    const std::string file = folder_.filePath("own.json").toStdString();
    write_lesson(file, own);
    ASSERT_EQ(find_lesson("gentle_pull").patient, "built-in");
    dock->patient_shown(true, {});
    dock->start(file);
    EXPECT_FALSE(dock->playing()) << "it waits";
    dock->start("gentle_pull");
    ASSERT_TRUE(dock->playing());
    dock->patient_shown(false, to_path(folder_.filePath("own.hep")));
    QCoreApplication::processEvents();  // a lesson begins a turn of the loop later
    EXPECT_FALSE(dock->playing());
    dock->start(file);
    dock->patient_shown(false, to_path(folder_.filePath("own.hep")));
    QCoreApplication::processEvents();
    EXPECT_TRUE(dock->playing()) << "its own";
    delete dock;
}

// The marks are vertices of the vessels that were played on: another body may have fewer.
TEST_F(LessonAttemptsTest, no_mark_is_looked_for_on_the_vessels_of_who_comes_next) {
    window_.lessons().start(lesson_file(R"({"what": "time_s", "at_least": 1000})"));
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    ASSERT_TRUE(wait_for([&] { return window_.view().scene().marks().size() == 1; }));
    std::optional<std::size_t> marks;
    SeesHiding sees([&] { marks = window_.view().scene().marks().size(); });
    window_.lessons().installEventFilter(&sees);
    window_.open(folder_.filePath("other.hep"));
    wait();
    ASSERT_TRUE(marks.has_value()) << "the panel goes with the play";
    EXPECT_EQ(*marks, 0u) << "his first frame was shown before";
    window_.lessons().removeEventFilter(&sees);
}

TEST_F(LessonAttemptsTest, a_try_that_cannot_begin_is_told_of) {
    int not_begun = 0;
    bool is_there = true;
    LessonDock::Ways ways;
    ways.patient = [&] { return is_there ? test::small_patient() : nullptr; };
    ways.may_begin = [] { return false; };
    ways.open_built_in = [] {};
    ways.not_begun = [&] { ++not_begun; };
    auto* dock = new LessonDock(std::move(ways), to_path(folder_.filePath("other")), &window_);
    EXPECT_TRUE(dock->try_out(new_lesson()));
    EXPECT_EQ(not_begun, 1);
    is_there = false;
    EXPECT_TRUE(dock->try_out(new_lesson()));
    EXPECT_EQ(not_begun, 1) << "its patient is being opened";
    dock->patient_not_shown();
    EXPECT_EQ(not_begun, 2);
    dock->patient_not_shown();
    EXPECT_EQ(not_begun, 2) << "nothing waited for him";
    Lesson of_built_in = new_lesson();
    of_built_in.patient = "built-in";
    EXPECT_TRUE(dock->try_out(of_built_in));
    dock->patient_shown(false, "/another.hep");
    EXPECT_EQ(not_begun, 3) << "another patient was opened meanwhile";
    EXPECT_TRUE(dock->try_out(of_built_in));
    EXPECT_TRUE(dock->start("look_around"));
    EXPECT_EQ(not_begun, 4) << "another lesson was chosen meanwhile";
    EXPECT_FALSE(dock->playing());
    delete dock;
}

// Who gave it up could not mend it: what is edited is the course that was chosen.
TEST_F(LessonAttemptsTest, a_course_of_which_a_lesson_is_gone_stays_chosen_and_can_be_edited) {
    const std::string course = folder_.filePath("course.json").toStdString();
    std::ofstream(course) << R"({"format": "hepatica-course", "version": 1, "name": "Wards",
        "lessons": [{"lesson": "gone.json"}, {"lesson": "look_around"}]})";
    window_.lessons().show_course(course);
    EXPECT_TRUE(window_.messages().text().contains("gone.json"));
    EXPECT_EQ(settings_.course(), QString::fromStdString(course));
    window_.lessons().show_course(course);
    EXPECT_EQ(settings_.course(), QString::fromStdString(course))
        << "however often it is asked for";
    window_.lessons().edit_course();
    auto* lessons = window_.findChild<QListWidget*>("courseLessons");
    ASSERT_NE(lessons, nullptr);
    ASSERT_EQ(lessons->count(), 2);
    EXPECT_TRUE(lessons->item(0)->text().contains("cannot be read"));
    lessons->setCurrentRow(0);
    window_.findChild<QPushButton*>("courseRemove")->click();
    window_.lessons().show_course(course);
    EXPECT_EQ(window_.lessons().course().lines().size(), 1u);
}

// As in a copy of the bleeding vessel whose vessels tear no more.
TEST_F(LessonAttemptsTest, a_lesson_whose_setup_is_refused_does_not_begin_and_says_why) {
    const std::string file = folder_.filePath("cut.json").toStdString();
    std::ofstream(file) << R"({"format": "hepatica-lesson", "version": 1, "name": "Cut before",
        "scene": {"name": "cut before", "deform": {}}, "tools": ["pull"],
        "setup": [{"do": "blade", "from_mm": [-1, 0, 0], "to_mm": [1, 0, 0]}],
        "steps": [{"text": "Hold it", "goal": [{"what": "holding", "at_least": 1}]}]})";
    window_.lessons().start(file);
    EXPECT_TRUE(wait_for([&] { return window_.messages().text().contains("nothing tears"); }))
        << window_.messages().text().toStdString();
    EXPECT_TRUE(window_.messages().text().contains("Cut before"));
    EXPECT_FALSE(window_.lessons().playing());
    EXPECT_TRUE(recordings_in(to_path(settings_.recordings_folder())).empty());
    EXPECT_TRUE(kept().list.empty());
}

TEST_F(LessonAttemptsTest, one_table_says_who_passed_what) {
    for (const auto& [file, name, time_s, passed] :
         {std::tuple("1.hrec", "Anna", 12.0, true), std::tuple("2.hrec", "Anna", 9.5, true),
          std::tuple("3.hrec", "Nr. 7", 30.0, false)}) {
        Attempt attempt;
        attempt.recording = to_path(settings_.recordings_folder()) / file;
        attempt.lesson = "Gentle pull";
        attempt.ended_at = "2026";
        attempt.name = name;
        attempt.passed = attempt.passed_lesson = passed;
        attempt.metrics[static_cast<std::size_t>(Quantity::time_s)] = time_s;
        write_attempt(attempt);
    }
    window_.lessons().show_results();
    auto* table = window_.findChild<QTableWidget*>("results");
    ASSERT_NE(table, nullptr);
    ASSERT_EQ(table->rowCount(), 2);
    ASSERT_EQ(table->columnCount(), 9) << "name, how many, and the seven";
    EXPECT_EQ(table->item(0, 0)->text(), "Anna");
    EXPECT_EQ(table->item(0, 1)->text(), "1 of 7");
    EXPECT_EQ(table->item(0, 3)->text(), "✓ 9.5 s, 2 attempts");
    EXPECT_EQ(table->item(1, 3)->text(), "✗ 1 attempt");
    EXPECT_EQ(table->item(1, 2)->text(), "");
}

}  // namespace
}  // namespace hepatica
