// SPDX-License-Identifier: GPL-3.0-or-later
// replay: plays a recording again and compares the state of every step (core/session/replay.h).
#include <spdlog/spdlog.h>

#include <filesystem>

#include "app/back_end_choice.h"
#include "app/recorded_patient.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/patient/patient_case.h"
#include "core/session/recording_file.h"
#include "core/session/replay.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct ReplayChoices {
    fs::path file;
    fs::path patient;
    std::uint64_t from_step = 0;
    bool verify = false;
};

Json run_replay(const ReplayChoices& options, Job& job) {
    const Recording recording = read_recording(options.file);
    for (const std::string& warning : recording.warnings) spdlog::warn("{}", warning);
    if (options.from_step > recording.steps.size())
        throw InputError("is behind the end of the recording, which has " +
                             std::to_string(recording.steps.size()) + " steps",
                         "--from-step " + std::to_string(options.from_step),
                         "Name an earlier step");
    constexpr int building_and_replaying = 2;
    auto patient = std::make_shared<const PatientCase>(recorded_patient(
        recording, options.file, options.patient, nullptr, building_and_replaying, job));
    const ReplayResult result = replay(
        recording, patient, job, options.from_step, choose_back_end(recording.back_end).back_end,
        {}, options.verify ? AfterDivergence::stop : AfterDivergence::go_on);
    if (options.verify && result.diverged_at)
        throw InputError(
            "diverged from the recording at step " + std::to_string(*result.diverged_at),
            options.file.string(), "Another build of the program or another processor made it");
    if (result.diverged_at)
        spdlog::warn(
            "it diverged from the recording at step {}: another build of the program or "
            "another processor made it",
            *result.diverged_at);
    Json answer{{"steps", result.steps}, {"began_at", result.began_at}};
    answer["diverged_at"] = result.diverged_at ? Json(*result.diverged_at) : Json(nullptr);
    answer["state_hash"] = to_hex(result.state_hash);
    answer["warnings"] = recording.warnings;
    return answer;
}

}  // namespace

void add_replay(CommandLine& line) {
    auto options = std::make_shared<ReplayChoices>();
    CLI::App& verb = line.add_verb("replay", "Play a recording again and compare every step",
                                   [options](Job& job) { return run_replay(*options, job); });
    verb.add_option("file", options->file, "Recording")->required();
    verb.add_option("--patient", options->patient,
                    "Case that was recorded; none: the one beside the recording that fits");
    verb.add_option("--from-step", options->from_step,
                    "Begin at the last keyframe (every ten seconds of play) at or before this step")
        ->check(whole_number_from(0));
    verb.add_flag("--verify", options->verify, "Fail (exit code 1) where it diverges");
}

}  // namespace hepatica
