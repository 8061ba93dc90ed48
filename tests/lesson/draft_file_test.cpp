// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/draft_file.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_writer.h"

namespace hepatica {
namespace {

TEST(DraftFile, HoldsTheLessonAndWhereItCameFrom) {
    Lesson lesson = new_lesson();
    lesson.steps[0].goal.clear();
    lesson.patient = "/home/a.hep";
    const LessonDraft draft{lesson, "/home/me/lesson.json", "../a.hep", "/home/a.hep"};
    const LessonDraft read = draft_of(text_of(draft), "copy");
    EXPECT_EQ(text_of(read.lesson), text_of(lesson));
    EXPECT_EQ(read.file, draft.file);
    EXPECT_EQ(read.patient_in_file, "../a.hep");
    EXPECT_EQ(read.patient_path, "/home/a.hep");
    const LessonDraft of_nowhere = draft_of(text_of(LessonDraft{lesson, {}, {}, {}}), "copy");
    EXPECT_TRUE(of_nowhere.file.empty());
}

TEST(DraftFile, ReadsALessonThatAnEarlierProgramLeft) {
    const LessonDraft read = draft_of(text_of(new_lesson()), "copy");
    EXPECT_EQ(text_of(read.lesson), text_of(new_lesson()));
    EXPECT_TRUE(read.file.empty());
}

TEST(DraftFile, RefusesWhatIsNone) {
    EXPECT_THROW(draft_of("{half", "copy"), InputError);
    EXPECT_THROW(draft_of("[]", "copy"), InputError);
    EXPECT_THROW(draft_of("{\"format\": \"other\"}", "copy"), InputError);
    std::string later = text_of(LessonDraft{new_lesson(), {}, {}, {}});
    later.replace(later.find("\"version\": 1"), 12, "\"version\": 2");
    EXPECT_THROW(draft_of(later, "copy"), InputError);
}

}  // namespace
}  // namespace hepatica
