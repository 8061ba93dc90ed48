// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_marks.h"

#include <algorithm>
#include <string>

namespace hepatica {

namespace {

// Whether an earlier step names the mark and none from this one on does.
bool is_done_with(const Lesson& lesson, std::size_t mark, std::size_t step) {
    const auto names = [&](const LessonStep& one) {
        return std::ranges::any_of(one.goal, [&](const Predicate& goal) {
            return goal.mark >= 0 && static_cast<std::size_t>(goal.mark) == mark;
        });
    };
    const auto now = lesson.steps.begin() + static_cast<std::ptrdiff_t>(step);
    return std::any_of(lesson.steps.begin(), now, names) &&
           std::none_of(now, lesson.steps.end(), names);
}

}  // namespace

std::vector<MarkView> views_of_marks(const Lesson& lesson, const std::vector<Vec3>& places_mm,
                                     std::size_t step) {
    std::vector<MarkView> marks;
    for (std::size_t i = 0; i < places_mm.size(); ++i)
        marks.push_back({places_mm[i], places_mm.size() > 1 ? std::to_string(i + 1) : std::string(),
                         is_done_with(lesson, i, std::min(step, lesson.steps.size()))});
    return marks;
}

}  // namespace hepatica
