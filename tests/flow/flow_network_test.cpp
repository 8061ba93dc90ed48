// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/flow_network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::Random;

using std::numbers::pi;

// Root at the origin, 10 mm along x, then two daughters of 5 mm.
VesselTree fork() {
    VesselTree tree;
    tree.nodes = {
        {Vec3(0, 0, 0), 2.0}, {Vec3(10, 0, 0), 1.5}, {Vec3(10, 5, 0), 1.0}, {Vec3(10, -5, 0), 0.8}};
    const auto add = [&](int from, int to, int parent, double r1, double r2) {
        VesselSegment s;
        s.proximal_node = from;
        s.distal_node = to;
        s.parent = parent;
        for (int i = 0; i <= 10; ++i) {
            const double share = i / 10.0;
            s.points_mm.push_back((1 - share) * tree.nodes[from].position_mm +
                                  share * tree.nodes[to].position_mm);
            s.radii_mm.push_back((1 - share) * r1 + share * r2);
        }
        tree.segments.push_back(s);
    };
    add(0, 1, -1, 2.0, 1.5);
    add(1, 2, 0, 1.2, 1.0);
    add(1, 3, 0, 1.0, 0.8);
    return tree;
}

TEST(FlowNetwork, KeepsAConeThatIsACone) {
    for (const SegmentShape shape : {SegmentShape::one_cone, SegmentShape::centreline}) {
        const FlowNetwork network = network_of(fork(), shape);
        EXPECT_EQ(network.root_nodes, std::vector<int>{0});
        EXPECT_EQ(network.outlet_nodes, (std::vector<int>{2, 3}));
        EXPECT_NEAR(proximal_radius_mm(network, 0), 2.0, 1e-13);
        EXPECT_NEAR(distal_radius_mm(network, 0), 1.5, 1e-13);
        EXPECT_NEAR(length_mm(network, 0), 10.0, 1e-13);
        EXPECT_NEAR(volume_mm3(network, 0), pi * 10 * (4 + 3 + 2.25) / 3, 1e-11);
    }
}

// The normal equations of the fit, by brute force over many samples of the piecewise linear radius.
TEST(FlowNetwork, FitsOneConeByLeastSquares) {
    VesselTree tree = fork();
    std::vector<double>& radii = tree.segments[0].radii_mm;
    Random random(7);
    for (double& r : radii) r += random.uniform(-0.3, 0.3);
    const FlowNetwork network = network_of(tree);
    double s0 = 0, s1 = 0, s2 = 0, t0 = 0, t1 = 0;
    const int samples = 1'000'000;
    for (int i = 0; i < samples; ++i) {
        const double x = 10.0 * (i + 0.5) / samples;
        const int piece = static_cast<int>(x);
        const double r = radii[piece] + (x - piece) * (radii[piece + 1] - radii[piece]);
        s0 += 1;
        s1 += x;
        s2 += x * x;
        t0 += r;
        t1 += r * x;
    }
    const double slope = (s0 * t1 - s1 * t0) / (s0 * s2 - s1 * s1);
    const double intercept = (t0 - slope * s1) / s0;
    EXPECT_NEAR(proximal_radius_mm(network, 0), intercept, 1e-9);
    EXPECT_NEAR(distal_radius_mm(network, 0), intercept + 10 * slope, 1e-9);
}

TEST(FlowNetwork, InvertsVolumeAndArclength) {
    Random random(8);
    for (int i = 0; i < 10'000; ++i) {
        FlowNetwork network;
        network.node_count = 2;
        FlowSegment s;
        s.proximal_node = 0;
        s.distal_node = 1;
        s.tree_segment = 0;
        s.cone_count = random.integer(1, 4);
        for (int c = 0; c < s.cone_count; ++c) {
            Cone cone = testing_flow::random_cone(random);
            if (random.integer(0, 3) == 0)
                cone.distal_radius_mm =
                    cone.proximal_radius_mm * (1.0 + random.uniform(-1e-12, 1e-12));
            network.cones.push_back(cone);
        }
        network.segments = {s};
        const double length = length_mm(network, 0);
        const double x = random.uniform(0.0, length);
        const double volume = volume_up_to_mm3(network, 0, x);
        ASSERT_NEAR(volume_up_to_mm3(network, 0, arclength_at_mm(network, 0, volume)), volume,
                    1e-13 * volume_mm3(network, 0));
        ASSERT_EQ(volume_up_to_mm3(network, 0, 0.0), 0.0);
        ASSERT_NEAR(volume_up_to_mm3(network, 0, length), volume_mm3(network, 0),
                    1e-12 * volume_mm3(network, 0));
    }
}

TEST(FlowNetwork, DividesWithoutChangingTheLumen) {
    for (const SegmentShape shape : {SegmentShape::one_cone, SegmentShape::centreline}) {
        FlowNetwork network = network_of(fork(), shape);
        const double volume = volume_mm3(network);
        const int nodes = network.node_count;
        const int first = divide(network, {0, 7.3, 0.0});
        const int second = divide(network, {0, 2.5, 0.0});
        const int again = divide(network, {0, 7.3, 0.0});
        EXPECT_EQ(first, again);
        EXPECT_EQ(network.node_count, nodes + 2);
        EXPECT_NE(first, second);
        EXPECT_NEAR(volume_mm3(network), volume, 1e-11);
        EXPECT_NEAR(length_mm(network, 0), 2.5, 1e-12);
        EXPECT_EQ(locate(network, {0, 5.0, 0.0}).segment, 4);
        EXPECT_NEAR(locate(network, {0, 5.0, 0.0}).arclength_mm, 2.5, 1e-12);
        EXPECT_EQ(locate(network, {0, 9.0, 0.0}).segment, 3);
        EXPECT_NEAR(locate(network, {0, 9.0, 0.0}).arclength_mm, 1.7, 1e-12);
        EXPECT_EQ(divide(network, {1, 0.0, 0.0}), 1);
        EXPECT_EQ(divide(network, {1, 5.0, 0.0}), 2);
        EXPECT_NO_THROW(validate(network));
    }
}

TEST(FlowNetwork, RefusesPointsThatAreNotOnIt) {
    FlowNetwork network = network_of(fork());
    EXPECT_THROW(divide(network, {-1, 0.0, 0.0}), InputError);
    EXPECT_THROW(divide(network, {3, 0.0, 0.0}), InputError);
    EXPECT_THROW(divide(network, {0, std::nan(""), 0.0}), InputError);
}

TEST(FlowNetwork, ARingOnOneNodeIsClosed) {
    VesselTree tree = fork();
    VesselSegment ring = tree.segments[1];
    ring.distal_node = ring.proximal_node;
    ring.closes_loop = true;
    tree.segments.push_back(ring);
    const FlowNetwork network = network_of(tree);
    EXPECT_FALSE(network.segments.back().open);
}

TEST(FlowNetwork, TearsAndOpenSidesMayShareAVessel) {
    Random random(31);
    FlowNetwork network = testing_flow::random_tree(random, 3);
    const double length = length_mm(network, 0);
    const std::vector<TreePoint> points{
        {0, 0.25 * length, 0.0}, {0, 0.75 * length, 0.0}, {0, 0.75 * length, 0.0}, {1, 0.0, 0.0}};
    const std::vector<double> areas{1.0, 2.0, 3.0, 4.0};
    const std::vector<TearOpening> openings =
        tear_all(network, points, areas, std::vector<std::uint8_t>{1, 1, 1, 0});
    ASSERT_EQ(openings.size(), 5u) << "both stumps of the tear, and one of each side";
    EXPECT_EQ(openings[1].torn_node, openings[2].torn_node);
    const std::vector<double> torn_mm2 = torn_areas_mm2(network, openings);
    EXPECT_EQ(torn_mm2, (std::vector<double>{1.0, 5.0, 4.0, 4.0}));
    EXPECT_EQ(network.segments[0].distal_node, network.torn_nodes[0]);
    int onwards = 0;
    for (const FlowSegment& s : network.segments)
        onwards += s.proximal_node == network.torn_nodes[0] ? 1 : 0;
    EXPECT_EQ(onwards, 1);
}

}  // namespace
}  // namespace hepatica
