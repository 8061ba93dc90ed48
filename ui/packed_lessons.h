// SPDX-License-Identifier: GPL-3.0-or-later
// The lessons for a case inside its file NAME.hepz (core/patient/case_archive.h): lesson-1.json,
// lesson-2.json, ... with the patient ".", so that they are right beside an unpacked case, too. No
// widgets.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/lesson/lesson.h"

namespace hepatica {

// The lessons in an archive, none where there is no archive. One that is damaged is left out.
// Throws InputError where the archive cannot be read.
std::vector<Lesson> lessons_in_archive(const std::filesystem::path& archive);

// Adds the lessons to an archive of their case that holds none. Throws InputError where a lesson is
// unfinished, there are more than 40, or the archive cannot be written.
void pack_lessons(const std::vector<Lesson>& lessons, const std::filesystem::path& archive);

// Writes the lessons beside the case at `place` as lessons for it, called as they say; a name that
// is taken gets a number. Returns the files. Throws InputError where one cannot be written.
std::vector<std::filesystem::path> put_beside(const std::vector<Lesson>& lessons,
                                              const std::filesystem::path& place);

}  // namespace hepatica
