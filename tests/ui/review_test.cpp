// SPDX-License-Identifier: GPL-3.0-or-later
// Looking back on a recording in the window: its frames, its time line, jumps, notes, and the way
// back to free play.
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScopeGuard>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <fstream>

#include "core/lesson/attempts.h"
#include "core/lesson/lesson_writer.h"
#include "core/lesson/play_notes.h"
#include "tests/ui/review_window_test.h"
#include "ui/message_bar.h"
#include "ui/recording_dialog.h"
#include "ui/review_list.h"
#include "ui/second_view.h"
#include "ui/slices/view_layout.h"

namespace hepatica {
namespace {

using testing::ReviewWindowTest;
using testing::wait_for;

TEST(ReviewList, AVerdictThatIsNotPassedLooksLikeNoStepThatIsReached) {
    ReviewList list;
    list.fill({{1.0, PlayEventKind::lesson, "Step 1 reached"},
               {2.0, PlayEventKind::not_passed, "Not passed: limit broken: force"}},
              {}, {});
    ASSERT_EQ(list.ticks().size(), 2u);
    EXPECT_NE(list.ticks()[0].colour, list.ticks()[1].colour);
}

TEST(ReviewTitle, LeavesANameAsItIs) {
    EXPECT_EQ(gone_through("Half %2 and %1", 0.256), "Half %2 and %1: 25 % of the recording read");
}

// Pictures and films hold the headings, and folders are often named after the patient.
TEST(ReviewTitle, OfTwoFilesOfOneNameTellsThemApartWithoutTheirFolders) {
    RecordingFacts one, other;
    one.file = "/data/Anton Beispiel/play.hrec";
    other.file = "/data/Berta Beispiel/play.hrec";
    one.lesson = other.lesson = "Gentle pull";
    const std::array<QString, 2> headings = headings_of(one, other);
    EXPECT_NE(headings[0], headings[1]);
    for (const QString& heading : headings) {
        EXPECT_TRUE(heading.contains("(play.hrec)")) << heading.toStdString();
        EXPECT_FALSE(heading.contains("Beispiel")) << heading.toStdString();
    }
}

// The files' names begin alike, say nothing more, and little of a long heading may be seen.
TEST(ReviewTitle, OfTwoFilesOfOneLessonBeginsWithWhatTellsThemApart) {
    RecordingFacts one, other;
    one.lesson = other.lesson = "Gentle pull";
    one.played = "28 Nov 2026, 09:39";
    other.played = "28 Nov 2026, 09:38";
    one.result = "not passed";
    one.file = "gentle_pull-20261126-034000-123.hrec";
    other.file = "gentle_pull-20261126-034100-123.hrec";
    const std::array<QString, 2> headings = headings_of(one, other);
    EXPECT_EQ(headings[0].toStdString(), "1: not passed, Gentle pull, 28 Nov 2026, 09:39");
    EXPECT_EQ(headings[1].toStdString(), "2: Gentle pull, 28 Nov 2026, 09:38");
}

TEST_F(ReviewWindowTest, goes_to_any_moment_of_the_play) {
    open_built_in();
    look_back();
    EXPECT_EQ(opened_, 1) << "the patient that is shown is the recorded one";
    EXPECT_NEAR(line().end_s(), steps / 60.0, 2e-3);
    line().set_at(30.2 / 60);
    EXPECT_TRUE(shows_step(29)) << "whose time ended then";
    QTest::keyClick(&line(), Qt::Key_End);
    EXPECT_TRUE(shows_step(steps - 1));
    QTest::keyClick(&line(), Qt::Key_Left);
    EXPECT_NEAR(dock().at_s(), steps / 60.0 - 0.1, 2e-3);
    const QPoint there(static_cast<int>(line().place_of(20.4 / 60)), line().height() / 2);
    QTest::mouseClick(&line(), Qt::LeftButton, {}, there);
    EXPECT_NEAR(dock().at_s(), 20.4 / 60, line().end_s() / line().width());
}

TEST_F(ReviewWindowTest, plays_at_the_chosen_speed_and_ends_by_itself) {
    open_built_in();
    look_back();
    auto* speed = dock().findChild<QComboBox*>("reviewSpeed");
    speed->setCurrentIndex(0);
    QTest::keyClick(&line(), Qt::Key_Home);
    QElapsedTimer wall;
    wall.start();
    click("reviewPlay");
    EXPECT_TRUE(dock().playing());
    ASSERT_TRUE(wait_for([this] { return dock().at_s() > 0.03; }));
    EXPECT_GE(1e-3 * static_cast<double>(wall.elapsed()), 9.0 * dock().at_s()) << "a tenth";
    speed->setCurrentIndex(5);
    const double from_s = dock().at_s();
    const qint64 from_ms = wall.elapsed();
    ASSERT_TRUE(wait_for([&] { return dock().at_s() > from_s + 0.8; }));
    const double passed_s = 1e-3 * static_cast<double>(wall.elapsed() - from_ms);
    EXPECT_GT(dock().at_s() - from_s, 3.0 * std::min(passed_s, 0.3)) << "four times as fast";
    EXPECT_TRUE(wait_for([this] { return !dock().playing(); }));
    EXPECT_TRUE(shows_step(steps - 1));
    click("reviewPlay");  // from the beginning again
    EXPECT_LT(dock().at_s(), line().end_s());
    window_.actions()[ActionId::pause_simulation].trigger();  // the clock's own key stops it, too
    EXPECT_FALSE(dock().playing());
}

TEST_F(ReviewWindowTest, jumps_to_what_happened) {
    open_built_in();
    look_back();
    ASSERT_EQ(events().count(), 2);
    EXPECT_EQ(line().ticks().size(), 2u);
    EXPECT_TRUE(events().item(0)->text().contains("Took hold"));
    EXPECT_TRUE(events().item(1)->text().contains("Let go"));
    QTest::keyClick(&line(), Qt::Key_Home);
    click("reviewOn");
    EXPECT_NEAR(dock().at_s(), (pull_begins + 1) / 60.0, 1e-9);
    click("reviewOn");
    EXPECT_NEAR(dock().at_s(), (pull_ends + 1) / 60.0, 1e-9);
    click("reviewOn");
    EXPECT_NEAR(dock().at_s(), (pull_ends + 1) / 60.0, 1e-9) << "nothing comes after";
    line().set_at((pull_ends + 1) / 60.0 + 0.03);  // it has only just happened
    click("reviewBack");
    EXPECT_NEAR(dock().at_s(), (pull_begins + 1) / 60.0, 1e-9);
    events().setCurrentRow(1);
    EXPECT_NEAR(dock().at_s(), (pull_ends + 1) / 60.0, 1e-9);
}

TEST_F(ReviewWindowTest, judges_by_the_pass_marks_of_the_course) {
    Lesson lesson;
    lesson.name = "Pull";
    lesson.scene = played().recording.scene;
    lesson.tools = {LessonTool::pull};
    lesson.steps = {{"Pull", "", {{Quantity::time_s, -1, true, 1.0}}, 0.0, {}}};
    const std::filesystem::path place = to_path(folder_.filePath("lesson.json"));
    write_lesson(place, lesson);
    Attempt attempt;
    attempt.recording = file_;
    attempt.lesson = lesson.name;
    attempt.ended_at = "2026";
    attempt.course_pass = {{Quantity::path_mm, -1, false, 0.1}};
    write_attempt(attempt);
    open_built_in();
    dock().open(file_, place.string());
    ASSERT_TRUE(wait_for([this] { return dock().complete(); }));
    EXPECT_EQ(events().findItems("pass mark missed", Qt::MatchContains).size(), 1);
}

TEST_F(ReviewWindowTest, notes_lie_beside_the_recording) {
    open_built_in();
    look_back();
    line().set_at(0.5);
    auto* note = dock().findChild<QLineEdit*>("reviewNote");
    QTest::keyClicks(note, "Slower <here>");
    QTest::keyClick(note, Qt::Key_Return);
    const std::vector<PlayNote> kept{{0.5, "Slower <here>"}};
    EXPECT_EQ(read_notes(file_), kept);
    EXPECT_TRUE(note->text().isEmpty());
    ASSERT_EQ(events().count(), 3);
    EXPECT_TRUE(events().item(1)->text().contains("Slower <here>"));
    look_back();  // again
    ASSERT_EQ(events().count(), 3);
    auto* remove = dock().findChild<QPushButton*>("reviewRemoveNote");
    EXPECT_FALSE(remove->isEnabled());
    events().setCurrentRow(1);
    EXPECT_TRUE(remove->isEnabled());
    remove->click();
    EXPECT_TRUE(read_notes(file_).empty());
    EXPECT_EQ(events().count(), 2);
    // It may have been the wrong one.
    EXPECT_EQ(note->text(), "Slower <here>");
    QTest::keyClick(note, Qt::Key_Return);
    EXPECT_EQ(read_notes(file_), kept) << "at its moment, to which the click on it led";
}

// Else the slider and its ticks would move under the mouse.
TEST_F(ReviewWindowTest, has_its_whole_length_while_it_is_still_read) {
    open_built_in();
    window_.open(to_text(file_));
    ASSERT_TRUE(wait_for([this] { return dock().reviewing(); }));
    const double length_s = steps / 60.0;
    while (!dock().complete()) {
        EXPECT_NEAR(line().end_s(), length_s, 1e-3);
        EXPECT_LE(line().read_s(), length_s + 1e-9);
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 10);
    }
    EXPECT_NEAR(line().end_s(), length_s, 1e-3);
    EXPECT_NEAR(line().read_s(), length_s, 1e-9);
}

TEST(TimeLineTest, bars_what_is_not_read_yet) {
    TimeLine line;
    line.resize(400, 34);
    line.set_end(10.0);
    line.set_read(10.0);
    const QImage whole = line.grab().toImage();
    line.set_read(5.0);
    const QImage half = line.grab().toImage();
    int left = 0, right = 0;
    for (int y = 0; y < half.height(); ++y)
        for (int x = 0; x < half.width(); ++x)
            if (half.pixel(x, y) != whole.pixel(x, y)) ++(x < half.width() / 2 ? left : right);
    EXPECT_EQ(left, 0);
    EXPECT_GT(right, 100);
}

TEST_F(ReviewWindowTest, nothing_can_be_done_to_it_and_leaving_gives_back_the_free_play) {
    open_built_in();
    look_back();
    line().set_at(0.0);
    EXPECT_TRUE(shows_step(0));
    using enum ActionId;
    const std::array tools{reset,        inject_mode,   edit_mode,  sphere_tool,
                           capsule_tool, hook_tool,     cut_mode,   weaken_mode,
                           forceps_tool, close_or_open, remove_drug};
    for (const ActionId id : tools) {
        EXPECT_FALSE(window_.actions()[id].isEnabled());
        EXPECT_TRUE(window_.actions()[id].statusTip().contains("leave the review first"));
    }
    EXPECT_TRUE(window_.actions()[pull_mode].isEnabled()) << "a drag turns the view";
    click("reviewLeave");
    for (const ActionId id : tools) EXPECT_TRUE(window_.actions()[id].isEnabled());
    EXPECT_FALSE(dock().reviewing());
    EXPECT_TRUE(dock().isHidden());
    paint();
    EXPECT_TRUE(wait_for([this] { return window_.frame().statistics.resting; }));
}

// It would change the patient under the review.
TEST_F(ReviewWindowTest, stops_a_vessel_that_is_being_drawn) {
    open_built_in();
    VesselPen& pen = window_.view_layout().slices().pen();
    bool stopped = false;
    pen.on_draw({[](const std::vector<Vec3>&, const VesselPen::Answered&) {},
                 [&stopped] { stopped = true; }});
    pen.set_taken(true);
    pen.add(Vec3(0, 0, 0));
    pen.add(Vec3(10, 0, 0));
    pen.finish();
    ASSERT_TRUE(pen.draws());
    look_back();
    EXPECT_TRUE(stopped);
    EXPECT_FALSE(pen.draws());
    EXPECT_EQ(pen.places_mm().size(), 2u) << "they can be drawn after it";
}

TEST_F(ReviewWindowTest, its_patient_is_opened_where_none_is_shown) {
    look_back();
    EXPECT_EQ(opened_, 1);
    EXPECT_GE(shown_step(), 0);
}

TEST_F(ReviewWindowTest, a_film_of_it_has_every_moment) {
    open_built_in();
    look_back();
    const std::filesystem::path place = to_path(folder_.filePath("film"));
    window_.save_film(place, 0.4, [&](double at_s) { line().set_at(at_s); });
    EXPECT_EQ(window_.messages().text(), "The film was saved: " + to_text(place));
    int pictures = 0;
    for (const auto& entry : std::filesystem::directory_iterator(place))
        pictures += entry.path().extension() == ".png";
    EXPECT_EQ(pictures, 11);
    const QImage first(to_text(place / "00000.png")), last(to_text(place / "00010.png"));
    EXPECT_FALSE(first.isNull());
    EXPECT_NE(first, last) << "the vessel is pulled in the last";
    EXPECT_EQ(first.width() / 2,
              static_cast<int>(window_.view().width() * window_.view().devicePixelRatioF()) / 2);
}

// As they stood at each moment, not when the film was asked for.
TEST_F(ReviewWindowTest, a_film_shows_when_the_marks_of_the_lesson_are_reached) {
    Lesson lesson;
    lesson.name = "Wait";
    lesson.scene = played().recording.scene;
    lesson.tools = {LessonTool::pull};
    lesson.marks = {{"the mark", {std::nullopt, 0.5}}};
    lesson.steps = {{"Look", "", {{Quantity::moved_mm, 0, true, 0.0}}, 0.5, {}}};
    const std::filesystem::path place = to_path(folder_.filePath("lesson.json"));
    write_lesson(place, lesson);
    open_built_in();
    dock().open(file_, place.string());
    ASSERT_TRUE(wait_for([this] { return dock().complete(); }));
    const auto reached_at = [this](double at_s) {
        line().set_at(at_s);
        return dock().marks_in(window_.frame()).front().reached;
    };
    double reached_s = 0.0;
    while (reached_s < 1.5 && !reached_at(reached_s)) reached_s += 1.0 / 60.0;
    ASSERT_GT(reached_s, 0.4);
    ASSERT_LT(reached_s, 1.5);
    // Its last picture alone is of that moment, and nothing is drawn behind it.
    window_.save_film(to_path(folder_.filePath("film")), reached_s,
                      [this](double at_s) { line().set_at(at_s); });
    ASSERT_EQ(window_.view().scene().marks().size(), 1u);
    EXPECT_TRUE(window_.view().scene().marks().front().reached);
}

TEST_F(ReviewWindowTest, a_film_without_ffmpeg_is_said_to_be_pictures_in_a_folder_that_one_names) {
    open_built_in();
    look_back();
    const auto as_before = qScopeGuard([path = qgetenv("PATH")] { qputenv("PATH", path); });
    qputenv("PATH", folder_.path().toLocal8Bit());  // where no program lies
    choose_file(folder_.filePath("new film"));
    line().set_at(0.5);
    click("reviewFilm");
    EXPECT_NEAR(dock().at_s(), 0.5, 1e-9) << "the review is where it was";
    EXPECT_TRUE(window_.messages().text().contains("ffmpeg, which is not installed"));
    EXPECT_TRUE(window_.messages().text().startsWith("The film was saved: "));
    EXPECT_TRUE(std::filesystem::exists(to_path(folder_.filePath("new film/00000.png"))));
    choose_file(folder_.path());
    click("reviewFilm");
    EXPECT_TRUE(window_.messages().text().contains("not empty"));
}

TEST_F(ReviewWindowTest, its_pictures_are_saved_whether_there_is_ffmpeg_or_not) {
    open_built_in();
    look_back();
    const auto as_before = qScopeGuard([path = qgetenv("PATH")] { qputenv("PATH", path); });
    std::ofstream(to_path(folder_.filePath("ffmpeg"))) << "#!/bin/sh\nexit 1\n";
    std::filesystem::permissions(to_path(folder_.filePath("ffmpeg")),
                                 std::filesystem::perms::owner_all);
    qputenv("PATH", folder_.path().toLocal8Bit());
    choose_file(folder_.filePath("moments"));
    line().set_at(0.5);
    click("reviewPictures");
    EXPECT_NEAR(dock().at_s(), 0.5, 1e-9) << "the review is where it was";
    EXPECT_TRUE(window_.messages().text().startsWith("The film was saved: "));
    EXPECT_TRUE(std::filesystem::exists(to_path(folder_.filePath("moments/00000.png"))));
}

// A recording has the figures of the play, whose clock ran.
TEST_F(ReviewWindowTest, that_is_stopped_is_not_called_as_fast_as_real_time) {
    open_built_in();
    look_back();
    auto* fast = window_.findChild<QLabel*>("realTime");
    EXPECT_TRUE(wait_for([&] { return fast->text() == "held"; }));
    fast->clear();
    line().set_at(30.2 / 60);
    EXPECT_TRUE(wait_for([&] { return !fast->text().isEmpty(); }));
    EXPECT_EQ(fast->text(), "held");
}

// What is half typed is about a moment of that recording.
TEST_F(ReviewWindowTest, a_note_that_was_not_kept_does_not_stand_in_the_next_review) {
    open_built_in();
    look_back();
    auto* note = dock().findChild<QLineEdit*>("reviewNote");
    note->setText("too deep");
    click("reviewLeave");
    ASSERT_FALSE(dock().reviewing());
    EXPECT_EQ(note->text(), "");
}

TEST_F(ReviewWindowTest, the_window_closes_with_two_recordings_in_it) {
    open_built_in();
    look_back();
    dock().compare(file_);
    ASSERT_TRUE(wait_for([this] { return dock().complete() && window_.second_view().shown(); }));
    EXPECT_TRUE(window_.close());
    EXPECT_FALSE(dock().reviewing());
    EXPECT_FALSE(window_.second_view().shown());
}

// What the panels' action shows again is not a review that is over.
TEST_F(ReviewWindowTest, is_gone_once_it_was_left_also_for_the_next_window) {
    write_notes(file_, {{0.5, "Slower"}});
    open_built_in();
    look_back();
    ASSERT_EQ(events().count(), 3);
    click("reviewLeave");
    EXPECT_EQ(events().count(), 0);
    QAction& panels = window_.actions()[ActionId::toggle_panels];
    panels.trigger();
    panels.trigger();
    EXPECT_TRUE(dock().isHidden());
    dock().findChild<QPushButton*>("reviewRemoveNote")->setEnabled(true);
    click("reviewRemoveNote");
    EXPECT_EQ(read_notes(file_).size(), 1u);
    look_back();
    EXPECT_TRUE(window_.close());
    MainWindow next(settings_,
                    {[](const OpenRequest&, Job& job) { return play(test::small_patient(), job); },
                     [](const std::filesystem::path&, const PatientCase&) {}});
    next.show();
    EXPECT_TRUE(next.review().isHidden());
}

TEST_F(ReviewWindowTest, a_line_that_is_chosen_already_is_gone_to_again) {
    open_built_in();
    look_back();
    events().setCurrentRow(0);
    line().set_at(1.0);
    const QRect place = events().visualItemRect(events().item(0));
    QTest::mouseClick(events().viewport(), Qt::LeftButton, {}, place.center());
    EXPECT_NEAR(dock().at_s(), (pull_begins + 1) / 60.0, 1e-9);
}

TEST_F(ReviewWindowTest, notes_that_cannot_be_kept_are_not_shown) {
    open_built_in();
    look_back();
    std::filesystem::create_directory(notes_file_of(file_));  // in the place of the file
    auto* note = dock().findChild<QLineEdit*>("reviewNote");
    QTest::keyClicks(note, "Slower");
    QTest::keyClick(note, Qt::Key_Return);
    EXPECT_FALSE(window_.messages().text().isEmpty());
    EXPECT_EQ(note->text(), "Slower") << "it is not lost";
    EXPECT_EQ(events().count(), 2);
}

TEST(ClockText, SaysMinutesSecondsAndTenths) {
    EXPECT_EQ(clock_text(0.0), "0:00.0");
    EXPECT_EQ(clock_text(9.96), "0:09.9");
    EXPECT_EQ(clock_text(62.5), "1:02.5");
    EXPECT_EQ(clock_text(3600.0), "60:00.0");
}

}  // namespace
}  // namespace hepatica
