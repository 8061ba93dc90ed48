// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "app/verbs/verbs.h"
#include "core/study/tear_study.h"

namespace hepatica {

void add_bench_tear(CommandLine& line) {
    const auto options = std::make_shared<TearStudyOptions>();
    CLI::App& verb = line.add_verb(
        "bench", "Benchmarks", "tear",
        "What tearing a notched bar takes: bare limit and fracture energy, entropy and vertex stop",
        [options](Job& job) {
            Json rows = Json::array();
            for (const TearRow& row : study_tear(*options, job))
                rows.push_back({{"law", row.law},
                                {"stop", row.stop},
                                {"tear_factor", row.tear_factor},
                                {"edge_mm", row.edge_mm},
                                {"tetrahedra", row.tetrahedra},
                                {"force_max_un", row.force_max_un},
                                {"work_nj", row.work_nj},
                                {"opened_mm2", row.opened_mm2},
                                {"vertices_split", row.vertices_split},
                                {"pieces", row.pieces},
                                {"entropy_produced_max", row.entropy_produced_max_nats},
                                {"step_ms", row.median_step_ms}});
            return Json{{"strength_pa", options->strength_pa},
                        {"fracture_energy_j_m2", options->fracture_energy_j_m2},
                        {"rows", rows}};
        });
    verb.add_option("--strength-pa", options->strength_pa, "Of the tissue")
        ->check(CLI::Range(1.0, 1e9));
    verb.add_option("--fracture-energy-j-m2", options->fracture_energy_j_m2, "Of the tissue")
        ->check(CLI::Range(1e-6, 1e9));
    verb.add_option("--edges-mm", options->edges_mm, "Of the cells of each mesh")
        ->check(CLI::Range(0.2, 4.0));
    verb.add_option("--tear-factors", options->tear_factors, "Each with both stops")
        ->check(CLI::Range(1e-3, 1e3));
    verb.add_option("--step-mm", options->step_mm, "By which a step pulls")
        ->check(CLI::Range(1e-3, 1.0));
}

}  // namespace hepatica
