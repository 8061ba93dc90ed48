// SPDX-License-Identifier: GPL-3.0-or-later
// Writes lessons and courses in the format of lesson_file.h.
#pragma once

#include <filesystem>
#include <string>

#include "core/lesson/lesson.h"
#include "core/lesson/lesson_file.h"

namespace hepatica {

// The text of the lesson's file, including all settings of the scene. Unfinished lessons are
// allowed.
std::string text_of(const Lesson& lesson);

// Writes the text atomically. Throws InputError where lesson_of() would refuse it, where two marks
// have the same name, or where the file cannot be written.
void write_lesson(const std::filesystem::path& file, const Lesson& lesson);

// Same for courses. Lessons that are files are relative to the course's folder.
std::string text_of(const Course& course);
void write_course(const std::filesystem::path& file, const Course& course);

}  // namespace hepatica
