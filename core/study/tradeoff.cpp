// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/tradeoff.h"

#include <cmath>
#include <functional>
#include <limits>

#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/quality_dial.h"
#include "core/study/frame_meter.h"
#include "core/study/pull_trial.h"
#include "core/study/reference_beam.h"
#include "core/study/timing.h"

namespace hepatica {
namespace {

constexpr int rest_frames = 120, motion_frames = 30;

struct Setting {
    std::string element;
    Index3 cells;
    LinearSolverKind solver = LinearSolverKind::automatic;
    double tolerance = 1e-2;
    int max_iterations = 10000;
    int substeps = 1;
    int newton = 1;
};

std::vector<Setting> beam_settings(bool quick) {
    using Kind = LinearSolverKind;
    std::vector<Setting> settings;
    std::vector<Setting> meshes{
        {"corotated", {20, 3, 3}}, {"corotated-10", {10, 2, 2}}, {"hexahedron", {16, 3, 3}}};
    if (!quick) meshes.push_back({"corotated", {35, 7, 7}});
    // Coarse meshes with several substeps: there the time step dominates the error of motion.
    for (const auto& [element, cells] :
         {std::pair<const char*, Index3>{"hexahedron", {5, 1, 1}}, {"corotated-10", {8, 1, 1}}})
        for (const int substeps : {2, 4, 8})
            settings.push_back({element, cells, Kind::automatic, 1e-2, 1000, substeps, 1});
    for (const Setting& mesh : meshes) {
        const auto add = [&](Kind solver, double tolerance, int most, int substeps, int newton) {
            settings.push_back(
                {mesh.element, mesh.cells, solver, tolerance, most, substeps, newton});
        };
        for (const int most : {5, 20, 100}) add(Kind::block_jacobi, 0.0, most, 1, 1);
        add(Kind::block_jacobi, 1e-2, 10000, 1, 1);
        for (const double tolerance : {1e-1, 1e-2, 1e-3})
            add(Kind::skeleton, tolerance, 1000, 1, 1);
        add(Kind::cholesky, 1e-2, 1000, 1, 1);
        add(Kind::automatic, 1e-2, 1000, 1, 1);
        for (const int substeps : {2, 4, 8}) add(Kind::automatic, 1e-2, 1000, substeps, 1);
        add(Kind::automatic, 1e-2, 1000, 1, 5);
    }
    for (const char* element : {"spring", "neohookean"}) settings.push_back({element, {20, 3, 3}});
    for (const Index3& cells : {Index3{8, 1, 1}, Index3{5, 1, 1}, Index3{16, 2, 2}})
        settings.push_back({"corotated-10", cells});
    for (const Index3& cells :
         {Index3{5, 1, 1}, Index3{8, 2, 2}, Index3{12, 2, 2}, Index3{20, 4, 4}})
        settings.push_back({"hexahedron", cells});
    settings.push_back({"neohookean-10", {10, 2, 2}});
    if (quick) return settings;
    settings.push_back({"corotated-10", {20, 3, 3}});
    settings.push_back({"hexahedron", {30, 6, 6}});
    settings.push_back({"neohookean-10", {20, 3, 3}, Kind::automatic, 1e-3, 1000, 4, 5});
    return settings;
}

StepperOptions options_of(const Setting& setting, const Discretisation& d) {
    StepperOptions options;
    options.model = d.model;
    options.order = d.order;
    options.solver = setting.solver;
    options.linear.energy_tolerance = setting.tolerance;
    options.linear.max_iterations = setting.max_iterations;
    options.substeps = setting.substeps;
    options.newton_iterations = setting.newton;
    options.sleeping = false;
    return options;
}

double rest_tip(BeamSpec spec, const Index3& cells, const char* element, Job& job) {
    spec.cells = cells;
    const Discretisation d = discretisation_of(element);
    const BodyDescription body = clamped_beam(spec, d);
    const auto stepper = make_cpu_stepper(body, {.model = d.model,
                                                 .order = d.order,
                                                 .linear = {.energy_tolerance = 1e-4},
                                                 .newton_iterations = 30});
    stepper->set_gravity(Vec3(0, 0, -spec.gravity_mm_s2));
    constexpr int long_steps = 6;  // in which backward Euler damps all motion
    for (int i = 0; i < long_steps; ++i) {
        job.advance((1.0 + i) / (1.0 + long_steps));
        stepper->step(100.0, job.stop_token());
    }
    return tip_deflection_mm(spec, body.mesh.vertices_mm, stepper->positions_mm());
}

Vec3 tip_motion(const BeamSpec& spec, const BodyDescription& body, const Stepper& stepper) {
    return {tip_deflection_mm(spec, body.mesh.vertices_mm, stepper.positions_mm()), 0.0, 0.0};
}

// The tip's fall over the first frames, with steps so short that backward Euler's damping is
// negligible.
CentrelineMotion reference_motion(BeamSpec spec, Job& job) {
    spec.cells = {10, 2, 2};
    const BodyDescription body = clamped_beam(spec, discretisation_of("corotated-10"));
    const auto stepper = make_cpu_stepper(
        body,
        {.order = ElementOrder::quadratic, .linear = {.energy_tolerance = 1e-3}, .substeps = 32});
    stepper->set_gravity(Vec3(0, 0, -spec.gravity_mm_s2));
    CentrelineMotion tips;
    for (int i = 0; i < motion_frames; ++i) {
        job.throw_if_cancelled();
        stepper->step(frame_s, job.stop_token());
        tips.push_back(tip_motion(spec, body, *stepper));
    }
    return tips;
}

struct BeamReference {
    double tip_mm;
    CentrelineMotion motion_mm;  // of the tip alone, along x here
};

TradeoffPoint measure_beam(BeamSpec spec, const Setting& setting, const BeamReference& reference,
                           double seconds_left, const std::function<void(double)>& progress,
                           Job& job) {
    spec.cells = setting.cells;
    const Discretisation d = discretisation_of(setting.element);
    const BodyDescription body = clamped_beam(spec, d);
    TradeoffPoint point;
    point.element = setting.element;
    point.elements = static_cast<int>(body.mesh.tetrahedra.size() + body.hexahedra.size());
    point.options = options_of(setting, d);
    point.error_relative = point.rest_error_relative = std::numeric_limits<double>::quiet_NaN();
    StepperOptions options = point.options;
    options.substeps = 1;  // the meter makes the substeps one by one
    const auto stepper = make_cpu_stepper(body, options);
    stepper->set_gravity(Vec3(0, 0, -spec.gravity_mm_s2));
    FrameMeter meter;
    CentrelineMotion tips;
    const BudgetClock clock(seconds_left);
    for (int i = 0; i < rest_frames; ++i) {
        progress(i / static_cast<double>(rest_frames));
        meter.step(*stepper, setting.substeps, job);
        tips.push_back(tip_motion(spec, body, *stepper));
        if (i == 0) continue;
        const double needed_s = 1e-3 * meter.last_wall_ms() * (rest_frames - i - 1);
        point.not_measured = why_no_time(needed_s, clock.left_s());
        if (!point.not_measured.empty()) break;
    }
    meter.book(point);
    if (!point.not_measured.empty()) return point;
    point.rest_error_relative = std::abs(tips.back().x() - reference.tip_mm) / reference.tip_mm;
    tips.resize(reference.motion_mm.size());
    point.error_relative = motion_error(tips, reference.motion_mm);
    return point;
}

}  // namespace

bool is_measured(const TradeoffPoint& point) {
    return point.not_measured.empty() && std::isfinite(point.frame_ms) && point.frame_ms > 0.0 &&
           std::isfinite(point.error_relative);
}

void mark_front(Tradeoff& tradeoff) {
    std::vector<double> cost, error;
    std::vector<std::size_t> measured;
    for (std::size_t i = 0; i < tradeoff.points.size(); ++i) {
        const TradeoffPoint& point = tradeoff.points[i];
        if (!is_measured(point)) continue;
        measured.push_back(i);
        cost.push_back(point.frame_ms);
        error.push_back(point.error_relative);
    }
    const std::vector<std::size_t> front = pareto_front(cost, error);
    if (front.empty()) return;
    const double low = std::log(cost[front.front()]), high = std::log(cost[front.back()]);
    for (const std::size_t i : front) {
        TradeoffPoint& point = tradeoff.points[measured[i]];
        point.on_front = true;
        point.quality = high > low ? (std::log(cost[i]) - low) / (high - low) : 1.0;
    }
}

Tradeoff measure_beam_tradeoff(const TradeoffOptions& options, Job& job) {
    const BudgetClock clock(options.budget_s);
    const BeamSpec spec;
    Tradeoff tradeoff;
    job.begin_stage("Measuring the reference");
    const Index3 finest = options.quick ? Index3{20, 4, 4} : Index3{30, 6, 6};
    BeamReference reference;
    reference.motion_mm = reference_motion(spec, job);
    reference.tip_mm = tradeoff.reference_tip_mm = rest_tip(spec, finest, "neohookean-10", job);
    tradeoff.timoshenko_tip_mm = timoshenko_tip_mm(spec);
    tradeoff.reference =
        "corotated-10 on 240 tetrahedra, 32 substeps a frame, first half second of the fall";
    tradeoff.rest_reference = "neohookean-10 on " +
                              std::to_string(6 * finest[0] * finest[1] * finest[2]) +
                              " tetrahedra, converged Newton, at rest";
    job.begin_stage("Measuring the settings");
    const std::vector<Setting> settings = beam_settings(options.quick);
    for (const Setting& setting : settings) {
        const auto done = static_cast<double>(tradeoff.points.size());
        const auto progress = [&](double share) {
            job.advance((done + share) / static_cast<double>(settings.size()));
        };
        tradeoff.points.push_back(
            measure_beam(spec, setting, reference, clock.left_s(), progress, job));
    }
    mark_front(tradeoff);
    tradeoff.seconds = clock.passed_s();
    return tradeoff;
}

}  // namespace hepatica
