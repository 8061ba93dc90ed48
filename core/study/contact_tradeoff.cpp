// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/contact_tradeoff.h"

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/deform/body/element_name.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/study/frame_meter.h"
#include "core/study/pull_trial.h"
#include "core/study/touching_blocks.h"

namespace hepatica {

namespace {

// A tenth of the earth's gravity, so that the sliding block stays on its slab.
constexpr double gravity_mm_per_s2 = 0.1 * units::standard_gravity;
// More than twice the thickest pad, because surfaces that begin closer get thinner pads there
// (SurfacePairs).
constexpr double gap_mm = 2.0;
constexpr double slope_rad = 0.26;  // steeper than a friction of 0.2 holds

struct ContactSetting {
    std::string name = "as in a scene";
    double pad_edges = 0.1;
    double friction = 0.2;
    StepperOptions options{.sleeping = false};
};

ContactSetting tight() {
    ContactSetting setting{.name = "tight", .pad_edges = 0.02};
    setting.options.substeps = 8;
    setting.options.newton_iterations = 6;
    setting.options.linear.energy_tolerance = 1e-5;
    return setting;
}

// Varies one parameter at a time from a scene's setting.
std::vector<ContactSetting> settings() {
    std::vector<ContactSetting> all(1);
    const auto add = [&](const std::string& name) -> ContactSetting& {
        all.emplace_back().name = name;
        return all.back();
    };
    for (const double pad : {0.02, 0.05, 0.2, 0.4})
        add("pad of " + number_text(pad) + " edges").pad_edges = pad;
    for (const double tolerance : {1e-1, 1e-3, 1e-5})
        add("solved to " + number_text(tolerance)).options.linear.energy_tolerance = tolerance;
    for (const auto solver : {LinearSolverKind::skeleton, LinearSolverKind::block_jacobi})
        add(std::string(name_of(solver))).options.solver = solver;
    for (const int newton : {2, 4})
        add(std::to_string(newton) + " Newton iterates").options.newton_iterations = newton;
    for (const int substeps : {2, 4})
        add(std::to_string(substeps) + " substeps").options.substeps = substeps;
    add("no friction").friction = 0.0;
    return all;
}

// Displacements of the block's vertices, frame by frame.
CentrelineMotion play(TouchingBlocks blocks, const ContactSetting& setting, int frames,
                      FrameMeter& meter, const Job& job) {
    blocks.body.self->thickness_edges = setting.pad_edges;
    blocks.body.self->friction = setting.friction;
    StepperOptions options = setting.options;
    options.substeps = 1;  // the meter makes the substeps one by one
    const auto stepper = make_cpu_stepper(blocks.body, options);
    stepper->set_gravity(gravity_mm_per_s2 * Vec3(std::sin(slope_rad), 0.0, -std::cos(slope_rad)));
    const auto first = static_cast<std::size_t>(blocks.first_of_block);
    const std::vector<Vec3>& rest = blocks.body.mesh.vertices_mm;
    CentrelineMotion motion;
    for (int f = 0; f < frames; ++f) {
        meter.step(*stepper, setting.options.substeps, job);
        for (std::size_t v = first; v < rest.size(); ++v)
            motion.push_back(stepper->positions_mm()[v] - rest[v]);
    }
    return motion;
}

std::string words_of(const ContactSetting& setting, std::size_t tetrahedra) {
    return "the same blocks, " + std::to_string(tetrahedra) +
           " tetrahedra, with a pad of a fiftieth of an edge, " +
           std::to_string(setting.options.substeps) + " substeps a frame, up to " +
           std::to_string(setting.options.newton_iterations) +
           " Newton iterates, each solved to 1e-5, and friction of 0.2";
}

}  // namespace

ContactTradeoff measure_contact_tradeoff(const ContactTradeoffOptions& options, Job& job) {
    const TouchingBlocks blocks = block_on_slab(options.slab_cells, options.block_cells, gap_mm);
    const std::size_t tetrahedra = blocks.body.mesh.tetrahedra.size();
    job.begin_stage("Measuring the reference");
    FrameMeter unused;
    const CentrelineMotion reference = play(blocks, tight(), options.frames, unused, job);
    job.begin_stage("Measuring the settings");
    ContactTradeoff tradeoff;
    tradeoff.reference = words_of(tight(), tetrahedra);
    const std::vector<ContactSetting> all = settings();
    for (const ContactSetting& setting : all) {
        FrameMeter meter;
        const CentrelineMotion motion = play(blocks, setting, options.frames, meter, job);
        ContactPoint measured{setting.name, setting.pad_edges, setting.friction, {}};
        TradeoffPoint& point = measured.point;
        point.element = element_name(setting.options.model, setting.options.order);
        point.elements = static_cast<int>(tetrahedra);
        point.options = setting.options;
        meter.book(point);
        point.error_relative = motion_error(motion, reference);
        tradeoff.points.push_back(std::move(measured));
        job.advance(static_cast<double>(tradeoff.points.size()) / static_cast<double>(all.size()));
    }
    mark_front_of(tradeoff);
    return tradeoff;
}

}  // namespace hepatica
