// SPDX-License-Identifier: GPL-3.0-or-later
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "app/back_end_choice.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/patient/patient_case.h"
#include "core/session/recording_file.h"
#include "core/session/replay.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct Options {
    fs::path file;
    fs::path patient;
    std::uint64_t from_step = 0;
    bool verify = false;
};

std::vector<fs::path> cases_beside(const fs::path& file) {
    std::vector<fs::path> cases;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::absolute(file).parent_path()))
        if (is_case(entry.path())) cases.push_back(entry.path());
    std::ranges::sort(cases);
    return cases;
}

// A recording names its patient by a hash alone: the case is the one given, or else the first
// beside the recording that has this hash. Reading a case costs a second at most.
PatientCase patient_of(const Recording& recording, const Options& options, Job& job) {
    if (!options.patient.empty()) return read_case_without_voxels(options.patient);
    for (const fs::path& folder : cases_beside(options.file)) {
        job.throw_if_cancelled();
        try {
            PatientCase patient = read_case_without_voxels(folder);
            if (hash_of(patient) == recording.patient_hash) return patient;
        } catch (const InputError& error) {
            spdlog::warn("{} is passed over: {}", folder.string(), error.problem());
        }
    }
    throw InputError("no case beside it has the patient that was recorded, whose hash is " +
                         to_hex(recording.patient_hash),
                     options.file.string(), "Name the case: --patient CASE");
}

Json run(const Options& options, Job& job) {
    const Recording recording = read_recording(options.file);
    for (const std::string& warning : recording.warnings) spdlog::warn("{}", warning);
    job.expect_stages(3);
    job.begin_stage("Reading the case");
    auto patient = std::make_shared<const PatientCase>(patient_of(recording, options, job));
    const ReplayResult result = replay(recording, patient, job, options.from_step,
                                       choose_back_end(recording.back_end).back_end);
    if (options.verify && result.diverged_at)
        throw InputError(
            "diverged from the recording at step " + std::to_string(*result.diverged_at),
            options.file.string(), "Another build of the program or another processor made it");
    Json answer{{"steps", result.steps}, {"began_at", result.began_at}};
    answer["diverged_at"] = result.diverged_at ? Json(*result.diverged_at) : Json(nullptr);
    answer["state_hash"] = to_hex(result.state_hash);
    answer["warnings"] = recording.warnings;
    return answer;
}

}  // namespace

void add_replay(CommandLine& line) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = line.add_verb("replay", "Play a recording again and compare every step",
                                   [options](Job& job) { return run(*options, job); });
    verb.add_option("file", options->file, "Recording")->required();
    verb.add_option("--patient", options->patient,
                    "Case that was recorded; none: the one beside the recording that fits");
    verb.add_option(
        "--from-step", options->from_step,
        "Begin at the last keyframe (every ten seconds of play) at or before this step");
    verb.add_flag("--verify", options->verify, "Fail (exit code 1) where it diverges");
}

}  // namespace hepatica
