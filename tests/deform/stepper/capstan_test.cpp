// SPDX-License-Identifier: GPL-3.0-or-later
// The capstan: a thick rope that slides over a round tool. With the tensions T1 and T2 before and
// behind, the angle phi, the radius R at which the rope touches and its half thickness r,
//   T2/T1 = exp(k phi),  k (R + r) = mu (R - k^2 r):
// friction acts at the rope's face, its tension along its middle; to first order k = mu R/(R + r).
// Elements are quadratic: linear ones as thin are far too stiff in bending, which costs tension
// where the rope comes on and goes off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

constexpr double drum_mm = 10.0, pad_mm = 0.2, half_mm = 0.3, tail_mm = 12.0, pitch_mm = 1.5;
constexpr double friction = 0.2, slack_un = 1e4, pull_mm_per_s = 4.0;

// k of the formula above.
double growth(double radius_mm) {
    double k = friction;
    for (int i = 0; i < 50; ++i)
        k = friction * (radius_mm - k * k * half_mm) / (radius_mm + half_mm);
    return k;
}

// A rope that was made around the drum, so that it is not bent there; its tails are straight. More
// than a turn would go along as a screw.
class Rope {
  public:
    explicit Rope(double angle_rad) : angle_rad_(angle_rad) {
        const double length = middle_mm() * angle_rad_ + 2.0 * tail_mm;
        const int cells = static_cast<int>(std::lround(length));
        body.mesh = kuhn_brick(Vec3(length, 2.0 * half_mm, 2.0 * half_mm), {cells, 1, 1});
        for (Vec3& x : body.mesh.vertices_mm) x = wound(x, length);
        body.material = {.young_modulus_pa = 2e6,
                         .poisson_ratio = 0.3,
                         .density_g_mm3 = 1e-3,
                         .damping_ratio = 0.2};
        body.touchable = true;
        for (int v = 0; v < 4; ++v) {
            first[v] = (cells + 1) * v;
            last[v] = (cells + 1) * v + cells;
        }
    }
    // Outwards along the tangents.
    Vec3 out_at_first() const { return {0, -1, 0}; }
    Vec3 out_at_last() const { return {-std::sin(angle_rad_), std::cos(angle_rad_), 0}; }

    BodyDescription body;
    std::array<int, 4> first{}, last{};

  private:
    static double middle_mm() { return drum_mm + 0.95 * pad_mm + half_mm; }
    Vec3 wound(const Vec3& x, double length) const {
        const double along = x.x() - tail_mm;
        const double angle = std::clamp(along / middle_mm(), 0.0, angle_rad_);
        const double beyond = along - angle * middle_mm();
        const Vec3 out(std::cos(angle), std::sin(angle), 0), on(-out.y(), out.x(), 0);
        const double screw = pitch_mm * (x.x() / length - 0.5) * angle_rad_ / (2.0 * M_PI);
        return (middle_mm() + half_mm - x.y()) * out + beyond * on +
               (x.z() - half_mm + screw) * Vec3::UnitZ();
    }
    double angle_rad_;
};

Grab hold(const Rope& rope, const std::array<int, 4>& vertices, const Vec3& by_mm,
          double limit_un) {
    Grab grab;
    grab.vertices = vertices;
    grab.weights.fill(0.25);
    grab.target_mm = by_mm;
    for (const int v : vertices) grab.target_mm += 0.25 * rope.body.mesh.vertices_mm[v];
    grab.stiffness_un_per_mm = 2e4;
    grab.force_limit_un = limit_un;
    return grab;
}

double tension(const Grab& grab, const Stepper& stepper) {
    Vec3 at = Vec3::Zero();
    for (const int v : grab.vertices) at += 0.25 * stepper.positions_mm()[v];
    return grab.stiffness_un_per_mm * (grab.target_mm - at).norm();
}

class Capstan : public testing::TestWithParam<double> {};

TEST_P(Capstan, TensionGrowsAsEulerHasItForAThickRope) {
    const double angle = GetParam() * M_PI / 180.0;
    const Rope rope(angle);
    const auto stepper =
        make_cpu_stepper(rope.body, {.order = ElementOrder::quadratic, .newton_iterations = 4});
    Tool drum = single_tool(
        {.centre_mm = Vec3::Zero(), .half_axis_mm = Vec3(0, 0, 20), .radius_mm = drum_mm});
    drum.pad_mm = pad_mm;
    drum.pressure_pa = 2e5;
    drum.friction = friction;
    stepper->set_tool(drum);
    // One end is pulled with a force that stays, the other is led away.
    const Grab slack = hold(rope, rope.first, 100.0 * rope.out_at_first(), slack_un);
    std::vector<double> ratios;
    for (int k = 0; k < 150; ++k) {
        const Grab pull =
            hold(rope, rope.last, pull_mm_per_s * frame_s * k * rope.out_at_last(), 1e9);
        stepper->set_grabs(std::vector{slack, pull});
        stepper->step(frame_s);
        if (k >= 110) ratios.push_back(tension(pull, *stepper) / slack_un);
    }
    double mean = 0.0;
    for (const double ratio : ratios) mean += ratio / static_cast<double>(ratios.size());
    const double expected = std::exp(growth(drum_mm + 0.95 * pad_mm) * angle);
    EXPECT_NEAR(mean, expected, 0.05 * expected);
}

INSTANTIATE_TEST_SUITE_P(Angles, Capstan, testing::Values(90.0, 180.0, 270.0, 360.0, 450.0, 540.0));

}  // namespace
}  // namespace hepatica
