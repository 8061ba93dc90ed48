// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_reach.h"

#include <algorithm>
#include <cmath>

#include "core/lesson/metrics.h"

namespace hepatica {

namespace {

// Initial value; NaN: unknown, which breaks no limit.
double first_value_of(const Lesson& lesson, const Predicate& bound) {
    if (words_of(bound.quantity).of_mark && bound.mark < 0) return std::nan("");
    LessonMoment moment;
    moment.marks.resize(lesson.marks.size());
    return value_of(bound, {}, moment, 0.0);
}

// Begins at infinity and decreases; all others begin at their minimum.
bool begins_far(Quantity quantity) {
    return quantity == Quantity::distance_mm || quantity == Quantity::touch_mm;
}

// The tools that can change a quantity; empty: it changes by itself.
std::vector<LessonTool> tools_that_move(Quantity quantity) {
    using enum Quantity;
    using enum LessonTool;
    switch (quantity) {
        case time_s:
        case step_time_s:
            return {};
        case contacts:
        case contact_s:
        case touch_mm:
            return {sphere, capsule, forceps, hook};
        case grip_mn:
            return {forceps};
        case injected_g:
        case delivered_g:
        case dose_target_g:
        case dose_elsewhere_g:
        case reflux_g:
        case dose_target_share:
        case target_filled:
        case elsewhere_filled:
        case drug_present:
            return {inject};
        case largest_stretch:
        case stretch:
        case moved_mm:
        case joints_broken:
        case pieces_off:
        case torn_area_mm2:
        case blood_lost_g:
        case leak_g_s:
            return {pull, sphere, capsule, forceps, hook, blade, cut_line, settings};
        default:  // quantities of the hand and of tools
            return {pull, sphere, capsule, forceps, hook};
    }
}

}  // namespace

bool breaks_at_once(const Lesson& lesson, const Predicate& limit, bool first) {
    const double value = first_value_of(lesson, limit);
    if (std::isnan(value)) return false;
    // The clock has already advanced at the first check.
    if (limit.quantity == Quantity::step_time_s || (first && limit.quantity == Quantity::time_s))
        return limit.at_least ? limit.bound > 0.0 : limit.bound <= 0.0;
    if (!limit.at_least && !begins_far(limit.quantity)) return limit.bound < value;
    return first && lesson.setup.actions.empty() && !limit.holds(value);
}

bool tool_is_missing(const Lesson& lesson, const Predicate& goal) {
    const double value = first_value_of(lesson, goal);
    const std::vector<LessonTool> tools = tools_that_move(goal.quantity);
    const bool by_itself = tools.empty() || goal.holds(value) || !lesson.setup.actions.empty();
    const bool falls = lesson.scene.deform && !lesson.scene.deform->gravity_mm_per_s2.isZero() &&
                       std::ranges::find(tools, LessonTool::settings) != tools.end();
    if (by_itself || falls) return false;
    return std::ranges::none_of(lesson.tools, [&](LessonTool tool) {
        return std::ranges::find(tools, tool) != tools.end();
    });
}

bool above_one(const Predicate& bound) {
    using enum Quantity;
    switch (bound.quantity) {
        case dose_target_share:
        case target_filled:
        case elsewhere_filled:
        case drug_present:
        case holding:
            return bound.bound > 1.0;
        default:
            return false;
    }
}

double least_time_s(const LessonStep& step) {
    double waited_s = 0.0;
    for (const Predicate& goal : step.goal)
        if (goal.quantity == Quantity::step_time_s && goal.at_least)
            waited_s = std::max(waited_s, goal.bound);
    return waited_s + step.hold_s;
}

double least_time_s(const Lesson& lesson, std::size_t steps) {
    double passed_s = 0.0;
    for (std::size_t i = 0; i < steps; ++i) {
        const LessonStep& step = lesson.steps.at(i);
        double end_s = passed_s + least_time_s(step);
        for (const Predicate& goal : step.goal)
            if (goal.quantity == Quantity::time_s && goal.at_least)
                end_s = std::max(end_s, goal.bound + step.hold_s);
        passed_s = end_s;
    }
    return passed_s;
}

}  // namespace hepatica
