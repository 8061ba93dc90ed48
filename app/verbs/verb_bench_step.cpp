// SPDX-License-Identifier: GPL-3.0-or-later
// bench step: time, error and energy ledger of a step on one and several threads
// (core/study/step_study.h).
#include <memory>

#include "app/verbs/case_tree.h"
#include "app/verbs/verbs.h"
#include "core/base/hash.h"
#include "core/study/step_study.h"

namespace hepatica {

namespace {

Json json_row(const StepRow& row) {
    return {{"threads", row.threads},
            {"tetrahedra", row.tetrahedra},
            {"ms", row.ms},
            {"longest_ms", row.longest_ms},
            {"steps_per_s", 1000.0 / row.ms},
            {"iterations", row.iterations},
            {"newton_iterations", row.newton_iterations},
            {"energy_error", row.energy_error},
            {"ledger_imbalance", row.ledger_imbalance},
            {"hash", to_hex(row.hash)}};
}

}  // namespace

void add_bench_step(CommandLine& line) {
    const auto options = std::make_shared<StepStudyOptions>();
    const auto patient = std::make_shared<CaseTree>();
    CLI::App& verb = line.add_verb(
        "bench", "Benchmarks", "step",
        "A step of a whole vessel tree: time on one core and on several, error, ledger",
        [options, patient](Job& job) {
            options->tree = patient->read();
            const std::vector<StepRow> measured = study_steps(*options, job);
            Json rows = Json::array();
            for (const StepRow& row : measured) rows.push_back(json_row(row));
            return Json{{"rows", rows}, {"thread_ratio", measured.front().ms / measured.back().ms}};
        });
    patient->add_options(verb, options->tetrahedra, "a symmetric tree");
    verb.add_option("--frames", options->frames, "Steps of 1/60 s")->check(CLI::Range(1, 100000));
    verb.add_option("--gravity-mm-s2", options->gravity_mm_s2, "Along -z, from the first step on");
    verb.add_option("--tether-pa-per-mm2", options->tether_pa_per_mm2,
                    "Pull of the surrounding tissue");
    verb.add_option("--threads", options->threads, "Numbers of threads, side by side")
        ->check(CLI::Range(1, 256));
}

}  // namespace hepatica
