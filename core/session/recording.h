// SPDX-License-Identifier: GPL-3.0-or-later
// A session that can be played again to the last bit: which patient and scene it began with, the
// commands of every step, a hash of the state after each, and every ten seconds of play a state in
// which a replay can begin. Nothing in it names the patient: only a hash of tree and mesh does.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/scene/scene_spec.h"
#include "core/scene/world_checkpoint.h"
#include "core/session/command.h"

namespace hepatica {

// A session after a step in which it was not paused, so that it is not.
struct Keyframe {
    std::uint64_t step = 0;          // the number of that step
    std::uint64_t played_steps = 0;  // of all up to it, those that were not paused
    bool automatic = false;          // the session picked the setting
    WorldCheckpoint world;
};

struct RecordedStep {
    std::vector<Command> commands;             // applied before the step, in order
    std::uint64_t state_hash = 0;              // after it
    std::shared_ptr<const Keyframe> keyframe;  // after it; usually none
};

struct Recording {
    std::string program;             // its version
    std::string back_end;            // that computed the body, see DeformBackEnd
    std::uint64_t patient_hash = 0;  // of tree and mesh, see hash_of(PatientCase)
    SceneSpec scene;
    std::vector<RecordedStep> steps;
    std::vector<std::string> warnings;  // of reading it
};

// The version of this program, as recordings name it.
std::string program_version();

}  // namespace hepatica
