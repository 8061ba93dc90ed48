// SPDX-License-Identifier: GPL-3.0-or-later
// Hertz: a rigid ball without friction pressed into a block. With the depth d of the block's
// surface below the ball and the radius R at which the two touch,
//   F = 4/3 E/(1 - nu^2) sqrt(R) d^1.5
// (Johnson, Contact Mechanics, 1985, eq. 4.23, for one rigid body).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

constexpr double ball_mm = 10.0, edge_mm = 0.55, block_mm = 100.0;
constexpr double young_pa = 1e5, poisson = 0.3;

// From 0 to `end`: five equal edges, then each longer by the same factor.
std::vector<double> graded(double end) {
    constexpr int equal = 5;
    constexpr double growth = 1.6;
    std::vector<double> at{0.0};
    double edge = edge_mm;
    while (at.back() < end) {
        if (static_cast<int>(at.size()) > equal) edge *= growth;
        at.push_back(at.back() + edge);
    }
    const double begin = equal * edge_mm, shrink = (end - begin) / (at.back() - begin);
    for (std::size_t i = equal + 1; i < at.size(); ++i) at[i] = begin + shrink * (at[i] - begin);
    return at;
}

// Ten radii each way, its upper face at height 0, fine around the middle of that; held below.
BodyDescription block(bool hexahedra) {
    const std::vector<double> aside = graded(0.5 * block_mm), down = graded(block_mm);
    const int n = static_cast<int>(aside.size()) - 1, m = static_cast<int>(down.size()) - 1;
    const Vec3 size(2 * n, 2 * n, m);
    const Index3 cells{2 * n, 2 * n, m};
    BodyDescription body;
    if (hexahedra) {
        HexMesh mesh = hexahedral_brick(size, cells);
        body.mesh.vertices_mm = std::move(mesh.vertices_mm);
        body.hexahedra = std::move(mesh.hexahedra);
    } else {
        body.mesh = kuhn_brick(size, cells);
    }
    const auto sideways = [&](double number) {
        const auto i = std::lround(number) - n;
        return i < 0 ? -aside[-i] : aside[i];
    };
    for (Vec3& x : body.mesh.vertices_mm) {
        x = Vec3(sideways(x.x()), sideways(x.y()), -down[m - std::lround(x.z())]);
        body.fixed.push_back(x.z() < -block_mm + 1e-6 ? 1 : 0);
    }
    body.material = {.young_modulus_pa = young_pa,
                     .poisson_ratio = poisson,
                     .density_g_mm3 = 1e-3,
                     .damping_ratio = 0.0};
    body.touchable = true;
    return body;
}

class Hertz : public testing::TestWithParam<bool> {};

// Six and eight edges across the contact, with which hexahedra are 1 % too soft. Linear tetrahedra
// are 5.4 % too stiff with six and 4.4 % with eight, which is tried. The pad is so stiff that it
// keeps its thickness: the two touch at its face.
TEST_P(Hertz, ABallIsPressedOutAsHertzHasIt) {
    const BodyDescription body = block(GetParam());
    const auto middle =
        std::ranges::find_if(body.mesh.vertices_mm, [](const Vec3& x) { return x.norm() < 1e-9; });
    ASSERT_NE(middle, body.mesh.vertices_mm.end());
    const auto stepper = make_cpu_stepper(
        body, {.linear = {.energy_tolerance = 1e-6}, .newton_iterations = 8, .sleeping = false});
    Tool ball = single_tool({.radius_mm = ball_mm});
    ball.pad_mm = 0.06 * ball_mm;
    ball.pressure_pa = 100.0 * young_pa;
    ball.parts[0].shape.centre_mm = Vec3(0, 0, ball_mm + ball.pad_mm);
    stepper->set_tool(ball);
    const bool hexahedra = GetParam();
    for (const double share : hexahedra ? std::vector{0.026, 0.044} : std::vector{0.044}) {
        stepper->lead_tool(Vec3(0, 0, ball_mm + ball.pad_mm - share * ball_mm));
        // So long that inertia is nothing.
        for (int k = 0; k < 2; ++k) stepper->step(1.0);
        const double depth = -stepper->positions_mm()[middle - body.mesh.vertices_mm.begin()].z();
        EXPECT_LT(depth, 0.05 * ball_mm);
        const double radius = ball_mm + ball.pad_mm;
        EXPECT_GE(2.0 * std::sqrt(radius * depth) / edge_mm, 6.0);
        const double expected = 4.0 / 3.0 * young_pa / (1.0 - poisson * poisson) *
                                std::sqrt(radius) * std::pow(depth, 1.5);
        const ToolLoad& load = stepper->tool_load();
        EXPECT_NEAR(load.force_un.z(), expected, 0.05 * expected) << share;
        EXPECT_LT(load.force_un.head<2>().norm(), 0.02 * expected);
    }
}

INSTANTIATE_TEST_SUITE_P(TetrahedraAndHexahedra, Hertz, testing::Bool());

}  // namespace
}  // namespace hepatica
