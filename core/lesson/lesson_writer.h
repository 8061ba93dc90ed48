// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons and courses back into the files that lesson_file.h reads.
#pragma once

#include <filesystem>
#include <string>

#include "core/lesson/lesson.h"
#include "core/lesson/lesson_file.h"

namespace hepatica {

// The file's text, which reads as the same lesson again; the scene with all its settings. Any
// lesson, one that could not be read (a step without a goal) too.
std::string text_of(const Lesson& lesson);

// The text, whole or not at all. Throws InputError where lesson_of() would refuse it, saying what
// is missing, or where the file cannot be written.
void write_lesson(const std::filesystem::path& file, const Lesson& lesson);

// The same of a course. Its lessons that are files lie relative to the course's own folder.
std::string text_of(const Course& course);
void write_course(const std::filesystem::path& file, const Course& course);

}  // namespace hepatica
