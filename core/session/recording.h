// SPDX-License-Identifier: GPL-3.0-or-later
// A session that can be replayed to the last bit: a hash of the patient, the scene, the commands of
// every step, a hash of the state after each step, and a full state (keyframe) every ten seconds of
// play, where a replay can start. It begins with a new scene or with a full state during a play.
// The date of the play may stand with it. The patient is identified only by the hash of tree and
// mesh.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/scene/scene_spec.h"
#include "core/scene/world_checkpoint.h"
#include "core/session/command.h"

namespace hepatica {

// The state of a session after a step. Taken only while the session is not paused.
struct Keyframe {
    std::uint64_t step = 0;          // number of the step
    std::uint64_t played_steps = 0;  // steps up to this one during which it was not paused
    bool automatic = false;          // whether the session chooses the setting
    WorldCheckpoint world;
};

struct RecordedStep {
    std::vector<Command> commands;             // applied before the step, in order
    std::uint64_t state_hash = 0;              // of the state after the step
    std::shared_ptr<const Keyframe> keyframe;  // of the state after the step; null in most steps
};

struct Recording {
    std::string program;             // version of the program that recorded it
    std::string back_end;            // name of the DeformBackEnd that computed the body
    std::uint64_t patient_hash = 0;  // of tree and mesh, see hash_of(PatientCase)
    SceneSpec scene;
    // When it was played: UTC in ISO 8601 ("2026-11-23T13:20:05Z"), given by who records, since
    // core asks no clock; empty: not known, as of a script, whose recordings are the same in every
    // run.
    std::string played_at;
    // The state at the start, with step number 0; null: at rest, with a new scene.
    std::shared_ptr<const Keyframe> begin;
    std::vector<RecordedStep> steps;
    std::vector<std::string> warnings;  // from reading the file
};

// The version of this program as it appears in recordings.
std::string program_version();

}  // namespace hepatica
