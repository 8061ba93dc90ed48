// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the stability suite: grabs that jump by a metre, and a thousandfold gravity.
#include <cmath>
#include <sstream>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/study/extreme_cases.h"
#include "core/study/reference_beam.h"
#include "core/study/trial.h"

namespace hepatica {
namespace {

// A strong spring holds the tip; its target jumps by a metre, there and back, and is released.
ExtremeRow run_jump(const std::string& element, double dt, double force_limit_un, int newton,
                    const ExtremeRun& how) {
    ExtremeRow row;
    const Discretisation d = discretisation_of(element);
    const BeamSpec spec = short_beam(d);
    const BodyDescription body = clamped_beam(spec, d);
    const auto stepper = make_cpu_stepper(
        body, {.model = d.model, .order = d.order, .newton_iterations = newton, .audit = true});
    Trial trial(*stepper, row, how);
    Grab grab;
    grab.vertices[0] = static_cast<int>(body.mesh.vertices_mm.size()) - 1;
    grab.stiffness_un_per_mm = 1e5;
    grab.force_limit_un = force_limit_un;
    const Vec3 place = body.mesh.vertices_mm.back();
    for (const Vec3& target : {place, Vec3(place + Vec3(0, 1000, 0)),
                               Vec3(place - Vec3(1000, 0, 0)), Vec3(place + Vec3(0, 0, -1000))}) {
        grab.target_mm = target;
        stepper->set_grabs(std::span(&grab, 1));
        if (!trial.run(20, dt)) return row;
    }
    stepper->set_grabs({});
    if (trial.run(200, std::max(dt, 0.02))) {
        trial.require_positive_volumes(body, d.model, d.order);
        trial.require_back_at(body.mesh.vertices_mm, 2e-3 * spec.length_mm);
    }
    return row;
}

ExtremeRow run_heavy(const std::string& element, double dt, const Vec3& direction,
                     const ExtremeRun& how) {
    ExtremeRow row;
    const Discretisation d = discretisation_of(element);
    const BeamSpec spec = short_beam(d);
    const BodyDescription body = clamped_beam(spec, d);
    const auto stepper =
        make_cpu_stepper(body, {.model = d.model, .order = d.order, .audit = true});
    stepper->set_gravity(1000.0 * 9810.0 * direction);
    Trial trial(*stepper, row, how);
    if (!trial.run(60, dt)) return row;
    stepper->set_gravity(Vec3::Zero());
    if (trial.run(200, std::max(dt, 0.02))) {
        trial.require_positive_volumes(body, d.model, d.order);
        trial.require_back_at(body.mesh.vertices_mm, 2e-3 * spec.length_mm);
    }
    return row;
}

}  // namespace

void add_tool_cases(std::vector<ExtremeCase>& cases) {
    for (const char* element : {"corotated", "neohookean", "corotated-10", "hexahedron"})
        for (const double dt : {1e-3, 1.0 / 60.0, 1.0}) {
            for (const double limit : {1e5, 1e9}) {
                std::ostringstream name;
                name << "grab jumps 1 m " << element << " dt=" << dt << " limit=" << limit;
                cases.push_back({name.str(), [=](const ExtremeRun& how) {
                                     return run_jump(element, dt, limit, 1, how);
                                 }});
            }
            std::ostringstream name;
            name << "gravity x 1000 " << element << " dt=" << dt;
            cases.push_back({name.str() + " down", [=](const ExtremeRun& how) {
                                 return run_heavy(element, dt, Vec3(0, 0, -1), how);
                             }});
            cases.push_back({name.str() + " along", [=](const ExtremeRun& how) {
                                 return run_heavy(element, dt, Vec3(1, 0, 0), how);
                             }});
            cases.push_back({name.str() + " into the clamp", [=](const ExtremeRun& how) {
                                 return run_heavy(element, dt, Vec3(-1, 0, 0), how);
                             }});
        }
    for (const double dt : {1e-3, 1.0 / 60.0, 1.0}) {
        std::ostringstream name;
        name << "grab jumps 1 m neohookean-10 dt=" << dt << " limit=1e+06 newton=20";
        cases.push_back({name.str(), [=](const ExtremeRun& how) {
                             return run_jump("neohookean-10", dt, 1e6, 20, how);
                         }});
    }
}

}  // namespace hepatica
