// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the case of a recording, which names its patient only by a hash.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/job.h"
#include "core/lesson/lesson.h"
#include "core/opening/built_in_cache.h"
#include "core/patient/patient_case.h"
#include "core/session/recording.h"

namespace hepatica {

// Returns the case `given`; where that is empty the first case beside the recording's file with its
// patient; or else the built-in patient, with his name, if it is that one. Without voxels. Reading
// a case takes up to a second, making the built-in patient about twenty; the latter is tried last,
// and only where `built_in` (the place of its cache) is not null. Announces the stages of this and
// `following_stages` of the caller's. Throws InputError where no case fits; Cancelled.
PatientCase recorded_patient(const Recording& recording, const std::filesystem::path& file,
                             const std::filesystem::path& given, const BuiltInCache* built_in,
                             int following_stages, Job& job);

// The case that a lesson names, relative to its own file; `given` where that is not empty or the
// lesson names none.
std::filesystem::path case_of_lesson(const Lesson& lesson, const std::string& lesson_file,
                                     const std::filesystem::path& given);

}  // namespace hepatica
