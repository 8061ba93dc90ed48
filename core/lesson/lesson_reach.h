// SPDX-License-Identifier: GPL-3.0-or-later
// What bounds of a lesson ask of a play before anybody has played it: whether a limit is broken by
// doing nothing, whether a tool that is allowed can reach a goal, how long the steps take at least.
#pragma once

#include "core/lesson/lesson.h"

namespace hepatica {

// By what is so when the lesson begins, before the trainee does anything. A limit of a later step
// (`first` false) only where that is sure whatever was done before.
bool breaks_at_once(const Lesson& lesson, const Predicate& limit, bool first);

// A goal that is not reached by itself, and that none of the tools moves which the lesson allows.
// False where there is no saying: something is set up, or gravity pulls.
bool tool_is_missing(const Lesson& lesson, const Predicate& goal);

// No share and no yes or no is ever above 1.
bool above_one(const Predicate& bound);

// What the goals' own times and their holding take, s: of a step alone, and from the beginning to
// the end of this many steps.
double least_time_s(const LessonStep& step);
double least_time_s(const Lesson& lesson, std::size_t steps);

}  // namespace hepatica
