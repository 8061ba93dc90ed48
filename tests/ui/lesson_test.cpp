// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson in the window, from the menu to its recording, which has the score that the window
// showed.
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QStatusBar>
#include <QTableWidget>
#include <atomic>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/lesson/attempts.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_writer.h"
#include "core/lesson/score.h"
#include "core/session/recording_file.h"
#include "tests/session/small_patient.h"
#include "tests/ui/lesson_window_test.h"
#include "ui/attempts_dialog.h"
#include "ui/course_dialog.h"
#include "ui/lesson_dock.h"
#include "ui/lesson_editor/lesson_editor.h"
#include "ui/lesson_play.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/review_dock.h"
#include "ui/slices/view_layout.h"

namespace hepatica {
namespace {

using testing::LessonWindowTest;
using testing::wait_for;

TEST_F(LessonWindowTest, the_menu_lists_the_seven_and_any_other) {
    QStringList names;
    for (const QAction* menu : window_.menuBar()->actions())
        if (menu->text() == "&Lesson")
            for (const QAction* action : menu->menu()->actions()) names << action->objectName();
    for (const BuiltInLesson& lesson : built_in_lessons())
        EXPECT_TRUE(names.contains(lesson.id)) << lesson.id;
    EXPECT_EQ(names.size(), 15) << "with a line, a course, its results, a new one, two others to "
                                   "open, and two editors";
}

TEST_F(LessonWindowTest, a_trainee_takes_hold_lets_go_and_has_the_score_of_the_recording) {
    const std::string file =
        lesson_file(R"({"what": "distance_mm", "mark": "the mark", "at_most": 20})");
    window_.lessons().start(file);
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    paint();
    EXPECT_EQ(shown("lessonStep"), "Step 1 of 2: Take the vessel");
    const Vec3 mark = window_.lessons().marks_in(window_.frame()).at(0).place_mm;
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_widget(mark));
    ASSERT_TRUE(wait_for([&] { return shown("lessonStep").startsWith("Step 2"); }));
    EXPECT_EQ(window_.statusBar()->currentMessage(), shown("lessonStep"));
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_widget(mark));
    ASSERT_TRUE(wait_for([&] { return shown("lessonEnd").contains("Passed"); }));
    const LessonStanding live = window_.lessons().standing();
    const std::filesystem::path recording = only_recording();
    ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
    Job job;
    const Lesson lesson = find_lesson(file);
    const Score again = score(read_recording(recording), lesson, test::small_patient(), job);
    EXPECT_EQ(to_json(again.standing, lesson).dump(), to_json(live, lesson).dump());
    EXPECT_GT(live.metrics.time_s, 0.0);
    // Its result lies beside it, and the learning curve begins.
    ASSERT_TRUE(wait_for([&] { return std::filesystem::exists(result_file_of(recording)); }));
    window_.lessons().findChild<QPushButton*>("lessonAttempts")->click();
    AttemptsDialog& dialog = window_.lessons().attempts();
    ASSERT_EQ(dialog.attempts().size(), 1u);
    EXPECT_TRUE(dialog.attempts()[0].passed);
    EXPECT_EQ(dialog.attempts()[0].value(Quantity::time_s), live.metrics.time_s);
    EXPECT_EQ(dialog.chart().curves.size(), 1u);
    auto& table = *dialog.findChild<QTableWidget*>("attempts");
    table.item(0, 3)->setCheckState(Qt::Checked);
    EXPECT_EQ(dialog.chart().curves.size(), 2u) << "the band of one reference";
    EXPECT_TRUE(attempts_at({"", "Take hold"}, recording.parent_path()).list[0].reference);
    dialog.findChild<QPushButton*>("attemptsLookBack")->click();
    EXPECT_TRUE(dialog.isHidden());
    EXPECT_TRUE(wait_for([&] { return window_.review().complete(); }));
    EXPECT_TRUE(wait_for([&] { return window_.view().scene().marks().size() == 1; }))
        << "who looks back sees what was asked for";
}

// What was judged is over: no hand pulls on, also where the button is still pressed.
TEST_F(LessonWindowTest, the_hand_is_empty_after_the_verdict) {
    const std::string file = folder_.filePath("hold.json").toStdString();
    std::ofstream(file) << R"({"format": "hepatica-lesson", "version": 1, "name": "Hold",
        "scene": {"name": "hold", "deform": {}}, "tools": ["pull"],
        "marks": {"the mark": {"share_of_longest_path": 0.2}},
        "steps": [{"text": "Hold it", "goal": [{"what": "holding", "at_least": 1}]}]})";
    window_.lessons().start(file);
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    paint();
    const Vec3 mark = window_.lessons().marks_in(window_.frame()).at(0).place_mm;
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_widget(mark));
    QTest::mouseMove(&window_.view(), on_widget(mark) + QPoint(30, 0));
    ASSERT_TRUE(wait_for([&] { return shown("lessonEnd").contains("Passed"); }));
    EXPECT_TRUE(wait_for([&] { return !window_.frame().grab; })) << "nothing pulls any more";
    QTest::mouseMove(&window_.view(), on_widget(mark) + QPoint(60, 0));
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_widget(mark) + QPoint(60, 0));
    wait_for_figures();
    EXPECT_FALSE(window_.frame().grab);
    EXPECT_TRUE(window_.frame().statistics.paused) << "the end of that drag begins nothing";
    EXPECT_EQ(window_.findChild<QLabel*>("toolForce")->text(), "no tool");
}

// Blood and drug of some more steps would stand beside the judged ones.
TEST(LessonPlay, NotAStepIsPlayedAfterTheVerdict) {
    const QTemporaryDir folder;
    const std::filesystem::path file = to_path(folder.filePath("play.hrec"));
    Lesson lesson = new_lesson();
    lesson.limits = {{Quantity::time_s, -1, false, 0.2}};
    Job job;
    const LessonPlay play = LessonPlay::begin(lesson, test::small_patient(), file, job);
    play.simulation->post(SetPaused{false});
    ASSERT_TRUE(wait_for([&] {
        const bool judged = play.watch->recorded();
        play.simulation->update_frame();
        return judged && play.simulation->frame().statistics.resting;
    })) << "it goes on";
    EXPECT_TRUE(play.simulation->frame().statistics.paused);
    EXPECT_EQ(play.simulation->frame().step, read_recording(file).steps.size() + 1)
        << "the step that was judged, and the one that pauses";
}

TEST(LearningCurve, HasAPointForEachAttemptAndTheBandOfTheReferences) {
    std::vector<Attempt> attempts(3);
    for (std::size_t i = 0; i < 3; ++i) attempts[i].metrics[0] = 10.0 - static_cast<double>(i);
    for (Attempt& attempt : attempts) attempt.passed = true;
    Chart chart = learning_curve(attempts, Quantity::time_s);
    ASSERT_EQ(chart.curves.size(), 1u);
    ASSERT_EQ(chart.curves[0].x, (std::vector<double>{1, 2, 3, 5}));
    EXPECT_TRUE(std::isnan(chart.curves[0].y[3])) << "the axis alone goes to 5";
    chart.curves[0].y.pop_back();
    EXPECT_EQ(chart.curves[0].y, (std::vector<double>{10, 9, 8}));
    EXPECT_EQ(chart.y_label, "time (s)");
    attempts[0].reference = attempts[2].reference = true;
    chart = learning_curve(attempts, Quantity::time_s);
    ASSERT_EQ(chart.curves.size(), 3u);
    EXPECT_EQ(chart.curves[1].y, (std::vector<double>{10, 10}));
    EXPECT_EQ(chart.curves[2].y, (std::vector<double>{8, 8}));
}

TEST(LearningCurve, OfBloodIsInTheUnitsOfTheClinicWhereTheyAreChosen) {
    std::vector<Attempt> attempts(2);
    for (Attempt& attempt : attempts) {
        attempt.metrics[static_cast<std::size_t>(Quantity::blood_lost_g)] = 10.6;
        attempt.passed = true;
    }
    attempts[0].reference = true;
    Chart chart = learning_curve(attempts, Quantity::blood_lost_g);
    EXPECT_EQ(chart.y_label, "blood lost (g)");
    EXPECT_EQ(chart.curves[0].y[0], 10.6);
    chart = learning_curve(attempts, Quantity::blood_lost_g, FlowUnits::clinic);
    EXPECT_EQ(chart.y_label, "blood lost (mL)");
    EXPECT_NEAR(chart.curves[0].y[0], 10.0, 1e-9);
    EXPECT_NEAR(chart.curves[1].y[0], 10.0, 1e-9) << "the band, too";
    chart = learning_curve(attempts, Quantity::path_mm, FlowUnits::clinic);
    EXPECT_EQ(chart.y_label, "path of the tip (mm)");
}

TEST(LearningCurve, MarksWhatWasNotPassed) {
    std::vector<Attempt> attempts(3);
    for (std::size_t i = 0; i < 3; ++i) attempts[i].metrics[0] = 10.0 - static_cast<double>(i);
    attempts[1].passed = true;
    const Chart chart = learning_curve(attempts, Quantity::time_s);
    ASSERT_EQ(chart.curves.size(), 2u);
    EXPECT_TRUE(std::isnan(chart.curves[0].y[0])) << "the line is of those that were passed";
    EXPECT_EQ(chart.curves[0].y[1], 9.0);
    EXPECT_TRUE(std::isnan(chart.curves[0].y[2]));
    EXPECT_TRUE(chart.curves[1].points_only);
    EXPECT_EQ(chart.curves[1].x, (std::vector<double>{1, 3}));
    EXPECT_EQ(chart.curves[1].y, (std::vector<double>{10, 8}));
}

TEST(CourseTitle, LeavesNamesAsTheyAre) {
    CourseDialog dialog([](const CourseLine&) {}, [] {}, nullptr);
    const auto* title = dialog.findChild<QLabel*>("courseTitle");
    dialog.show_course("%2 of %4", {CourseLine{}}, "Berta %3", false);
    EXPECT_EQ(title->text(), "<b>%2 of %4</b>: 0 of 1 lessons passed by Berta %3");
    dialog.show_course("%2 of %3", {CourseLine{}}, "", false);
    EXPECT_EQ(title->text(), "<b>%2 of %3</b>: 0 of 1 lessons passed by everybody here");
}

// A course whose first lesson asks for more than the lesson itself.
TEST_F(LessonWindowTest, a_course_says_what_is_passed_and_begins_the_next_with_its_marks) {
    lesson_file(R"({"what": "time_s", "at_least": 1000})");
    const std::string course = folder_.filePath("course.json").toStdString();
    std::ofstream(course) << R"({"format": "hepatica-course", "version": 1, "name": "Two",
        "lessons": [{"lesson": "gentle_pull"}, {"lesson": "lesson.json",
                     "pass": [{"what": "time_s", "at_most": 5}]}]})";
    Attempt attempt;
    attempt.recording = to_path(settings_.recordings_folder()) / "1.hrec";
    attempt.lesson = "Gentle pull";
    attempt.ended_at = "2026";
    attempt.passed = true;
    write_attempt(attempt);
    window_.lessons().show_course(course);
    CourseDialog& dialog = window_.lessons().course();
    ASSERT_EQ(dialog.lines().size(), 2u);
    EXPECT_TRUE(dialog.lines()[0].passed);
    EXPECT_FALSE(dialog.lines()[1].passed);
    EXPECT_EQ(dialog.findChild<QTableWidget*>("course")->currentRow(), 1) << "the next one";
    EXPECT_EQ(dialog.focusWidget(), dialog.findChild<QTableWidget*>("course"))
        << "the first arrow key chooses";
    EXPECT_TRUE(dialog.findChild<QLabel*>("courseTitle")->text().contains("1 of 2"));
    // Somebody else's pass counts for nobody who gives his own name.
    window_.lessons().set_trainee("Berta");
    window_.lessons().show_course(course);
    EXPECT_FALSE(dialog.lines()[0].passed);
    EXPECT_TRUE(dialog.findChild<QLabel*>("courseTitle")
                    ->text()
                    .contains("0 of 2 lessons passed by Berta"));
    attempt.name = "Berta";
    write_attempt(attempt);
    window_.lessons().show_course(course);
    EXPECT_TRUE(dialog.lines()[0].passed);
    dialog.findChild<QPushButton*>("courseBegin")->click();
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    ASSERT_EQ(window_.lessons().standing().pass.size(), 1u);
    EXPECT_EQ(window_.lessons().standing().pass[0].predicate.bound, 5.0);
    window_.lessons().show_course(folder_.filePath("none.json").toStdString());
    EXPECT_TRUE(window_.messages().text().contains("none.json"));
}

TEST_F(LessonWindowTest, the_course_that_was_chosen_is_shown_in_the_next_run_too) {
    const std::string course = folder_.filePath("course.json").toStdString();
    std::ofstream(course) << R"({"format": "hepatica-course", "version": 1, "name": "Wards",
        "lessons": []})";
    window_.lessons().show_course(course);
    const auto title = [](MainWindow& window) {
        window.lessons().show_chosen_course();
        return window.lessons().course().findChild<QLabel*>("courseTitle")->text();
    };
    EXPECT_TRUE(title(window_).contains("Wards</b> holds no lesson yet"));
    EXPECT_FALSE(window_.lessons().course().findChild<QPushButton*>("courseBegin")->isEnabled());
    {
        MainWindow next(settings_, {});
        EXPECT_TRUE(title(next).contains("Wards"));
        std::filesystem::remove(course);
        next.lessons().show_chosen_course();
        EXPECT_TRUE(next.messages().text().contains("course.json"));
        EXPECT_TRUE(title(next).contains("First steps")) << "the program's own";
    }
    MainWindow last(settings_, {});
    EXPECT_TRUE(title(last).contains("First steps"));
    EXPECT_TRUE(last.messages().text().isEmpty());
}

// Someone opens another patient while the lesson's own is on his way.
TEST_F(LessonWindowTest, a_lesson_for_one_case_begins_on_no_other) {
    Lesson lesson = new_lesson();
    lesson.patient = folder_.filePath("own.hep").toStdString();
    lesson.marks[0].place = {Vec3(0, 0, 500), std::nullopt};
    const std::string file = folder_.filePath("lesson.json").toStdString();
    write_lesson(file, lesson);
    window_.lessons().start(file);
    window_.open(folder_.filePath("other.hep"));
    wait();
    QTest::qWait(50);  // a lesson begins a turn of the loop later
    EXPECT_FALSE(window_.lessons().playing());
    window_.lessons().start(file);
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    EXPECT_TRUE(shown("lessonPlaceDoubts").contains("beside the vessels"));
    window_.lessons().start_on(file, folder_.filePath("third.hep"));
    ASSERT_TRUE(wait_for([&] { return !window_.busy(); }));
    EXPECT_TRUE(wait_for([&] { return window_.lessons().playing(); })) << "whom it was begun on";
}

TEST_F(LessonWindowTest, the_editor_offers_the_patient_who_is_opened) {
    LessonEditor& editor = window_.lesson_editor();
    editor.show_editor();
    auto* patients = editor.findChild<QComboBox*>("lessonPatient");
    EXPECT_EQ(patients->count(), 2);
    window_.open(folder_.filePath("other.hep"));
    wait();
    EXPECT_GE(patients->findData(folder_.filePath("other.hep")), 0);
}

// Thinking before the first deed counts for nothing; after it, it does.
TEST_F(LessonWindowTest, the_clock_runs_from_the_first_thing_that_is_done) {
    window_.lessons().start(
        lesson_file(R"({"what": "distance_mm", "mark": "the mark", "at_most": 20})"));
    ASSERT_TRUE(wait_for([&] {
        return window_.lessons().playing() && !window_.busy() && window_.frame().statistics.paused;
    }));
    wait_for_figures();
    const QLabel& clock = *window_.lessons().findChild<QLabel*>("lessonClock");
    EXPECT_FALSE(clock.isHidden());
    EXPECT_TRUE(clock.text().contains("stands"));
    EXPECT_EQ(window_.view().scene().marks().size(), 1u) << "they are seen while it is read";
    paint();
    EXPECT_EQ(window_.lessons().standing().metrics.time_s, 0.0);
    const Vec3 mark = window_.lessons().marks_in(window_.frame()).at(0).place_mm;
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_widget(mark));
    EXPECT_TRUE(wait_for([&] { return window_.lessons().standing().metrics.time_s > 0.0; }));
    wait_for_figures();
    EXPECT_TRUE(clock.text().startsWith("Time: ")) << clock.text().toStdString();
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_widget(mark));
}

TEST_F(LessonWindowTest, a_lesson_begins_with_all_vessels_in_view) {
    open_built_in();
    SceneView& view = window_.view().scene();
    view.look_from(ViewDirection::left);
    view.zoom_by(20.0);
    window_.lessons().start(lesson_file(R"({"what": "time_s", "at_least": 1000})"));
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    paint();
    EXPECT_GT(view.axes().forward.y(), 0.9) << "from the front";
    const std::vector<float>& at = window_.frame().positions_mm;
    for (std::size_t v = 0; v + 2 < at.size(); v += 3) {
        const QPoint pixel = on_widget(Vec3(at[v], at[v + 1], at[v + 2]));
        ASSERT_TRUE(window_.view().rect().contains(pixel)) << "vertex " << v / 3;
    }
}

TEST_F(LessonWindowTest, the_first_card_leads_to_the_lessons) {
    window_.findChild<QPushButton*>("welcomeLessons")->click();
    EXPECT_TRUE(window_.lessons().course().isVisible());
    EXPECT_EQ(window_.lessons().course().findChild<QTableWidget*>("course")->currentRow(), 0);
}

TEST_F(LessonWindowTest, leaving_gives_back_the_free_play) {
    window_.lessons().start(lesson_file(R"({"what": "time_s", "at_least": 1000})"));
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    EXPECT_FALSE(window_.lessons().playing());
    paint();
    EXPECT_TRUE(window_.lessons().isHidden());
}

// Those of who made the case would lie across what the trainee is to see.
TEST_F(LessonWindowTest, earlier_measurements_are_not_drawn_while_a_lesson_is_played) {
    const std::string file = lesson_file(R"({"what": "time_s", "at_least": 1000})");
    const auto play = [&] {
        window_.lessons().start(file);
        return wait_for([&] { return window_.lessons().playing() && !window_.busy(); });
    };
    const auto drawn = [&] { return window_.view().scene().measures().size(); };
    Measurements& measurements = window_.view_layout().slices().measurements();
    const auto measure = [&] {
        measurements.choose(MeasurementKind::distance);
        for (const double z : {0.0, 9.0})
            measurements.add_point(Vec3(0, 0, z), {}, test::small_patient()->tree);
    };
    const auto leave = [&] { window_.lessons().findChild<QPushButton*>("lessonLeave")->click(); };
    ASSERT_TRUE(play());
    leave();
    measure();
    EXPECT_EQ(drawn(), 1u);
    ASSERT_TRUE(play());
    EXPECT_EQ(drawn(), 0u);
    measure();
    EXPECT_EQ(drawn(), 1u) << "one's own is seen";
    leave();
    EXPECT_EQ(drawn(), 2u);
}

TEST_F(LessonWindowTest, the_panel_shows_how_fast_the_lessons_drug_runs) {
    const auto* speed = window_.findChild<QDoubleSpinBox*>("speed");
    Lesson lesson = new_lesson();
    lesson.scene.flow = FlowSpec{.drug_speed = 4.0};
    const std::string file = folder_.filePath("lesson.json").toStdString();
    write_lesson(file, lesson);
    window_.lessons().start(file);
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    EXPECT_TRUE(wait_for([&] { return speed->value() == 4.0; }));
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    EXPECT_TRUE(wait_for([&] { return speed->value() == 1.0; }));
}

TEST_F(LessonWindowTest, leaving_offers_the_patient_from_before) {
    const QString other = folder_.filePath("other.hep"), own = folder_.filePath("own.hep");
    window_.open(other);
    wait();
    Lesson lesson = new_lesson();
    lesson.patient = own.toStdString();
    const std::string file = folder_.filePath("lesson.json").toStdString();
    write_lesson(file, lesson);
    for (int time = 0; time < 2; ++time) {  // begun again, it is still the one from before
        window_.lessons().start(file);
        ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    }
    EXPECT_EQ(window_.workspace().folder(), to_path(own));
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    EXPECT_TRUE(window_.messages().text().contains("other.hep"));
    window_.messages().findChild<QPushButton*>("offer")->click();
    wait();
    EXPECT_EQ(window_.workspace().folder(), to_path(other));
    // Whoever is opened by hand is no lesson's.
    window_.lessons().start(file);
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    window_.open(folder_.filePath("third.hep"));
    wait();
    window_.lessons().start(lesson_file(R"({"what": "time_s", "at_least": 1000})"));
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    EXPECT_FALSE(window_.messages().text().contains("other.hep"));
}

// Who was shown anyway needs no way back.
TEST_F(LessonWindowTest, leaving_says_nothing_where_the_lessons_patient_was_there_before) {
    const QString own = folder_.filePath("own.hep");
    window_.open(own);
    wait();
    Lesson lesson = new_lesson();
    lesson.patient = own.toStdString();
    const std::string file = folder_.filePath("lesson.json").toStdString();
    write_lesson(file, lesson);
    for (int time = 0; time < 2; ++time) {
        window_.lessons().start(file);
        ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    }
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    EXPECT_EQ(window_.messages().text(), "");
}

// Opens the small patient as the built-in one, once he may come.
class LessonMeanwhile : public testing::WindowTest {
  protected:
    LessonMeanwhile()
        : WindowTest({[this](const OpenRequest&, Job& job) {
                          ++openings_;
                          while (held_) {
                              job.throw_if_cancelled();
                              std::this_thread::yield();
                          }
                          LoadedPatient loaded = play(test::small_patient(), job);
                          loaded.title = built_in_title;
                          return loaded;
                      },
                      [](const std::filesystem::path&, const PatientCase&) {}}) {}
    ~LessonMeanwhile() override { held_ = false; }
    void start_lesson() {
        const std::string file = folder_.filePath("lesson.json").toStdString();
        write_lesson(file, new_lesson());
        ASSERT_TRUE(window_.lessons().start(file));
    }
    void open() {
        window_.open(OpenRequest{true, {}});
        ASSERT_TRUE(wait_for([this] { return openings_ > 0; }));
    }

    std::atomic<int> openings_ = 0;
    std::atomic<bool> held_ = true;
};

TEST_F(LessonMeanwhile, waits_for_the_patient_who_is_on_his_way) {
    open();
    start_lesson();
    held_ = false;
    EXPECT_TRUE(wait_for([this] { return window_.lessons().playing() && !window_.busy(); }));
    EXPECT_EQ(openings_, 1) << "begun again, it would take a minute more";
}

TEST_F(LessonMeanwhile, does_not_wait_for_one_who_was_cancelled) {
    open();
    window_.cancel_job();
    start_lesson();
    held_ = false;
    EXPECT_TRUE(wait_for([this] { return window_.lessons().playing() && !window_.busy(); }));
    EXPECT_EQ(openings_, 2);
}

TEST_F(LessonWindowTest, a_lesson_that_cannot_be_read_is_said_above_the_view) {
    window_.lessons().start(folder_.filePath("nothing.json").toStdString());
    EXPECT_FALSE(window_.lessons().playing());
    EXPECT_TRUE(window_.messages().text().contains("nothing.json"));
}

}  // namespace
}  // namespace hepatica
