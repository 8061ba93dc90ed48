// SPDX-License-Identifier: GPL-3.0-or-later
// A free play that is recorded, and recordings that a crash cut off.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/base/temporary_folder.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_writer.h"
#include "core/session/recording_file.h"
#include "core/session/replay.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"
#include "tests/ui/window_test.h"
#include "ui/attempts_dialog.h"
#include "ui/lesson_dock.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/recording_dialog.h"
#include "ui/recording_guard.h"
#include "ui/review_dock.h"
#include "ui/time_of_play.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using testing::wait_for;

MainWindow::Patients small_patients() {
    return {[](const OpenRequest&, Job& job) { return play(test::small_patient(), job); },
            [](const fs::path&, const PatientCase&) {}};
}

class RecordedWindow : public testing::WindowTest {
  protected:
    RecordedWindow() : WindowTest(small_patients()) {}

    fs::path recordings() const { return to_path(settings_.recordings_folder()); }
    bool says_that_it_records() { return window_.findChild<QLabel*>("recording")->isVisible(); }
    QAction& record() { return window_.actions()[ActionId::record_play]; }
    // Its clock runs to an end that nobody reaches.
    std::string lesson_file() {
        const std::string file = folder_.filePath("endless.json").toStdString();
        std::ofstream(file) << R"({"format": "hepatica-lesson", "version": 1, "name": "Endless",
            "scene": {"name": "endless", "deform": {}}, "tools": ["pull"],
            "steps": [{"text": "Wait", "goal": [{"what": "time_s", "at_least": 1000}]}]})";
        return file;
    }
    void start_lesson() {
        window_.lessons().start(lesson_file());
        ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
        paint();
    }
    // What a program that is killed now leaves: its files, and nobody's lock on them.
    QString killed_now() {
        const fs::path copy = to_path(folder_.filePath("killed"));
        fs::create_directories(copy);
        fs::copy(recordings(), copy / "recordings", fs::copy_options::recursive);
        for (const auto& entry : fs::directory_iterator(copy / "recordings"))
            if (entry.path().extension() == ".lock") fs::remove(entry.path());
        return to_text(copy / "settings.ini");
    }
};

TEST_F(RecordedWindow, a_free_play_is_recorded_and_looked_back_on) {
    EXPECT_FALSE(record().isEnabled()) << "there is nobody to play with";
    open_built_in();
    EXPECT_FALSE(says_that_it_records());
    record().trigger();
    EXPECT_TRUE(record().isChecked());
    EXPECT_TRUE(says_that_it_records());
    const Vec3 at = test::middle_of(test::small_patient()->tree, 4);
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_widget(at));
    QTest::mouseMove(&window_.view(), on_widget(at) + QPoint(40, 0));
    ASSERT_TRUE(wait_for([&] { return window_.frame().grab.has_value(); }));
    paint();
    record().trigger();
    EXPECT_FALSE(record().isChecked());
    EXPECT_FALSE(says_that_it_records());
    const auto files = recordings_in(recordings());
    ASSERT_EQ(files.size(), 1u);
    Job job;
    const Recording recording = read_recording(files[0]);
    EXPECT_GT(recording.steps.size(), 0u);
    EXPECT_FALSE(replay(recording, test::small_patient(), job).diverged_at);
    EXPECT_EQ(facts_of(files[0]).lesson, "Free play");
    const QDateTime played = time_of_play(files[0]).toUTC();
    EXPECT_TRUE(to_text(files[0].filename()).startsWith(played.toString("'play-'yyyyMMdd-HHmmss-")))
        << recording.played_at;
    EXPECT_TRUE(interrupted_recordings(recordings()).empty()) << "it ended as it should";
    window_.messages().findChild<QPushButton*>("offer")->click();
    EXPECT_TRUE(wait_for([&] { return window_.review().complete(); }));
    EXPECT_FALSE(record().isEnabled()) << "what is looked back on is recorded already";
}

TEST_F(RecordedWindow, the_recording_of_a_lesson_holds_its_date) {
    start_lesson();
    const auto files = recordings_in(recordings());
    ASSERT_EQ(files.size(), 1u);
    EXPECT_TRUE(time_of_play(files[0]).isValid());
}

// Nor does a copy change it, whose own time is another one.
TEST(TimeOfPlay, IsThatOfTheHeaderOrOfTheResultBesideItOrUnknown) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "play.hrec";
    Recording recording = test::new_session()->recording_start();
    write_recording(file, recording);
    EXPECT_FALSE(time_of_play(file).isValid());
    EXPECT_EQ(words_on_time_of_play(file), "date unknown");
    EXPECT_EQ(facts_of(file).played, "date unknown");
    Attempt attempt;
    attempt.recording = file;
    attempt.lesson = "Gentle pull";
    attempt.ended_at = "2023-02-03T12:00:00Z";
    write_attempt(attempt);
    EXPECT_EQ(time_of_play(file).toUTC().date(), QDate(2023, 2, 3));
    recording.played_at = "2024-05-06T12:00:00Z";
    write_recording(file, recording);
    EXPECT_EQ(time_of_play(file).toUTC(), QDateTime(QDate(2024, 5, 6), QTime(12, 0), Qt::UTC));
    EXPECT_TRUE(words_on_time_of_play(file).contains("2024"));
    EXPECT_FALSE(time_of_play(folder.path() / "none.hrec").isValid());
}

TEST(TimeOfPlay, IsKnownOfARecordingOfAnotherVersion) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "old.hrec";
    std::ofstream(file) << R"({"format": "hepatica-recording", "version": 1, "program": "9.9.9",
        "played_at": "2026-11-28T12:00:00Z"})";
    EXPECT_FALSE(time_of_play(file).isValid()) << "the header is one line";
    std::ofstream(file) << R"({"format": "hepatica-recording", "version": 1, "program": "9.9.9", )"
                        << R"("played_at": "2026-11-28T12:00:00Z"})"
                        << "\n";
    EXPECT_EQ(time_of_play(file).toUTC().toString(Qt::ISODate), "2026-11-28T12:00:00Z");
    std::ofstream(file) << R"({"played_at": 5})";
    EXPECT_FALSE(time_of_play(file).isValid());
}

TEST_F(RecordedWindow, the_recording_ends_with_the_patient) {
    open_built_in();
    record().trigger();
    ASSERT_TRUE(wait_for([&] { return recordings_in(recordings()).size() == 1; }));
    window_.open(OpenRequest{true, {}});
    wait();
    EXPECT_FALSE(record().isChecked());
    EXPECT_EQ(recordings_in(recordings()).size(), 1u);
}

TEST_F(RecordedWindow, a_lesson_that_a_crash_cut_off_is_offered_once_and_listed) {
    start_lesson();
    ASSERT_EQ(recordings_in(recordings()).size(), 1u);
    {
        MainWindow beside(settings_, small_patients());
        EXPECT_TRUE(beside.messages().text().isEmpty()) << "it is still being played here";
    }
    Settings settings(killed_now());
    const fs::path left = to_path(settings.recordings_folder());
    EXPECT_EQ(interrupted_recordings(left).size(), 1u);
    {
        MainWindow next(settings, small_patients());
        EXPECT_TRUE(next.messages().text().contains("interrupted"));
        next.messages().findChild<QPushButton*>("secondOffer")->click();
    }
    EXPECT_TRUE(interrupted_recordings(left).empty());
    EXPECT_EQ(recordings_in(left).size(), 1u) << "forgotten, not removed";
    {
        const MainWindow next(settings, small_patients());
        EXPECT_TRUE(const_cast<MainWindow&>(next).messages().text().isEmpty());
    }
    AttemptsDialog dialog(
        {[](const fs::path&) {}, [](const std::string&) {}, [](const std::exception_ptr&) {}},
        nullptr);
    dialog.show_lesson({"", "Endless"}, left, "", recordings_without_result(left, "endless"));
    const auto& table = *dialog.findChild<QTableWidget*>("attempts");
    ASSERT_EQ(table.rowCount(), 1);
    EXPECT_EQ(table.item(0, 2)->text(), "interrupted");
    EXPECT_TRUE(dialog.findChild<QPushButton*>("attemptsLookBack")->isEnabled());
    EXPECT_EQ(facts_of(recordings_in(left)[0]).result, "interrupted");
}

// Nobody is blamed for a crash.
TEST_F(RecordedWindow, a_lesson_that_a_crash_cut_off_is_kept_under_its_name_until_it_is_forgotten) {
    auto& name = *window_.lessons().findChild<QLineEdit*>("lessonName");
    const auto type_name = [&](const char* text) {
        name.setText(text);
        QTest::keyClick(&name, Qt::Key_Return);
    };
    start_lesson();
    type_name("Nr. 7");
    ASSERT_TRUE(wait_for([&] { return window_.frame().statistics.paused; }));
    window_.actions()[ActionId::pause_simulation].trigger();
    ASSERT_TRUE(wait_for([&] { return window_.lessons().standing().metrics.time_s > 0.0; }));
    type_name("Nr. 8");
    Settings settings(killed_now());
    const fs::path left = to_path(settings.recordings_folder());
    EXPECT_TRUE(all_attempts(left).list.empty()) << "it was being played";
    for (int start = 0; start < 2; ++start) {
        const MainWindow next(settings, small_patients());
        const Attempts kept = all_attempts(left);
        ASSERT_EQ(kept.list.size(), 1u);
        EXPECT_EQ(kept.list[0].lesson, "Endless");
        EXPECT_EQ(kept.list[0].name, "Nr. 8") << "the name that was given last";
        EXPECT_FALSE(kept.list[0].passed);
        EXPECT_EQ(kept.list[0].reasons, std::vector<std::string>{"interrupted before the end"});
        EXPECT_TRUE(std::isnan(kept.list[0].value(Quantity::time_s))) << "nobody measured it";
    }
    const RecordingFacts facts = facts_of(recordings_in(left).at(0));
    EXPECT_EQ(facts.trainee, "Nr. 8");
    EXPECT_EQ(facts.result, "interrupted");
    AttemptsDialog dialog(
        {[](const fs::path&) {}, [](const std::string&) {}, [](const std::exception_ptr&) {}},
        nullptr);
    dialog.show_lesson({"", "Endless"}, left, "Nr. 8", {});
    EXPECT_TRUE(dialog.attempts().empty()) << "it is no attempt";
    const auto& table = *dialog.findChild<QTableWidget*>("attempts");
    ASSERT_EQ(table.rowCount(), 1);
    EXPECT_EQ(table.item(0, 2)->text(), "interrupted");
    EXPECT_EQ(table.item(0, 4)->text(), "Nr. 8");
    {
        MainWindow next(settings, small_patients());
        next.messages().findChild<QPushButton*>("secondOffer")->click();
    }
    EXPECT_TRUE(all_attempts(left).list.empty());
    EXPECT_TRUE(recordings_in(left).empty());
    EXPECT_TRUE(interrupted_recordings(left).empty());
}

TEST(RecordingGuard, LeavesTheResultOfWhatIsInterruptedAndNoneOfAFreePlay) {
    const TemporaryFolder folder;
    const fs::path ended = folder.path() / "a.hrec", killed = folder.path() / "b.hrec";
    const fs::path free = folder.path() / "c.hrec";
    for (const fs::path& recording : {ended, killed, free}) std::ofstream(recording) << "{}";
    Attempt attempt;
    attempt.recording = ended;
    attempt.lesson = "Gentle pull";
    attempt.ended_at = "2026-11-26T03:41:00Z";
    {
        RecordingGuard guard(ended);
        fs::copy_file(ended.string() + ".unfinished", free.string() + ".unfinished");
        guard.note(attempt);
        fs::copy_file(ended.string() + ".unfinished", killed.string() + ".unfinished");
    }
    EXPECT_FALSE(fs::exists(ended.string() + ".unfinished"));
    keep_interrupted(free);
    EXPECT_TRUE(all_attempts(folder.path()).list.empty());
    keep_interrupted(killed);
    ASSERT_EQ(all_attempts(folder.path()).list.size(), 1u);
    EXPECT_EQ(all_attempts(folder.path()).list[0].recording, killed);
    EXPECT_NE(all_attempts(folder.path()).list[0].ended_at, attempt.ended_at);
    // The program may be killed once the result is written, before the mark goes.
    name_attempt(killed, "Nr. 7");
    keep_interrupted(killed);
    EXPECT_EQ(name_beside(killed), "Nr. 7");
}

// What ended by itself is never taken for what is forgotten, nor is a free play.
TEST(RecordingGuard, ForgetsAnInterruptedAttemptAlone) {
    const TemporaryFolder folder;
    const fs::path failed = folder.path() / "a.hrec", killed = folder.path() / "b.hrec";
    const fs::path free = folder.path() / "c.hrec";
    for (const fs::path& recording : {failed, killed, free}) {
        std::ofstream(recording) << "{}";
        std::ofstream(recording.string() + ".unfinished").flush();
    }
    for (const auto& [recording, why] :
         {std::pair{failed, "given up before the end"}, {killed, interrupted_reason}}) {
        Attempt attempt;
        attempt.recording = recording;
        attempt.lesson = "Gentle pull";
        attempt.ended_at = "2026-11-28T12:00:00Z";
        attempt.reasons = {why};
        write_attempt(attempt);
    }
    for (const fs::path& recording : {failed, killed, free}) forget_attempt(recording);
    EXPECT_TRUE(interrupted_recordings(folder.path()).empty());
    EXPECT_FALSE(fs::exists(killed));
    EXPECT_FALSE(fs::exists(result_file_of(killed)));
    EXPECT_TRUE(fs::exists(failed));
    EXPECT_TRUE(fs::exists(result_file_of(failed)));
    EXPECT_TRUE(fs::exists(free));
}

TEST(RecordingGuard, TellsAttemptsFromThoseAtALessonWhoseNameBeginsAlike) {
    const TemporaryFolder folder;
    for (const char* name :
         {"pull-20261128-120000-000", "pull-hard-20261128-120001-000", "pull-20261128-120002-000"})
        std::ofstream(folder.path() / (std::string(name) + ".hrec")) << "{}";
    EXPECT_EQ(recordings_without_result(folder.path(), "pull").size(), 2u);
    EXPECT_EQ(recordings_without_result(folder.path(), "pull-hard").size(), 1u);
    EXPECT_TRUE(recordings_without_result(folder.path(), "pul").empty());
}

TEST_F(RecordedWindow, a_lesson_that_was_left_is_no_crash) {
    start_lesson();
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    EXPECT_TRUE(interrupted_recordings(recordings()).empty());
    start_lesson();
    EXPECT_TRUE(window_.close());
    EXPECT_TRUE(interrupted_recordings(recordings()).empty());
}

// The table as the panel of the lesson, and the quantity stays whoever's attempts are shown.
TEST_F(RecordedWindow, attempts_are_in_the_units_that_were_chosen) {
    const fs::path folder = to_path(folder_.filePath("attempts"));
    fs::create_directories(folder);
    for (const char* name : {"A", "B"}) {
        Attempt attempt;
        attempt.recording = folder / (std::string("cut-") + name + ".hrec");
        std::ofstream(attempt.recording) << "{}";
        attempt.lesson = "Cut";
        attempt.ended_at = "2026-11-26T03:41:00Z";
        attempt.name = name;
        attempt.metrics[static_cast<std::size_t>(Quantity::time_s)] = 12.0;
        attempt.metrics[static_cast<std::size_t>(Quantity::blood_lost_g)] = 21.2;
        attempt.metrics[static_cast<std::size_t>(Quantity::joints_broken)] = 6.0;
        write_attempt(attempt);
    }
    AttemptsDialog dialog(
        {[](const fs::path&) {}, [](const std::string&) {}, [](const std::exception_ptr&) {}},
        nullptr);
    dialog.show_lesson({"", "Cut"}, folder);
    const auto& table = *dialog.findChild<QTableWidget*>("attempts");
    const auto cell_of = [&](const QString& head) {
        for (int column = 0; column < table.columnCount(); ++column)
            if (table.horizontalHeaderItem(column)->text() == head)
                return table.item(0, column)->text();
        return QString("none");
    };
    EXPECT_EQ(cell_of("blood lost (g)"), "21.2");
    dialog.set_units(FlowUnits::clinic);
    EXPECT_EQ(cell_of("blood lost (mL)"), "20.0");
    EXPECT_EQ(cell_of("time (s)"), "12.0");
    EXPECT_EQ(cell_of("joints broken"), "6") << "a count has no decimals";
    auto& quantity = *dialog.findChild<QComboBox*>("attemptsQuantity");
    quantity.setCurrentIndex(quantity.findText("blood lost"));
    dialog.findChild<QComboBox*>("attemptsWhose")->setCurrentIndex(1);
    EXPECT_EQ(quantity.currentText(), "blood lost");
    EXPECT_EQ(dialog.chart().y_label, "blood lost (mL)");
}

TEST_F(RecordedWindow, the_list_says_what_each_recording_is) {
    const fs::path folder = to_path(folder_.filePath("list"));
    fs::create_directories(folder);
    std::ofstream(folder / "gentle_pull-20261126-034000-123.hrec") << "{}";
    Attempt attempt;
    attempt.recording = folder / "gentle_pull-20261126-034000-123.hrec";
    attempt.lesson = "Gentle pull";
    attempt.ended_at = "2026-11-26T03:41:00Z";
    attempt.passed = true;
    attempt.name = "Nr. 7";
    write_attempt(attempt);
    RecordingDialog dialog(folder, nullptr);
    const auto& table = *dialog.findChild<QTableWidget*>("recordings");
    ASSERT_EQ(table.rowCount(), 1);
    EXPECT_EQ(table.item(0, 0)->text(), "Gentle pull");
    EXPECT_EQ(table.item(0, 3)->text(), "✓ passed");
    EXPECT_EQ(table.item(0, 4)->text(), "Nr. 7") << "who played it";
}

TEST_F(RecordedWindow, the_list_says_how_long_each_recording_is) {
    const fs::path folder = to_path(folder_.filePath("list"));
    const auto session = test::new_session();
    const auto recording = test::keep_recording(*session);
    test::play(*session, 90);
    fs::create_directories(folder);
    std::ofstream(folder / "play-20261126-033000-123.hrec") << "damaged";
    write_recording(folder / "play-20261126-034000-123.hrec", *recording);
    RecordingDialog dialog(folder, nullptr);
    const auto& table = *dialog.findChild<QTableWidget*>("recordings");
    ASSERT_EQ(table.rowCount(), 2);
    EXPECT_EQ(table.horizontalHeaderItem(2)->text(), "Length");
    EXPECT_TRUE(wait_for([&] { return table.item(0, 2)->text() == "0:01.5"; }))
        << table.item(0, 2)->text().toStdString();
    EXPECT_EQ(table.item(1, 2)->text(), "");
}

// Which is tried again until it is good, under one name of a file.
TEST_F(RecordedWindow, a_lesson_that_is_tried_has_its_name) {
    const fs::path folder = to_path(folder_.filePath("tried"));
    fs::create_directories(folder);
    const fs::path recording = folder / "lesson-20261126-034000-123.hrec";
    std::ofstream(recording) << "{}";
    EXPECT_EQ(facts_of(recording).lesson, "Lesson");
    Lesson lesson = find_lesson("gentle_pull");
    lesson.name = "Mine";
    write_lesson(folder / "lesson.json", lesson);
    EXPECT_EQ(facts_of(recording).lesson, "Mine");
}

// What is of another patient cannot be compared, and another lesson tells little.
TEST_F(RecordedWindow, the_newest_of_the_same_patient_and_lesson_is_chosen_to_compare_with) {
    const fs::path folder = to_path(folder_.filePath("list"));
    const auto write = [&](const char* lesson, const char* time, std::uint64_t patient) {
        Recording recording = test::new_session()->recording_start();
        recording.patient_hash = patient;
        const fs::path file = folder / (std::string(lesson) + "-20261126-" + time + "-123.hrec");
        write_recording(file, recording);
        return file;
    };
    const fs::path shown = write("gentle_pull", "010000", 1);
    write("gentle_pull", "060000", 2);
    write("play", "050000", 1);
    const auto chosen = [&] {
        RecordingDialog dialog(folder, nullptr, shown);
        const auto& table = *dialog.findChild<QTableWidget*>("recordings");
        const auto* open = dialog.findChild<QPushButton*>("openRecording");
        const auto rows = table.selectionModel()->selectedRows();
        EXPECT_EQ(open->isEnabled(), !rows.isEmpty());
        return rows.isEmpty() ? QString("none") : table.item(rows.front().row(), 5)->text();
    };
    EXPECT_EQ(chosen(), "none");
    write("gentle_pull", "020000", 1);
    write("gentle_pull", "030000", 1);
    EXPECT_EQ(chosen(), "gentle_pull-20261126-030000-123.hrec");
}

TEST_F(RecordedWindow, the_list_cuts_no_name_of_a_file) {
    const fs::path folder = to_path(folder_.filePath("list"));
    fs::create_directories(folder);
    const std::string name(30, 'n');
    std::ofstream(folder / (name + "-20261126-034000-123.hrec")) << "{}";
    RecordingDialog dialog(folder, nullptr);
    const auto& table = *dialog.findChild<QTableWidget*>("recordings");
    ASSERT_EQ(table.rowCount(), 1);
    EXPECT_GE(table.columnWidth(5),
              table.fontMetrics().horizontalAdvance(table.item(0, 5)->text()));
    EXPECT_GE(dialog.width(), table.horizontalHeader()->length());
}

// With itself there is nothing to compare.
TEST_F(RecordedWindow, what_to_compare_with_is_another_recording) {
    const fs::path folder = to_path(folder_.filePath("list"));
    fs::create_directories(folder);
    const fs::path shown = folder / "gentle_pull-20261126-034000-123.hrec";
    const fs::path other = folder / "gentle_pull-20261126-033000-123.hrec";
    for (const fs::path& recording : {other, shown}) std::ofstream(recording) << "{}";
    RecordingDialog dialog(folder, nullptr, shown);
    EXPECT_EQ(dialog.windowTitle(), "Compare with");
    const auto& table = *dialog.findChild<QTableWidget*>("recordings");
    ASSERT_EQ(table.rowCount(), 1);
    EXPECT_EQ(table.item(0, 5)->text(), "gentle_pull-20261126-033000-123.hrec");
}

}  // namespace
}  // namespace hepatica
