// SPDX-License-Identifier: GPL-3.0-or-later
// What the editor starts with, in the language of the window. From then on it is the instructor's
// own text and is not translated.
#pragma once

#include <string>

#include "core/lesson/lesson.h"

namespace hepatica {

Lesson new_lesson_in_words();
// A copy of a built-in lesson; `id` as find_lesson() takes it.
Lesson built_in_lesson_in_words(const std::string& id);
LessonStep new_step_in_words();
// A name that no mark of the lesson has.
std::string free_mark_name_in_words(const Lesson& lesson);

}  // namespace hepatica
