// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_gaps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_writer.h"

namespace hepatica {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A lesson with one gap, and what is said of it.
struct OneGap {
    void (*make)(Lesson&);
    const char* said;
};
const OneGap one_gaps[] = {
    {[](Lesson& lesson) { lesson.name.clear(); }, "has no name"},
    {[](Lesson& lesson) { lesson.scene.deform.reset(); }, "of nothing"},
    {[](Lesson& lesson) { lesson.steps[0].text.clear(); }, "Step 1 says nothing"},
    {[](Lesson& lesson) { lesson.steps[0].goal.clear(); },
     "Step 1 \"Pull the vessel at the mark aside and hold it…\" has no goal"},
    {[](Lesson& lesson) { lesson.steps[0].tool = LessonTool::hook; },
     "hold it…\" asks for the tool hook, which the lesson does not allow"},
    {[](Lesson& lesson) { remove_mark(lesson, 0); }, "hold it…\", goal: \"way moved by no mark"},
    {[](Lesson& lesson) {
         lesson.limits = {{Quantity::touch_mm, -1, false, 2.0}};
     },
     "Limits all the time: \"distance of the touch to no mark"},
    {[](Lesson& lesson) {
         lesson.pass = {{Quantity::touch_mm, -1, false, 2.0}};
     },
     "Pass marks: \"distance of the touch to no mark"},
    {[](Lesson& lesson) {
         lesson.steps[0].limits = {{Quantity::touch_mm, -1, false, 2.0}};
     },
     "hold it…\", limits: \"distance of the touch to no mark"},
    {[](Lesson& lesson) {
         lesson.pass = {{Quantity::touch_mm, 1, false, 2.0}};  // the lesson has one mark
     },
     "Pass marks: \"distance of the touch to no mark"}};

TEST(LessonGaps, NamesWhatKeepsALessonFromBeingReadAndNothingElse) {
    EXPECT_THAT(gaps_in(new_lesson()), IsEmpty());
    for (const BuiltInLesson& entry : built_in_lessons())
        EXPECT_THAT(gaps_in(find_lesson(entry.id)), IsEmpty()) << entry.id;
    for (const auto& [make, said] : one_gaps) {
        Lesson lesson = new_lesson();
        make(lesson);
        EXPECT_THAT(gaps_in(lesson), ElementsAre(AllOf(HasSubstr(said), Not(HasSubstr("[0]")))));
        EXPECT_THROW(lesson_of(text_of(lesson), "lesson"), InputError) << said;
    }
}

// What a crash leaves of it is all of it.
TEST(LessonGaps, AreKeptInTheCopyOfAnUnfinishedLesson) {
    for (const auto& [make, said] : one_gaps) {
        Lesson lesson = new_lesson();
        make(lesson);
        const Lesson read = unfinished_lesson_of(text_of(lesson), "copy");
        EXPECT_EQ(text_of(read), text_of(lesson)) << said;
        EXPECT_EQ(gaps_in(read), gaps_in(lesson)) << said;
    }
}

TEST(LessonGaps, CutsLongTitlesBetweenWordsAndLettersNeverInside) {
    Lesson lesson = new_lesson();
    lesson.steps[0].text = "Short";
    EXPECT_EQ(step_in_words(lesson, 0), "Step 1 \"Short\"");
    lesson.steps[0].text = "x";
    for (int i = 0; i < 40; ++i) lesson.steps[0].text += "ä";  // two bytes, from an odd place
    const std::string words = step_in_words(lesson, 0);
    EXPECT_EQ(words.substr(words.size() - 6), "ä…\"");
}

}  // namespace
}  // namespace hepatica
