// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"
#include "core/base/text_file.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"

namespace hepatica {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

// Every value that a text names, compared with what was read and written again.
void expect_says_all_of(const Json& before, const Json& after, const std::string& where) {
    if (!before.is_object()) {
        EXPECT_EQ(before, after) << where;
        return;
    }
    for (const auto& [key, value] : before.items()) {
        ASSERT_TRUE(after.contains(key)) << where << "." << key;
        expect_says_all_of(value, after[key], where + "." + key);
    }
}

// Beside it only the settings that a scene leaves at their defaults.
TEST(LessonWriter, WritesEveryLessonOfTheProgramAsItWas) {
    for (const BuiltInLesson& entry : built_in_lessons()) {
        const Json before = Json::parse(entry.text);
        const Json after = Json::parse(text_of(lesson_of(entry.text, entry.id)));
        expect_says_all_of(before, after, entry.id);
        for (const auto& [key, value] : after.items()) {
            EXPECT_TRUE(before.contains(key)) << entry.id << ": " << key;
            if (value.is_array()) {
                EXPECT_EQ(before[key].size(), value.size()) << entry.id << ": " << key;
            }
        }
        for (const auto& [part, settings] : after["scene"].items())
            EXPECT_TRUE(before["scene"].contains(part) || part == "dt_s") << entry.id << part;
    }
}

// No key of the format is at its default here.
TEST(LessonWriter, WritesEverySettingThatAFileCanName) {
    const Json before = Json::parse(R"({
        "format": "hepatica-lesson", "version": 1, "name": "All", "id": "1f", "about": "Why",
        "patient": "../cases/a.hep",
        "scene": {"name": "s", "dt_s": 0.004,
            "deform": {"material": "hepatic vein", "fixed": "all", "quality": 0.25,
                "gravity_mm_per_s2": [0.1, -0.2, 0.3], "tether_pa_per_mm2": 7.5,
                "wall_mm": 1.25, "velocity_error": [0.5, 0.001]},
            "contact": {"tools": false, "self": true},
            "tear": {"tear_factor": 2.5, "stop": "vertices", "entropy_budget": 0.75,
                "vertex_budget": 17, "bare_limit": true},
            "flow": {"drug_speed": 3.25}},
        "setup": [{"do": "blade", "from_mm": [17.5, -35.5, 28.0], "to_mm": [14.9, -35.5, 22.0]}],
        "tools": ["settings", "pull"],
        "marks": {"b": {"point_mm": [1.5, 2.25, -3.0]}, "a": {"share_of_longest_path": 0.125}},
        "target": {"point_mm": [4.0, 5.0, 6.5]},
        "steps": [{"text": "One", "hint": "Slowly",
            "goal": [{"what": "moved_mm", "mark": "a", "at_least": 1.5},
                     {"what": "holding", "at_most": 0.0}], "hold_s": 2.5,
            "limits": [{"what": "force_mn", "at_most": 600.125}]}],
        "limits": [{"what": "leak_g_s", "at_most": 0.0625}],
        "pass": [{"what": "dose_target_share", "at_least": 0.75}]})");
    const Json after = Json::parse(text_of(lesson_of(before.dump(), "file")));
    expect_says_all_of(before, after, "lesson");
    EXPECT_EQ(before.size(), after.size());
}

TEST(LessonWriter, WritesATargetGivenAsAPointAndLimitsOfAStep) {
    Lesson lesson = new_lesson();
    lesson.target = ScriptPlace{Vec3(1.5, -2.0, 0.25), std::nullopt};
    lesson.steps[0].limits = {{Quantity::distance_mm, 0, false, 12.5}};
    const Lesson read = lesson_of(text_of(lesson), "file");
    EXPECT_EQ(read.target->point_mm, Vec3(1.5, -2.0, 0.25));
    EXPECT_EQ(read.steps[0].limits, lesson.steps[0].limits);
    EXPECT_EQ(read.steps[0].goal, lesson.steps[0].goal);
    EXPECT_EQ(text_of(read), text_of(lesson));
}

TEST(LessonWriter, WritesAFileThatCanBeReadOrNone) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "lesson.json";
    write_lesson(file, new_lesson());
    EXPECT_EQ(read_lesson(file).name, "A new lesson");
    const std::string whole = read_text_file(file, "");

    Lesson without_goal = new_lesson();
    without_goal.steps[0].goal.clear();
    Lesson two_of_a_name = new_lesson();
    two_of_a_name.marks.push_back(two_of_a_name.marks.front());
    for (const auto& [lesson, reason] :
         {std::pair(without_goal, "has no goal"), std::pair(two_of_a_name, "\"mark 1\"")}) {
        try {
            write_lesson(file, lesson);
            ADD_FAILURE() << reason;
        } catch (const InputError& error) {
            EXPECT_THAT(std::string(error.what()) + error.place(), HasSubstr(reason));
        }
        EXPECT_EQ(read_text_file(file, ""), whole);
    }
}

TEST(CourseWriter, WritesWhatReadsAsTheSameCourse) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "course.json";
    const Course course{
        "Two \"steps\"",
        {{"gentle_pull",
          {{Quantity::path_mm, -1, false, 100.5}, {Quantity::time_s, -1, true, 1.0}}},
         {"../a lesson.json", {}}},
        "2026-11-23T13:20:05Z"};
    write_course(file, course);
    EXPECT_EQ(read_course(file), course);
    EXPECT_THROW(write_course(file, {"", course.lessons, {}}), InputError);
    EXPECT_EQ(read_course(file), course) << "nothing that cannot be read takes its place";
    const Course empty{"new", {}, {}};
    write_course(file, empty);
    EXPECT_EQ(read_course(file), empty);
}

// As a bound of a lesson's mark may come into a course, whose file names no marks.
TEST(LessonWriter, WritesABoundOfAMarkThatThereIsNotWithoutIt) {
    const Course course{"One", {{"look_around", {{Quantity::moved_mm, 0, true, 2.0}}}}};
    const Json written = Json::parse(text_of(course))["lessons"][0]["pass"][0];
    EXPECT_EQ(written, (Json{{"what", "moved_mm"}, {"at_least", 2.0}}));
    EXPECT_THROW(course_of(text_of(course), "course"), InputError) << "and nobody plays it";
    Lesson lesson = new_lesson();
    lesson.limits = {{Quantity::moved_mm, 7, false, 2.0}};
    EXPECT_THROW(lesson_of(text_of(lesson), "lesson"), InputError);
}

}  // namespace
}  // namespace hepatica
