// SPDX-License-Identifier: GPL-3.0-or-later
// What the editor begins with, in the language of the window: from then on it is the instructor's
// own text, which nobody translates.
#pragma once

#include <string>

#include "core/lesson/lesson.h"

namespace hepatica {

Lesson new_lesson_in_words();
// A copy of a lesson that comes with the program.
Lesson built_in_lesson_in_words(const std::string& id);
LessonStep new_step_in_words();
// That no mark of the lesson has.
std::string free_mark_name_in_words(const Lesson& lesson);

}  // namespace hepatica
