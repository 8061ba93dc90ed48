// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the stability suite: a clamped beam over modulus, time step, Poisson's ratio and element,
// judged by beam theory.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/study/extreme_cases.h"
#include "core/study/reference_beam.h"
#include "core/study/trial.h"

namespace hepatica {
namespace {

struct BeamRow {
    std::string element;
    double young_pa;
    double dt_s;
    double nu;
    int newton = 1;
};

// Gravity is proportional to the modulus, so that all beams have the same shape at rest, with the
// tip 8 % of the length lower, and one closed form judges all of them.
BeamSpec spec_of(const BeamRow& row, const Discretisation& d) {
    BeamSpec spec;
    spec.cells = d.order == ElementOrder::quadratic ? Index3{10, 1, 1}
                 : !d.hexahedra                     ? Index3{12, 2, 2}
                 : row.nu > 0.4                     ? Index3{20, 4, 4}
                                                    : Index3{14, 3, 3};
    spec.material.young_modulus_pa = row.young_pa;
    spec.material.poisson_ratio = row.nu;
    spec.gravity_mm_s2 = 9810.0 * row.young_pa / 1e6;
    const double frequency = 1.0 / first_period_s(spec);
    spec.material.damping_low_hz = frequency;
    spec.material.damping_high_hz = 10.0 * frequency;
    return spec;
}

// Linear tetrahedra are too stiff with so few cells, and springs are no exact solid. They must
// sink, but not further than theory says (springs: not further than twice that).
void judge_rest(const BeamSpec& spec, const Discretisation& d, double tip, Trial& trial) {
    const double theory = timoshenko_tip_mm(spec);
    if (d.order == ElementOrder::quadratic || d.hexahedra)
        trial.require_close(tip, theory, spec.material.poisson_ratio > 0.4 ? 0.08 : 0.06,
                            "Timoshenko");
    else
        trial.require(tip > 0.0 && tip < (d.model == ElementModel::spring ? 2.0 : 1.02) * theory,
                      "the tip does not rest where a beam can");
}

ExtremeRow run_beam(const BeamRow& what, const ExtremeRun& how) {
    ExtremeRow row;
    const Discretisation d = discretisation_of(what.element);
    const BeamSpec spec = spec_of(what, d);
    const BodyDescription body = clamped_beam(spec, d);
    const auto stepper = make_cpu_stepper(
        body,
        {.model = d.model, .order = d.order, .newton_iterations = what.newton, .audit = true});
    stepper->set_gravity(Vec3(0, 0, -spec.gravity_mm_s2));
    Trial trial(*stepper, row, how);
    const double period = first_period_s(spec), dt = what.dt_s;
    const int steps = static_cast<int>(std::clamp(5.0 * period / dt, 30.0, 60.0));
    if (!trial.run(steps, dt)) return row;
    const double tip = tip_deflection_mm(spec, body.mesh.vertices_mm, stepper->positions_mm());
    const double time = steps * dt, theory = timoshenko_tip_mm(spec);
    if (time < 0.03 * period)  // no wave has arrived from the clamp yet
        trial.require_close(tip, 0.5 * spec.gravity_mm_s2 * time * (time + dt), 0.05, "free fall");
    else if (time > 4.9 * period)
        judge_rest(spec, d, tip, trial);
    else
        trial.require(tip > -0.1 * theory && tip < 2.2 * theory, "the tip swings too far");
    trial.require(tip < spec.length_mm + spec.section_mm, "the tip left the beam's reach");
    trial.require_positive_volumes(body, d.model, d.order);
    stepper->set_gravity(Vec3::Zero());
    if (trial.run(60, std::max(dt, period / 10.0)))
        trial.require_back_at(body.mesh.vertices_mm, 2e-3 * spec.length_mm);
    return row;
}

void add(std::vector<ExtremeCase>& cases, const BeamRow& row) {
    std::ostringstream name;
    name << "beam " << row.element << " E=" << row.young_pa << " dt=" << row.dt_s
         << " nu=" << row.nu;
    if (row.newton > 1) name << " newton=" << row.newton;
    cases.push_back({name.str(), [row](const ExtremeRun& how) { return run_beam(row, how); }});
}

}  // namespace

void add_beam_grid(std::vector<ExtremeCase>& cases) {
    for (const double young : {1.0, 1e3, 1e6, 1e9})
        for (const double dt : {1e-5, 1e-3, 1.0 / 60.0, 0.1, 1.0, 10.0})
            for (const double nu : {0.0, 0.3, 0.49, 0.4999})
                add(cases, {"corotated-10", young, dt, nu});
    for (const char* element : {"spring", "corotated", "neohookean", "neohookean-10", "hexahedron"})
        for (const double young : {1e4, 1e6, 1e9})
            for (const double dt : {1e-3, 0.1, 1.0})
                for (const double nu : {0.3, 0.49}) add(cases, {element, young, dt, nu});
    for (const char* element : {"neohookean-10", "corotated-10", "hexahedron"})
        for (const double dt : {1e-3, 0.1, 10.0}) add(cases, {element, 1e6, dt, 0.3, 20});
}

}  // namespace hepatica
