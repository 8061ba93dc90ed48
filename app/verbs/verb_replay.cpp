// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/patient/patient_case.h"
#include "core/session/recording.h"

namespace hepatica {

namespace {

struct Options {
    std::filesystem::path file;
    bool verify = false;
};

Json run(const Options& options, Job& job) {
    const Recording recording = read_recording(options.file);
    job.expect_stages(3);
    job.begin_stage("Reading the case");
    auto patient = std::make_shared<const PatientCase>(read_case_without_voxels(
        std::filesystem::absolute(options.file).parent_path() / recording.patient_path));
    const ReplayResult result = replay(recording, patient, job);
    if (options.verify && result.diverged_at)
        throw InputError(
            "diverged from the recording at step " + std::to_string(*result.diverged_at),
            options.file.string(), "Another version of the program or another processor made it");
    Json answer{{"steps", result.steps}};
    answer["diverged_at"] = result.diverged_at ? Json(*result.diverged_at) : Json(nullptr);
    answer["state_hash"] = to_hex(result.state_hash);
    return answer;
}

}  // namespace

void add_replay(CommandLine& line) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = line.add_verb("replay", "Play a recording again and compare every step",
                                   [options](Job& job) { return run(*options, job); });
    verb.add_option("file", options->file, "Recording")->required();
    verb.add_flag("--verify", options->verify, "Fail (exit code 1) where it diverges");
}

}  // namespace hepatica
