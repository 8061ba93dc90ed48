// SPDX-License-Identifier: GPL-3.0-or-later
// Error against cost of the solver's settings on a given body: measure_body_tradeoff() of
// tradeoff.h.
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/error.h"
#include "core/base/frame_time.h"
#include "core/deform/body/element_name.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/study/frame_meter.h"
#include "core/study/pull_trial.h"
#include "core/study/timing.h"
#include "core/study/tradeoff.h"

namespace hepatica {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int frames_before_a_forecast = 2;
constexpr int most_frames_to_sleep = 90;
constexpr const char* no_time_left = "no time was left";

struct Setting {
    std::size_t mesh = 0;
    bool live = false;
    StepperOptions options;
    bool on_device = false;
};

StepperOptions options_of(ElementModel model, ElementOrder order, int substeps, int newton = 1) {
    StepperOptions options;
    options.model = model;
    options.order = order;
    options.substeps = substeps;
    options.newton_iterations = newton;
    options.sleeping = false;
    return options;
}

StepperOptions solved_by(LinearSolverKind kind, double tolerance, int most) {
    StepperOptions options = options_of(ElementModel::corotated, ElementOrder::linear, 1);
    options.solver = kind;
    options.linear = {.energy_tolerance = tolerance, .max_iterations = most};
    return options;
}

// Cheap settings first, so that an exhausted budget only omits costly ones.
std::vector<Setting> settings_of(std::size_t meshes, bool device) {
    using Kind = LinearSolverKind;
    using Model = ElementModel;
    constexpr auto linear = ElementOrder::linear, quadratic = ElementOrder::quadratic;
    std::vector<Setting> settings;
    const auto add = [&](const StepperOptions& options, std::size_t mesh = 0, bool live = false) {
        settings.push_back({mesh, live, options});
        if (device) settings.push_back({mesh, live, options, true});
    };
    for (const int most : {5, 20}) add(solved_by(Kind::block_jacobi, 0.0, most));
    add(solved_by(Kind::automatic, 1e-1, 1000));
    for (const Model model : {Model::spring, Model::corotated, Model::neohookean})
        add(options_of(model, linear, 1));
    for (const Kind kind : {Kind::cholesky, Kind::skeleton}) add(solved_by(kind, 1e-2, 1000));
    add(solved_by(Kind::automatic, 1e-3, 1000));
    for (const int substeps : {1, 4}) add(options_of(Model::corotated, linear, substeps), 0, true);
    for (const int substeps : {2, 4, 8}) add(options_of(Model::corotated, linear, substeps));
    add(options_of(Model::corotated, linear, 1, 5));
    add(options_of(Model::spring, linear, 4));
    add(options_of(Model::neohookean, linear, 4));
    for (std::size_t mesh = 1; mesh < meshes; ++mesh) {
        for (const int substeps : {1, 4}) add(options_of(Model::corotated, linear, substeps), mesh);
    }
    add(solved_by(Kind::block_jacobi, 0.0, 100));
    for (const int substeps : {1, 2, 4}) add(options_of(Model::corotated, quadratic, substeps));
    add(options_of(Model::neohookean, quadratic, 1));
    add(solved_by(Kind::block_jacobi, 1e-2, 10000));
    return settings;
}

// The same pull on every mesh, observed at the same points of the centreline.
struct Scene {
    const std::vector<BodyDescription>& meshes;
    Pull pull;
    std::vector<CentrelineProbes> probes;

    explicit Scene(const std::vector<BodyDescription>& bodies)
        : meshes(bodies), pull(bodies.front()) {
        const std::vector<Vec3>& points = bodies.front().skeleton.positions_mm;
        for (const BodyDescription& body : bodies) probes.emplace_back(points, body.mesh);
    }

    void watch(std::size_t mesh, const Stepper& stepper, CentrelineMotion& motion) const {
        const std::vector<Vec3> rest = probes[mesh].places_mm(meshes[mesh].mesh.vertices_mm);
        const std::vector<Vec3> now = probes[mesh].places_mm(stepper.positions_mm());
        for (std::size_t p = 0; p < rest.size(); ++p) motion.push_back(now[p] - rest[p]);
    }
};

struct Reference {
    CentrelineMotion motion;
    StepperOptions options;
    std::string words;
};

std::unique_ptr<Stepper> reference_stepper(const BodyDescription& body, ElementOrder order) {
    StepperOptions options = options_of(ElementModel::corotated, order, 1);
    options.linear.energy_tolerance = 1e-3;
    return make_cpu_stepper(body, options);
}

struct ReferenceChoice {
    ElementOrder order;
    int most_substeps, least_substeps;
    double share;  // share of the budget that may have passed when it is done
};
constexpr ReferenceChoice reference_choices[] = {{ElementOrder::quadratic, 8, 8, 0.4},
                                                 {ElementOrder::linear, 32, 8, 0.6},
                                                 {ElementOrder::linear, 4, 0, 1e9}};

// The largest power of two of substeps for which the motion fits into `seconds`, estimated from two
// steps; 0 if not even the least fits.
int substeps_within(const Scene& scene, const ReferenceChoice& choice, double seconds,
                    const Job& job) {
    const auto stepper = reference_stepper(scene.meshes.front(), choice.order);
    FrameMeter meter;
    stepper->set_grabs(scene.pull.grabs(scene.meshes.front(), 0));
    for (int i = 0; i < 2; ++i) meter.step(*stepper, 1, job);
    int substeps = choice.most_substeps;
    while (substeps > choice.least_substeps &&
           1e-3 * meter.last_wall_ms() * substeps * Pull::frames > seconds)
        substeps /= 2;
    const bool fits = 1e-3 * meter.last_wall_ms() * substeps * Pull::frames <= seconds;
    return fits ? substeps : 0;
}

// Empty where it does not end before the clock passes `end_s`.
CentrelineMotion reference_motion(const Scene& scene, ElementOrder order, int substeps,
                                  const BudgetClock& clock, double end_s, Job& job) {
    const BodyDescription& body = scene.meshes.front();
    const auto stepper = reference_stepper(body, order);
    CentrelineMotion motion;
    FrameMeter meter;
    for (int f = 0; f < Pull::frames; ++f) {
        job.advance(f / static_cast<double>(Pull::frames));
        stepper->set_grabs(scene.pull.grabs(body, f));
        meter.step(*stepper, substeps, job);
        scene.watch(0, *stepper, motion);
        if (clock.passed_s() > end_s) return {};
    }
    return motion;
}

std::string words_of_reference(const BodyDescription& body, const StepperOptions& options) {
    const bool linear = options.order == ElementOrder::linear;
    return "the same body, " + element_name(options.model, options.order) + " on " +
           std::to_string(body.mesh.tetrahedra.size()) + " tetrahedra, " +
           std::to_string(options.substeps) +
           " substeps a frame, pulled by 30 mm in half a second and back" +
           (linear ? " (the mesh's own error is not in it)" : "");
}

// Measures the first choice that the budget allows; the last one in any case.
Reference measure_reference(const Scene& scene, const BudgetClock& clock, double budget_s,
                            Job& job) {
    Reference reference;
    for (const ReferenceChoice& choice : reference_choices) {
        const double end_s = choice.share * budget_s;
        int substeps = choice.most_substeps;
        if (choice.least_substeps > 0)
            substeps = substeps_within(scene, choice, end_s - clock.passed_s(), job);
        if (substeps == 0) continue;
        reference.options = options_of(ElementModel::corotated, choice.order, substeps);
        reference.motion = reference_motion(scene, choice.order, substeps, clock, end_s, job);
        if (!reference.motion.empty()) break;
    }
    reference.words = words_of_reference(scene.meshes.front(), reference.options);
    return reference;
}

std::unique_ptr<Stepper> new_stepper(const BodyDescription& body, const Setting& setting,
                                     const StepperOptions& options, const TradeoffOptions& how) {
    if (!setting.on_device)
        return setting.live ? make_live_stepper(body, options, how.region)
                            : make_cpu_stepper(body, options);
    LiveRegionOptions region = how.region;
    if (!setting.live) region.still_radii_per_s = 0.0;  // so that nothing freezes
    return how.device->make(body, options, region);
}

std::unique_ptr<Stepper> stepper_for(const BodyDescription& body, const Setting& setting,
                                     const TradeoffOptions& how) {
    StepperOptions options = setting.options;
    if (!setting.live) options.substeps = 1;  // the meter makes the substeps one by one
    return new_stepper(body, setting, options, how);
}

// Empty where the whole motion was measured; otherwise the reason.
std::string measure_motion(const Scene& scene, const Setting& setting,
                           const TradeoffOptions& options, const BudgetClock& clock, Job& job,
                           const std::function<void(double)>& progress, FrameMeter& meter,
                           CentrelineMotion& motion) {
    const BodyDescription& body = scene.meshes[setting.mesh];
    if (clock.left_s() <= 0.0) return no_time_left;
    const auto stepper = stepper_for(body, setting, options);
    const char* const left = "the device leaves such steps to the processor";
    if (setting.on_device && !stepper->on_device()) return left;
    if (setting.live && !let_fall_asleep(*stepper, most_frames_to_sleep, clock, job))
        return no_time_left;
    for (int f = 0; f < Pull::frames; ++f) {
        progress(f / static_cast<double>(Pull::frames));
        stepper->set_grabs(scene.pull.grabs(body, f));
        meter.step(*stepper, setting.live ? 1 : setting.options.substeps, job);
        scene.watch(setting.mesh, *stepper, motion);
        if (f + 1 < frames_before_a_forecast) continue;
        const double needed_s = 1e-3 * meter.last_wall_ms() * (Pull::frames - f - 1);
        std::string reason = why_no_time(needed_s, clock.left_s());
        if (!reason.empty()) return reason;
    }
    if (setting.on_device && !stepper->on_device()) return left;
    return {};
}

bool finer_than(const Setting& setting, const StepperOptions& reference) {
    if (setting.mesh > 0) return false;
    const bool order =
        setting.options.order == ElementOrder::quadratic && reference.order == ElementOrder::linear;
    return order || (setting.options.order == reference.order &&
                     2 * setting.options.substeps > reference.substeps);
}

TradeoffPoint measure_setting(const Scene& scene, const Setting& setting,
                              const Reference& reference, const TradeoffOptions& options,
                              const BudgetClock& clock, Job& job,
                              const std::function<void(double)>& progress) {
    TradeoffPoint point;
    point.element = element_name(setting.options.model, setting.options.order);
    point.elements = static_cast<int>(scene.meshes[setting.mesh].mesh.tetrahedra.size());
    point.region = setting.live ? "live" : "whole";
    if (setting.on_device) {
        point.back_end = options.device->name;
        point.device = options.device->device;
    }
    point.own_mesh = setting.mesh == 0;
    point.options = setting.options;
    point.dt_s = frame_s / setting.options.substeps;
    point.step_ms = point.frame_ms = point.iterations = unknown;
    point.error_relative = point.rest_error_relative = unknown;
    FrameMeter meter;
    CentrelineMotion motion;
    if (finer_than(setting, reference.options))
        point.not_measured = "the reference that the budget allowed is no finer";
    else
        point.not_measured =
            measure_motion(scene, setting, options, clock, job, progress, meter, motion);
    if (meter.frames() > 0) meter.book(point);
    if (point.not_measured.empty()) point.error_relative = motion_error(motion, reference.motion);
    return point;
}

}  // namespace

Tradeoff measure_body_tradeoff(const std::vector<BodyDescription>& meshes,
                               const TradeoffOptions& options, Job& job) {
    const BudgetClock clock(options.budget_s);
    job.begin_stage("Finding the centreline in the meshes");
    const Scene scene(meshes);
    job.begin_stage("Measuring the reference");
    const Reference reference = measure_reference(scene, clock, options.budget_s, job);
    require_movement(reference.motion);
    job.begin_stage("Measuring the settings");
    Tradeoff tradeoff;
    tradeoff.reference = reference.words;
    const std::vector<Setting> settings = settings_of(meshes.size(), options.device.has_value());
    for (const Setting& setting : settings) {
        const auto done = static_cast<double>(tradeoff.points.size());
        const auto progress = [&](double share) {
            job.advance((done + share) / static_cast<double>(settings.size()));
        };
        tradeoff.points.push_back(
            measure_setting(scene, setting, reference, options, clock, job, progress));
    }
    mark_front(tradeoff);
    tradeoff.seconds = clock.passed_s();
    return tradeoff;
}

}  // namespace hepatica
