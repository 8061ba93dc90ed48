// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/contact_study.h"

#include <algorithm>
#include <memory>

#include "core/base/frame_time.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/study/timing.h"

namespace hepatica {

namespace {

constexpr double cell_mm = 2.0, layers_mm = 6.0, gap_mm = 0.05;
constexpr int layers = 3, cells = 24;  // of the lower block: 10,368 tetrahedra
constexpr int rows_of_a_self_contact = 1, rows_of_a_tool_contact = 3;
constexpr int most_settling = 60;

struct Setup {
    std::string kind;
    TetMesh lower, upper;  // of a tool alone the lower
    std::vector<std::uint8_t> fixed;
    double ball_mm = 0.0;  // radius; 0: no tool
    Material material{.young_modulus_pa = 2e4,
                      .poisson_ratio = 0.3,
                      .density_g_mm3 = 1e-3,
                      .damping_ratio = 0.05};
};

// A block of so many cells across on a slab whose bottom is held.
Setup self_setup(int across) {
    Setup setup;
    setup.kind = "self";
    const double wide = cells * cell_mm;
    setup.lower = kuhn_brick(Vec3(wide, wide, layers_mm), {cells, cells, layers});
    for (const Vec3& x : setup.lower.vertices_mm) setup.fixed.push_back(x.z() < 1e-9 ? 1 : 0);
    setup.upper = kuhn_brick(across * cell_mm * Vec3(1, 1, 0) + layers_mm * Vec3::UnitZ(),
                             {across, across, layers});
    // Beside the vertices below, as no two meshes fit.
    const double from = 0.5 * (wide - across * cell_mm);
    for (Vec3& x : setup.upper.vertices_mm)
        x += Vec3(from + 0.31 * cell_mm, from + 0.17 * cell_mm, layers_mm + gap_mm);
    return setup;
}

// A slab that is held at its rim lies on a ball: the wider, the more of it.
Setup tool_setup(double ball_mm) {
    Setup setup;
    setup.kind = "tool";
    const double wide = cells * cell_mm;
    setup.lower = kuhn_brick(Vec3(wide, wide, layers_mm), {cells, cells, layers});
    for (const Vec3& x : setup.lower.vertices_mm)
        setup.fixed.push_back(std::min({x.x(), x.y(), wide - x.x(), wide - x.y()}) < 1e-9 ? 1 : 0);
    setup.ball_mm = ball_mm;
    return setup;
}

Vec3 ball_centre(const Setup& setup) {
    const double middle = 0.5 * cells * cell_mm;
    return {middle, middle, -setup.ball_mm - gap_mm};
}

std::unique_ptr<Stepper> our_world(const Setup& setup, const Vec3& gravity) {
    BodyDescription body;
    body.mesh = setup.lower;
    const int first = static_cast<int>(body.mesh.vertices_mm.size());
    body.mesh.vertices_mm.insert(body.mesh.vertices_mm.end(), setup.upper.vertices_mm.begin(),
                                 setup.upper.vertices_mm.end());
    for (auto nodes : setup.upper.tetrahedra) {
        for (int& node : nodes) node += first;
        body.mesh.tetrahedra.push_back(nodes);
    }
    body.fixed = setup.fixed;
    body.fixed.resize(body.mesh.vertices_mm.size(), 0);
    body.material = setup.material;
    if (setup.ball_mm > 0.0)
        body.touchable = true;
    else
        body.self.emplace();
    auto stepper = make_cpu_stepper(body, {.sleeping = false});
    stepper->set_gravity(gravity);
    if (setup.ball_mm > 0.0) {
        Tool tool =
            single_tool({.centre_mm = ball_centre(setup), .radius_mm = setup.ball_mm - 0.2});
        tool.pad_mm = 0.2;
        tool.pressure_pa = 2.0 * setup.material.young_modulus_pa;
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
    row.tetrahedra =
        static_cast<int>(setup.lower.tetrahedra.size() + setup.upper.tetrahedra.size());
    return row;
}

// Of one kind, the least contacts first.
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
    std::vector<Setup> self, tool;
    for (const int across : {2, 3, 4, 6, 8, 12, 16, 22}) self.push_back(self_setup(across));
    for (const double radius_mm : {2.0, 5.0, 20.0, 100.0, 500.0})
        tool.push_back(tool_setup(radius_mm));
    std::vector<ContactRow> rows;
    job.begin_stage("Contacts of surfaces");
    measure(self, options, job, rows);
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
