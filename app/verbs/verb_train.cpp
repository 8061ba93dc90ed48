// SPDX-License-Identifier: GPL-3.0-or-later
// train: learns on synthetic patients which lines of a CT are vessels
// (core/training/link_training.h).
#include <spdlog/spdlog.h>

#include <cstdint>
#include <filesystem>

#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/training/link_training.h"

namespace hepatica {

namespace {

struct TrainChoices {
    std::filesystem::path out;
    std::int64_t seed = 1;  // signed, so that negative numbers are detected
    TrainingOptions training;
};

Json run_train(TrainChoices options, Job& job) {
    if (options.seed < 1)
        throw InputError(std::to_string(options.seed) + " is no seed", "--seed",
                         "Give a whole number from 1 on");
    options.training.seed = static_cast<std::uint64_t>(options.seed);
    require_writable_file(options.out, ".json");
    int left_out = 0;
    const LinkModel model =
        trained_links(options.training, job, [&](std::uint64_t number, const InputError& reason) {
            ++left_out;
            spdlog::warn("the patient of seed {} is left out: {}", number, reason.what());
        });
    write_link_model(options.out, model);
    std::size_t nodes = 0;
    for (const auto& tree : model.forest.trees) nodes += tree.size();
    return {{"model", options.out.string()},
            {"made_by", model.made_by},
            {"trees", model.forest.trees.size()},
            {"nodes", nodes},
            {"patients_left_out", left_out}};
}

}  // namespace

void add_train(CommandLine& line) {
    auto options = std::make_shared<TrainChoices>();
    CLI::App& verb =
        line.add_verb("train", "Learn on synthetic patients which lines of a CT are vessels",
                      [options](Job& job) { return run_train(*options, job); });
    verb.add_option("--out", options->out, "Model to make, a JSON file for reconstruct --model")
        ->required();
    verb.add_option("--seed", options->seed, "Other seeds draw other patients")
        ->capture_default_str();
    verb.add_option("--volumes", options->training.volumes, "Patients to learn on, some 20 s each")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
}

}  // namespace hepatica
