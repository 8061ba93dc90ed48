// SPDX-License-Identifier: GPL-3.0-or-later
// bench tear: force, work and entropy of tearing a notched bar, or the cost of a step in which
// joints break (core/study/tear_study.h).
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/chart_file.h"
#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/base/file_extension.h"
#include "core/study/tear_study.h"

namespace hepatica {

namespace {

struct TearPlots {
    std::filesystem::path entropy, force;  // empty: not requested
};

std::string name_of(const char* what, const TearRow& row) {
    char name[80];
    std::snprintf(name, sizeof name, "%s, %.3g mm", what, row.edge_mm);
    return name;
}

Curve curve_of(const TearRow& row, const std::string& name, double TearRow::Sample::*value,
               double unit) {
    Curve curve{name, {}, {}};
    for (const TearRow::Sample& sample : row.samples) {
        curve.x.push_back(sample.pulled_mm);
        curve.y.push_back(unit * (sample.*value));
    }
    return curve;
}

// Entropy, and entropy produced, of the bars with a fracture energy and no stop.
Chart entropy_chart(const std::vector<TearRow>& rows) {
    Chart chart{
        "Entropy while a bar is torn, by the mesh's edge", "Pulled by (mm)", "Entropy (nats)", {}};
    for (const TearRow& row : rows)
        if (row.stop == "none" && row.law == "fracture energy") {
            chart.curves.push_back(
                curve_of(row, name_of("S", row), &TearRow::Sample::entropy_nats, 1.0));
            chart.curves.push_back(curve_of(row, name_of("produced", row),
                                            &TearRow::Sample::entropy_produced_nats, 1.0));
        }
    return chart;
}

// Force on all bars without a stop: with a fracture energy, and with a bare limit.
Chart force_chart(const std::vector<TearRow>& rows) {
    Chart chart{"Force that tears a bar, by the mesh's edge", "Pulled by (mm)", "Force (N)", {}};
    for (const TearRow& row : rows)
        if (row.stop == "none")
            chart.curves.push_back(
                curve_of(row, name_of(row.law.c_str(), row), &TearRow::Sample::force_un, 1e-6));
    return chart;
}

void write_plots(const TearPlots& plots, const std::vector<TearRow>& rows) {
    if (!plots.entropy.empty()) write_chart(plots.entropy, entropy_chart(rows));
    if (!plots.force.empty()) write_chart(plots.force, force_chart(rows));
}

struct Breaking {
    std::vector<int> tetrahedra;  // empty: the bars instead
    int tries = 9;
};

Json breaking_rows(const Breaking& wanted, Job& job) {
    Json rows = Json::array();
    for (const BreakingRow& row : study_breaking(wanted.tetrahedra, wanted.tries, job))
        rows.push_back({{"tetrahedra", row.tetrahedra},
                        {"joints", row.joints},
                        {"awake_ms", row.awake_ms},
                        {"breaks_ms", row.breaks_ms},
                        {"after_ms", row.after_ms}});
    return {{"rows", rows}};
}

void require_writable_plots(const TearPlots& plots) {
    require_different({plots.entropy, plots.force});
    for (const auto& file : {plots.entropy, plots.force})
        if (!file.empty()) {
            require_chart_file(file);
            require_writable_file(file, extension_of(file));
        }
}

}  // namespace

void add_bench_tear(CommandLine& line) {
    const auto options = std::make_shared<TearStudyOptions>();
    const auto plots = std::make_shared<TearPlots>();
    const auto breaking = std::make_shared<Breaking>();
    CLI::App& verb = line.add_verb(
        "bench", "Benchmarks", "tear",
        "What tearing a notched bar takes: bare limit and fracture energy, entropy and vertex stop",
        [options, plots, breaking](Job& job) {
            if (!breaking->tetrahedra.empty()) return breaking_rows(*breaking, job);
            require_writable_plots(*plots);
            const std::vector<TearRow> found = study_tear(*options, job);
            write_plots(*plots, found);
            Json rows = Json::array();
            for (const TearRow& row : found)
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
    CLI::Option* breaks =
        verb.add_option("--breaking", breaking->tetrahedra,
                        "Instead: what a step costs in which a hundred joints of a vessel tree "
                        "break, of so many tetrahedra")
            ->check(CLI::Range(2000, 1'000'000));
    verb.add_option("--tries", breaking->tries, "How often, each elsewhere")
        ->check(CLI::Range(1, 1000))
        ->needs(breaks)
        ->capture_default_str();
    verb.add_option("--plot-entropy", plots->entropy,
                    "Entropy over the pull, on each mesh: .png or .csv");
    verb.add_option("--plot-force", plots->force, "Force over the pull, by law: .png or .csv");
    verb.add_option("--step-mm", options->step_mm, "By which a step pulls")
        ->check(CLI::Range(1e-3, 1.0));
    for (const char* of_bars : {"--plot-entropy", "--plot-force", "--edges-mm", "--tear-factors",
                                "--step-mm", "--strength-pa", "--fracture-energy-j-m2"})
        breaks->excludes(verb.get_option(of_bars));
}

}  // namespace hepatica
