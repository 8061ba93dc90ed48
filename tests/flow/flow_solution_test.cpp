// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/flow_solution.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::add_loops;
using testing_flow::Random;
using testing_flow::random_tree;

constexpr std::array laws = {PressureLaw::published, PressureLaw::consistent, PressureLaw::regime};

Inlet flow_into(int node, double mass_flow_g_s) {
    return {node, InletKind::mass_flow, mass_flow_g_s, pure(blood())};
}

FlowConditions conditions_of(PressureLaw law, std::vector<Inlet> inlets) {
    FlowConditions conditions;
    conditions.law = law;
    conditions.inlets = std::move(inlets);
    return conditions;
}

// The solution is right if every node keeps what it gets and every segment's drop is the law's:
// both are checked here from the outside, with nothing of the solver's.
void expect_solved(const FlowNetwork& network, const FlowConditions& conditions,
                   const FlowSolution& solution, double drop_tolerance) {
    std::vector<double> balance(network.node_count, 0.0);
    double highest = 0.0;
    for (const double p : solution.total_pressure_pa) highest = std::max(highest, std::abs(p));
    double entering = 0.0;
    for (std::size_t i = 0; i < conditions.inlets.size(); ++i) {
        balance[conditions.inlets[i].node] += solution.inlet_flow_mm3_s[i];
        entering += std::abs(solution.inlet_flow_mm3_s[i]);
    }
    for (std::size_t o = 0; o < network.outlet_nodes.size(); ++o)
        balance[network.outlet_nodes[o]] -= solution.outlet_flow_mm3_s[o];
    const double density = conditions.resident.density_g_mm3;
    for (std::size_t i = 0; i < network.segments.size(); ++i) {
        const FlowSegment& s = network.segments[i];
        const double q = solution.volume_flow_mm3_s[i];
        balance[s.proximal_node] -= q;
        balance[s.distal_node] += q;
        if (!s.open) {
            ASSERT_EQ(q, 0.0);
            continue;
        }
        double drop = 0.0;
        for (int c = s.first_cone; c < s.first_cone + s.cone_count; ++c)
            drop += total_pressure_drop(conditions.law, network.cones[c], conditions.resident,
                                        density * q)
                        .pressure_pa;
        const double found =
            solution.total_pressure_pa[s.proximal_node] - solution.total_pressure_pa[s.distal_node];
        ASSERT_NEAR(found, drop, drop_tolerance * highest) << "segment " << i;
    }
    for (int n = 0; n < network.node_count; ++n)
        ASSERT_LE(std::abs(balance[n]), 1e-12 * entering) << "node " << n;
    ASSERT_LE(solution.mass_error_relative, 1e-12);
}

TEST(FlowSolution, SolvesRandomTreesUnderEveryLaw) {
    Random random(11);
    for (int i = 0; i < 300; ++i) {
        const FlowNetwork network = random_tree(random, random.integer(1, 200));
        for (const PressureLaw law : laws) {
            const FlowConditions conditions =
                conditions_of(law, {flow_into(0, random.logarithmic(1e-6, 100.0))});
            expect_solved(network, conditions, solve_flow(network, conditions), 1e-11);
        }
    }
}

TEST(FlowSolution, SolvesRandomLoopsUnderEveryLaw) {
    Random random(12);
    for (int i = 0; i < 200; ++i) {
        FlowNetwork network = random_tree(random, random.integer(5, 150));
        add_loops(random, network, random.integer(1, 10));
        for (const PressureLaw law : laws) {
            FlowConditions conditions =
                conditions_of(law, {flow_into(0, random.logarithmic(1e-3, 30.0))});
            expect_solved(network, conditions, solve_flow(network, conditions), 1e-10);
        }
    }
}

// Laminar flow is linear: an independent dense solution of Kirchhoff's equations.
TEST(FlowSolution, EqualsADenseSolutionWhereFlowIsLaminar) {
    Random random(13);
    for (int i = 0; i < 50; ++i) {
        FlowNetwork network = random_tree(random, 60);
        if (i % 2 == 1) add_loops(random, network, 5);
        FlowConditions conditions = conditions_of(PressureLaw::regime, {flow_into(0, 1e-3)});
        for (std::size_t o = 0; o < network.outlet_nodes.size(); ++o) {
            conditions.outlet_pressures_pa.push_back(random.uniform(0.0, 1e-4));
            conditions.terminal_resistances.push_back(random.logarithmic(1e-6, 1e-3));
        }
        const FlowSolution solution = solve_flow(network, conditions);
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(network.node_count, network.node_count);
        Eigen::VectorXd rhs = Eigen::VectorXd::Zero(network.node_count);
        rhs[0] = 1e-3 / conditions.resident.density_g_mm3;
        for (const FlowSegment& s : network.segments) {
            const Cone& c = network.cones[s.first_cone];
            const double a = c.proximal_radius_mm;
            const double b = c.distal_radius_mm;
            const double resistance =
                8 * 3.5e-3 * c.length_mm / 3.14159265358979323846 *
                (1 / (a * b * b * b) + 1 / (a * a * b * b) + 1 / (a * a * a * b)) / 3;
            matrix(s.proximal_node, s.proximal_node) += 1 / resistance;
            matrix(s.distal_node, s.distal_node) += 1 / resistance;
            matrix(s.proximal_node, s.distal_node) -= 1 / resistance;
            matrix(s.distal_node, s.proximal_node) -= 1 / resistance;
        }
        for (std::size_t o = 0; o < network.outlet_nodes.size(); ++o) {
            const double g = 1 / conditions.terminal_resistances[o];
            matrix(network.outlet_nodes[o], network.outlet_nodes[o]) += g;
            rhs[network.outlet_nodes[o]] += g * conditions.outlet_pressures_pa[o];
        }
        const Eigen::VectorXd p = matrix.ldlt().solve(rhs);
        for (int n = 0; n < network.node_count; ++n)
            ASSERT_NEAR(solution.total_pressure_pa[n], p[n], 1e-10 * p.cwiseAbs().maxCoeff());
    }
}

// Two equal daughters halve the flow; a cylinder of 1.5 r carries 1.5^4 times as much.
TEST(FlowSolution, SplitsByTheFourthPowerOfTheRadius) {
    FlowNetwork network;
    network.node_count = 4;
    network.root_nodes = {0};
    network.outlet_nodes = {2, 3};
    network.cones = {{2, 2, 10}, {1.5, 1.5, 10}, {1, 1, 10}};
    network.segments = {{0, 1, 0, 1, 0}, {1, 2, 1, 1, 1}, {1, 3, 2, 1, 2}};
    const FlowSolution solution =
        solve_flow(network, conditions_of(PressureLaw::regime, {flow_into(0, 1.0)}));
    EXPECT_NEAR(solution.mass_flow_g_s[1] / solution.mass_flow_g_s[2], std::pow(1.5, 4), 1e-12);
    EXPECT_NEAR(solution.mass_flow_g_s[0], 1.0, 1e-15);
}

TEST(FlowSolution, PressureInletAndFlowInletAreTwoSidesOfOneSolution) {
    Random random(14);
    for (const PressureLaw law : laws) {
        const FlowNetwork network = random_tree(random, 101);
        const FlowSolution by_flow = solve_flow(network, conditions_of(law, {flow_into(0, 3.0)}));
        const FlowSolution by_pressure = solve_flow(
            network, conditions_of(law, {{0, InletKind::pressure, by_flow.inlet_pressure_pa[0],
                                          pure(blood())}}));
        EXPECT_NEAR(by_pressure.mass_flow_g_s[0], 3.0, 1e-9);
        EXPECT_NEAR(by_pressure.inlet_flow_mm3_s[0], by_flow.inlet_flow_mm3_s[0], 1e-6);
    }
}

TEST(FlowSolution, AClosedSegmentSendsItsFlowElsewhere) {
    Random random(15);
    FlowNetwork network = random_tree(random, 31);
    const FlowConditions conditions = conditions_of(PressureLaw::regime, {flow_into(0, 1.0)});
    const FlowSolution before = solve_flow(network, conditions);
    set_open(network, 1, false);
    const FlowSolution after = solve_flow(network, conditions);
    expect_solved(network, conditions, after, 1e-11);
    EXPECT_EQ(after.volume_flow_mm3_s[1], 0.0);
    EXPECT_GT(after.volume_flow_mm3_s[2], before.volume_flow_mm3_s[2]);
    EXPECT_NEAR(after.mass_flow_g_s[2], 1.0, 1e-12);
}

TEST(FlowSolution, ATornSegmentBleedsFromBothStumps) {
    Random random(16);
    FlowNetwork network = random_tree(random, 31);
    FlowConditions conditions =
        conditions_of(PressureLaw::regime, {{0, InletKind::pressure, 2000.0, pure(blood())}});
    conditions.outlet_pressure_pa = 1000.0;
    const double before = solve_flow(network, conditions).inlet_flow_mm3_s[0];
    tear(network, {1, 0.5 * length_mm(network, 1), 0.0});
    const FlowSolution torn = solve_flow(network, conditions);
    ASSERT_EQ(torn.torn_flow_mm3_s.size(), 2u);
    // The surroundings are at 0 Pa: blood comes from the inlet and back from the outlets.
    EXPECT_GT(torn.torn_flow_mm3_s[0], 0.0);
    EXPECT_GT(torn.torn_flow_mm3_s[1], 0.0);
    EXPECT_GT(torn.inlet_flow_mm3_s[0], before);
    double leaving = torn.torn_flow_mm3_s[0] + torn.torn_flow_mm3_s[1];
    for (const double q : torn.outlet_flow_mm3_s) leaving += q;
    EXPECT_NEAR(leaving, torn.inlet_flow_mm3_s[0], 1e-9 * torn.inlet_flow_mm3_s[0]);
}

// As one that is torn just behind its beginning: what else the fork supplies is still supplied.
TEST(FlowSolution, ABranchThatIsTornOffItsForkIsSeveredAlone) {
    for (int seed = 0; seed < 20; ++seed) {
        Random random(600 + seed);
        const FlowNetwork whole = random_tree(random, 31);
        FlowConditions conditions = conditions_of(PressureLaw::regime, {flow_into(0, 1.0)});
        conditions.torn_areas_mm2.assign(2, random.uniform(0.1, 3.0));
        const int branch = 1 + seed;
        SCOPED_TRACE("branch " + std::to_string(branch));
        const auto torn_at = [&](double arclength_mm) {
            FlowNetwork network = whole;
            tear(network, {branch, arclength_mm, 0.0});
            const FlowSolution solution = solve_flow(network, conditions);
            double leaving = 0.0;
            for (const double q : solution.torn_flow_mm3_s) leaving += q;
            for (const double q : solution.outlet_flow_mm3_s) leaving += q;
            EXPECT_NEAR(leaving, solution.inlet_flow_mm3_s[0], 1e-9 * solution.inlet_flow_mm3_s[0]);
            return solution;
        };
        const FlowSolution off = torn_at(0.0), near = torn_at(1e-5);
        const double inflow = off.inlet_flow_mm3_s[0];
        ASSERT_EQ(off.torn_flow_mm3_s.size(), 2u);
        EXPECT_NEAR(off.torn_flow_mm3_s[0] + off.torn_flow_mm3_s[1],
                    near.torn_flow_mm3_s[0] + near.torn_flow_mm3_s[1], 1e-3 * inflow);
        for (int i = 0; i < 31; ++i) {
            if (i == branch) continue;
            EXPECT_NEAR(off.volume_flow_mm3_s[i], near.volume_flow_mm3_s[i], 1e-3 * inflow) << i;
            if (whole.segments[i].proximal_node == whole.segments[branch].proximal_node) {
                EXPECT_GT(off.volume_flow_mm3_s[i], 1e-6 * inflow) << "beside it";
            }
        }
        EXPECT_NEAR(off.volume_flow_mm3_s[branch], 0.0, 1e-9 * inflow);
    }
}

// Each node bleeds once, whatever is torn there how often.
TEST(FlowNetwork, AForkThatAllBranchesAreTornOffBleedsOnce) {
    Random random(31);
    FlowNetwork network = random_tree(random, 3);  // a trunk and two branches
    const std::array<int, 2> first = tear(network, {1, 0.0, 0.0});
    const std::array<int, 2> second = tear(network, {2, 0.0, 0.0});
    EXPECT_EQ(first[0], network.segments[0].distal_node);
    EXPECT_EQ(second[0], first[0]);
    EXPECT_EQ(network.segments[1].proximal_node, first[1]);
    EXPECT_EQ(network.segments[2].proximal_node, second[1]);
    EXPECT_EQ(tear(network, {1, 0.0, 0.0}), (std::array<int, 2>{first[1], first[1]})) << "again";
    EXPECT_EQ(network.torn_nodes, (std::vector<int>{first[0], first[1], second[1]}));
}

// A tube with a hole in its side: of the flow q, x leaves by the hole, with the loss k x^2, and the
// rest by the resistance r of the tube and of the bed behind: k x^2 = r (q - x).
TEST(FlowSolution, AnOpenSideLeaksByItsQuadratic) {
    FlowNetwork network;
    network.node_count = 2;
    network.root_nodes = {0};
    network.outlet_nodes = {1};
    network.cones = {{1.0, 1.0, 20.0}};
    network.segments = {{0, 1, 0, 1, 0}};
    const int node = open_side(network, {0, 8.0, 0.0});
    EXPECT_EQ(open_side(network, {0, 8.0, 0.0}), node) << "again";
    EXPECT_EQ(network.torn_nodes, std::vector<int>{node});
    EXPECT_EQ(network.outlet_nodes, std::vector<int>{1}) << "the vessel goes on";
    FlowConditions conditions = conditions_of(PressureLaw::regime, {flow_into(0, 0.1)});
    conditions.resident = pure(blood());
    conditions.terminal_resistances = {2.0};
    const auto [density, viscosity, share] = conditions.resident;
    const double q = 0.1 / density;
    const double r = 2.0 + 8.0 * viscosity * 12.0 / std::numbers::pi;
    double last = 0.0;
    for (const double area_mm2 : {0.01, 0.1, 0.4, 1.0, 3.0}) {
        conditions.torn_areas_mm2 = {area_mm2};
        const FlowSolution solution = solve_flow(network, conditions);
        const double k = 0.5 * density / std::pow(0.6 * area_mm2, 2);
        const double x = (std::sqrt(r * r + 4.0 * k * r * q) - r) / (2.0 * k);
        EXPECT_NEAR(solution.torn_flow_mm3_s[0], x, 1e-5 * x) << area_mm2;
        EXPECT_NEAR(solution.outlet_flow_mm3_s[0] + solution.torn_flow_mm3_s[0],
                    solution.inlet_flow_mm3_s[0], 1e-12 * q);
        EXPECT_LE(solution.mass_error_relative, 1e-12);
        EXPECT_NEAR(solution.volume_flow_mm3_s[0], q, 1e-12 * q);
        EXPECT_NEAR(solution.volume_flow_mm3_s[1], q - x, 1e-5 * q);
        EXPECT_GT(solution.torn_flow_mm3_s[0], last);
        last = solution.torn_flow_mm3_s[0];
    }
}

TEST(FlowSolution, AWedgedCatheterPerfusesOnlyWhatIsDownstream) {
    Random random(17);
    const FlowNetwork whole = random_tree(random, 31);
    FlowNetwork network = whole;
    const int tip = place_catheter(network, {1, 0.4 * length_mm(whole, 1), 0.0}, true);
    const FlowConditions conditions = conditions_of(PressureLaw::regime, {flow_into(tip, 0.2)});
    const FlowSolution solution = solve_flow(network, conditions);
    expect_solved(network, conditions, solution, 1e-11);
    EXPECT_EQ(solution.volume_flow_mm3_s[0], 0.0);
    EXPECT_EQ(solution.volume_flow_mm3_s[1], 0.0);  // upstream of the tip
    EXPECT_EQ(solution.volume_flow_mm3_s[2], 0.0);  // the sister
    EXPECT_NEAR(solution.mass_flow_g_s.back(), 0.2, 1e-15);
    EXPECT_NEAR(solution.mass_flow_g_s[3] + solution.mass_flow_g_s[4], 0.2, 1e-14);
}

TEST(FlowSolution, AFreeCatheterAddsToTheBloodAndMayFlowBack) {
    Random random(18);
    const FlowNetwork whole = random_tree(random, 31);
    const FlowSolution rest =
        solve_flow(whole, conditions_of(PressureLaw::regime, {flow_into(0, 0.5)}));
    for (const double injected : {0.01, 20.0}) {
        FlowNetwork network = whole;
        const int tip = place_catheter(network, {1, 0.4 * length_mm(whole, 1), 0.0}, false);
        FlowConditions conditions =
            conditions_of(PressureLaw::regime, {flow_into(0, 0.5), flow_into(tip, injected)});
        const FlowSolution solution = solve_flow(network, conditions);
        expect_solved(network, conditions, solution, 1e-11);
        EXPECT_LT(solution.mass_flow_g_s[1], rest.mass_flow_g_s[1]);
        EXPECT_GT(solution.mass_flow_g_s.back(), rest.mass_flow_g_s[1]);
        // More than the blood can carry away runs back up to the sister.
        EXPECT_EQ(solution.mass_flow_g_s[1] < 0.0, injected == 20.0);
    }
}

TEST(FlowSolution, MurrayResistancesShareTheFlowByTheCubeOfTheRadius) {
    Random random(19);
    const FlowNetwork network = random_tree(random, 63);
    FlowConditions conditions = conditions_of(PressureLaw::regime, {flow_into(0, 1.0)});
    // So large that the resolved vessels do not matter.
    conditions.terminal_resistances = murray_terminal_resistances(network, 1e9);
    const FlowSolution solution = solve_flow(network, conditions);
    EXPECT_NEAR(solution.inlet_pressure_pa[0] / (solution.inlet_flow_mm3_s[0] * 1e9), 1.0, 1e-9);
    const double scale = solution.outlet_flow_mm3_s[0] /
                         std::pow(network.cones[network.outlet_nodes[0] - 1].distal_radius_mm, 3);
    for (std::size_t o = 0; o < network.outlet_nodes.size(); ++o) {
        const double r = network.cones[network.outlet_nodes[o] - 1].distal_radius_mm;
        EXPECT_NEAR(solution.outlet_flow_mm3_s[o] / (scale * r * r * r), 1.0, 1e-6);
    }
}

TEST(FlowSolution, AnInfiniteResistanceClosesAnOutlet) {
    Random random(23);
    const FlowNetwork network = random_tree(random, 31);
    FlowConditions conditions = conditions_of(PressureLaw::regime, {flow_into(0, 1.0)});
    conditions.terminal_resistances = murray_terminal_resistances(network, 10.0);
    conditions.terminal_resistances[1] = std::numeric_limits<double>::infinity();
    const FlowSolution solution = solve_flow(network, conditions);
    EXPECT_EQ(solution.outlet_flow_mm3_s[1], 0.0);
    EXPECT_LT(solution.mass_error_relative, 1e-11);
    double out = 0.0;
    for (const double q : solution.outlet_flow_mm3_s) out += q;
    EXPECT_NEAR(out / solution.inlet_flow_mm3_s[0], 1.0, 1e-11);
}

// It was printed as -0.
TEST(FlowSolution, WhereNothingEntersTheInflowHasNoSign) {
    FlowNetwork network;
    network.node_count = 2;
    network.root_nodes = {0};
    network.outlet_nodes = {1};
    network.cones = {{1.0, 1.0, 10.0}};
    network.segments = {{0, 1, 0, 1, 0}};
    network.segments[0].open = false;
    const FlowSolution solution = solve_flow(
        network,
        conditions_of(PressureLaw::regime, {{0, InletKind::pressure, 5000.0, pure(blood())}}));
    EXPECT_EQ(solution.inlet_flow_mm3_s[0], 0.0);
    EXPECT_FALSE(std::signbit(solution.inlet_flow_mm3_s[0]));
}

TEST(FlowSolution, TheLossCoefficientCostsDynamicPressureInTheBranches) {
    FlowNetwork network;
    network.node_count = 4;
    network.root_nodes = {0};
    network.outlet_nodes = {2, 3};
    network.cones = {{2, 2, 10}, {1, 1, 10}, {1, 1, 10}};
    network.segments = {{0, 1, 0, 1, 0}, {1, 2, 1, 1, 1}, {1, 3, 2, 1, 2}};
    FlowConditions conditions = conditions_of(PressureLaw::regime, {flow_into(0, 1.0)});
    const double without = solve_flow(network, conditions).inlet_pressure_pa[0];
    conditions.bifurcation_loss_coefficient = 0.8;
    const double with = solve_flow(network, conditions).inlet_pressure_pa[0];
    const double speed_mm_s = 0.5 / 1.06e-3 / 3.14159265358979323846;
    EXPECT_NEAR(with - without, 0.8 * 1.06e-3 * speed_mm_s * speed_mm_s / 2, 1e-9);
}

TEST(FlowSolution, StaticPressureIsTotalLessDynamic) {
    FlowNetwork network;
    network.node_count = 2;
    network.root_nodes = {0};
    network.outlet_nodes = {1};
    network.cones = {{2.5, 1.8, 20}};
    network.segments = {{0, 1, 0, 1, 0}};
    FlowConditions conditions = conditions_of(PressureLaw::regime, {flow_into(0, 2.0)});
    const FlowSolution solution = solve_flow(network, conditions);
    const SegmentPressures p = static_pressures(network, solution, conditions.resident, 0);
    EXPECT_NEAR(
        p.proximal_static_pa - p.distal_static_pa,
        static_pressure_drop_pa(PressureLaw::regime, network.cones[0], conditions.resident, 2.0),
        1e-12);
}

void expect_finite(const FlowSolution& solution) {
    for (const auto* values :
         {&solution.volume_flow_mm3_s, &solution.mass_flow_g_s, &solution.total_pressure_pa,
          &solution.outlet_flow_mm3_s, &solution.inlet_pressure_pa, &solution.inlet_flow_mm3_s})
        for (const double value : *values) ASSERT_TRUE(std::isfinite(value));
}

TEST(FlowSolution, GivesAFiniteAnswerAtTheExtremes) {
    for (const double void_fraction : {0.0, 1e-12, 0.999})
        for (const double radius : {1e-6, 1.0})
            for (const double length : {0.0, 10.0})
                for (const double flow : {0.0, -1.0, 1e-300, 1e9})
                    for (const PressureLaw law : laws)
                        for (const int segments : {1, 2, 7}) {
                            Random random(20);
                            FlowNetwork network = random_tree(random, segments);
                            network.cones[segments / 2] = {radius, radius, length};
                            FlowConditions conditions = conditions_of(law, {flow_into(0, flow)});
                            conditions.resident = mixture(blood(), gas(), void_fraction);
                            expect_finite(solve_flow(network, conditions));
                        }
}

TEST(FlowSolution, RefusesAFlowThatHasNoWayOut) {
    Random random(21);
    FlowNetwork network = random_tree(random, 15);
    FlowConditions conditions = conditions_of(PressureLaw::regime, {flow_into(0, 1.0)});
    conditions.terminal_resistances.assign(network.outlet_nodes.size(),
                                           std::numeric_limits<double>::infinity());
    EXPECT_THROW(solve_flow(network, conditions), InputError);
    // Under a pressure everything is simply at rest, at that pressure.
    conditions.inlets = {{0, InletKind::pressure, 1234.0, pure(blood())}};
    const FlowSolution still = solve_flow(network, conditions);
    for (const double q : still.volume_flow_mm3_s) EXPECT_EQ(q, 0.0);
    for (const double p : still.total_pressure_pa) EXPECT_EQ(p, 1234.0);
    // Loops have another path through the code.
    add_loops(random, network, 3);
    expect_finite(solve_flow(network, conditions));
    conditions.inlets = {flow_into(0, 1.0)};
    EXPECT_THROW(solve_flow(network, conditions), InputError);
}

// Vessels that nothing drives, cut off on all sides, are at rest and at some finite pressure.
TEST(FlowSolution, LeavesAPieceThatNothingDrivesAtRest) {
    Random random(23);
    for (const int loops : {0, 3}) {
        FlowNetwork network = random_tree(random, 15);
        if (loops > 0) {  // within the piece that is cut off
            network.cones.push_back({1.0, 1.0, 10.0});
            network.segments.push_back(
                {network.segments[3].distal_node, network.segments[4].distal_node, 15, 1, 15});
        }
        set_open(network, 1, false);
        FlowConditions conditions = conditions_of(PressureLaw::regime, {flow_into(0, 1.0)});
        set_open(network, 14, false);  // a single end
        std::vector<bool> cut_off(network.node_count, false);
        for (const int closed : {1, 14}) cut_off[network.segments[closed].distal_node] = true;
        for (int s = 2; s < 15; ++s)
            if (cut_off[network.segments[s].proximal_node])
                cut_off[network.segments[s].distal_node] = true;
        for (const int outlet : network.outlet_nodes)
            conditions.terminal_resistances.push_back(
                cut_off[outlet] ? std::numeric_limits<double>::infinity() : 0.0);
        const FlowSolution solution = solve_flow(network, conditions);
        for (int n = 0; n < network.node_count; ++n)
            EXPECT_TRUE(std::isfinite(solution.total_pressure_pa[n])) << n;
        for (std::size_t s = 0; s < network.segments.size(); ++s)
            if (cut_off[network.segments[s].distal_node]) {
                EXPECT_EQ(solution.volume_flow_mm3_s[s], 0.0) << s;
            }
        EXPECT_NEAR(solution.mass_flow_g_s[2], 1.0, 1e-12);
    }
}

TEST(FlowSolution, RefusesConditionsOutOfRange) {
    Random random(22);
    const FlowNetwork network = random_tree(random, 3);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {nan, 1e16, -std::numeric_limits<double>::infinity()})
        EXPECT_THROW(solve_flow(network, conditions_of(PressureLaw::regime, {flow_into(0, bad)})),
                     InputError);
    FlowConditions conditions = conditions_of(PressureLaw::regime, {flow_into(9, 1.0)});
    EXPECT_THROW(solve_flow(network, conditions), InputError);
    conditions.inlets = {flow_into(0, 1.0)};
    conditions.outlet_pressure_pa = nan;
    EXPECT_THROW(solve_flow(network, conditions), InputError);
    conditions.outlet_pressure_pa = 0.0;
    conditions.terminal_resistances = {1.0};
    EXPECT_THROW(solve_flow(network, conditions), InputError);
}

}  // namespace
}  // namespace hepatica
