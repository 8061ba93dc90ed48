// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/arrival_times.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/flow/quadrature.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::integrate;
using testing_flow::Random;
using testing_flow::random_tree;
using testing_flow::Real;

// The integral of A/Q from the tip to the point, by quadrature along the path.
TEST(ArrivalTimes, AreTheIntegralOfAreaOverFlow) {
    Random random(31);
    for (int i = 0; i < 30; ++i) {
        const FlowNetwork network = random_tree(random, 40);
        FlowConditions conditions;
        conditions.inlets = {
            {0, InletKind::mass_flow, random.logarithmic(0.01, 10.0), pure(blood())}};
        const FlowSolution solution = solve_flow(network, conditions);
        const ArrivalTimes times = arrival_times(network, solution, {0});
        const auto travel = [&](int segment, double to_mm) {
            const Cone& cone = network.cones[segment];
            return integrate(
                [&](Real x) {
                    const Real r =
                        cone.proximal_radius_mm +
                        (cone.distal_radius_mm - cone.proximal_radius_mm) * x / cone.length_mm;
                    return 3.141592653589793238L * r * r / solution.volume_flow_mm3_s[segment];
                },
                0.0L, to_mm, 1e-15L);
        };
        for (int segment = 0; segment < 40; ++segment) {
            const double x = random.uniform(0.0, network.cones[segment].length_mm);
            Real expected = travel(segment, x);
            for (int node = network.segments[segment].proximal_node; node > 0;
                 node = network.segments[node - 1].proximal_node)
                expected += travel(node - 1, network.cones[node - 1].length_mm);
            ASSERT_NEAR(times.arrival_s(segment, x), static_cast<double>(expected),
                        1e-12 * times.end_s());
            ASSERT_EQ(times.arrival_s(segment, x), times.arrival_s(TreePoint{segment, x, 0.0}));
        }
    }
}

TEST(ArrivalTimes, AreInfiniteWhereNothingComes) {
    Random random(32);
    FlowNetwork network = random_tree(random, 31);
    const double length = length_mm(network, 1);
    const int tip = place_catheter(network, {1, 0.5 * length, 0.0}, true);
    FlowConditions conditions;
    conditions.inlets = {{tip, InletKind::mass_flow, 1.0, pure(blood())}};
    const ArrivalTimes times = arrival_times(network, solve_flow(network, conditions), {tip});
    EXPECT_TRUE(std::isinf(times.arrival_s(TreePoint{0, 1.0, 0.0})));
    EXPECT_TRUE(std::isinf(times.arrival_s(TreePoint{2, 1.0, 0.0})));
    EXPECT_TRUE(std::isinf(times.arrival_s(TreePoint{1, 0.4 * length, 0.0})));
    EXPECT_EQ(times.arrival_s(TreePoint{1, 0.5 * length, 0.0}), 0.0);
    EXPECT_GT(times.arrival_s(TreePoint{1, 0.6 * length, 0.0}), 0.0);
    EXPECT_TRUE(std::isfinite(times.arrival_s(TreePoint{3, 0.0, 0.0})));
    EXPECT_TRUE(std::isfinite(times.end_s()));
}

// Two ways round to the same place: a wide slow one and a narrow fast one. Times by hand from Q.
TEST(ArrivalTimes, TakeTheEarlierOfTwoPaths) {
    FlowNetwork network;
    network.node_count = 4;
    network.root_nodes = {0};
    network.outlet_nodes = {3};
    network.cones = {{2, 2, 1}, {1, 1, 10}, {1, 1, 30}, {2, 2, 10}};
    network.segments = {{0, 1, 0, 1, 0}, {1, 2, 1, 1, 1}, {1, 2, 2, 1, 2}, {2, 3, 3, 1, 3}};
    FlowConditions conditions;
    conditions.inlets = {{0, InletKind::mass_flow, 1.06e-1, pure(blood())}};  // 100 mm3/s
    const ArrivalTimes times = arrival_times(network, solve_flow(network, conditions), {0});
    const double pi = 3.14159265358979323846;
    const double first = 4 * pi / 100;
    EXPECT_NEAR(times.arrival_s(3, 0.0), first + 10 * pi / 75, 1e-12);
    EXPECT_NEAR(times.arrival_s(2, 30.0), first + 30 * pi / 25, 1e-12);
}

// One front from each end, each a little beyond the place where they meet.
TEST(ArrivalTimes, TakeTheEarlierOfTwoFrontsThatMeet) {
    FlowNetwork network;
    network.node_count = 2;
    network.cones = {{1, 1, 10}};
    network.segments = {{0, 1, 0, 1, 0}};
    const double volume = volume_mm3(network, 0);
    ArrivalTimes times(network);
    times.set_from_proximal(0, {{0.0, 0.0}, {0.8 * volume, 0.8}});
    times.set_from_distal(0, {{0.4 * volume, 0.9}, {volume, 0.1}});
    for (const auto& [at_mm, expected_s] :
         {std::pair{0.0, 0.0}, {3.0, 0.3}, {5.0, 0.5}, {6.1, 0.61}, {7.0, 0.5}, {10.0, 0.1}})
        EXPECT_NEAR(times.arrival_s(0, at_mm), expected_s, 1e-12) << at_mm;
    EXPECT_EQ(times.first_s(0), 0.0);
}

}  // namespace
}  // namespace hepatica
