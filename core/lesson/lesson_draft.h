// SPDX-License-Identifier: GPL-3.0-or-later
// What the lesson editor starts from, and its edits that change more than one value.
#pragma once

#include <functional>
#include <string>

#include "core/lesson/lesson.h"

namespace hepatica {

// A complete lesson on any patient: a gentle pull at a mark in the middle of the longest path.
Lesson new_lesson();

// A new id for a lesson, by chance.
std::string new_lesson_id();

// A valid step: wait for 5 s.
LessonStep new_step();

// Removes the mark with this index (it must exist). Bounds on it stay with mark -1, which gaps_in()
// reports; the indices of later marks are adjusted everywhere.
void remove_mark(Lesson& lesson, int mark);

// A place for another mark, as a share of the longest path: the middle, or where it is farthest
// from the marks that are shares; those that are points lie wherever somebody clicked. `is_hidden`:
// whether the place at a share cannot be seen; it is taken only where all that is seen is taken.
ScriptPlace free_place(const Lesson& lesson,
                       const std::function<bool(double share)>& is_hidden = {});

// The first free name of "mark 1", "mark 2", ...
std::string free_mark_name(const Lesson& lesson);

}  // namespace hepatica
