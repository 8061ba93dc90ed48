// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/embolization.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::Random;
using testing_flow::random_tree;

FlowConditions under_pressure(const FlowNetwork& network, double resistance = 0.05) {
    FlowConditions conditions;
    conditions.inlets = {{0, InletKind::pressure, 5000.0, pure(blood())}};
    conditions.terminal_resistances = murray_terminal_resistances(network, resistance);
    return conditions;
}

// One vessel that parts into two: the beds beyond the outlets are what the beads shut.
FlowNetwork fork(double left_mm, double right_mm) {
    FlowNetwork network;
    network.node_count = 4;
    network.root_nodes = {0};
    network.outlet_nodes = {2, 3};
    network.cones = {{1.5, 1.5, 10}, {left_mm, left_mm, 10}, {right_mm, right_mm, 10}};
    network.segments = {{0, 1, 0, 1, 0}, {1, 2, 1, 1, 1}, {1, 3, 2, 1, 2}};
    return network;
}

TEST(Embolization, LodgesWhereTheLumenIsAsSmallAsTheBead) {
    FlowNetwork network;
    network.node_count = 2;
    network.cones = {{1.0, 0.4, 6.0}, {0.4, 0.2, 4.0}};
    FlowSegment s;
    s.proximal_node = 0;
    s.distal_node = 1;
    s.cone_count = 2;
    network.segments = {s};
    EXPECT_NEAR(lodging_place_mm(network, 0, 0.7, true), 3.0, 1e-12);
    EXPECT_NEAR(lodging_place_mm(network, 0, 0.3, true), 8.0, 1e-12);
    EXPECT_TRUE(std::isinf(lodging_place_mm(network, 0, 0.1, true)));
    EXPECT_EQ(lodging_place_mm(network, 0, 1.5, true), 0.0);
    EXPECT_EQ(lodging_place_mm(network, 0, 0.3, false), 10.0);  // does not even enter
}

TEST(Embolization, KeepsTheMassOfTheBeads) {
    Random random(71);
    for (int i = 0; i < 10; ++i) {
        const FlowNetwork network = random_tree(random, 63, 1.5);
        EmbolizationOptions options;
        options.beads = bead_presets()[i % 4];
        options.bead_count = 2000;
        options.batch = 50;
        options.seed = 100 + i;
        Job job;
        const Embolization result = embolize(network, under_pressure(network), 0, options, job);
        const int lodged =
            std::accumulate(result.lodged_in_segment.begin(), result.lodged_in_segment.end(), 0) +
            std::accumulate(result.lodged_beyond_outlet.begin(), result.lodged_beyond_outlet.end(),
                            0);
        EXPECT_EQ(lodged + result.passed, result.injected);
        EXPECT_LE(result.mass_error_relative(), 1e-12);
        EXPECT_GT(result.injected_mass_g, 0.0);
    }
}

// Under one pressure the flow can only fall as vessels are plugged.
TEST(Embolization, FlowFallsToStasis) {
    const FlowNetwork network = fork(0.8, 0.6);
    EmbolizationOptions options;
    options.beads = bead_preset("300-500");
    options.bead_count = 100'000;
    options.batch = 5;
    Job job;
    const Embolization result = embolize(network, under_pressure(network), 0, options, job);
    ASSERT_TRUE(result.stasis);
    EXPECT_LT(result.injected, options.bead_count);
    for (std::size_t i = 1; i < result.series.size(); ++i)
        ASSERT_LE(result.series[i].flow_mm3_s, result.series[i - 1].flow_mm3_s * (1 + 1e-12));
    EXPECT_LE(result.series.back().flow_mm3_s, 0.05 * result.series.front().flow_mm3_s);
    // Each bed of radius r takes about (r/b)^3 beads, b = 0.2 mm: 64 and 27. A bead's volume varies
    // by 2 per cent about that of the mean, and the last batch overshoots.
    EXPECT_NEAR(result.lodged_beyond_outlet[0], 64, 12);
    EXPECT_NEAR(result.lodged_beyond_outlet[1], 27, 9);
}

// The first batch finds the flow undisturbed: beads divide like the flow, within three deviations
// of a binomial.
TEST(Embolization, BeadsFollowTheFlow) {
    const FlowNetwork network = fork(0.9, 0.6);
    const FlowConditions conditions = under_pressure(network);
    const FlowSolution flow = solve_flow(network, conditions);
    const double share = flow.volume_flow_mm3_s[1] / flow.volume_flow_mm3_s[0];
    EmbolizationOptions options;
    options.beads = {"small", 20.0, 0.0, 1.2e-3, ""};
    options.bead_count = 10'000;
    options.batch = 10'000;
    Job job;
    const Embolization result = embolize(network, conditions, 0, options, job);
    const double deviation = std::sqrt(share * (1 - share) / options.bead_count);
    EXPECT_NEAR(result.lodged_beyond_outlet[0] / 1e4, share, 3 * deviation);
}

TEST(Embolization, TheFlowGoesWhereNoBeadsAre) {
    FlowNetwork network = fork(0.8, 0.8);
    network.cones[1].distal_radius_mm = 0.15;  // a narrow branch that the beads plug
    FlowConditions conditions = under_pressure(network);
    EmbolizationOptions options;
    options.beads = {"large", 350.0, 0.0, 1.2e-3, ""};
    options.bead_count = 200;
    options.batch = 1;
    options.capillary_radius_um = 300.0;  // the other branch lets them all through
    Job job;
    const FlowSolution before = solve_flow(network, conditions);
    const Embolization result = embolize(network, conditions, 0, options, job);
    EXPECT_EQ(result.lodged_in_segment[1], 1);
    EXPECT_EQ(result.passed, 199);
    EXPECT_NEAR(result.lodged_at_mm[1], 10.0 * (0.8 - 0.175) / (0.8 - 0.15), 1e-12);
    EXPECT_EQ(result.series.front().open_outlets, 2);
    EXPECT_EQ(result.series.back().open_outlets, 1);
    EXPECT_EQ(result.end.volume_flow_mm3_s[1], 0.0);
    EXPECT_GT(result.end.volume_flow_mm3_s[2], before.volume_flow_mm3_s[2]);
}

// However little flows: what counts is where to, and not how many mm3/s.
TEST(Embolization, BeadsOfABatchStayBehindTheOnesThatPluggedTheWay) {
    FlowNetwork network = fork(0.8, 0.8);
    network.cones[1].distal_radius_mm = network.cones[2].distal_radius_mm = 0.15;
    EmbolizationOptions options;
    options.beads = {"large", 350.0, 0.0, 1.2e-3, ""};
    options.bead_count = options.batch = 20;
    for (const double resistance : {0.05, 1e5}) {
        Job job;
        const Embolization result =
            embolize(network, under_pressure(network, resistance), 0, options, job);
        EXPECT_EQ(result.lodged_in_segment[0], 0);
        EXPECT_GT(result.lodged_in_segment[1], 0);
        EXPECT_GT(result.lodged_in_segment[2], 0);
        EXPECT_EQ(result.lodged_in_segment[1] + result.lodged_in_segment[2], 20) << resistance;
        EXPECT_EQ(result.passed, 0);
    }
}

// A batch may hold a hundred million beads.
TEST(Embolization, ABatchHearsThatItIsCancelled) {
    const FlowNetwork network = fork(0.8, 0.6);
    EmbolizationOptions options;
    options.beads = bead_preset("300-500");
    options.bead_count = options.batch = 100'000;
    Job job;
    int heard = 0;
    job.observe([&](JobEvent) {
        if (++heard == 10) job.cancel();
    });
    EXPECT_THROW(embolize(network, under_pressure(network), 0, options, job), Cancelled);
}

// Half of these beads are narrower than the ends of both branches: once wider ones have plugged
// these, the narrow ones of the batch stay behind them, too.
TEST(Embolization, ANarrowBeadDoesNotPassAPlug) {
    FlowNetwork network = fork(0.8, 0.8);
    network.cones[1].distal_radius_mm = network.cones[2].distal_radius_mm = 0.2;
    EmbolizationOptions options;
    options.beads = {"mixed", 400.0, 50.0, 1.2e-3, ""};
    options.bead_count = options.batch = 400;
    Job job;
    const Embolization result = embolize(network, under_pressure(network), 0, options, job);
    const int beyond = result.lodged_beyond_outlet[0] + result.lodged_beyond_outlet[1];
    EXPECT_LT(beyond, 40);
    EXPECT_EQ(result.lodged_in_segment[1] + result.lodged_in_segment[2], 400 - beyond);
    EXPECT_LE(result.mass_error_relative(), 1e-12);
}

TEST(Embolization, BeadsNarrowerThanTheCapillariesPass) {
    Random random(72);
    const FlowNetwork network = random_tree(random, 15);
    EmbolizationOptions options;
    options.beads = {"dust", 4.0, 0.0, 1.2e-3, ""};
    options.bead_count = 500;
    Job job;
    const Embolization result = embolize(network, under_pressure(network), 0, options, job);
    EXPECT_EQ(result.passed, 500);
    EXPECT_FALSE(result.stasis);
    EXPECT_EQ(result.series.front().flow_mm3_s, result.series.back().flow_mm3_s);
}

// A second supply at a lower pressure draws blood off: beads leave with it and lodge nowhere, least
// of all in the narrow branch beside it, in which nothing flows.
TEST(Embolization, BeadsLeaveThroughASupplyThatDrawsBloodOff) {
    const FlowNetwork network = fork(0.05, 0.05);
    FlowConditions conditions;
    conditions.inlets = {{0, InletKind::pressure, 5000.0, pure(blood())},
                         {1, InletKind::pressure, 0.0, pure(blood())}};
    conditions.terminal_resistances = murray_terminal_resistances(network, 0.05);
    EmbolizationOptions options;
    options.beads = bead_preset("300-500");
    options.bead_count = 200;
    options.batch = 50;
    Job job;
    const Embolization result = embolize(network, conditions, 0, options, job);
    EXPECT_EQ(result.injected, 200);
    EXPECT_EQ(result.passed, 200);
    EXPECT_EQ(result.lodged_in_segment, (std::vector<int>{0, 0, 0}));
    EXPECT_EQ(result.lodged_beyond_outlet, (std::vector<int>{0, 0}));
}

TEST(Embolization, IsTheSameForTheSameSeed) {
    Random random(73);
    const FlowNetwork network = random_tree(random, 31, 1.5);
    EmbolizationOptions options;
    options.beads = bead_preset("100-300");
    options.bead_count = 3000;
    const auto run = [&](std::uint64_t seed) {
        options.seed = seed;
        Job job;
        return embolize(network, under_pressure(network), 0, options, job).lodged_beyond_outlet;
    };
    EXPECT_EQ(run(5), run(5));
    EXPECT_NE(run(5), run(6));
}

TEST(Embolization, RefusesWhatCannotWork) {
    const FlowNetwork network = fork(0.8, 0.6);
    EmbolizationOptions options;
    options.beads = bead_preset("100-300");
    Job job;
    FlowConditions conditions = under_pressure(network);
    EXPECT_THROW(embolize(network, conditions, 1, options, job), InputError);
    conditions.inlets[0] = {0, InletKind::mass_flow, 1.0, pure(blood())};
    EXPECT_THROW(embolize(network, conditions, 0, options, job), InputError);
    conditions = under_pressure(network);
    conditions.terminal_resistances.clear();
    EXPECT_THROW(embolize(network, conditions, 0, options, job), InputError);
    conditions = under_pressure(network);
    options.beads.mean_diameter_um = 0.0;
    EXPECT_THROW(embolize(network, conditions, 0, options, job), InputError);
    EXPECT_THROW(bead_preset("pebbles"), InputError);
}

}  // namespace
}  // namespace hepatica
