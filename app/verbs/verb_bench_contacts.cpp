// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's table of contacts: how long a step takes with more and more of them.
// A block rests on another (self), or a slab on a
// ball (tool), under its weight; the touching area grows from row to row, the tetrahedra do not.
#include <algorithm>
#include <memory>

#include "app/verbs/verbs.h"
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
constexpr int rows_of_a_point_in_the_paper = 6;
constexpr int most_settling = 60;

struct ContactOptions {
    int steps = 30;
    int threads = 2;
    double budget_ms = 16.7;
};

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

Json measure(const Setup& setup, const ContactOptions& options) {
    const ThreadLimit limit(options.threads);
    const Vec3 gravity(0.0, 0.0, -units::standard_gravity);
    const auto ours = our_world(setup, gravity);
    StepReport report;
    for (int k = 0; k < most_settling; ++k) report = ours->step(frame_s);
    std::vector<double> our_ms, iterations;
    for (int k = 0; k < options.steps; ++k) {
        our_ms.push_back(timed_ms([&] { report = ours->step(frame_s); }));
        iterations.push_back(report.linear_iterations);
    }
    const bool tool = setup.ball_mm > 0.0;
    const int contacts = tool ? report.tool.contacts : report.self.contacts;
    const double step_ms = quantile(our_ms, 0.5);
    return {{"backend", "cpu"},
            {"method", tool ? "in the matrix" : "conjugate gradients"},
            {"kind", setup.kind},
            {"contacts", contacts},
            {"rows", contacts * (tool ? rows_of_a_tool_contact : rows_of_a_self_contact)},
            {"rows_as_the_paper_counts", contacts * rows_of_a_point_in_the_paper},
            {"step_ms", step_ms},
            {"step_ms_p95", quantile(our_ms, 0.95)},
            {"linear_iterations", quantile(iterations, 0.5)},
            {"in_time", step_ms <= options.budget_ms},
            {"tetrahedra", setup.lower.tetrahedra.size() + setup.upper.tetrahedra.size()},
            {"peer", nullptr},
            {"peer_ms", nullptr}};
}

}  // namespace

void add_bench_contacts(CommandLine& line) {
    const auto options = std::make_shared<ContactOptions>();
    CLI::App& verb = line.add_verb("bench", "Benchmarks", "contacts",
                                   "Steps with more and more contacts, of surfaces and of a tool",
                                   [options](Job& job) {
                                       std::vector<Setup> setups;
                                       for (const int across : {2, 3, 4, 6, 8, 12, 16, 22})
                                           setups.push_back(self_setup(across));
                                       for (const double radius_mm : {2.0, 5.0, 20.0, 100.0, 500.0})
                                           setups.push_back(tool_setup(radius_mm));
                                       Json rows = Json::array();
                                       for (const Setup& setup : setups) {
                                           job.begin_stage(setup.kind + " contact");
                                           rows.push_back(measure(setup, *options));
                                       }
                                       return Json{{"threads", options->threads}, {"rows", rows}};
                                   });
    verb.add_option("--steps", options->steps, "Measured, after the bodies have come to rest")
        ->check(CLI::Range(5, 100000))
        ->capture_default_str();
    verb.add_option("--threads", options->threads, "Of ours")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    verb.add_option("--budget-ms", options->budget_ms, "Of a step in time")->capture_default_str();
}

}  // namespace hepatica
