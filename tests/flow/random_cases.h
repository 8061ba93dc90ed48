// SPDX-License-Identifier: GPL-3.0-or-later
// Random cones, flows and trees for property tests: the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "core/flow/flow_network.h"

namespace hepatica::testing_flow {

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    double logarithmic(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    int integer(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }

  private:
    std::mt19937_64 engine_;
};

// The ranges that the accuracy of the pressure laws is promised over.
inline Cone random_cone(Random& random) {
    return {random.logarithmic(0.05, 10.0), random.logarithmic(0.05, 10.0),
            random.logarithmic(0.1, 200.0)};
}

inline Fluid random_fluid(Random& random) {
    const double share = random.integer(0, 3) == 0 ? 0.0 : random.uniform(0.0, 0.999);
    return random.integer(0, 1) == 0 ? mixture(blood(), lipiodol(), share)
                                     : mixture(blood(), gas(), share);
}

// A binary tree of `segments` conical segments under Murray's law with scatter, breadth first.
inline FlowNetwork random_tree(Random& random, int segments, double root_radius_mm = 3.0) {
    FlowNetwork network;
    network.node_count = segments + 1;
    network.root_nodes = {0};
    std::vector<double> radius(network.node_count, root_radius_mm);
    std::vector<int> daughters(network.node_count, 0);
    int parent = 0;
    for (int i = 0; i < segments; ++i) {
        const int node = i + 1;
        if (i > 0 && daughters[parent] >= (parent == 0 ? 1 : 2)) ++parent;
        ++daughters[parent];
        const double r1 = radius[parent] * (parent == 0 ? 1.0 : random.uniform(0.6, 0.95));
        const double r2 = r1 * random.uniform(0.7, 1.05);
        radius[node] = r2;
        FlowSegment s;
        s.proximal_node = parent;
        s.distal_node = node;
        s.first_cone = i;
        s.cone_count = 1;
        s.tree_segment = i;
        network.segments.push_back(s);
        network.cones.push_back({r1, r2, r1 * random.uniform(2.0, 15.0)});
    }
    for (int n = 1; n < network.node_count; ++n)
        if (daughters[n] == 0) network.outlet_nodes.push_back(n);
    return network;
}

// A binary tree of straight conical vessels, depth first, Murray's radii.
inline void grow(VesselTree& tree, Random& random, int parent, int node, double radius,
                 int generations) {
    const double length = radius * random.uniform(4.0, 12.0);
    const double distal = radius * random.uniform(0.8, 1.0);
    const Vec3 direction =
        Vec3(1.0, random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)).normalized();
    const Vec3 start = tree.nodes[node].position_mm;
    const int end = static_cast<int>(tree.nodes.size());
    tree.nodes.push_back({start + length * direction, distal});
    VesselSegment s;
    s.proximal_node = node;
    s.distal_node = end;
    s.parent = parent;
    for (int i = 0; i <= 8; ++i) {
        s.points_mm.push_back(start + length * i / 8.0 * direction);
        s.radii_mm.push_back(radius + (distal - radius) * i / 8.0);
    }
    const int id = static_cast<int>(tree.segments.size());
    tree.segments.push_back(s);
    if (generations == 0) return;
    const double share = random.uniform(0.3, 0.7);
    grow(tree, random, id, end, distal * std::cbrt(share), generations - 1);
    grow(tree, random, id, end, distal * std::cbrt(1.0 - share), generations - 1);
}

inline VesselTree make_tree(std::uint64_t seed, int generations) {
    Random random(seed);
    VesselTree tree;
    tree.nodes.push_back({Vec3::Zero(), 2.5});
    grow(tree, random, -1, 0, 2.5, generations);
    validate(tree);
    return tree;
}

// Links between random nodes, so that the network has loops.
inline void add_loops(Random& random, FlowNetwork& network, int count) {
    for (int i = 0; i < count; ++i) {
        FlowSegment s;
        s.proximal_node = random.integer(0, network.node_count - 1);
        s.distal_node = random.integer(0, network.node_count - 1);
        if (s.proximal_node == s.distal_node) continue;
        s.first_cone = static_cast<int>(network.cones.size());
        s.tree_segment = static_cast<int>(network.segments.size());
        network.cones.push_back({random.uniform(0.3, 1.5), random.uniform(0.3, 1.5), 20.0});
        network.segments.push_back(s);
    }
}

}  // namespace hepatica::testing_flow
