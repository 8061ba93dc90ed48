// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the pieces of all training patients and trains the forest on them.
#include "core/training/link_training.h"

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/training/grown_forest.h"
#include "core/training/taught_pieces.h"

namespace hepatica {

namespace {

constexpr std::uint64_t patients_of_a_seed = 1000000;
constexpr std::uint64_t most_seed = 1000000000000;
constexpr std::size_t enough_pieces = 200;

// Hides the stages of one patient, so that each patient is one stage of the job.
std::vector<TaughtPiece> taught_quietly(const Teacher& teach, std::uint64_t number,
                                        double line_share, Job& job) {
    Job own;
    const std::stop_callback pass_on(job.stop_token(), [&] { own.cancel(); });
    return teach(number, line_share, own);
}

void require_sensible(const TrainingOptions& options) {
    if (options.volumes < 1 || options.volumes > 10000)
        throw InputError(std::to_string(options.volumes) + " patients cannot be used", "--volumes",
                         "Choose a number from 1 to 10000");
    if (options.seed < 1 || options.seed > most_seed)
        throw InputError(std::to_string(options.seed) + " is no seed", "--seed",
                         "Give a whole number from 1 to " + std::to_string(most_seed));
}

// The pieces of all patients, except of those that are refused.
std::vector<TaughtPiece> taught_by_all(const TrainingOptions& options, double line_share, Job& job,
                                       const OnLeftOut& on_left_out, const Teacher& teach) {
    std::vector<TaughtPiece> pieces;
    int left_out = 0;
    for (int volume = 1; volume <= options.volumes; ++volume) {
        job.begin_stage("Patient " + std::to_string(volume));
        const std::uint64_t number = patient_number(options.seed, volume);
        try {
            const auto taught = taught_quietly(teach, number, line_share, job);
            pieces.insert(pieces.end(), taught.begin(), taught.end());
        } catch (const InputError& reason) {
            if (on_left_out) on_left_out(number, reason);
            if (++left_out == options.volumes)
                throw InputError(
                    "all " + std::to_string(left_out) +
                        " patients were refused, the last one because: " + reason.what(),
                    "--volumes", "Ask for more patients, or for those of another seed");
        }
    }
    return pieces;
}

}  // namespace

std::uint64_t patient_number(std::uint64_t seed, int volume) {
    return seed * patients_of_a_seed + static_cast<std::uint64_t>(volume);
}

LinkModel trained_links(const TrainingOptions& options, Job& job, const OnLeftOut& on_left_out,
                        const Teacher& teach) {
    require_sensible(options);
    LinkModel model;
    model.made_by = "hepatica-cli train --seed " + std::to_string(options.seed) + " --volumes " +
                    std::to_string(options.volumes);
    job.expect_stages(options.volumes + 1);
    const std::vector<TaughtPiece> pieces =
        taught_by_all(options, model.line_share, job, on_left_out, teach);
    job.begin_stage("Growing the forest");
    if (pieces.size() < enough_pieces)
        throw InputError(
            "the patients taught only " + std::to_string(pieces.size()) + " pieces of vessels",
            "--volumes", "Ask for more patients");
    model.forest = grown_forest(pieces, ForestOptions{});
    return model;
}

}  // namespace hepatica
