// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/tradeoff.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/deform/quality_dial.h"
#include "core/study/reference_beam.h"

namespace hepatica {
namespace {

constexpr double frame_s = 1.0 / 60.0;
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
        add(Kind::automatic, 1e-2, 1000, 4, 1);
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

double rest_tip(BeamSpec spec, const Index3& cells, const char* element) {
    spec.cells = cells;
    const Discretisation d = discretisation_of(element);
    const BodyDescription body = clamped_beam(spec, d);
    const auto stepper = make_cpu_stepper(body, {.model = d.model,
                                                 .order = d.order,
                                                 .linear = {.energy_tolerance = 1e-4},
                                                 .newton_iterations = 30});
    stepper->set_gravity(Vec3(0, 0, -spec.gravity_mm_s2));
    for (int i = 0; i < 6; ++i) stepper->step(100.0);
    return tip_deflection_mm(spec, body.mesh.vertices_mm, stepper->positions_mm());
}

// The tip's fall over the first frames with steps so short that backward Euler no longer brakes.
std::vector<double> reference_motion(BeamSpec spec) {
    spec.cells = {10, 2, 2};
    const BodyDescription body = clamped_beam(spec, discretisation_of("corotated-10"));
    const auto stepper = make_cpu_stepper(
        body,
        {.order = ElementOrder::quadratic, .linear = {.energy_tolerance = 1e-3}, .substeps = 32});
    stepper->set_gravity(Vec3(0, 0, -spec.gravity_mm_s2));
    std::vector<double> tips;
    for (int i = 0; i < motion_frames; ++i) {
        stepper->step(frame_s);
        tips.push_back(tip_deflection_mm(spec, body.mesh.vertices_mm, stepper->positions_mm()));
    }
    return tips;
}

double motion_error(std::span<const double> tips, std::span<const double> reference) {
    double missed = 0.0, moved = 0.0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        missed += (tips[i] - reference[i]) * (tips[i] - reference[i]);
        moved += reference[i] * reference[i];
    }
    return std::sqrt(missed / moved);
}

// Steps a frame at a time and keeps what it costs.
struct Meter {
    std::vector<double> frame_ms;
    double iterations = 0.0;

    void step(Stepper& stepper) {
        const auto start = std::chrono::steady_clock::now();
        iterations += stepper.step(frame_s).linear_iterations;
        frame_ms.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count());
    }

    void book(TradeoffPoint& point) {
        point.iterations =
            iterations / (static_cast<double>(frame_ms.size()) * point.options.substeps);
        std::ranges::nth_element(frame_ms, frame_ms.begin() + frame_ms.size() / 2);
        point.frame_ms = frame_ms[frame_ms.size() / 2];
        point.step_ms = point.frame_ms / point.options.substeps;
        point.dt_s = frame_s / point.options.substeps;
    }
};

TradeoffPoint measure_beam(BeamSpec spec, const Setting& setting, double reference_tip,
                           std::span<const double> motion) {
    spec.cells = setting.cells;
    const Discretisation d = discretisation_of(setting.element);
    const BodyDescription body = clamped_beam(spec, d);
    TradeoffPoint point;
    point.element = setting.element;
    point.elements = static_cast<int>(body.mesh.tetrahedra.size() + body.hexahedra.size());
    point.options = options_of(setting, d);
    const auto stepper = make_cpu_stepper(body, point.options);
    stepper->set_gravity(Vec3(0, 0, -spec.gravity_mm_s2));
    Meter meter;
    std::vector<double> tips;
    for (int i = 0; i < rest_frames; ++i) {
        meter.step(*stepper);
        tips.push_back(tip_deflection_mm(spec, body.mesh.vertices_mm, stepper->positions_mm()));
    }
    meter.book(point);
    point.error_relative = std::abs(tips.back() - reference_tip) / reference_tip;
    point.motion_error_relative = motion_error(tips, motion);
    return point;
}

void mark_front(Tradeoff& tradeoff) {
    std::vector<double> cost, error;
    for (const TradeoffPoint& point : tradeoff.points) {
        cost.push_back(point.frame_ms);
        error.push_back(point.error_relative);
    }
    const std::vector<std::size_t> front = pareto_front(cost, error);
    if (front.empty()) return;
    const double low = std::log(cost[front.front()]), high = std::log(cost[front.back()]);
    for (const std::size_t i : front) {
        tradeoff.points[i].on_front = true;
        tradeoff.points[i].quality = high > low ? (std::log(cost[i]) - low) / (high - low) : 1.0;
    }
}

}  // namespace

Tradeoff measure_beam_tradeoff(bool quick, Job& job) {
    const BeamSpec spec;
    Tradeoff tradeoff;
    job.begin_stage("reference");
    const Index3 finest = quick ? Index3{20, 4, 4} : Index3{30, 6, 6};
    tradeoff.reference_tip_mm = rest_tip(spec, finest, "neohookean-10");
    tradeoff.timoshenko_tip_mm = timoshenko_tip_mm(spec);
    tradeoff.reference = "neohookean-10 on " +
                         std::to_string(6 * finest[0] * finest[1] * finest[2]) +
                         " tetrahedra, converged Newton, at rest";
    const std::vector<double> motion = reference_motion(spec);
    job.begin_stage("settings");
    const std::vector<Setting> settings = beam_settings(quick);
    for (const Setting& setting : settings) {
        job.advance(static_cast<double>(tradeoff.points.size()) /
                    static_cast<double>(settings.size()));
        tradeoff.points.push_back(measure_beam(spec, setting, tradeoff.reference_tip_mm, motion));
    }
    mark_front(tradeoff);
    return tradeoff;
}

Tradeoff measure_body_tradeoff(const BodyDescription& body, Job& job) {
    std::vector<StepperOptions> settings;
    for (const ElementModel model :
         {ElementModel::spring, ElementModel::corotated, ElementModel::neohookean})
        for (const ElementOrder order : {ElementOrder::linear, ElementOrder::quadratic})
            for (const double tolerance : {1e-1, 1e-2}) {
                if (order == ElementOrder::quadratic && model != ElementModel::corotated) continue;
                StepperOptions options;
                options.model = model;
                options.order = order;
                options.linear.energy_tolerance = tolerance;
                settings.push_back(options);
            }
    StepperOptions jacobi;
    jacobi.solver = LinearSolverKind::block_jacobi;
    jacobi.linear = {.energy_tolerance = 0.0, .max_iterations = 20};
    settings.push_back(jacobi);
    const Vec3 gravity(0, 0, -units::standard_gravity);
    Tradeoff tradeoff;
    job.begin_stage("reference");
    const std::vector<Vec3> rest = converged_rest(body, gravity);
    job.begin_stage("settings");
    for (const StepperOptions& options : settings) {
        job.advance(static_cast<double>(tradeoff.points.size()) /
                    static_cast<double>(settings.size()));
        const QualityPoint measured = measure_quality(body, options, 60, gravity, rest);
        TradeoffPoint point;
        point.element = name_of(Discretisation{options.model, options.order, false});
        point.elements = static_cast<int>(body.mesh.tetrahedra.size());
        point.options = options;
        point.dt_s = frame_s;
        point.step_ms = point.frame_ms = measured.frame_ms;
        point.error_relative = measured.error_relative;
        point.motion_error_relative = std::numeric_limits<double>::quiet_NaN();
        tradeoff.reference = measured.reference;
        tradeoff.points.push_back(point);
    }
    mark_front(tradeoff);
    return tradeoff;
}

}  // namespace hepatica
