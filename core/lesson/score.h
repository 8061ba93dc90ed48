// SPDX-License-Identifier: GPL-3.0-or-later
// Scores a recording: plays it again and shows every step to a LessonRun, as the live play did.
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

// Called after every step with its frame and how the attempt stands then: for pictures of a report.
using SeeScored = std::function<void(const Frame&, const LessonStanding&)>;

// Throws InputError where the recording is of another patient, scene or back end, or does not
// replay to the same bits (it is then no evidence); Cancelled. Begins two stages of the job.
Score score(const Recording& recording, const Lesson& lesson,
            std::shared_ptr<const PatientCase> patient, Job& job,
            const DeformBackEnd& back_end = cpu_back_end(), const SeeScored& see = {});

// The lesson that comes with the program and has the recorded scene; none where none has.
std::optional<Lesson> built_in_lesson_of(const Recording& recording);

bool is_same_scene(const SceneSpec& recorded, const SceneSpec& wanted);
// Throws InputError unless the scenes have the same name, parts and settings but for the solver's
// accuracy, which the machine may choose. The name tells lessons apart that are played in scenes of
// the same parts.
void require_same_scene(const SceneSpec& recorded, const SceneSpec& wanted);

}  // namespace hepatica
