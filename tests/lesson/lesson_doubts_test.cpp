// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_doubts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"

namespace hepatica {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(LessonDoubts, HasNoneOfTheLessonsOfTheProgram) {
    for (const BuiltInLesson& entry : built_in_lessons())
        EXPECT_THAT(doubts_about(lesson_of(entry.text, entry.id)), IsEmpty()) << entry.id;
}

// Each part of a scene taken away makes a lesson doubtful that needs it.
TEST(LessonDoubts, NamesThePartThatIsMissing) {
    Lesson lesson = new_lesson();
    lesson.scene.deform.reset();
    EXPECT_THAT(doubts_about(lesson),
                ElementsAre(AllOf(HasSubstr("tool pull"), HasSubstr("vessels that move")),
                            AllOf(HasSubstr("(step 1)"), HasSubstr("vessels that move")),
                            AllOf(HasSubstr("force at most 1000 mN"), HasSubstr("(the limit)"))));

    const std::pair<const char*, void (*)(SceneSpec&)> parts[] = {
        {"bleeding_vessel", [](SceneSpec& scene) { scene.contact.reset(); }},
        {"probe_free", [](SceneSpec& scene) { scene.contact->tools = false; }},
        {"cut_line", [](SceneSpec& scene) { scene.tear.reset(); }},
        {"embolization", [](SceneSpec& scene) { scene.flow.reset(); }}};
    for (const auto& [id, take_away] : parts) {
        Lesson built_in = find_lesson(id);
        take_away(built_in.scene);
        EXPECT_FALSE(doubts_about(built_in).empty()) << id;
    }
}

TEST(LessonDoubts, MissesATarget) {
    Lesson lesson = find_lesson("embolization");
    lesson.target.reset();
    EXPECT_THAT(doubts_about(lesson), testing::Each(HasSubstr("needs a target")));
    EXPECT_FALSE(doubts_about(lesson).empty());
}

TEST(LessonDoubts, KnowsThatAPointBelongsToOnePatient) {
    Lesson lesson = new_lesson();
    lesson.marks[0].place = {Vec3(1, 2, 3), std::nullopt};
    lesson.target = lesson.marks[0].place;
    EXPECT_THAT(doubts_about(lesson), ElementsAre(HasSubstr("\"mark 1\""), HasSubstr("target")));
    lesson.patient = "built-in";
    EXPECT_THAT(doubts_about(lesson), IsEmpty());
}

TEST(LessonDoubts, SeesAStepThatEndsBeforeItIsHeld) {
    Lesson lesson = new_lesson();
    lesson.steps[0].hold_s = 5.0;
    lesson.steps[0].limits = {{Quantity::step_time_s, -1, false, 5.0}};
    EXPECT_THAT(doubts_about(lesson), ElementsAre(HasSubstr("held for longer")));
    lesson.steps[0].limits[0].bound = 6.0;
    EXPECT_THAT(doubts_about(lesson), IsEmpty());
}

TEST(LessonDoubts, AsksForATool) {
    Lesson lesson = new_lesson();
    lesson.tools.clear();
    EXPECT_THAT(doubts_about(lesson), ElementsAre(HasSubstr("no tool")));
}

}  // namespace
}  // namespace hepatica
