// SPDX-License-Identifier: GPL-3.0-or-later
// Goes through a recording once more and puts every frame, and what happened, onto a tape on which
// a person can look back.
#pragma once

#include <memory>
#include <optional>

#include "core/base/job.h"
#include "core/lesson/lesson_run.h"
#include "core/lesson/review_tape.h"
#include "core/scene/deform_back_end.h"
#include "core/session/recording.h"

namespace hepatica {

struct Review {
    std::optional<LessonStanding> standing;    // where a lesson was given
    std::optional<std::uint64_t> diverged_at;  // the first step that is not what was recorded
};

// With a lesson its steps and its end are events, too. A recording that does not replay to the same
// bits is gone through as well; where it begins to differ is an event. Throws InputError where the
// recording is of another patient or back end, of another scene than the lesson's, or holds no
// step; Cancelled. Begins two stages of the job.
Review review(const Recording& recording, const std::optional<Lesson>& lesson,
              std::shared_ptr<const PatientCase> patient, ReviewTape& tape, Job& job,
              const DeformBackEnd& back_end = cpu_back_end());

}  // namespace hepatica
