// SPDX-License-Identifier: GPL-3.0-or-later
// The tube law against itself, and a squeezed pipe against what can be worked out by hand.
#include "core/flow/tube_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/flow/flow_solution.h"

namespace hepatica {
namespace {

TEST(TubeLaw, TheShareIsWhereWallAndPressureAgree) {
    const TubeWall wall{.young_modulus_pa = 5e5, .thickness_per_radius = 0.08};
    const double bending_pa = 5e5 * 0.08 * 0.08 * 0.08 / 9.0;
    double last = 1.0;
    for (double excess_pa = 0.01; excess_pa < 1e7; excess_pa *= 3.0) {
        const double share = open_share(excess_pa, wall);
        EXPECT_NEAR(std::pow(share, -1.5) - std::pow(share, 10.0), excess_pa / bending_pa,
                    1e-9 * (1.0 + excess_pa / bending_pa));
        EXPECT_LT(share, last);
        EXPECT_GT(share, 0.0);
        last = share;
    }
    EXPECT_EQ(open_share(0.0, wall), 1.0);
    EXPECT_EQ(open_share(-1e5, wall), 1.0);
    // Far beyond, the open tube's term is nothing.
    EXPECT_NEAR(open_share(1e6, wall), std::pow(1e6 / bending_pa, -2.0 / 3.0), 1e-12);
}

TEST(TubeLaw, AnOpenTubeHasNoJetAndASlitLosesAllOfIt) {
    EXPECT_NEAR(jet_loss(1.0), 0.0, 1e-15);
    EXPECT_NEAR(jet_loss(1e-9), 1.0 / (0.62 * 0.62), 1e-6);
    EXPECT_GT(jet_loss(0.2), jet_loss(0.5));
}

// A crack of 2 a in a sheet under the stress s opens to an ellipse with the half axes a and 2 a
// s/E.
TEST(TubeLaw, ASlitIsHeldOpenAsACrackInASheet) {
    const TubeWall wall{.young_modulus_pa = 5e5, .thickness_per_radius = 0.08};
    for (const double length : {0.5, 3.0, 8.0})
        for (const double pressure_pa : {670.0, 1070.0, 10700.0}) {
            const double half = 0.5 * length;
            const double wide = 2.0 * half * pressure_pa / 0.08 / 5e5;
            EXPECT_NEAR(slit_mm2(length, pressure_pa, wall), std::numbers::pi * half * wide, 1e-12);
        }
    EXPECT_EQ(slit_mm2(3.0, 0.0, wall), 0.0);
    EXPECT_EQ(slit_mm2(3.0, -10.0, wall), 0.0);
}

FlowNetwork straight_pipe(double radius_mm, double length_mm) {
    VesselTree tree;
    tree.nodes = {{Vec3(0, 0, 0)}, {Vec3(length_mm, 0, 0)}};
    VesselSegment segment;
    segment.system = VascularSystem::portal;
    segment.proximal_node = 0;
    segment.distal_node = 1;
    segment.points_mm = {Vec3(0, 0, 0), Vec3(length_mm, 0, 0)};
    segment.radii_mm = {radius_mm, radius_mm};
    tree.segments = {segment};
    return network_of(tree);
}

// Poiseuille in three pipes, and the head of the jet.
TEST(SqueezedNetwork, DropsWhatTheNarrowPipeAndItsJetTake) {
    constexpr double radius_mm = 4.0, length_mm = 20.0, share = 0.25;
    FlowNetwork network = straight_pipe(radius_mm, length_mm);
    squeeze(network, 0, 5.0, 13.0, share);
    EXPECT_EQ(network.segments.size(), 3u);
    FlowConditions conditions;
    conditions.resident = pure(blood());
    const double density = conditions.resident.density_g_mm3;
    const double viscosity = conditions.resident.viscosity_pa_s;
    for (const double flow_mm3_s : {10.0, 500.0, -500.0}) {
        conditions.inlets = {{0, InletKind::mass_flow, flow_mm3_s * density, conditions.resident}};
        const FlowSolution solution = solve_flow(network, conditions);
        const auto poiseuille = [&](double length, double radius) {
            return 8.0 * viscosity * length * flow_mm3_s /
                   (std::numbers::pi * std::pow(radius, 4.0));
        };
        const double throat_mm2 = share * std::numbers::pi * radius_mm * radius_mm;
        const double speed = flow_mm3_s / throat_mm2;
        const double jet = 0.5 * density * speed * std::abs(speed) * jet_loss(share);
        const double drop = poiseuille(12.0, radius_mm) + poiseuille(8.0, 0.5 * radius_mm) + jet;
        EXPECT_NEAR(solution.inlet_pressure_pa[0], drop, 1e-6 * std::abs(drop)) << flow_mm3_s;
    }
}

double drop_pa(const FlowNetwork& network, double flow_mm3_s) {
    FlowConditions conditions;
    conditions.resident = pure(blood());
    const double mass_flow_g_s = flow_mm3_s * conditions.resident.density_g_mm3;
    conditions.inlets = {{0, InletKind::mass_flow, mass_flow_g_s, conditions.resident}};
    return solve_flow(network, conditions).inlet_pressure_pa[0];
}

// By a catheter, for instance, before or after.
TEST(SqueezedNetwork, ItsJetCountsOnceHoweverTheVesselIsDivided) {
    FlowNetwork whole = straight_pipe(4.0, 20.0);
    squeeze(whole, 0, 5.0, 13.0, 0.25);
    FlowNetwork before = straight_pipe(4.0, 20.0);
    for (const double at_mm : {7.0, 9.0}) divide(before, {.segment = 0, .arclength_mm = at_mm});
    squeeze(before, 0, 5.0, 13.0, 0.25);
    FlowNetwork after = whole;
    for (const double at_mm : {9.0, 7.0}) divide(after, {.segment = 0, .arclength_mm = at_mm});
    for (const double flow_mm3_s : {500.0, -500.0}) {
        const double drop = drop_pa(whole, flow_mm3_s);
        EXPECT_NEAR(drop_pa(before, flow_mm3_s), drop, 1e-6 * std::abs(drop)) << flow_mm3_s;
        EXPECT_NEAR(drop_pa(after, flow_mm3_s), drop, 1e-6 * std::abs(drop)) << flow_mm3_s;
    }
}

// A narrower stretch at the begin, in the middle, and at the end of another.
TEST(SqueezedNetwork, SqueezesThatOverlapHaveAJetEach) {
    constexpr double flow_mm3_s = 500.0, radius_mm = 4.0;
    const Fluid fluid = pure(blood());
    const auto poiseuille = [&](double length, double share) {
        return 8.0 * fluid.viscosity_pa_s * length * flow_mm3_s /
               (std::numbers::pi * std::pow(radius_mm, 4.0) * share * share);
    };
    const auto head = [&](double share) {
        const double speed = flow_mm3_s / (share * std::numbers::pi * radius_mm * radius_mm);
        return 0.5 * fluid.density_g_mm3 * speed * speed;
    };
    const double drop = poiseuille(8.0, 1.0) + poiseuille(7.0, 0.5) + poiseuille(5.0, 0.25) +
                        jet_loss(0.5) * (head(0.5) + head(0.25));
    for (const double from_mm : {5.0, 8.0, 12.0}) {
        FlowNetwork network = straight_pipe(radius_mm, 20.0);
        squeeze(network, 0, 5.0, 17.0, 0.5);
        squeeze(network, 0, from_mm, from_mm + 5.0, 0.5);
        EXPECT_NEAR(drop_pa(network, flow_mm3_s), drop, 1e-6 * drop) << from_mm;
    }
}

TEST(SqueezedNetwork, OfTheWholeLumenIsTheSame) {
    FlowNetwork network = straight_pipe(4.0, 20.0);
    squeeze(network, 0, 5.0, 13.0, 1.0);
    EXPECT_EQ(network.segments.size(), 1u);
    squeeze(network, 0, 0.0, 30.0, 0.5);  // farther than it reaches
    ASSERT_EQ(network.segments.size(), 1u);
    EXPECT_NEAR(smallest_radius_mm(network, 0), 4.0 * std::sqrt(0.5), 1e-12);
    EXPECT_THROW(squeeze(network, 0, 1.0, 2.0, 0.0), InputError);
    EXPECT_THROW(squeeze(network, 0, 1.0, 2.0, 1.5), InputError);
    try {
        squeeze(network, 0, 1.0, 2.0, -1e-9);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "is -1e-09");
    }
}

}  // namespace
}  // namespace hepatica
