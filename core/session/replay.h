// SPDX-License-Identifier: GPL-3.0-or-later
// Plays a recording again and compares the state after every step.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/base/job.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_back_end.h"
#include "core/session/recording.h"
#include "core/session/session.h"

namespace hepatica {

struct ReplayResult {
    std::uint64_t began_at = 0;  // step of the keyframe where it began; 0: the recording's start
    std::uint64_t steps = 0;     // number of the last step that was replayed
    std::optional<std::uint64_t> diverged_at;  // first step (from 1) whose hash differs
    std::uint64_t state_hash = 0;              // of the state after the last step
};

// Throws InputError where the recording is of another back end, whose steps have other bits.
void require_back_end(const Recording& recording, const DeformBackEnd& back_end);

// Restores a state of a recording. The session then chooses no settings by itself, because they
// come from the recorded commands.
void restore_recorded(Session& session, Keyframe keyframe);

// What follows the first step whose hash is another one is another play: it serves who only looks,
// and nobody who judges.
enum class AfterDivergence { go_on, stop };

// Starts at the last keyframe that is not after `from_step`, or at the recording's start. Throws
// InputError if the patient or the back end is another one, if there is no such step, or if the
// keyframe is damaged; throws Cancelled. Reports progress to the job. `watch` sees every replayed
// step, see Session::watch; what it throws ends the replay and is thrown on.
ReplayResult replay(const Recording& recording, std::shared_ptr<const PatientCase> patient,
                    Job& job, std::uint64_t from_step = 0,
                    const DeformBackEnd& back_end = cpu_back_end(),
                    const Session::Watch& watch = {},
                    AfterDivergence after = AfterDivergence::go_on);

}  // namespace hepatica
