// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.h"

namespace hepatica {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

Json good() {
    return Json::parse(R"({"format": "hepatica-lesson", "version": 1, "name": "a lesson",
        "about": "what it is for", "patient": "any",
        "scene": {"deform": {}, "tear": {}},
        "setup": [{"do": "cut_line", "from": {"share_of_longest_path": 0.5},
                   "to": {"share_of_longest_path": 0.5}, "strength": 0}],
        "tools": ["pull", "cut_line"],
        "marks": {"here": {"share_of_longest_path": 0.25}, "there": {"point_mm": [1, 2, 3]}},
        "target": {"share_of_longest_path": 0.5},
        "steps": [{"text": "pull", "hint": "gently", "hold_s": 2,
                   "goal": [{"what": "moved_mm", "mark": "there", "at_least": 5}],
                   "limits": [{"what": "step_time_s", "at_most": 10}]}],
        "limits": [{"what": "force_mn", "at_most": 500}],
        "pass": [{"what": "time_s", "at_most": 60}]})");
}

TEST(LessonFile, ReadsWhatIsWritten) {
    const Lesson lesson = lesson_of(good().dump(), "file");
    EXPECT_EQ(lesson.name, "a lesson");
    EXPECT_EQ(lesson.about, "what it is for");
    EXPECT_TRUE(lesson.scene.deform && lesson.scene.tear && !lesson.scene.flow);
    EXPECT_EQ(lesson.setup.actions.size(), 1u);
    EXPECT_EQ(lesson.tools, (std::vector{LessonTool::pull, LessonTool::cut_line}));
    EXPECT_EQ(lesson.mark_names(), (std::vector<std::string>{"here", "there"}));
    EXPECT_EQ(*lesson.marks[1].place.point_mm, Vec3(1, 2, 3));
    EXPECT_EQ(*lesson.target->share_of_longest_path, 0.5);
    ASSERT_EQ(lesson.steps.size(), 1u);
    EXPECT_EQ(lesson.steps[0].hint, "gently");
    EXPECT_EQ(lesson.steps[0].hold_s, 2.0);
    EXPECT_EQ(lesson.steps[0].goal, (std::vector<Predicate>{{Quantity::moved_mm, 1, true, 5.0}}));
    EXPECT_EQ(lesson.limits, (std::vector<Predicate>{{Quantity::force_mn, -1, false, 500.0}}));
    EXPECT_EQ(lesson.pass, (std::vector<Predicate>{{Quantity::time_s, -1, false, 60.0}}));
}

TEST(LessonFile, MayAskForADrug) {
    Json json = good();
    EXPECT_EQ(lesson_of(json.dump(), "file").drug, "");
    json["drug"] = "lipiodol";
    EXPECT_EQ(lesson_of(json.dump(), "file").drug, "lipiodol");
    json["drug"] = "water";
    try {
        lesson_of(json.dump(), "file");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("\"water\" is no drug"));
        EXPECT_THAT(error.what(), HasSubstr("gas, lipiodol, carrier"));
    }
}

// What a file says once this is in it at this place; empty: it is read.
std::string refusal(const std::string& pointer, const Json& value) {
    Json json = good();
    const Json::json_pointer place(pointer);
    if (value.is_discarded())
        json[place.parent_pointer()].erase(place.back());
    else
        json[place] = value;
    try {
        lesson_of(json.dump(), "file.json");
        return "";
    } catch (const InputError& error) {
        EXPECT_THAT(error.place(), HasSubstr("file.json"));
        EXPECT_NE(error.remedy(), "");
        return error.what();
    }
}

TEST(LessonFile, NamesThePlaceAndTheValueOfWhateverIsWrong) {
    const Json gone(Json::value_t::discarded);
    EXPECT_THAT(refusal("/format", "x"), HasSubstr("file.json: format"));
    EXPECT_THAT(refusal("/version", 2), HasSubstr("is 2"));
    EXPECT_THAT(refusal("/name", ""), HasSubstr("name"));
    EXPECT_THAT(refusal("/name", gone), HasSubstr("has no \"name\""));
    EXPECT_THAT(refusal("/surprise", 1), HasSubstr("surprise"));
    EXPECT_THAT(refusal("/scene/deform/softness", 1), HasSubstr("softness"));
    EXPECT_THAT(refusal("/tools/0", "spoon"), HasSubstr("tools[0]"));
    EXPECT_THAT(refusal("/marks/here/share_of_longest_path", 2), HasSubstr("is 2"));
    EXPECT_THAT(refusal("/marks/there/point_mm", Json::array({1, 2})), HasSubstr("point_mm"));
    EXPECT_THAT(refusal("/steps", Json::array()), HasSubstr("steps"));
    EXPECT_THAT(refusal("/steps/0/goal", Json::array()), HasSubstr("no goal"));
    EXPECT_THAT(refusal("/steps/0/goal/0/what", "courage"), HasSubstr("steps[0].goal[0].what"));
    EXPECT_THAT(refusal("/steps/0/goal/0/mark", "nowhere"), HasSubstr("\"nowhere\""));
    EXPECT_THAT(refusal("/steps/0/goal/0/mark", gone), HasSubstr("which mark"));
    EXPECT_THAT(refusal("/steps/0/goal/0/at_most", 1), HasSubstr("either"));
    EXPECT_THAT(refusal("/steps/0/goal/0/at_least", "five"), HasSubstr("\"five\""));
    EXPECT_THAT(refusal("/steps/0/hold_s", -1), HasSubstr("is -1"));
    EXPECT_THAT(refusal("/steps/0/tool", "spoon"), HasSubstr("steps[0].tool"));
    EXPECT_THAT(refusal("/steps/0/tool", "inject"), HasSubstr("not held in the hand"));
    EXPECT_THAT(refusal("/steps/0/tool", "hook"), HasSubstr("does not allow"));
    EXPECT_THAT(refusal("/limits/0/mark", "here"), HasSubstr("does not need"));
    EXPECT_THAT(refusal("/setup/0/strength", 7), HasSubstr("strength"));
    EXPECT_THAT(refusal("/setup/0/at_s", 1), HasSubstr("over time"));
    const Json slow = Json::parse(R"({"do": "move_grab", "target_mm": [1, 2, 3], "over_s": 0.5})");
    EXPECT_THAT(refusal("/setup/0", slow), HasSubstr("over time"));
    EXPECT_EQ(refusal("/about", gone), "");
}

TEST(LessonFile, HasNoKeyTwice) {
    std::string text = good().dump();
    text.insert(1, "\"name\": \"another\", ");
    try {
        lesson_of(text, "file");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "file: name");
        EXPECT_EQ(error.problem(), "is given twice");
    }
}

TEST(LessonFile, IsNamedWithTheLineThatIsDamaged) {
    for (const char* text : {"{\"name\":\n1e400}", "{\"name\":\nNaN}"}) try {
            lesson_of(text, "file");
            FAIL() << text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), "file");
            EXPECT_THAT(error.problem(), HasSubstr("line 2, column")) << text;
        }
}

TEST(LessonFile, IsNoJsonOrNotThere) {
    EXPECT_THROW(lesson_of("{", "file"), InputError);
    EXPECT_THROW(lesson_of("[]", "file"), InputError);
    EXPECT_THROW(find_lesson("no such lesson"), InputError);
}

TEST(LessonFile, TheBuiltInOnesAreSevenInTheOrderOfTheirCourse) {
    const Course course = course_of(built_in_course(), "course");
    const std::vector<BuiltInLesson> lessons = built_in_lessons();
    ASSERT_EQ(lessons.size(), 7u);
    ASSERT_EQ(course.lessons.size(), 7u);
    std::set<std::string> names;
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        EXPECT_EQ(course.lessons[i].lesson, lessons[i].id);
        const Lesson lesson = find_lesson(lessons[i].id);
        EXPECT_EQ(lesson.patient, "built-in");
        EXPECT_NE(lesson.about, "");
        names.insert(lesson.name);
    }
    EXPECT_EQ(names.size(), 7u);
}

// Else the forceps alone would pass the first step, which asks for the probe.
TEST(BuiltInLessonFiles, StepsWhoseTextsNameAToolAskForIt) {
    const Lesson bleeding = find_lesson("bleeding_vessel");
    ASSERT_EQ(bleeding.steps.size(), 2u);
    EXPECT_EQ(bleeding.steps[0].tool, LessonTool::sphere);
    EXPECT_EQ(bleeding.steps[1].tool, LessonTool::forceps);
    EXPECT_EQ(find_lesson("probe_free").steps[0].tool, LessonTool::capsule);
    EXPECT_FALSE(find_lesson("probe_free").steps[2].tool) << "there it is put away";
}

TEST(CourseFile, HasLessonsWithPassMarks) {
    const auto course_with = [](const std::string& lessons) {
        return course_of(R"({"format": "hepatica-course", "version": 1, "name": "c", "lessons": )" +
                             lessons + "}",
                         "course.json");
    };
    const Course course =
        course_with(R"([{"lesson": "cut_line", "pass": [{"what": "path_mm", "at_most": 90}]}])");
    EXPECT_EQ(course.lessons[0].pass,
              (std::vector<Predicate>{{Quantity::path_mm, -1, false, 90.0}}));
    EXPECT_TRUE(course_with("[]").lessons.empty()) << "as a new one begins";
    EXPECT_THROW(course_with(R"([{"lesson": "a", "grade": 1}])"), InputError);
    EXPECT_EQ(course.made_at, "");
    const auto made = [&](const std::string& at) {
        return course_with(R"([], "made_at": ")" + at + "\"").made_at;
    };
    EXPECT_EQ(made("2026-11-23T13:20:05Z"), "2026-11-23T13:20:05Z");
    EXPECT_THROW(made("yesterday"), InputError);
    EXPECT_THROW(made("2026-11-23T13:20:05+01:00"), InputError) << "of another zone";
}

}  // namespace
}  // namespace hepatica
