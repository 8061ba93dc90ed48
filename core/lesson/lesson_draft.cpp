// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_draft.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>

#include "core/base/hash.h"

namespace hepatica {

namespace {

void forget(std::vector<Predicate>& bounds, int mark) {
    for (Predicate& bound : bounds)
        if (bound.mark == mark)
            bound.mark = -1;
        else if (bound.mark > mark)
            --bound.mark;
}

}  // namespace

std::string new_lesson_id() {
    std::random_device random;
    return to_hex(std::uint64_t{random()} << 32U | random());
}

LessonStep new_step() {
    LessonStep step;
    step.text = "What the trainee is to do.";
    step.goal = {{Quantity::step_time_s, -1, true, 5.0}};
    return step;
}

Lesson new_lesson() {
    Lesson lesson;
    lesson.name = "A new lesson";
    lesson.scene = default_scene();
    lesson.scene.name = "lesson";
    lesson.scene.flow.reset();
    lesson.tools = {LessonTool::pull};
    lesson.marks = {{"mark 1", {std::nullopt, 0.5}}};
    LessonStep step;
    // Without the goal's numbers, which are shown beside it and may be changed.
    step.text = "Pull the vessel at the mark aside and hold it there.";
    step.hint = "Slowly.";
    step.goal = {{Quantity::moved_mm, 0, true, 5.0}};
    step.hold_s = 1.0;
    lesson.steps = {step};
    // Stretch and not force: the force that moves a vessel grows with its section, and no limit on
    // it suits every patient. Measured in docs/lessons.md, Making a lesson.
    lesson.limits = {{Quantity::largest_stretch, -1, false, 1.5}};
    lesson.pass = {{Quantity::time_s, -1, false, 60.0}};
    return lesson;
}

void remove_mark(Lesson& lesson, int mark) {
    lesson.marks.erase(lesson.marks.begin() + mark);
    for (LessonStep& step : lesson.steps) {
        forget(step.goal, mark);
        forget(step.limits, mark);
    }
    forget(lesson.limits, mark);
    forget(lesson.pass, mark);
}

ScriptPlace free_place(const Lesson& lesson, const std::function<bool(double)>& is_hidden) {
    const auto room = [&](double share) {
        double least = 1.0;
        for (const LessonMark& mark : lesson.marks)
            if (const std::optional<double> other = mark.place.share_of_longest_path)
                least = std::min(least, std::abs(*other - share));
        return least;
    };
    const auto worth = [&](double share) {
        constexpr double least_room = 0.04;
        const bool seen = !is_hidden || !is_hidden(share);
        return std::pair(seen && room(share) > least_room, room(share));
    };
    // Neither in the trunk nor at the very end. The middle comes first and wins where all are free.
    constexpr double middle = 0.5;
    constexpr int first = 4, last = 18;  // in twentieths
    double best = middle;
    std::pair<bool, double> most = worth(middle);
    for (int k = first; k <= last; ++k) {
        const std::pair<bool, double> here = worth(0.05 * k);
        const bool better =
            here.first != most.first ? here.first : here.second > most.second + 1e-9;
        if (!better) continue;
        best = 0.05 * k;
        most = here;
    }
    return {std::nullopt, best};
}

std::string free_mark_name(const Lesson& lesson) {
    const std::vector<std::string> names = lesson.mark_names();
    for (int number = 1;; ++number) {
        std::string name = "mark " + std::to_string(number);
        if (std::ranges::find(names, name) == names.end()) return name;
    }
}

}  // namespace hepatica
