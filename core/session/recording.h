// SPDX-License-Identifier: GPL-3.0-or-later
// A session that can be played again: which patient and scene it began with, the commands of every
// step, and a hash of the state after each. Replay runs the commands and says where it diverged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/patient/patient_case.h"
#include "core/scene/scene_spec.h"
#include "core/session/command.h"

namespace hepatica {

struct RecordedStep {
    std::vector<Command> commands;  // applied before the step, in order
    std::uint64_t state_hash = 0;   // after it
};

struct Recording {
    std::string patient_path;        // the case; relative paths start at the recording's folder
    std::uint64_t patient_hash = 0;  // of tree and mesh, see hash_of(PatientCase)
    SceneSpec scene;
    std::vector<RecordedStep> steps;
};

// JSON lines: a header, then one line per step. Written atomically; throw InputError that names the
// file and line.
void write_recording(const std::filesystem::path& file, const Recording& recording);
Recording read_recording(const std::filesystem::path& file);

struct ReplayResult {
    std::uint64_t steps = 0;
    std::optional<std::uint64_t> diverged_at;  // first step (from 1) whose hash differs
    std::uint64_t state_hash = 0;              // after the last step
};

// Plays a recording on its patient from the start. Throws InputError if the patient is another one,
// Cancelled. Progress through the job.
ReplayResult replay(const Recording& recording, std::shared_ptr<const PatientCase> patient,
                    Job& job);

}  // namespace hepatica
