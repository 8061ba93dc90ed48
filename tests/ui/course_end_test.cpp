// SPDX-License-Identifier: GPL-3.0-or-later
// What the panel says of a course once a lesson of it has ended, and that it leads to no other.
#include <QPushButton>
#include <QTableWidget>
#include <fstream>

#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"
#include "tests/ui/lesson_window_test.h"
#include "ui/course_dialog.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

using testing::wait_for;

class CourseEnd : public testing::LessonWindowTest {
  protected:
    // In a file of the test's folder; `lessons` are its entries in JSON.
    std::string course(const std::string& lessons, const std::string& more = "") {
        const std::string file = folder_.filePath("course.json").toStdString();
        std::ofstream(file) << R"({"format": "hepatica-course", "version": 1, "name": "Mine",
            "lessons": [)" << lessons
                            << "]" << more << "}";
        return file;
    }
    // A result of "Gentle pull" that ended then.
    void keep_passed_pull(const std::string& ended_at) {
        Attempt attempt;
        attempt.recording = to_path(settings_.recordings_folder()) / "1.hrec";
        attempt.lesson = find_lesson("gentle_pull").name;
        attempt.ended_at = ended_at;
        attempt.passed = attempt.passed_lesson = true;
        write_attempt(attempt);
    }
    // Over as soon as the clock has run for a moment, and passed.
    std::string passed_at_once() { return lesson_file(R"({"what": "time_s", "at_least": 0.05})"); }
    void play(const std::string& lesson, const std::vector<Predicate>& marks = {}) {
        window_.lessons().start(lesson, marks);
        start_clock();
        ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
        wait_for_figures();
    }
    QPushButton& next() { return *window_.lessons().findChild<QPushButton*>("lessonNext"); }
    QLabel& said() { return *window_.lessons().findChild<QLabel*>("lessonCourse"); }
};

TEST_F(CourseEnd, after_the_last_lesson_the_panel_says_that_the_course_is_passed) {
    const std::string lesson = passed_at_once();
    window_.lessons().show_course(course(R"({"lesson": "lesson.json"})"));
    play(lesson);
    ASSERT_EQ(window_.lessons().standing().outcome, LessonOutcome::passed);
    EXPECT_TRUE(next().isHidden());
    EXPECT_FALSE(said().isHidden());
    EXPECT_EQ(said().text(),
              "✓ The course \"Mine\" is passed by everybody here: all of its lessons are.");
    window_.lessons().findChild<QPushButton*>("lessonAgain")->click();
    wait_for_figures();
    EXPECT_TRUE(said().isHidden()) << "another attempt runs";
}

TEST_F(CourseEnd, after_the_last_lesson_the_panel_says_how_much_of_the_course_is_passed) {
    const std::string lesson = passed_at_once();
    window_.lessons().show_course(
        course(R"({"lesson": "gentle_pull"}, {"lesson": "lesson.json"})"));
    play(lesson);
    EXPECT_TRUE(next().isHidden());
    EXPECT_EQ(
        said().text(),
        "This was the last lesson of the course \"Mine\": 1 of 2 are passed by everybody here.");
}

// Of whoever handed out a new course nobody has passed it yet.
TEST_F(CourseEnd, what_was_passed_before_the_course_was_made_is_said_and_does_not_count) {
    const std::string lesson = passed_at_once();
    keep_passed_pull("2019-01-01T00:00:00Z");
    const std::string file = course(R"({"lesson": "gentle_pull"}, {"lesson": "lesson.json"})",
                                    R"(, "made_at": "2020-01-01T00:00:00Z")");
    window_.lessons().show_course(file);
    const auto* table = window_.lessons().course().findChild<QTableWidget*>("course");
    EXPECT_EQ(table->item(0, 3)->text(), "passed earlier, before this course");
    EXPECT_EQ(table->item(0, 2)->text(), "0");
    play(lesson);
    EXPECT_EQ(said().text(),
              "This was the last lesson of the course \"Mine\": 1 of 2 are passed by everybody "
              "here.");
}

TEST_F(CourseEnd, a_course_that_is_passed_leads_to_no_next_lesson) {
    const std::string lesson = passed_at_once();
    keep_passed_pull("2019-01-01T00:00:00Z");
    window_.lessons().show_course(
        course(R"({"lesson": "lesson.json"}, {"lesson": "gentle_pull"})"));
    play(lesson);
    EXPECT_EQ(said().text(),
              "✓ The course \"Mine\" is passed by everybody here: all of its lessons are.");
    EXPECT_TRUE(next().isHidden());
}

TEST_F(CourseEnd, it_is_said_for_whom_it_counts) {
    const std::string lesson = passed_at_once();
    window_.lessons().set_trainee("Nr. 7");
    window_.lessons().show_course(course(R"({"lesson": "lesson.json"})"));
    play(lesson);
    EXPECT_EQ(said().text(), "✓ The course \"Mine\" is passed by Nr. 7: all of its lessons are.");
}

// The lesson stands in the program's own course, too, where another comes after it.
TEST_F(CourseEnd, the_last_lesson_of_ones_own_course_leads_to_no_lesson_of_another) {
    const std::string after = find_lesson("probe_free").name;
    const auto proposed = [&] { return next().toolTip().contains(QString::fromStdString(after)); };
    window_.lessons().show_course({});
    window_.lessons().start("gentle_pull");
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing(); }));
    EXPECT_TRUE(proposed()) << next().toolTip().toStdString();
    window_.lessons().show_course(course(R"({"lesson": "gentle_pull"})"));
    window_.lessons().findChild<QPushButton*>("lessonAgain")->click();
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing(); }));
    EXPECT_FALSE(proposed());
}

TEST_F(CourseEnd, a_lesson_of_no_course_says_nothing_of_one) {
    play(passed_at_once());
    EXPECT_TRUE(next().isHidden());
    EXPECT_TRUE(said().isHidden());
}

}  // namespace
}  // namespace hepatica
