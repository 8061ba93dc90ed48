// SPDX-License-Identifier: GPL-3.0-or-later
// A recording names its patient by a hash alone: finds the case that it was made of.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/job.h"
#include "core/lesson/lesson.h"
#include "core/opening/built_in_cache.h"
#include "core/patient/patient_case.h"
#include "core/session/recording.h"

namespace hepatica {

// The case `given`, or where that is empty the first beside the recording's file that has its
// patient, or the built-in patient where it is that. Without voxels. Reading a case costs a second
// at most; making the built-in patient, which is tried last and only where `built_in` says
// where it may be kept, some twenty. Announces the stages of that and `following_stages` of the
// caller's. Throws InputError where none is it, Cancelled.
PatientCase recorded_patient(const Recording& recording, const std::filesystem::path& file,
                             const std::filesystem::path& given, const BuiltInCache* built_in,
                             int following_stages, Job& job);

// The case that a lesson names, relative to its own file; `given` where that is not empty or the
// lesson names none.
std::filesystem::path case_of_lesson(const Lesson& lesson, const std::string& lesson_file,
                                     const std::filesystem::path& given);

}  // namespace hepatica
