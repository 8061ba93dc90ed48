// SPDX-License-Identifier: GPL-3.0-or-later
// bench iterations: iterations of each linear solver to a given true error
// (core/study/iteration_study.h).
#include <memory>

#include "app/verbs/case_tree.h"
#include "app/verbs/verbs.h"
#include "core/study/iteration_study.h"

namespace hepatica {

namespace {

Json json_row(const IterationRow& row) {
    return {{"body", row.body},
            {"solver", row.solver},
            {"slenderness", row.slenderness},
            {"tetrahedra", row.tetrahedra},
            {"iterations_10pct", row.iterations_10pct},
            {"iterations_1pct", row.iterations_1pct},
            {"ms", row.ms},
            {"prepare_ms", row.prepare_ms},
            {"iterations_stopped", row.iterations_stopped},
            {"estimate", row.estimate},
            {"error", row.error}};
}

}  // namespace

void add_bench_iterations(CommandLine& line) {
    const auto options = std::make_shared<IterationStudyOptions>();
    const auto skip = std::make_shared<bool>(false);
    const auto patient = std::make_shared<CaseTree>();
    CLI::App& verb =
        line.add_verb("bench", "Benchmarks", "iterations",
                      "Iterations of each linear solver to a true error, over slenderness and size",
                      [options, skip, patient](Job& job) {
                          options->block_jacobi = !*skip;
                          options->tree = patient->read();
                          Json rows = Json::array();
                          for (const IterationRow& row : study_iterations(*options, job)) {
                              rows.push_back(json_row(row));
                          }
                          return Json{{"rows", rows}};
                      });
    patient->add_options(verb, options->tetrahedra, "bars and symmetric trees");
    verb.get_option("--tetrahedra")->needs(verb.get_option("--case"));
    verb.add_flag("--quick", options->quick, "Two small bars only")
        ->excludes(verb.get_option("--case"));
    verb.add_flag("--no-block-jacobi", *skip, "Leave out the slow yardstick");
}

}  // namespace hepatica
