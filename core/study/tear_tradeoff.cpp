// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/tear_tradeoff.h"

#include <cmath>
#include <utility>

#include "core/base/frame_time.h"
#include "core/base/number_text.h"
#include "core/deform/body/element_name.h"

namespace hepatica {
namespace {

struct TearSetting {
    std::string name = "as in a scene";
    double edge_mm = 0.0;
    StepperOptions options{.sleeping = false};
};

TearSetting tight_tear(double edge_mm) {
    TearSetting setting{.name = "tight", .edge_mm = edge_mm};
    setting.options.substeps = 4;
    setting.options.newton_iterations = 4;
    setting.options.linear.energy_tolerance = 1e-5;
    return setting;
}

// Varies one parameter at a time from a scene's setting; only what can tear.
std::vector<TearSetting> tear_settings(const TearTradeoffOptions& options) {
    std::vector<TearSetting> all;
    const auto add = [&](const std::string& name) -> TearSetting& {
        return all.emplace_back(TearSetting{.name = name, .edge_mm = options.edge_mm});
    };
    add("as in a scene");
    for (const double edge : options.other_edges_mm)
        add("edges of " + number_text(edge) + " mm").edge_mm = edge;
    for (const ElementModel model : {ElementModel::spring, ElementModel::neohookean})
        add(element_name(model, ElementOrder::linear)).options.model = model;
    for (const double tolerance : {1e-1, 1e-3})
        add("solved to " + number_text(tolerance)).options.linear.energy_tolerance = tolerance;
    add(std::string(name_of(LinearSolverKind::block_jacobi))).options.solver =
        LinearSolverKind::block_jacobi;
    for (const int newton : {2, 4})
        add(std::to_string(newton) + " Newton iterates").options.newton_iterations = newton;
    for (const int substeps : {2, 4})
        add(std::to_string(substeps) + " substeps").options.substeps = substeps;
    return all;
}

// The strength and the fracture energy of study_tear(), nothing that stops the tear.
TearLaw law_of_bar() {
    const TearStudyOptions bar;
    return {.strength_pa = bar.strength_pa, .fracture_energy_j_m2 = bar.fracture_energy_j_m2};
}

// RMS of the difference over RMS of the reference. Both were pulled by the same steps.
double force_curve_error(const TearRow& row, const TearRow& reference) {
    double difference = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < reference.samples.size(); ++i) {
        const double there = reference.samples[i].force_un;
        difference += std::pow(row.samples[i].force_un - there, 2);
        scale += there * there;
    }
    return std::sqrt(difference / scale);
}

TearPoint tear_point(const TearSetting& setting, const TornBar& torn, const TearRow& reference) {
    const auto error = [](double value, double there) { return std::abs(value - there) / there; };
    const TearRow& row = torn.row;
    TearPoint measured{.name = setting.name,
                       .edge_mm = setting.edge_mm,
                       .force_max_un = row.force_max_un,
                       .work_nj = row.work_nj,
                       .force_error = error(row.force_max_un, reference.force_max_un),
                       .work_error = error(row.work_nj, reference.work_nj),
                       .opened_mm2 = row.opened_mm2,
                       .pieces = row.pieces,
                       .point = {}};
    TradeoffPoint& point = measured.point;
    point.element = element_name(setting.options.model, setting.options.order);
    point.elements = row.tetrahedra;
    point.options = setting.options;
    point.dt_s = frame_s / setting.options.substeps;
    point.frame_ms = torn.frame_ms;
    point.step_ms = torn.frame_ms / setting.options.substeps;
    point.iterations = torn.iterations;
    point.error_relative = force_curve_error(row, reference);
    return measured;
}

std::string words_of_tear(const TearSetting& setting, int tetrahedra) {
    return "the same bar, " + std::to_string(tetrahedra) + " tetrahedra of edges of " +
           number_text(setting.edge_mm) + " mm, " + std::to_string(setting.options.substeps) +
           " substeps a frame, up to " + std::to_string(setting.options.newton_iterations) +
           " Newton iterates, each solved to 1e-5";
}

}  // namespace

TearTradeoff measure_tear_tradeoff(const TearTradeoffOptions& options, Job& job) {
    const TearLaw law = law_of_bar();
    const TearSetting tight = tight_tear(options.tight_edge_mm);
    job.begin_stage("Measuring the reference");
    const TearRow reference = tear_bar(tight.edge_mm, law, options.step_mm, tight.options, job).row;
    TearTradeoff tradeoff{.points = {},
                          .reference = words_of_tear(tight, reference.tetrahedra),
                          .reference_force_max_un = reference.force_max_un,
                          .reference_work_nj = reference.work_nj};
    job.begin_stage("Measuring the settings");
    const std::vector<TearSetting> all = tear_settings(options);
    for (const TearSetting& setting : all) {
        const TornBar torn = tear_bar(setting.edge_mm, law, options.step_mm, setting.options, job);
        tradeoff.points.push_back(tear_point(setting, torn, reference));
        tradeoff.points.back().point.own_mesh = setting.edge_mm == options.edge_mm;
        job.advance(static_cast<double>(tradeoff.points.size()) / static_cast<double>(all.size()));
    }
    mark_front_of(tradeoff);
    return tradeoff;
}

}  // namespace hepatica
