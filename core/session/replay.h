// SPDX-License-Identifier: GPL-3.0-or-later
// Plays a recording again and compares the state after every step.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/base/job.h"
#include "core/patient/patient_case.h"
#include "core/session/recording.h"

namespace hepatica {

struct ReplayResult {
    std::uint64_t began_at = 0;                // step of the keyframe it began with; 0: the start
    std::uint64_t steps = 0;                   // number of the last step
    std::optional<std::uint64_t> diverged_at;  // first step (from 1) whose hash differs
    std::uint64_t state_hash = 0;              // after the last step
};

// Begins with the last keyframe at or before `from_step`, or else at rest. Throws InputError if the
// patient is another one, if there is no such step, or if the keyframe is damaged; Cancelled.
// Progress through the job.
ReplayResult replay(const Recording& recording, std::shared_ptr<const PatientCase> patient,
                    Job& job, std::uint64_t from_step = 0);

}  // namespace hepatica
