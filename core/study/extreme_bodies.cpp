// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the stability suite: long runs at rest, in flight and spinning, tiny and disconnected
// bodies, overflow, and input that must be refused.
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/study/extreme_cases.h"
#include "core/study/trial.h"

namespace hepatica {
namespace {

constexpr int long_run = 100000;

BodyDescription small_body() {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(10, 8, 6), {1, 1, 1});
    body.material.damping_ratio = 0.0;
    return body;
}

StepperOptions awake() {
    return {.solver = LinearSolverKind::block_jacobi,
            .linear = {.energy_tolerance = 1e-10},
            .sleeping = false,
            .audit = true};
}

Vec3 momentum(const Stepper& stepper, std::span<const double> mass) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < mass.size(); ++i) sum += mass[i] * stepper.velocities_mm_per_s()[i];
    return sum;
}

Vec3 angular_momentum(const Stepper& stepper, std::span<const double> mass) {
    Vec3 centre = Vec3::Zero(), sum = Vec3::Zero();
    double total = 0.0;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        centre += mass[i] * stepper.positions_mm()[i];
        total += mass[i];
    }
    centre /= total;
    for (std::size_t i = 0; i < mass.size(); ++i)
        sum +=
            mass[i] * (stepper.positions_mm()[i] - centre).cross(stepper.velocities_mm_per_s()[i]);
    return sum;
}

ExtremeRow rest_for_long(double dt, const ExtremeRun& how) {
    ExtremeRow row;
    BodyDescription body = small_body();
    const auto stepper = make_cpu_stepper(body, awake());
    Trial trial(*stepper, row, how);
    if (trial.run(long_run, dt)) trial.require_back_at(body.mesh.vertices_mm, 1e-9);
    return row;
}

ExtremeRow fly_for_long(double dt, const ExtremeRun& how) {
    ExtremeRow row;
    const BodyDescription body = small_body();
    const std::vector<double> mass =
        build_body(body, ElementModel::corotated, ElementOrder::linear).mass_g;
    const auto stepper = make_cpu_stepper(body, awake());
    const std::vector<Vec3> velocities(mass.size(), Vec3(300, -200, 100));
    stepper->set_state(body.mesh.vertices_mm, velocities);
    const Vec3 before = momentum(*stepper, mass);
    Trial trial(*stepper, row, how);
    if (!trial.run(long_run, dt)) return row;
    const double drift = (momentum(*stepper, mass) - before).norm() / before.norm();
    trial.require_close(1.0 + drift, 1.0, 1e-9, "conservation of momentum");
    return row;
}

// Backward Euler slows a spin by d omega/dt = -dt omega^3; nothing else may slow it.
ExtremeRow spin_for_long(double dt, double omega, const ExtremeRun& how) {
    ExtremeRow row;
    const BodyDescription body = small_body();
    const std::vector<double> mass =
        build_body(body, ElementModel::corotated, ElementOrder::linear).mass_g;
    const auto stepper = make_cpu_stepper(body, awake());
    Vec3 centre = Vec3::Zero();
    double total = 0.0;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        centre += mass[i] * body.mesh.vertices_mm[i];
        total += mass[i];
    }
    centre /= total;
    std::vector<Vec3> velocities;
    for (const Vec3& x : body.mesh.vertices_mm)
        velocities.push_back(Vec3(0, 0, omega).cross(Vec3(x - centre)));
    stepper->set_state(body.mesh.vertices_mm, velocities);
    const double before = angular_momentum(*stepper, mass).norm();
    Trial trial(*stepper, row, how);
    if (!trial.run(long_run, dt)) return row;
    const double left = angular_momentum(*stepper, mass).norm() / before;
    const double expected = 1.0 / std::sqrt(1.0 + 2.0 * omega * omega * dt * dt * long_run);
    // The loss is judged, not what is left, of which it is a thousandth.
    trial.require_close(1.0 - left, 1.0 - expected, 0.1, "backward Euler's own loss of spin");
    return row;
}

ExtremeRow fall(const BodyDescription& body, std::size_t first_free, const ExtremeRun& how) {
    ExtremeRow row;
    const auto stepper =
        make_cpu_stepper(body, {.linear = {.energy_tolerance = 1e-10}, .audit = true});
    stepper->set_gravity(Vec3(0, 0, -9810));
    Trial trial(*stepper, row, how);
    if (!trial.run(60, 1.0 / 60.0)) return row;
    const double expected = 9810.0 * 60.0 * 61.0 / 2.0 / 3600.0;
    std::vector<double> fallen_mm;
    for (std::size_t v = first_free; v < body.mesh.vertices_mm.size(); ++v)
        fallen_mm.push_back(body.mesh.vertices_mm[v][2] - stepper->positions_mm()[v][2]);
    trial.require_all_close(fallen_mm, expected, 1e-6, "free fall");
    return row;
}

BodyDescription one_element() {
    BodyDescription body = small_body();
    body.mesh.vertices_mm = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    body.mesh.tetrahedra = {{0, 1, 2, 3}};
    return body;
}

// The first body is clamped, the second beside it is free.
BodyDescription two_bodies() {
    BodyDescription body = small_body();
    const TetMesh other = body.mesh;
    const int offset = static_cast<int>(other.vertices_mm.size());
    for (const Vec3& x : other.vertices_mm) {
        body.fixed.push_back(x[2] == 0.0);
        body.mesh.vertices_mm.push_back(x + Vec3(100, 0, 0));
    }
    for (const auto& t : other.tetrahedra)
        body.mesh.tetrahedra.push_back(
            {t[0] + offset, t[1] + offset, t[2] + offset, t[3] + offset});
    body.fixed.resize(2 * static_cast<std::size_t>(offset), 0);
    return body;
}

ExtremeRow everything_fixed(const ExtremeRun& how) {
    ExtremeRow row;
    BodyDescription body = small_body();
    body.fixed.assign(body.mesh.vertices_mm.size(), 1);
    const auto stepper = make_cpu_stepper(body, {.audit = true});
    stepper->set_gravity(Vec3(0, 0, -9810));
    Trial trial(*stepper, row, how);
    if (trial.run(100, 1.0 / 60.0)) trial.require_back_at(body.mesh.vertices_mm, 0.0);
    return row;
}

// Finite, but so large that forces and energies overflow.
ExtremeRow overflow(double size_mm, double speed_mm_s, const ExtremeRun& how) {
    ExtremeRow row;
    const BodyDescription body = small_body();
    const auto stepper = make_cpu_stepper(body, {});
    std::vector<Vec3> x = body.mesh.vertices_mm, v(x.size(), Vec3::Zero());
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] *= size_mm;
        v[i] = speed_mm_s * Vec3(1, i % 2 ? 1 : -1, 0);
    }
    stepper->set_state(x, v);
    for (int i = 0; i < 5; ++i) {
        stepper->step(1.0 / 60.0, how.stop);
        for (const Vec3& p : stepper->positions_mm())
            if (!p.allFinite()) row.note = "a position is not finite";
    }
    stepper->set_state(body.mesh.vertices_mm, std::vector<Vec3>(v.size(), Vec3::Zero()));
    Trial trial(*stepper, row, how);
    if (trial.run(10, 1.0 / 60.0)) trial.require_back_at(body.mesh.vertices_mm, 1e-9);
    return row;
}

// Passes only if `attempt` throws InputError.
ExtremeCase refusal(const std::string& name, const std::function<void()>& attempt) {
    return {"refuse " + name, [attempt](const ExtremeRun&) {
                ExtremeRow row;
                try {
                    attempt();
                    row.note = "was accepted";
                } catch (const InputError& error) {
                    row.refused = true;
                    row.note = error.what();
                }
                return row;
            }};
}

void refuse_description(std::vector<ExtremeCase>& cases, const std::string& name,
                        const std::function<void(BodyDescription&)>& spoil) {
    cases.push_back(refusal(name, [spoil] {
        BodyDescription body = small_body();
        spoil(body);
        make_cpu_stepper(body, {});
    }));
}

void refuse_call(std::vector<ExtremeCase>& cases, const std::string& name,
                 const std::function<void(Stepper&)>& call) {
    cases.push_back(refusal(name, [call] {
        const auto stepper = make_cpu_stepper(small_body(), {});
        try {
            call(*stepper);
        } catch (const InputError&) {
            stepper->step(0.01);  // the refused call must have had no effect
            for (const Vec3& x : stepper->positions_mm())
                if (!x.allFinite()) return;
            throw;
        }
    }));
}

void refuse_grab(std::vector<ExtremeCase>& cases, const std::string& name,
                 const std::function<void(Grab&)>& spoil) {
    refuse_call(cases, "grab " + name, [spoil](Stepper& stepper) {
        Grab grab{.vertices = {0, -1, -1, -1}};
        grab.stiffness_un_per_mm = 1e4;
        grab.force_limit_un = 1e6;
        spoil(grab);
        stepper.set_grabs(std::span(&grab, 1));
    });
}

}  // namespace

void add_long_runs(std::vector<ExtremeCase>& cases) {
    cases.push_back({"100000 steps at rest dt=1/60",
                     [](const ExtremeRun& how) { return rest_for_long(1.0 / 60.0, how); }});
    cases.push_back({"100000 steps in flight dt=1e-3",
                     [](const ExtremeRun& how) { return fly_for_long(1e-3, how); }});
    cases.push_back({"100000 steps spinning dt=1e-4 1 rad/s",
                     [](const ExtremeRun& how) { return spin_for_long(1e-4, 1, how); }});
    cases.push_back(
        {"one element falls", [](const ExtremeRun& how) { return fall(one_element(), 0, how); }});
    cases.push_back(
        {"nothing fixed falls", [](const ExtremeRun& how) { return fall(small_body(), 0, how); }});
    cases.push_back({"two disconnected bodies, one clamped, one falls", [](const ExtremeRun& how) {
                         const BodyDescription body = two_bodies();
                         return fall(body, body.mesh.vertices_mm.size() / 2, how);
                     }});
    cases.push_back({"everything fixed", everything_fixed});
    cases.push_back(
        {"overflow of positions", [](const ExtremeRun& how) { return overflow(1e200, 0.0, how); }});
    cases.push_back({"overflow of velocities",
                     [](const ExtremeRun& how) { return overflow(1.0, 1e200, how); }});
    cases.push_back(
        {"overflow of both", [](const ExtremeRun& how) { return overflow(1e150, 1e300, how); }});
}

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

void refuse_meshes(std::vector<ExtremeCase>& cases) {
    refuse_description(cases, "a lone vertex", [](BodyDescription& b) {
        b.mesh.vertices_mm = {Vec3(1, 2, 3)};
        b.mesh.tetrahedra.clear();
    });
    refuse_description(cases, "an empty body", [](BodyDescription& b) { b.mesh = {}; });
    refuse_description(cases, "a vertex of no element",
                       [](BodyDescription& b) { b.mesh.vertices_mm.push_back(Vec3(9, 9, 9)); });
    refuse_description(cases, "a flat element", [](BodyDescription& b) {
        for (Vec3& x : b.mesh.vertices_mm) x[2] = 0.0;
    });
    refuse_description(cases, "an inverted element", [](BodyDescription& b) {
        std::swap(b.mesh.tetrahedra[2][0], b.mesh.tetrahedra[2][1]);
    });
    refuse_description(cases, "an index out of range",
                       [](BodyDescription& b) { b.mesh.tetrahedra[1][3] = 99; });
    refuse_description(cases, "a NaN vertex",
                       [](BodyDescription& b) { b.mesh.vertices_mm[3][1] = nan; });
    refuse_description(cases, "an infinite vertex",
                       [](BodyDescription& b) { b.mesh.vertices_mm[3][1] = inf; });
}

void refuse_materials(std::vector<ExtremeCase>& cases) {
    for (const double nu : {0.5, 0.6, -0.1, nan})
        refuse_description(cases, "nu=" + std::to_string(nu),
                           [nu](BodyDescription& b) { b.material.poisson_ratio = nu; });
    for (const double e : {0.0, -1.0, inf, nan})
        refuse_description(cases, "E=" + std::to_string(e),
                           [e](BodyDescription& b) { b.material.young_modulus_pa = e; });
    for (const double rho : {0.0, nan})
        refuse_description(cases, "density=" + std::to_string(rho),
                           [rho](BodyDescription& b) { b.material.density_g_mm3 = rho; });
    refuse_description(cases, "a stiffness factor of 0",
                       [](BodyDescription& b) { b.stiffness_factor = {1, 1, 0, 1, 1, 1}; });
    refuse_description(cases, "a NaN tether",
                       [](BodyDescription& b) { b.tether_pa_per_mm2 = nan; });
}

void refuse_clocks_and_states(std::vector<ExtremeCase>& cases) {
    for (const double dt : {0.0, -0.01, inf, nan})
        refuse_call(cases, "dt=" + std::to_string(dt), [dt](Stepper& s) { s.step(dt); });
    for (const double g : {inf, nan})
        refuse_call(cases, "gravity=" + std::to_string(g),
                    [g](Stepper& s) { s.set_gravity(Vec3(0, g, 0)); });
    for (const double x : {inf, nan}) {
        refuse_call(cases, "position=" + std::to_string(x), [x](Stepper& s) {
            std::vector<Vec3> p(s.positions_mm().begin(), s.positions_mm().end());
            p[3][0] = x;
            s.set_state(p, std::vector<Vec3>(p.size(), Vec3::Zero()));
        });
        refuse_call(cases, "velocity=" + std::to_string(x), [x](Stepper& s) {
            std::vector<Vec3> p(s.positions_mm().begin(), s.positions_mm().end());
            std::vector<Vec3> v(p.size(), Vec3::Zero());
            v[2][1] = x;
            s.set_state(p, v);
        });
    }
}

void refuse_grabs(std::vector<ExtremeCase>& cases) {
    for (const double x : {inf, nan}) {
        refuse_grab(cases, "target=" + std::to_string(x),
                    [x](Grab& g) { g.target_mm = Vec3(x, 0, 0); });
        refuse_grab(cases, "stiffness=" + std::to_string(x),
                    [x](Grab& g) { g.stiffness_un_per_mm = x; });
        refuse_grab(cases, "force limit=" + std::to_string(x),
                    [x](Grab& g) { g.force_limit_un = x; });
        refuse_grab(cases, "weight=" + std::to_string(x), [x](Grab& g) { g.weights[0] = x; });
    }
    refuse_grab(cases, "of vertex 99", [](Grab& g) { g.vertices[0] = 99; });
    refuse_grab(cases, "stiffness=0", [](Grab& g) { g.stiffness_un_per_mm = 0; });
}

}  // namespace

void add_refusals(std::vector<ExtremeCase>& cases) {
    refuse_meshes(cases);
    refuse_materials(cases);
    refuse_clocks_and_states(cases);
    refuse_grabs(cases);
}

}  // namespace hepatica
