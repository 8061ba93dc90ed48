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

// All that the files of the program say, but for the settings that a scene leaves at their
// defaults.
TEST(LessonWriter, WritesEveryLessonOfTheProgramAsItWas) {
    for (const BuiltInLesson& entry : built_in_lessons()) {
        const Json before = Json::parse(entry.text);
        const Json after = Json::parse(text_of(lesson_of(entry.text, entry.id)));
        for (const auto& [key, value] : before.items()) {
            if (key == "scene") {
                for (const auto& [part, settings] : value.items())
                    EXPECT_TRUE(after["scene"].contains(part)) << entry.id << ": " << part;
                EXPECT_EQ(to_json(scene_from_json(value)), after["scene"]) << entry.id;
            } else {
                EXPECT_EQ(value, after[key]) << entry.id << ": " << key;
            }
        }
        for (const auto& [key, value] : after.items())
            EXPECT_TRUE(before.contains(key) || key == "scene") << entry.id << ": " << key;
    }
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

}  // namespace
}  // namespace hepatica
