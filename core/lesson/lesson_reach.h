// SPDX-License-Identifier: GPL-3.0-or-later
// What the bounds of a lesson demand before anyone has played it: whether doing nothing breaks a
// limit, whether an allowed tool can reach a goal, how long the steps take at least.
#pragma once

#include "core/lesson/lesson.h"

namespace hepatica {

// Returns true if the limit is broken before the trainee does anything. `first`: the limit applies
// from the beginning; for limits of later steps true only where it holds whatever was done before.
bool breaks_at_once(const Lesson& lesson, const Predicate& limit, bool first);

// Returns true if the goal is not reached by itself and no allowed tool can change its quantity.
// False where this is undecided: the lesson has a setup, or gravity acts.
bool tool_is_missing(const Lesson& lesson, const Predicate& goal);

// Returns true if the bound exceeds 1 on a share or a yes-or-no quantity, which are 1 at most.
bool above_one(const Predicate& bound);

// Least duration in s, from goals on time and holding times: of one step, and of the first `steps`
// steps.
double least_time_s(const LessonStep& step);
double least_time_s(const Lesson& lesson, std::size_t steps);

}  // namespace hepatica
