// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that tear: conservation over splits, fracture energy, and what they go on from.
#include <gtest/gtest.h>

#include <cmath>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/mesh/brick_mesh.h"
#include "core/tear/tearing.h"

namespace hepatica {
namespace {

constexpr double dt_s = 1.0 / 60.0;

BodyDescription bar(const Vec3& size_mm, const Index3& cells, const TearLaw& law) {
    BodyDescription body;
    body.mesh = kuhn_brick(size_mm, cells);
    body.material.young_modulus_pa = 0.5e6;
    body.material.poisson_ratio = 0.3;
    body.fixed.assign(body.mesh.vertices_mm.size(), 0);
    for (std::size_t v = 0; v < body.fixed.size(); ++v)
        body.fixed[v] = body.mesh.vertices_mm[v].x() < 1e-9;
    body.tear = law;
    return body;
}

// Every vertex of the far end is led by (x, 0, 0).
std::vector<Grab> pull_of(const BodyDescription& body, double length_mm, double x_mm) {
    std::vector<Grab> grabs;
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        if (body.mesh.vertices_mm[v].x() < length_mm - 1e-9) continue;
        Grab grab;
        grab.vertices[0] = static_cast<int>(v);
        grab.target_mm = body.mesh.vertices_mm[v] + Vec3(x_mm, 0, 0);
        grab.stiffness_un_per_mm = 1e6;
        grab.force_limit_un = 1e12;
        grabs.push_back(grab);
    }
    return grabs;
}

TEST(TearingBody, Explore) {
    BodyDescription body = bar(Vec3(20, 4, 4), {10, 2, 2}, {.strength_pa = 1e5});
    const auto stepper = make_cpu_stepper(body, {});
    double work = 0.0, torn = 0.0;
    for (int k = 0; k < 200; ++k) {
        stepper->set_grabs(pull_of(body, 20.0, 0.1 * k));
        const StepReport r = stepper->step(dt_s);
        work += r.energy.tool_work;
        torn += r.energy.tear_loss;
        if (k % 5 == 0 || r.degraded)
            std::printf("%d parted %d broken %d split %d pieces %d S %.4f dS %.4f el %.3g coh %.3g "
                        "torn %.4g work %.4g imb %.2g %s\n",
                        k, r.tear.joints_parted, r.tear.joints_broken, r.tear.vertices_split,
                        r.tear.pieces, r.tear.entropy_nats, r.tear.entropy_produced_nats,
                        r.energy.elastic, r.energy.cohesion, torn, work,
                        relative_imbalance(r.energy), r.message.c_str());
    }
    std::printf("G A = %g\n", 164e3 * 16);
}

}  // namespace
}  // namespace hepatica
