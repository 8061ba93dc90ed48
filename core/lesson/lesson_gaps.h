// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps a lesson that is being made from being played, in a person's words: the steps by
// number and title, as the editor shows them.
#pragma once

#include <string>
#include <vector>

#include "core/lesson/lesson.h"

namespace hepatica {

// 'Step 2 "Pull the vessel at the mark"', of a step that the lesson has.
std::string step_in_words(const Lesson& lesson, std::size_t step);

// A sentence each, with what would help: empty texts, a goal without a bound, a bound that has lost
// its mark, a scene of nothing. None where lesson_of() would read the lesson's text, but for what
// no editor changes.
std::vector<std::string> gaps_in(const Lesson& lesson);

}  // namespace hepatica
