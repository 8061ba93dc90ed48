// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_draft.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/lesson/lesson_doubts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_gaps.h"
#include "core/lesson/lesson_writer.h"

namespace hepatica {
namespace {

TEST(LessonDraft, BeginsAsALessonThatCanBeReadAndPlayed) {
    Lesson lesson = new_lesson();
    lesson.steps.push_back(new_step());
    EXPECT_NO_THROW(lesson_of(text_of(lesson), "new"));
    EXPECT_TRUE(doubts_about(lesson).empty());
}

// Thick vessels need more force for the same way, so that no limit on it suits every patient.
TEST(LessonDraft, BeginsWithoutALimitOnTheForce) {
    using enum Quantity;
    const Lesson lesson = new_lesson();
    for (const std::vector<Predicate>& bounds : {lesson.limits, lesson.pass})
        for (const Predicate& bound : bounds)
            EXPECT_TRUE(bound.quantity != force_mn && bound.quantity != peak_force_mn &&
                        bound.quantity != impulse_mn_s)
                << to_words(bound, lesson.mark_names());
}

// Else their numbers would be printed over each other.
TEST(LessonDraft, PutsEachNewMarkElsewhere) {
    Lesson lesson = new_lesson();
    lesson.marks.clear();
    EXPECT_EQ(free_place(lesson).share_of_longest_path, 0.5);
    lesson.marks.push_back({"clicked", {Vec3(1, 2, 3), std::nullopt}});
    EXPECT_EQ(free_place(lesson).share_of_longest_path, 0.5);
    for (int mark = 0; mark < 6; ++mark) {
        const ScriptPlace place = free_place(lesson);
        const double share = place.share_of_longest_path.value();
        EXPECT_GE(share, 0.2);
        EXPECT_LE(share, 0.9 + 1e-9);
        for (const LessonMark& other : lesson.marks)
            EXPECT_GT(std::abs(other.place.share_of_longest_path.value_or(-1.0) - share), 0.04);
        lesson.marks.push_back({"mark", place});
    }
}

TEST(LessonDraft, PutsANewMarkWhereItIsSeen) {
    const Lesson lesson = new_lesson();  // with a mark in the middle
    const auto beyond_the_bend = [](double share) { return share > 0.45 + 1e-9; };
    EXPECT_NEAR(free_place(lesson).share_of_longest_path.value(), 0.9, 1e-9);
    EXPECT_NEAR(free_place(lesson, beyond_the_bend).share_of_longest_path.value(), 0.2, 1e-9);
    const auto everywhere = [](double) { return true; };
    EXPECT_EQ(free_place(lesson, everywhere).share_of_longest_path,
              free_place(lesson).share_of_longest_path);
    const auto but_in_the_middle = [](double share) { return std::abs(share - 0.5) > 1e-9; };
    EXPECT_NE(free_place(lesson, but_in_the_middle).share_of_longest_path, 0.5)
        << "a mark is there already";
}

TEST(LessonDraft, TakesAMarkAwayAndKeepsWhatNamedIt) {
    Lesson lesson = new_lesson();
    lesson.marks = {
        {"a", {std::nullopt, 0.1}}, {"b", {std::nullopt, 0.2}}, {"c", {std::nullopt, 0.3}}};
    const Predicate of_a{Quantity::distance_mm, 0, false, 1.0};
    const Predicate of_b{Quantity::moved_mm, 1, true, 2.0};
    const Predicate of_c{Quantity::touch_mm, 2, false, 3.0};
    const Predicate of_none{Quantity::time_s, -1, false, 4.0};
    lesson.steps = {new_step(), new_step()};
    lesson.steps[0].goal = {of_b};
    lesson.steps[0].limits = {of_c, of_b};
    lesson.steps[1].goal = {of_a, of_b};
    lesson.limits = {of_b, of_none};
    lesson.pass = {of_none, of_c};

    remove_mark(lesson, 1);

    Predicate lost = of_b, now_of_c = of_c;
    lost.mark = -1;
    now_of_c.mark = 1;
    EXPECT_EQ(lesson.mark_names(), (std::vector<std::string>{"a", "c"}));
    EXPECT_EQ(lesson.steps[0].goal, std::vector{lost});
    EXPECT_EQ(lesson.steps[0].limits, (std::vector{now_of_c, lost}));
    EXPECT_EQ(lesson.steps[1].goal, (std::vector{of_a, lost}));
    EXPECT_EQ(lesson.limits, (std::vector{lost, of_none}));
    EXPECT_EQ(lesson.pass, (std::vector{of_none, now_of_c}));
    EXPECT_EQ(gaps_in(lesson).size(), 4u) << "one for each that lost it";
}

TEST(LessonDraft, NamesMarksAnew) {
    Lesson lesson;
    EXPECT_EQ(free_mark_name(lesson), "mark 1");
    lesson.marks = {{"mark 1", {}}, {"mark 3", {}}};
    EXPECT_EQ(free_mark_name(lesson), "mark 2");
}

}  // namespace
}  // namespace hepatica
