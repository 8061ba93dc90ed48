// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons back into the files that lesson_file.h reads.
#pragma once

#include <filesystem>
#include <string>

#include "core/lesson/lesson.h"

namespace hepatica {

// The file's text, which reads as the same lesson again; the scene with all its settings. Any
// lesson, one that could not be read (a step without a goal) too.
std::string text_of(const Lesson& lesson);

// The text, whole or not at all. Throws InputError where lesson_of() would refuse it, saying what
// is missing, or where the file cannot be written.
void write_lesson(const std::filesystem::path& file, const Lesson& lesson);

}  // namespace hepatica
