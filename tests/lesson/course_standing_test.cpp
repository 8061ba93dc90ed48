// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/course_standing.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"
#include "core/lesson/course_results.h"

namespace hepatica {
namespace {

Attempt attempt_of_time(const std::string& lesson, bool passed, double time_s) {
    Attempt attempt;
    attempt.lesson = lesson;
    attempt.passed = attempt.passed_lesson = passed;
    attempt.metrics[static_cast<std::size_t>(Quantity::time_s)] = time_s;
    attempt.metrics[static_cast<std::size_t>(Quantity::dose_target_share)] =
        std::numeric_limits<double>::quiet_NaN();
    return attempt;
}

Predicate no_more_than(Quantity quantity, double bound) {
    return {quantity, -1, false, bound};
}

TEST(CourseStanding, AnAttemptMustPassTheLessonAndMeetTheCoursesMarks) {
    const std::vector<Predicate> quick{no_more_than(Quantity::time_s, 10.0)};
    EXPECT_TRUE(passes(attempt_of_time("x", true, 10.0), quick));
    EXPECT_FALSE(passes(attempt_of_time("x", true, 10.1), quick));
    EXPECT_FALSE(passes(attempt_of_time("x", false, 1.0), quick));
    EXPECT_TRUE(passes(attempt_of_time("x", true, 99.0), {}));
    EXPECT_FALSE(
        passes(attempt_of_time("x", true, 1.0), {no_more_than(Quantity::dose_target_share, 1.0)}))
        << "what is not known meets no mark";
    EXPECT_FALSE(passes(attempt_of_time("x", true, 1.0), {no_more_than(Quantity::force_mn, 1e9)}))
        << "what is of a moment is not known afterwards";
}

TEST(CourseStanding, AMarkOfAMomentIsMetByWhatPassedItThen) {
    const Predicate gentle = no_more_than(Quantity::force_mn, 5.0);
    Attempt attempt = attempt_of_time("x", true, 1.0);
    attempt.course_pass = {gentle};
    EXPECT_TRUE(passes(attempt, {gentle}));
    EXPECT_FALSE(passes(attempt, {no_more_than(Quantity::force_mn, 4.0)})) << "another course";
    attempt.passed = false;
    EXPECT_FALSE(passes(attempt, {gentle})) << "the lesson's own marks alone were met";
}

TEST(CourseStanding, AMarkThatTheLessonHasItselfIsMetByWhoPassedIt) {
    const Lesson pull = find_lesson("gentle_pull");
    ASSERT_FALSE(pull.pass.empty());
    const Predicate gentle = no_more_than(Quantity::force_mn, 5.0);
    std::vector<Predicate> marks = pull.pass;
    marks.push_back(gentle);
    const Course course{"c", {{"gentle_pull", marks}}};
    EXPECT_EQ(standing_of(course, "", {}).at(0).pass, std::vector<Predicate>{gentle});
}

TEST(CourseStanding, CountsEachLessonsAttemptsAndOneThatPassedIsEnough) {
    Course course{"c", {{"gentle_pull", {no_more_than(Quantity::time_s, 10.0)}}, {"cut_line", {}}}};
    const std::string pull = find_lesson("gentle_pull").name;
    const std::vector<CourseLine> lines =
        standing_of(course, "",
                    {attempt_of_time(pull, true, 20.0), attempt_of_time(pull, true, 9.0),
                     attempt_of_time(pull, false, 1.0)});
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].title, pull);
    EXPECT_EQ(lines[0].attempts, 3);
    EXPECT_TRUE(lines[0].passed);
    EXPECT_EQ(lines[1].attempts, 0);
    EXPECT_FALSE(lines[1].passed);
    course.lessons[1].lesson = "none.json";
    EXPECT_THROW(standing_of(course, "/nowhere", {}), InputError);
}

TEST(CourseStanding, CountsNoAttemptThatWasInterrupted) {
    const Course course{"c", {{"gentle_pull", {}}}};
    const std::string pull = find_lesson("gentle_pull").name;
    Attempt cut = attempt_of_time(pull, false, 1.0);
    cut.reasons = {interrupted_reason};
    EXPECT_TRUE(was_interrupted(cut));
    EXPECT_EQ(standing_of(course, "", {cut}).at(0).attempts, 0);
    EXPECT_EQ(results_of(course, "", {cut}).trainees.at(0).lessons.at(0), LessonResult{});
    cut.reasons = {"given up before the end"};
    EXPECT_FALSE(was_interrupted(cut));
    EXPECT_EQ(standing_of(course, "", {cut}).at(0).attempts, 1);
    EXPECT_EQ(results_of(course, "", {cut}).trainees.at(0).lessons.at(0).attempts, 1);
}

TEST(CourseStanding, WhatWasPlayedBeforeTheCourseWasMadeDoesNotCount) {
    const Course course{"c", {{"gentle_pull", {}}}, "2026-11-30T12:00:00Z"};
    Attempt attempt = attempt_of_time(find_lesson("gentle_pull").name, true, 1.0);
    attempt.ended_at = "2026-11-30T11:59:59Z";
    const CourseLine before = standing_of(course, "", {attempt}).at(0);
    EXPECT_FALSE(before.passed);
    EXPECT_TRUE(before.passed_earlier);
    EXPECT_EQ(before.attempts, 0);
    EXPECT_EQ(results_of(course, "", {attempt}).trainees.at(0).lessons.at(0), LessonResult{});
    EXPECT_TRUE(standing_of({"c", course.lessons, {}}, "", {attempt}).at(0).passed)
        << "of a course that does not know when it was made";
    attempt.ended_at = course.made_at;
    const CourseLine since = standing_of(course, "", {attempt}).at(0);
    EXPECT_TRUE(since.passed);
    EXPECT_FALSE(since.passed_earlier);
    EXPECT_EQ(since.attempts, 1);
    EXPECT_TRUE(results_of(course, "", {attempt}).trainees.at(0).lessons.at(0).passed);
}

TEST(CourseStanding, OfTheProgramsOwnCourseHasALineForEachLesson) {
    const auto lines = standing_of(course_of(built_in_course(), "course"), "", {});
    EXPECT_EQ(lines.size(), built_in_lessons().size());
}

TEST(CourseEntries, NameALessonFromWhereverTheCourseLies) {
    EXPECT_EQ(lesson_named_by("gentle_pull", "/a/b"), "gentle_pull");
    EXPECT_EQ(entry_naming("gentle_pull", "/a/b"), "gentle_pull");
    for (const char* lesson : {"/a/b/one.json", "/a/c/one.json", "/one.json", "/a/b/c/one.json"})
        for (const char* folder : {"/a/b", "/a/b/", "/", "/z/y/x"})
            EXPECT_EQ(lesson_named_by(entry_naming(lesson, folder), folder), lesson) << folder;
    EXPECT_EQ(entry_naming("/a/b/one.json", "/a/b"), "one.json") << "they can be moved together";
}

}  // namespace
}  // namespace hepatica
