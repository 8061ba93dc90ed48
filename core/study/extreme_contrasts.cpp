// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the stability suite: contrasts of stiffness and density along a beam, slivers, and starts
// far from rest.
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <sstream>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/study/extreme_cases.h"
#include "core/study/reference_beam.h"
#include "core/study/touch_bodies.h"
#include "core/study/trial.h"

namespace hepatica {
namespace {

using AlongBeam = std::function<double(double x_mm)>;

// Tip deflection of a cantilever whose modulus and weight vary along it: the unit-load theorem with
// bending and shear, integrated by the midpoint rule.
double beam_tip_mm(const BeamSpec& spec, const AlongBeam& stiffness, const AlongBeam& weight) {
    const int n = 4000;
    const double length = spec.length_mm, h = length / n, nu = spec.material.poisson_ratio;
    const double area = spec.section_mm * spec.section_mm;
    const double inertia = area * area / 12.0;
    const double kappa = shear_coefficient(spec.material);
    const double q = spec.material.density_g_mm3 * area * spec.gravity_mm_s2;
    double shear = 0.0, moment = 0.0, tip = 0.0;
    for (int i = n - 1; i >= 0; --i) {  // from the tip to the clamp
        const double x = (i + 0.5) * h, load = q * weight(x) * h;
        const double e = spec.material.young_modulus_pa * stiffness(x);
        const double mid_shear = shear + 0.5 * load, mid_moment = moment + 0.5 * h * mid_shear;
        tip += h * ((length - x) * mid_moment / (e * inertia) +
                    mid_shear / (kappa * e / (2.0 * (1.0 + nu)) * area));
        moment += h * mid_shear;
        shear += load;
    }
    return tip;
}

double middle_of(const BodyDescription& body, std::size_t element) {
    double x = 0.0;
    const std::size_t tetrahedra = body.mesh.tetrahedra.size();
    if (element < tetrahedra) {
        for (const int v : body.mesh.tetrahedra[element]) x += body.mesh.vertices_mm[v][0] / 4.0;
    } else {
        for (const int v : body.hexahedra[element - tetrahedra])
            x += body.mesh.vertices_mm[v][0] / 8.0;
    }
    return x;
}

ExtremeRow run_contrast(const std::string& element, LinearSolverKind solver, double dt,
                        const AlongBeam& stiffness, const AlongBeam& weight,
                        const ExtremeRun& how) {
    ExtremeRow row;
    const Discretisation d = discretisation_of(element);
    BeamSpec spec;
    spec.cells = d.hexahedra ? Index3{20, 2, 2} : Index3{16, 2, 2};
    // The tip sinks by 0.5 % of the length, so that linear theory also holds for the short flexible
    // part.
    spec.gravity_mm_s2 *= 1.0 / beam_tip_mm(spec, stiffness, weight);
    BodyDescription body = clamped_beam(spec, d);
    for (std::size_t e = 0; e < body.mesh.tetrahedra.size() + body.hexahedra.size(); ++e) {
        body.stiffness_factor.push_back(stiffness(middle_of(body, e)));
        body.density_factor.push_back(weight(middle_of(body, e)));
    }
    body.material.damping_low_hz = 0.5;
    body.material.damping_high_hz = 20.0;
    const auto stepper = make_cpu_stepper(
        body, {.model = d.model, .order = d.order, .solver = solver, .audit = true});
    stepper->set_gravity(Vec3(0, 0, -spec.gravity_mm_s2));
    // Rounding errors of a stiff tip's forces do work in proportion to the motion that a soft clamp
    // allows, whereas the energies fall with its square.
    const bool stiff_tip = stiffness(spec.length_mm) > 1e3 * stiffness(0.0);
    Trial trial(*stepper, row, how, stiff_tip ? 1.0 : 0.0);
    if (!trial.run(static_cast<int>(std::max(150.0, 20.0 / dt)), dt)) return row;
    trial.require_close(tip_deflection_mm(spec, body.mesh.vertices_mm, stepper->positions_mm()),
                        beam_tip_mm(spec, stiffness, weight), 0.06, "Timoshenko, piecewise");
    trial.require_positive_volumes(body, d.model, d.order);
    stepper->set_gravity(Vec3::Zero());
    if (trial.run(300, std::max(dt, 0.1)))
        trial.require_back_at(body.mesh.vertices_mm, 2e-3 * spec.length_mm);
    return row;
}

void add_contrasts(std::vector<ExtremeCase>& cases) {
    const auto one = [](double) { return 1.0; };
    const auto stiff_tip = [](double x) { return x > 100.0 ? 1e6 : 1.0; };
    const auto stiff_root = [](double x) { return x < 100.0 ? 1e6 : 1.0; };
    const auto heavy_tip = [](double x) { return x > 100.0 ? 1.0 : 1e-6; };
    const auto heavy_root = [](double x) { return x < 100.0 ? 1.0 : 1e-6; };
    struct Kind {
        const char* name;
        AlongBeam stiffness, weight;
    };
    for (const Kind& kind : {Kind{"stiffness 1:1e6, stiff tip", stiff_tip, one},
                             Kind{"stiffness 1:1e6, stiff root", stiff_root, one},
                             Kind{"density 1:1e6, heavy tip", one, heavy_tip},
                             Kind{"density 1:1e6, heavy root", one, heavy_root}})
        for (const char* element : {"corotated-10", "hexahedron"})
            for (const LinearSolverKind solver :
                 {LinearSolverKind::automatic, LinearSolverKind::cholesky})
                for (const double dt : {0.1, 1.0}) {
                    std::ostringstream name;
                    name << "contrast " << kind.name << ' ' << element << ' ' << name_of(solver)
                         << " dt=" << dt;
                    cases.push_back({name.str(), [=](const ExtremeRun& how) {
                                         return run_contrast(element, solver, dt, kind.stiffness,
                                                             kind.weight, how);
                                     }});
                }
}

// One layer of cells is squeezed until its tetrahedra have dihedral angles of the given size.
ExtremeRow run_sliver(const std::string& element, double angle_deg, double dt,
                      const ExtremeRun& how) {
    ExtremeRow row;
    const Discretisation d = discretisation_of(element);
    BeamSpec spec;
    spec.cells = d.order == ElementOrder::quadratic ? Index3{11, 1, 1} : Index3{11, 2, 2};
    BodyDescription body = clamped_beam(spec, d);
    const double cell = spec.section_mm / spec.cells[1];
    const double thin = cell * std::tan(angle_deg * std::numbers::pi / 180.0);
    for (Vec3& x : body.mesh.vertices_mm) {
        const int plane = static_cast<int>(std::lround(x[0] / spec.length_mm * 11.0));
        x[0] = plane <= 5 ? 20.0 * plane : plane == 6 ? 100.0 + thin : 20.0 * (plane - 1);
    }
    const auto stepper =
        make_cpu_stepper(body, {.model = d.model, .order = d.order, .audit = true});
    stepper->set_gravity(Vec3(0, 0, -spec.gravity_mm_s2));
    Trial trial(*stepper, row, how);
    if (!trial.run(150, dt)) return row;
    const double tip = tip_deflection_mm(spec, body.mesh.vertices_mm, stepper->positions_mm());
    if (d.order == ElementOrder::quadratic || d.hexahedra)
        trial.require_close(tip, timoshenko_tip_mm(spec), 0.06, "Timoshenko");
    else
        trial.require(tip > 0.0 && tip < 1.02 * timoshenko_tip_mm(spec),
                      "the tip does not rest where a beam can");
    trial.require_positive_volumes(body, d.model, d.order);
    stepper->set_gravity(Vec3::Zero());
    if (trial.run(100, std::max(dt, 0.05)))
        trial.require_back_at(body.mesh.vertices_mm, 2e-3 * spec.length_mm);
    return row;
}

using Deform = std::function<Vec3(const Vec3& rest, std::mt19937_64& random)>;

// Starts from a severely deformed shape and must return to rest by itself.
ExtremeRow run_broken_start(const std::string& element, double dt, const Deform& deform,
                            const ExtremeRun& how) {
    ExtremeRow row;
    const Discretisation d = discretisation_of(element);
    BeamSpec spec;
    spec.length_mm = 80.0;
    spec.cells = d.order == ElementOrder::quadratic ? Index3{4, 2, 2} : Index3{6, 3, 3};
    spec.material.damping_ratio = 1.0;
    const BodyDescription body = clamped_beam(spec, d);
    const auto stepper =
        make_cpu_stepper(body, {.model = d.model, .order = d.order, .audit = true});
    std::vector<Vec3> start = body.mesh.vertices_mm;
    std::mt19937_64 random(5);
    for (std::size_t v = 0; v < start.size(); ++v)
        if (!body.fixed[v]) start[v] = deform(start[v], random);
    stepper->set_state(start, std::vector<Vec3>(start.size(), Vec3::Zero()));
    Trial trial(*stepper, row, how);
    if (trial.run(300, dt) && trial.run(100, std::max(dt, 0.05))) {
        trial.require_positive_volumes(body, d.model, d.order);
        trial.require_back_at(body.mesh.vertices_mm, 2e-3 * spec.length_mm);
    }
    return row;
}

void add_shapes(std::vector<ExtremeCase>& cases) {
    for (const char* element : {"corotated", "corotated-10", "hexahedron"})
        for (const double angle : {10.0, 1.0, 0.1, 0.01})
            for (const double dt : {1.0 / 60.0, 1.0}) {
                std::ostringstream name;
                name << "sliver " << element << " angle=" << angle << " dt=" << dt;
                cases.push_back({name.str(), [=](const ExtremeRun& how) {
                                     return run_sliver(element, angle, dt, how);
                                 }});
            }
    struct Start {
        const char* name;
        Deform deform;
    };
    const Start starts[] = {
        {"flat", [](const Vec3& x, std::mt19937_64&) { return Vec3(x[0], x[1], 20.0); }},
        {"line", [](const Vec3& x, std::mt19937_64&) { return Vec3(x[0], 20.0, 20.0); }},
        {"inverted", [](const Vec3& x, std::mt19937_64&) { return Vec3(x[0], x[1], 40.0 - x[2]); }},
        {"crushed", [](const Vec3&, std::mt19937_64&) { return Vec3(40, 20, 20); }},
        {"turned back", [](const Vec3& x, std::mt19937_64&) { return Vec3(-x[0], x[1], x[2]); }},
        {"stretched 10 times", [](const Vec3& x, std::mt19937_64&) { return Vec3(10.0 * x); }},
        {"random", [](const Vec3&, std::mt19937_64& random) {
             const double z = uniform(random, 0, 40);
             const double y = uniform(random, 0, 40);
             const double x = uniform(random, 0, 80);
             return Vec3(x, y, z);
         }}};
    for (const Start& start : starts)
        for (const char* element : {"corotated", "neohookean", "corotated-10", "hexahedron"})
            for (const double dt : {1e-3, 1.0 / 60.0}) {
                std::ostringstream name;
                name << "start " << start.name << ' ' << element << " dt=" << dt;
                cases.push_back({name.str(), [=](const ExtremeRun& how) {
                                     return run_broken_start(element, dt, start.deform, how);
                                 }});
            }
}

}  // namespace

void add_contrast_and_shape_cases(std::vector<ExtremeCase>& cases) {
    add_contrasts(cases);
    add_shapes(cases);
}

}  // namespace hepatica
