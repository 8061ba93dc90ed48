// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/contact_study.h"

#include <algorithm>
#include <memory>

#include "core/base/frame_time.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/study/timing.h"
#include "core/study/touching_blocks.h"

namespace hepatica {

namespace {

constexpr int cells = 24;  // cells across the slab: 10,368 tetrahedra
constexpr int bars = 192;  // cells of both bars together: 10,368 tetrahedra, too
constexpr int rows_of_a_self_contact = 1, rows_of_a_tool_contact = 3;
constexpr int most_settling = 60;

struct Setup {
    std::string kind;
    BodyDescription body;
    double ball_mm = 0.0;  // radius; 0: no tool
};

Setup self_setup(int across) {
    return {.kind = "self", .body = block_on_slab(cells, across).body};
}

Setup vessels_setup(int along) {
    return {.kind = "vessels", .body = bar_along_bar(bars - along, along).body};
}

// A slab lies on a ball; the wider the ball, the more contacts.
Setup tool_setup(double ball_mm) {
    Setup setup{.kind = "tool", .body = slab_held_at_rim(cells), .ball_mm = ball_mm};
    setup.body.touchable = true;
    return setup;
}

Vec3 ball_centre(const Setup& setup) {
    const double middle = 0.5 * cells * study_cell_mm;
    return {middle, middle, -setup.ball_mm - study_gap_mm};
}

std::unique_ptr<Stepper> our_world(const Setup& setup, const Vec3& gravity) {
    auto stepper = make_cpu_stepper(setup.body, {.sleeping = false});
    stepper->set_gravity(gravity);
    if (setup.ball_mm > 0.0) {
        Tool tool =
            single_tool({.centre_mm = ball_centre(setup), .radius_mm = setup.ball_mm - 0.2});
        tool.pad_mm = 0.2;
        tool.pressure_pa = 2.0 * setup.body.material.young_modulus_pa;
        tool.target_mm = tool.centre_mm();
        stepper->set_tool(tool);
    }
    return stepper;
}

ContactRow measure(const Setup& setup, const ContactStudyOptions& options, Job& job) {
    const ThreadLimit limit(options.threads);
    const Vec3 gravity(0.0, 0.0, -units::standard_gravity);
    const auto ours = our_world(setup, gravity);
    StepReport report;
    const auto step = [&] {
        job.throw_if_cancelled();
        report = ours->step(frame_s, job.stop_token());
    };
    for (int k = 0; k < most_settling; ++k) step();
    std::vector<double> step_ms, iterations;
    for (int k = 0; k < options.steps; ++k) {
        const FrameTimer timer;
        step();
        step_ms.push_back(timer.passed().cost_ms());
        iterations.push_back(report.linear_iterations);
    }
    const bool tool = setup.ball_mm > 0.0;
    ContactRow row{.kind = setup.kind,
                   .contacts = tool ? report.tool.contacts : report.self.contacts,
                   .step_ms = quantile(step_ms, 0.5),
                   .step_ms_p95 = quantile(step_ms, 0.95),
                   .linear_iterations = quantile(iterations, 0.5)};
    row.rows = row.contacts * (tool ? rows_of_a_tool_contact : rows_of_a_self_contact);
    row.in_time = row.step_ms <= options.budget_ms;
    row.tetrahedra = static_cast<int>(setup.body.mesh.tetrahedra.size());
    return row;
}

// Measures the setups of one kind, with ascending numbers of contacts.
void measure(const std::vector<Setup>& setups, const ContactStudyOptions& options, Job& job,
             std::vector<ContactRow>& rows) {
    for (std::size_t i = 0; i < setups.size(); ++i) {
        rows.push_back(measure(setups[i], options, job));
        job.advance(static_cast<double>(i + 1) / static_cast<double>(setups.size()));
        if (options.to_budget && !rows.back().in_time) return;
    }
}

}  // namespace

std::vector<ContactRow> study_contacts(const ContactStudyOptions& options, Job& job) {
    std::vector<Setup> self, vessels, tool;
    for (const int across : {2, 3, 4, 6, 8, 12, 16, 22}) self.push_back(self_setup(across));
    for (const int along : {6, 12, 24, 48, 72, 96}) vessels.push_back(vessels_setup(along));
    for (const double radius_mm : {2.0, 5.0, 20.0, 100.0, 500.0, 2e3, 3e3, 4e3})
        tool.push_back(tool_setup(radius_mm));
    std::vector<ContactRow> rows;
    job.begin_stage("Contacts of surfaces");
    measure(self, options, job, rows);
    job.begin_stage("Contacts of vessels");
    measure(vessels, options, job, rows);
    job.begin_stage("Contacts of a tool");
    measure(tool, options, job, rows);
    return rows;
}

ContactRow most_in_time(const std::vector<ContactRow>& rows, const std::string& kind) {
    ContactRow most{.kind = kind};
    for (const ContactRow& row : rows)
        if (row.kind == kind && row.in_time && row.contacts > most.contacts) most = row;
    return most;
}

}  // namespace hepatica
