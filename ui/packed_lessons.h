// SPDX-License-Identifier: GPL-3.0-or-later
// The lessons for a case inside its file NAME.hepz (core/patient/case_archive.h): lesson-1.json,
// lesson-2.json, ... with the patient ".", so that they are right beside an unpacked case, too. No
// widgets.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/lesson/lesson.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// The lessons in an archive, none where there is no archive. One that is damaged is left out.
// Throws InputError where the archive cannot be read.
std::vector<Lesson> lessons_in_archive(const std::filesystem::path& archive);

// Those without the ones for its case that lie beside the archive under the same names: they were
// put there before, and may have been changed since. Throws as lessons_in_archive(), and Cancelled.
std::vector<Lesson> lessons_not_beside(const std::filesystem::path& archive, Job& job);

// Whether the archive holds a lesson, readable or not.
bool holds_lessons(const std::filesystem::path& archive);

// Throws InputError where write_with_lessons() would refuse the place for what is there: a folder,
// or a file that is no case. To be called before long work.
void require_place_of_file(const std::filesystem::path& archive);

// Adds the lessons to an archive of their case that holds none. Throws InputError where a lesson is
// unfinished, there are more than 40, or the archive cannot be written.
void pack_lessons(const std::vector<Lesson>& lessons, const std::filesystem::path& archive);

// Writes the case and the lessons into one file, of which an older one, with its lessons, is
// replaced atomically. Throws InputError as write_case() and pack_lessons(); the older one then
// stays as it was.
void write_with_lessons(const std::filesystem::path& archive, const PatientCase& patient,
                        const std::vector<Lesson>& lessons);

// Writes the lessons beside the case at `place` as lessons for it, called as they say; a name that
// is taken gets a number. Returns the files. Throws InputError where one cannot be written.
std::vector<std::filesystem::path> put_beside(const std::vector<Lesson>& lessons,
                                              const std::filesystem::path& place);

}  // namespace hepatica
