// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_marks.h"

#include <algorithm>
#include <string>

namespace hepatica {

namespace {

bool names_mark(const LessonStep& step, std::size_t mark) {
    return std::ranges::any_of(step.goal, [&](const Predicate& goal) {
        return goal.mark >= 0 && static_cast<std::size_t>(goal.mark) == mark;
    });
}

// Whether the lesson's last step is reached, or an earlier step names the mark and none from this
// one on does.
bool is_done_with(const Lesson& lesson, std::size_t mark, std::size_t step) {
    if (step == lesson.steps.size()) return true;
    const auto names_it = [&](const LessonStep& one) { return names_mark(one, mark); };
    const auto now = lesson.steps.begin() + static_cast<std::ptrdiff_t>(step);
    return std::any_of(lesson.steps.begin(), now, names_it) &&
           std::none_of(now, lesson.steps.end(), names_it);
}

}  // namespace

std::vector<MarkView> views_of_marks(const Lesson& lesson, const std::vector<Vec3>& places_mm,
                                     std::size_t step) {
    step = std::min(step, lesson.steps.size());
    std::vector<MarkView> marks;
    for (std::size_t i = 0; i < places_mm.size(); ++i) {
        MarkView& mark = marks.emplace_back();
        mark.place_mm = places_mm[i];
        if (places_mm.size() > 1) mark.number = std::to_string(i + 1);
        mark.reached = is_done_with(lesson, i, step);
        mark.wanted = step < lesson.steps.size() && names_mark(lesson.steps[step], i);
    }
    return marks;
}

}  // namespace hepatica
