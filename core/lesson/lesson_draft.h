// SPDX-License-Identifier: GPL-3.0-or-later
// What an editor of lessons begins with, and what it does to a lesson beside setting its values.
#pragma once

#include "core/lesson/lesson.h"

namespace hepatica {

// A whole lesson on any patient: a gentle pull at a mark in the middle of the longest path.
Lesson new_lesson();

// A step that can be reached.
LessonStep new_step();

// Without this mark. The bounds that name it stay, with no mark (-1): gaps_in() names them until
// another mark is chosen for each, or they are removed.
void remove_mark(Lesson& lesson, int mark);

// A name that no mark of the lesson has: "mark 1", "mark 2", ...
std::string free_mark_name(const Lesson& lesson);

}  // namespace hepatica
