// SPDX-License-Identifier: GPL-3.0-or-later
// Scores a recording: replays it and feeds every step to a LessonRun, as the live play did.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/job.h"
#include "core/lesson/lesson_run.h"
#include "core/scene/deform_back_end.h"
#include "core/session/recording.h"

namespace hepatica {

struct Score {
    LessonStanding standing;
    std::vector<LessonSample> samples;
};

// Called after every step with its frame and the standing, e.g. for a report's pictures.
using SeeScored = std::function<void(const Frame&, const LessonStanding&)>;

// Throws InputError where the recording belongs to another patient, scene or back end, or does not
// replay to the same bits, so that it proves nothing, at the first step that differs; Cancelled.
// Begins two stages of the job.
Score score(const Recording& recording, const Lesson& lesson,
            std::shared_ptr<const PatientCase> patient, Job& job,
            const DeformBackEnd& back_end = cpu_back_end(), const SeeScored& see = {});

// The first built-in lesson with the recorded scene, or nullopt.
std::optional<Lesson> built_in_lesson_of(const Recording& recording);

bool is_same_scene(const SceneSpec& recorded, const SceneSpec& wanted);
// Throws InputError unless the scenes agree in name, parts and settings, except the solver's
// accuracy, which may be chosen by the machine. The name distinguishes lessons with equal parts.
void require_same_scene(const SceneSpec& recorded, const SceneSpec& wanted);

}  // namespace hepatica
