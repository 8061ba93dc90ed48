// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/replay.h"

#include <exception>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"

namespace hepatica {

namespace {

// The last keyframe that is not after the step; null where there is none.
const RecordedStep* keyframe_before(const Recording& recording, std::uint64_t step) {
    if (step > recording.steps.size())
        throw InputError("step " + std::to_string(step) + " is behind the end", "recording",
                         "It has " + std::to_string(recording.steps.size()) + " steps");
    for (std::uint64_t i = step; i > 0; --i)
        if (recording.steps[i - 1].keyframe) return &recording.steps[i - 1];
    return nullptr;
}

}  // namespace

void require_back_end(const Recording& recording, const DeformBackEnd& back_end) {
    if (recording.back_end != back_end.name)
        throw InputError("was computed by the back end \"" + recording.back_end +
                             "\", and this is \"" + back_end.name + "\"",
                         "recording", "Replay it with the back end that recorded it");
}

void restore_recorded(Session& session, Keyframe keyframe) {
    keyframe.automatic = false;
    session.restore(keyframe);
}

ReplayResult replay(const Recording& recording, std::shared_ptr<const PatientCase> patient,
                    Job& job, std::uint64_t from_step, const DeformBackEnd& back_end,
                    const Session::Watch& watch, AfterDivergence after) {
    require_back_end(recording, back_end);
    if (hash_of(*patient) != recording.patient_hash)
        throw InputError(
            "is not the patient that was recorded", "patient",
            "Give the case whose tree and mesh have the hash " + to_hex(recording.patient_hash));
    const RecordedStep* start = keyframe_before(recording, from_step);
    Session session(std::move(patient), recording.scene, job, back_end);
    ReplayResult result;
    if (start == nullptr && recording.begin) restore_recorded(session, *recording.begin);
    if (start != nullptr) {
        restore_recorded(session, *start->keyframe);
        result.began_at = result.steps = start->keyframe->step;
        result.state_hash = session.state_hash();
        if (result.state_hash != start->state_hash)
            throw InputError("the keyframe of step " + std::to_string(result.steps) +
                                 " is not the state that was recorded",
                             "recording", "Begin at an earlier step");
    }
    // The session would take itself back after an error of its watch, and what follows would be
    // taken for another play: the replay ends with the error instead.
    std::exception_ptr error_of_watch;
    if (watch)
        session.watch([&](const std::vector<Command>& commands, const Frame& frame,
                          const std::stop_token& stop) {
            try {
                return watch(commands, frame, stop);
            } catch (...) {
                error_of_watch = std::current_exception();
                return false;
            }
        });
    session.record([](const RecordedStep&) {});  // hashes are computed only while recording
    job.begin_stage("Replaying");
    const std::uint64_t count = recording.steps.size();
    while (result.steps < count) {
        const RecordedStep& step = recording.steps[result.steps];
        for (const Command& command : step.commands) session.post(command);
        result.state_hash = session.step(job).state_hash;
        if (error_of_watch) std::rethrow_exception(error_of_watch);
        ++result.steps;
        if (!result.diverged_at && result.state_hash != step.state_hash)
            result.diverged_at = result.steps;
        if (result.diverged_at && after == AfterDivergence::stop) break;
        job.advance(static_cast<double>(result.steps - result.began_at) /
                    static_cast<double>(count - result.began_at));
    }
    return result;
}

}  // namespace hepatica
