// SPDX-License-Identifier: GPL-3.0-or-later
// Finds what keeps a lesson that is being edited from being played, in sentences for its author.
#pragma once

#include <string>
#include <vector>

#include "core/lesson/lesson.h"

namespace hepatica {

// E.g. 'Step 2 "Pull the vessel at the mark"'; throws std::out_of_range for a step that does not
// exist.
std::string step_in_words(const Lesson& lesson, std::size_t step);

// One sentence per gap, with advice: empty texts, a goal without a bound, a bound that has lost its
// mark, a tool that is not allowed, an empty scene. If there is none, lesson_of() accepts the
// lesson's text, except for values that the editor cannot change.
std::vector<std::string> gaps_in(const Lesson& lesson);

}  // namespace hepatica
