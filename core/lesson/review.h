// SPDX-License-Identifier: GPL-3.0-or-later
// Replays a recording and puts its frames and events on a tape for review.
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
    std::optional<LessonStanding> standing;    // if a lesson was given
    std::optional<std::uint64_t> diverged_at;  // first step (from 1) that differs
};

// With a lesson its steps and its end are events, too. A recording that does not replay to the same
// bits is still reviewed; the first difference is an event. Throws InputError where the recording
// belongs to another patient or back end, has another scene than the lesson, or no steps;
// Cancelled. Begins two stages of the job. `interrupted`: a crash cut the play off, so that its end
// is no verdict (see interrupted_beside()).
Review review(const Recording& recording, const std::optional<Lesson>& lesson,
              std::shared_ptr<const PatientCase> patient, ReviewTape& tape, Job& job,
              const DeformBackEnd& back_end = cpu_back_end(), bool interrupted = false);

// How long the play took, without its pauses, as far as its commands tell: one that the solver
// stopped is shorter.
double played_s(const Recording& recording);

}  // namespace hepatica
