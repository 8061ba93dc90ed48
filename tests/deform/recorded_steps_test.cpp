// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of whole motions as they are today: bodies that are pulled, pressed, torn, let go and put
// to sleep, with every element, solver and option of a stepper.
#include <gtest/gtest.h>

#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/mesh/hex_mesh.h"
#include "tests/deform/support/step_figures.h"
#include "tests/deform/support/test_bodies.h"
#include "tests/deform/support/tool_oracles.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::StepSeries;

BodyDescription uneven_brick(bool hexahedra) {
    BodyDescription body;
    if (hexahedra) {
        const HexMesh brick = hexahedral_brick(Vec3(24, 6, 4), {6, 2, 1});
        body.mesh.vertices_mm = brick.vertices_mm;
        body.hexahedra = brick.hexahedra;
    } else {
        body.mesh = kuhn_brick(Vec3(24, 6, 4), {6, 2, 1});
    }
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.x() == 0.0);
    const std::size_t elements = body.mesh.tetrahedra.size() + body.hexahedra.size();
    for (std::size_t e = 0; e < elements; ++e) {
        body.stiffness_factor.push_back(0.6 + 0.1 * static_cast<double>(e % 7));
        body.density_factor.push_back(0.8 + 0.07 * static_cast<double>(e % 5));
    }
    body.material = {.young_modulus_pa = 2e4, .poisson_ratio = 0.4, .damping_ratio = 0.08};
    body.tether_pa_per_mm2 = 15.0;
    if (!hexahedra) body.skeleton = skeleton_of_mesh(body.mesh);
    return body;
}

Grab uneven_grab(const BodyDescription& body, int last, double pull_mm) {
    Grab grab{.vertices = {last, last - 1, last - 2, -1}, .weights = {0.5, 0.3, 0.2, 0.0}};
    grab.target_mm = body.mesh.vertices_mm[last] + pull_mm * Vec3(0.4, 1.0, -0.7);
    grab.stiffness_un_per_mm = 3e3;
    grab.force_limit_un = 9e3;
    return grab;
}

// Pulled aside under weight, further than the grab can bear, and let go.
StepSeries pulled(const BodyDescription& body, const StepperOptions& options, int steps = 14) {
    const auto stepper = make_cpu_stepper(body, options);
    const int last = static_cast<int>(body.mesh.vertices_mm.size()) - 1;
    stepper->set_gravity(Vec3(300.0, -2000.0, 700.0));
    StepSeries series;
    for (int k = 0; k < steps; ++k) {
        const Grab grabs[] = {uneven_grab(body, last, 0.8 * k), uneven_grab(body, last / 2, -0.3)};
        if (k < 9) stepper->set_grabs(grabs);
        if (k == 9) stepper->set_grabs({});
        const StepReport report = stepper->step(frame_s);
        series.add(*stepper, report);
    }
    return series;
}

TEST(StepFigures, OfEveryElement) {
    const auto record = [](const std::string& name, ElementModel model, ElementOrder order,
                           bool hexahedra) {
        const BodyDescription body = uneven_brick(hexahedra);
        for (const int newton : {1, 4})
            expect_recorded("deform", "steps_" + name + "_" + std::to_string(newton),
                            pulled(body, {.model = model,
                                          .order = order,
                                          .linear = {.energy_tolerance = 1e-5},
                                          .newton_iterations = newton})
                                .figures());
    };
    record("spring", ElementModel::spring, ElementOrder::linear, false);
    record("corotated", ElementModel::corotated, ElementOrder::linear, false);
    record("neohookean", ElementModel::neohookean, ElementOrder::linear, false);
    record("corotated-10", ElementModel::corotated, ElementOrder::quadratic, false);
    record("neohookean-10", ElementModel::neohookean, ElementOrder::quadratic, false);
    record("hexahedra", ElementModel::corotated, ElementOrder::linear, true);
}

TEST(StepFigures, OfEverySolver) {
    const BodyDescription body = uneven_brick(false);
    for (const LinearSolverKind solver :
         {LinearSolverKind::block_jacobi, LinearSolverKind::skeleton, LinearSolverKind::cholesky,
          LinearSolverKind::automatic})
        for (const double tolerance : {1e-1, 1e-6})
            expect_recorded(
                "deform",
                "solver_" + std::string(name_of(solver)) + (tolerance == 1e-1 ? "" : "_other"),
                pulled(body, {.solver = solver, .linear = {.energy_tolerance = tolerance}})
                    .figures());
}

TEST(StepFigures, OfEveryOption) {
    const BodyDescription body = uneven_brick(false);
    const auto record = [&](const std::string& name, const StepperOptions& options) {
        expect_recorded("deform", "option_" + name, pulled(body, options).figures());
    };
    record("default", {});
    record("substeps", {.substeps = 3});
    record("velocity_error", {.velocity_error = {.alpha_per_s = 2.0, .beta_s = 1e-3}});
    record("negative_error", {.velocity_error = {.alpha_per_s = -90.0, .beta_s = -0.05}});
    record("published", {.published = true});
    record("audit", {.newton_iterations = 2, .audit = true});
    record("loose_newton", {.newton_iterations = 9, .newton_tolerance = 3e-2});
    record("few_iterations", {.solver = LinearSolverKind::block_jacobi,
                              .linear = {.energy_tolerance = 1e-9, .max_iterations = 7}});
    record("residual", {.solver = LinearSolverKind::block_jacobi,
                        .linear = {.energy_tolerance = 0.0, .residual_tolerance = 1e-3}});
    record("skeleton_residual", {.solver = LinearSolverKind::skeleton,
                                 .linear = {.energy_tolerance = 0.0, .residual_tolerance = 1e-3}});
}

// A free body that is thrown and spun, twisted so far that elements are turned inside out.
TEST(StepFigures, OfAFreeBodyThrownAndCrushed) {
    BodyDescription body = uneven_brick(false);
    body.fixed.clear();
    body.tether_pa_per_mm2 = 0.0;
    for (const bool crushed : {false, true}) {
        const auto stepper = make_cpu_stepper(body, {.newton_iterations = crushed ? 3 : 1});
        stepper->set_gravity(Vec3(0, 0, -9810));
        std::vector<Vec3> x = body.mesh.vertices_mm, v;
        for (Vec3& p : x) {
            v.push_back(Vec3(30, -20, 10) + Vec3(4, 40, -30).cross(p));
            p = Eigen::AngleAxisd(0.05 * p.x(), Vec3::UnitX()) * p;
        }
        if (crushed) x.back() -= Vec3(9.0, 1.0, 0.5);
        stepper->set_state(x, v);
        StepSeries series;
        for (int k = 0; k < 10; ++k) {
            const StepReport report = stepper->step(k % 2 == 0 ? frame_s : 0.5 * frame_s);
            series.add(*stepper, report);
        }
        expect_recorded("deform", crushed ? "crushed" : "thrown", series.figures());
    }
}

// Until it rests; then it is asleep, wakes and is led elsewhere.
TEST(StepFigures, OfSleep) {
    BodyDescription body = uneven_brick(false);
    body.material.damping_ratio = 2.0;
    const auto stepper = make_cpu_stepper(body, {});
    StepSeries series;
    for (int k = 0; k < 90; ++k) {
        if (k == 3) stepper->set_gravity(Vec3(0, -500, 100));
        if (k == 6) stepper->set_gravity(Vec3(0, 0, 0));
        if (k == 85) stepper->set_gravity(Vec3(20, -50, 100));
        const StepReport report = stepper->step(frame_s);
        if (k % 5 == 0 || k > 84) series.add(*stepper, report);
    }
    expect_recorded("deform", "sleep", series.figures());
}

Tool uneven_jaws() {
    Tool tool;
    for (const double side : {-0.5, 0.5})
        tool.parts.push_back({.shape = {.centre_mm = Vec3(31, 3.2, 3) + side * 10.0 * Vec3::UnitZ(),
                                        .half_axis_mm = Vec3(0.5, 4, 0.3),
                                        .radius_mm = 1.5 + 0.2 * side},
                              .opens = side * Vec3::UnitZ()});
    tool.opening_mm = tool.opening_target_mm = 7.0;
    tool.target_mm = tool.centre_mm();
    tool.pad_mm = 0.4;
    tool.pressure_pa = 1e5;
    tool.friction = 0.4;
    tool.force_limit_un = 4e4;
    return tool;
}

TEST(StepFigures, OfATool) {
    BodyDescription body = test::bar();
    body.material.young_modulus_pa = 1e5;
    for (const int newton : {1, 4}) {
        const auto stepper = make_cpu_stepper(body, {.newton_iterations = newton});
        stepper->set_tool(uneven_jaws());
        StepSeries series;
        for (int k = 0; k < 26; ++k) {
            stepper->open_tool(std::max(7.0 - 0.4 * k, 2.0));
            if (k > 14) stepper->lead_tool(stepper->tool()->target_mm + Vec3(0.2, 0.15, 0.3));
            if (k > 16) stepper->turn_tool(Vec3(0.02, -0.01, 0.03));
            const StepReport report = stepper->step(frame_s);
            series.add(*stepper, report);
        }
        test::Figures figures = series.figures();
        figures.add("tool.centre", test::flat(std::vector{stepper->tool()->centre_mm()}));
        figures.add("tool.opening", stepper->tool()->opening_mm);
        figures.add("tool.reach", stepper->tool()->reach_mm());
        figures.add("tool.speed", stepper->tool()->speed_mm_per_s());
        expect_recorded("deform", "jaws_" + std::to_string(newton), figures);
    }
}

TEST(StepFigures, OfSurfacesThatTouch) {
    BodyDescription body = test::crossed_bars(0.15);
    body.material.young_modulus_pa = 5e4;
    for (const int newton : {1, 3}) {
        const auto stepper = make_cpu_stepper(body, {.newton_iterations = newton});
        std::vector<Vec3> v;
        for (const Vec3& x : body.mesh.vertices_mm)
            v.push_back(x.z() > 2.05 ? Vec3(3, -2, -60) : Vec3(0, 0, 15));
        stepper->set_state(body.mesh.vertices_mm, v);
        StepSeries series;
        for (int k = 0; k < 10; ++k) {
            const StepReport report = stepper->step(0.25 * frame_s);
            series.add(*stepper, report);
        }
        expect_recorded("deform", "bars_" + std::to_string(newton), series.figures());
    }
}

TEST(StepFigures, OfTears) {
    for (const bool bare : {false, true}) {
        BodyDescription body = uneven_brick(false);
        body.stiffness_factor.clear();
        body.tear = TearLaw{.strength_pa = 4e3,
                            .fracture_energy_j_m2 = 1.0,
                            .tear_factor = 0.9,
                            .bare_limit = bare};
        const auto stepper = make_cpu_stepper(body, {.newton_iterations = 2});
        const int last = static_cast<int>(body.mesh.vertices_mm.size()) - 1;
        StepSeries series;
        for (int k = 0; k < 16; ++k) {
            Grab grab = uneven_grab(body, last, 0.0);
            grab.target_mm += Vec3(0.9 * k, 0.1 * k, 0.05 * k);
            grab.force_limit_un = 1e5;
            stepper->set_grabs(std::span(&grab, 1));
            const int weak[] = {3, 8, 12};
            if (k == 2) stepper->weaken(weak, 0.3);
            if (k == 12) stepper->cut(Vec3(11, -1, -1), Vec3(0, 4, 0), Vec3(0, 0, 7));
            const StepReport report = stepper->step(frame_s);
            series.add(*stepper, report);
        }
        expect_recorded("deform", bare ? "tear_bare" : "tear", series.figures());
    }
}

// Only what moves is computed; what is still freezes, and wakes again.
TEST(StepFigures, OfALiveRegion) {
    BodyDescription body = test::description_of(test::make_brick_tree(3, 3.0, 1.5));
    body.material.damping_ratio = 0.5;
    const auto stepper = make_live_stepper(body, {.linear = {.energy_tolerance = 1e-6}},
                                           {.wake_radii = 1e-3, .still_radii_per_s = 5e-3});
    const int tip = test::tip_of(body);
    StepSeries series;
    std::vector<double> extents;
    for (int k = 0; k < 75; ++k) {
        Grab grab{.vertices = {k < 60 ? tip : tip / 2, -1, -1, -1}};
        grab.target_mm = body.mesh.vertices_mm[grab.vertices[0]] +
                         std::min(k < 60 ? k : k - 60, 8) * Vec3(0.03, 0.05, -0.02);
        grab.stiffness_un_per_mm = 2e4;
        grab.force_limit_un = 1e5;
        stepper->set_grabs(std::span(&grab, 1));
        const StepReport report = stepper->step(frame_s);
        if (k % 6 == 0 || k > 70) series.add(*stepper, report);
        const auto extent = stepper->extent();
        for (const int count :
             {extent.live_elements, extent.elements, extent.live_vertices, extent.vertices})
            extents.push_back(count);
    }
    const StepperCheckpoint kept = stepper->checkpoint();
    test::Figures figures = series.figures();
    figures.add("extents", extents);
    figures.add("region.live", kept.region->live);
    figures.add("region.still", kept.region->still_s);
    figures.add("region.held", test::as_doubles(kept.region->held));
    figures.add("region.reference", test::flat(kept.region->reference_mm));
    figures.add("bytes", static_cast<double>(to_bytes(kept).size()));
    expect_recorded("deform", "live", figures);
}

}  // namespace
}  // namespace hepatica
