// SPDX-License-Identifier: GPL-3.0-or-later
// Rayleigh damping: the ratio asked for, by its closed form and by a bar that rings.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "core/deform/body/material.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

using std::numbers::pi;

// alpha / (2 w) + beta w / 2
double ratio_at(const RayleighDamping& damping, double frequency_hz) {
    const double w = 2.0 * pi * frequency_hz;
    return damping.alpha_per_s / (2.0 * w) + 0.5 * damping.beta_s * w;
}

TEST(RayleighDamping, HasTheRatioAtBothFrequenciesAndLessBetween) {
    const Material material{.damping_ratio = 0.07, .damping_low_hz = 2.0, .damping_high_hz = 50.0};
    const RayleighDamping damping = rayleigh_of(material);
    EXPECT_NEAR(ratio_at(damping, 2.0), 0.07, 1e-15);
    EXPECT_NEAR(ratio_at(damping, 50.0), 0.07, 1e-15);
    EXPECT_LT(ratio_at(damping, 10.0), 0.07);
    EXPECT_GT(ratio_at(damping, 100.0), 0.07);
}

struct Mode {
    double frequency_hz;
    double damping_ratio;
};

// Of a series a_n: its recurrence a_n+1 = p a_n + q a_n-1 by least squares, whose roots z are
// 1 / (1 - dt lambda) for backward Euler, without error: its own damping drops out.
Mode mode_of(const std::vector<double>& a, double dt_s) {
    double uu = 0, uv = 0, vv = 0, ur = 0, vr = 0;
    for (std::size_t n = 1; n + 1 < a.size(); ++n) {
        uu += a[n] * a[n];
        uv += a[n] * a[n - 1];
        vv += a[n - 1] * a[n - 1];
        ur += a[n] * a[n + 1];
        vr += a[n - 1] * a[n + 1];
    }
    const double det = uu * vv - uv * uv;
    const double p = (ur * vv - vr * uv) / det, q = (vr * uu - ur * uv) / det;
    const std::complex<double> z = 0.5 * (p + std::sqrt(std::complex<double>(p * p + 4.0 * q)));
    const std::complex<double> lambda = (1.0 - 1.0 / z) / dt_s;
    return {std::abs(lambda) / (2.0 * pi), -lambda.real() / std::abs(lambda)};
}

constexpr double length_mm = 40.0;

// A clamped bar, struck along its axis in its lowest mode sin(pi x / 2 L).
Mode ring(const Material& material, double dt_s) {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(length_mm, 4, 4), {20, 2, 2});
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x[0] == 0.0);
    body.material = material;
    const auto stepper = make_cpu_stepper(body, {.linear = {.energy_tolerance = 1e-10}});
    const std::vector<Vec3>& rest = body.mesh.vertices_mm;
    std::vector<double> shape;
    std::vector<Vec3> velocity;
    for (const Vec3& x : rest) {
        shape.push_back(std::sin(0.5 * pi * x[0] / length_mm));
        velocity.push_back(Vec3(0.1 * shape.back(), 0, 0));
    }
    stepper->set_state(rest, velocity);
    std::vector<double> amplitude;
    for (int i = 0; i < 200; ++i) {
        stepper->step(dt_s);
        double sum = 0.0;
        for (std::size_t v = 0; v < rest.size(); ++v)
            sum += shape[v] * (stepper->positions_mm()[v][0] - rest[v][0]);
        amplitude.push_back(sum);
    }
    return mode_of(amplitude, dt_s);
}

// The lowest frequency of theory, sqrt(E / rho) / (4 L), is once the lower and once the upper one
// of the material: damped by alpha most, then by beta.
TEST(RayleighDamping, ABarRingsDownWithTheRatioAskedFor) {
    Material material{.young_modulus_pa = 1e6, .poisson_ratio = 0.0, .density_g_mm3 = 1e-3};
    const double theory =
        std::sqrt(material.young_modulus_pa / material.density_g_mm3) / (4.0 * length_mm);
    material.damping_ratio = 0.1;
    for (const double other : {10.0, 0.1}) {
        material.damping_low_hz = theory * std::min(other, 1.0);
        material.damping_high_hz = theory * std::max(other, 1.0);
        const Mode mode = ring(material, 0.02 / theory);
        EXPECT_NEAR(mode.frequency_hz, theory, 0.01 * theory);
        EXPECT_NEAR(mode.damping_ratio, 0.1, 0.002);
    }
}

}  // namespace
}  // namespace hepatica
