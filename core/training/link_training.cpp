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
std::vector<TaughtPiece> taught_quietly(std::uint64_t number, double line_share, Job& job) {
    Job own;
    const std::stop_callback pass_on(job.stop_token(), [&] { own.cancel(); });
    return taught_by(number, line_share, own);
}

}  // namespace

std::uint64_t patient_number(std::uint64_t seed, int volume) {
    return seed * patients_of_a_seed + static_cast<std::uint64_t>(volume);
}

LinkModel trained_links(const TrainingOptions& options, Job& job) {
    if (options.volumes < 1 || options.volumes > 10000)
        throw InputError(std::to_string(options.volumes) + " patients cannot be used", "--volumes",
                         "Choose a number from 1 to 10000");
    if (options.seed < 1 || options.seed > most_seed)
        throw InputError(std::to_string(options.seed) + " is no seed", "--seed",
                         "Give a whole number from 1 to " + std::to_string(most_seed));
    LinkModel model;
    model.made_by = "hepatica-cli train --seed " + std::to_string(options.seed) + " --volumes " +
                    std::to_string(options.volumes);
    std::vector<TaughtPiece> pieces;
    job.expect_stages(options.volumes + 1);
    for (int volume = 1; volume <= options.volumes; ++volume) {
        job.begin_stage("Patient " + std::to_string(volume));
        const auto taught =
            taught_quietly(patient_number(options.seed, volume), model.line_share, job);
        pieces.insert(pieces.end(), taught.begin(), taught.end());
    }
    job.begin_stage("Growing the forest");
    if (pieces.size() < enough_pieces)
        throw InputError(
            "the patients taught only " + std::to_string(pieces.size()) + " pieces of vessels",
            "--volumes", "Ask for more patients");
    model.forest = grown_forest(pieces, ForestOptions{});
    return model;
}

}  // namespace hepatica
