// SPDX-License-Identifier: GPL-3.0-or-later
// Hollow tubes against beam theory: the second moment of an annulus.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

constexpr double length_mm = 60.0, radius_mm = 3.0, gravity_mm_s2 = 100.0;
constexpr int cells_across = 4, sides = 4 * cells_across;
constexpr double angle = 2.0 * std::numbers::pi / sides;

// Circumradius of the regular polygon that has the circle's second moment of area.
double polygon_radius_mm() {
    const double share = sides / 24.0 * std::sin(angle) * (2.0 + std::cos(angle));
    return radius_mm * std::pow(0.25 * std::numbers::pi / share, 0.25);
}

double polygon_area_mm2() {
    return 0.5 * sides * std::pow(polygon_radius_mm(), 2) * std::sin(angle);
}

// A prism over a regular polygon along x, its centreline as skeleton: squares become circles.
BodyDescription tube() {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(length_mm, 2, 2), {16, cells_across, cells_across});
    for (Vec3& x : body.mesh.vertices_mm) {
        const double u = x[1] - 1.0, v = x[2] - 1.0;
        const double rho = std::max(std::abs(u), std::abs(v));
        double turn = 0.0;
        if (std::abs(u) >= std::abs(v) && rho > 0.0)
            turn = 0.25 * std::numbers::pi * v / u + (u < 0.0 ? std::numbers::pi : 0.0);
        else if (rho > 0.0)
            turn = 0.5 * std::numbers::pi - 0.25 * std::numbers::pi * u / v +
                   (v < 0.0 ? std::numbers::pi : 0.0);
        const double r = rho * polygon_radius_mm();
        x = Vec3(x[0], r * std::cos(turn), r * std::sin(turn));
        body.fixed.push_back(x[0] == 0.0);
    }
    body.material = {.young_modulus_pa = 5e5, .poisson_ratio = 0.3, .density_g_mm3 = 1e-3};
    for (int i = 0; i <= 20; ++i) {
        body.skeleton.positions_mm.push_back(Vec3(length_mm * i / 20.0, 0, 0));
        body.skeleton.parent.push_back(i - 1);
        body.skeleton.radii_mm.push_back(radius_mm);
    }
    return body;
}

double tip_mm(const BodyDescription& body) {
    const auto stepper = make_cpu_stepper(body, {.order = ElementOrder::quadratic,
                                                 .linear = {.energy_tolerance = 1e-6},
                                                 .newton_iterations = 20});
    stepper->set_gravity(Vec3(0, 0, -gravity_mm_s2));
    for (int i = 0; i < 4; ++i) stepper->step(100.0);
    double sum = 0.0;
    int count = 0;
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        if (body.mesh.vertices_mm[v][0] < length_mm - 1e-9) continue;
        sum += body.mesh.vertices_mm[v][2] - stepper->positions_mm()[v][2];
        ++count;
    }
    return sum / count;
}

// Cantilever under its weight, which a hollow wall keeps: bending of the annulus, and the shear of
// the solid section (1 % of it) softened alike.
double theory_mm(double wall_mm) {
    const double inner = std::max(0.0, radius_mm - wall_mm), young = 5e5, nu = 0.3;
    const double moment = 0.25 * std::numbers::pi * (std::pow(radius_mm, 4) - std::pow(inner, 4));
    const double solid = 0.25 * std::numbers::pi * std::pow(radius_mm, 4);
    const double load = 1e-3 * polygon_area_mm2() * gravity_mm_s2;
    const double kappa = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu);  // Cowper 1966, solid circle
    const double shear = young / (2.0 * (1.0 + nu));
    return load * std::pow(length_mm, 4) / (8.0 * young * moment) +
           load * std::pow(length_mm, 2) / (2.0 * kappa * shear * polygon_area_mm2()) * solid /
               moment;
}

TEST(HollowWall, BendsLikeAnAnnulus) {
    for (const double wall_mm : {radius_mm, 1.5, 0.6, 0.3}) {
        BodyDescription body = tube();
        make_hollow(body, wall_mm);
        EXPECT_NEAR(tip_mm(body) / theory_mm(wall_mm), 1.0, 0.02) << "wall " << wall_mm << " mm";
    }
}

TEST(HollowWall, KeepsWhatIsThickerThanTheRadius) {
    BodyDescription body = tube();
    make_hollow(body, 2.0 * radius_mm);
    for (const double factor : body.stiffness_factor) EXPECT_EQ(factor, 1.0);
}

TEST(HollowWall, RefusesAWallOfNothing) {
    for (const double wall_mm : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        BodyDescription body = tube();
        EXPECT_THROW(make_hollow(body, wall_mm), InputError);
    }
    BodyDescription body = tube();
    try {
        make_hollow(body, -1e-9);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "is -1e-09");
    }
    body.skeleton = {};
    EXPECT_THROW(make_hollow(body, 1.0), InputError);
}

}  // namespace
}  // namespace hepatica
