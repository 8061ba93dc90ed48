// SPDX-License-Identifier: GPL-3.0-or-later
// Small trees made by hand.
#pragma once

#include <gtest/gtest.h>

#include "core/tree/extraction/vessel_graph.h"
#include "core/tree/vessel_tree.h"

namespace hepatica::test {

inline VesselLink straight_link(VesselGraph& graph, int from, int to, double from_radius_mm,
                                double to_radius_mm,
                                VascularSystem system = VascularSystem::unknown) {
    VesselLink link;
    link.from = from;
    link.to = to;
    link.system = system;
    for (int i = 0; i <= 8; ++i) {
        const double share = i / 8.0;
        link.points_mm.push_back(graph.nodes[from].position_mm +
                                 share *
                                     (graph.nodes[to].position_mm - graph.nodes[from].position_mm));
        link.radii_mm.push_back(from_radius_mm + share * (to_radius_mm - from_radius_mm));
    }
    link.points_mm.back() = graph.nodes[to].position_mm;
    return link;
}

// A trunk (0-1), two branches (1-2, 1-3), the second of which forks again (3-4, 3-5).
inline VesselGraph forked_graph() {
    VesselGraph graph;
    for (const auto& [position, radius] : {std::pair{Vec3(0, 0, 0), 4.0},
                                           {Vec3(0.1, 20, 3), 3.7},
                                           {Vec3(-12, 31, 5), 2.1},
                                           {Vec3(9, 33, 1), 3.0},
                                           {Vec3(5, 50, -4), 1.6},
                                           {Vec3(22, 45, 2), 2.2}})
        graph.nodes.push_back({position, radius});
    graph.links = {straight_link(graph, 0, 1, 4.0, 3.7), straight_link(graph, 1, 2, 2.5, 2.1),
                   straight_link(graph, 1, 3, 3.3, 3.0), straight_link(graph, 3, 4, 1.9, 1.6),
                   straight_link(graph, 3, 5, 2.4, 2.2)};
    return graph;
}

inline VesselTree forked_tree() {
    return directed(forked_graph());
}

inline void expect_equal(const VesselTree& a, const VesselTree& b) {
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (std::size_t n = 0; n < a.nodes.size(); ++n) {
        EXPECT_EQ(a.nodes[n].position_mm, b.nodes[n].position_mm) << "node " << n;
        EXPECT_EQ(a.nodes[n].radius_mm, b.nodes[n].radius_mm) << "node " << n;
    }
    ASSERT_EQ(a.segments.size(), b.segments.size());
    for (std::size_t s = 0; s < a.segments.size(); ++s) {
        const VesselSegment& x = a.segments[s];
        const VesselSegment& y = b.segments[s];
        EXPECT_EQ(x.points_mm, y.points_mm) << "segment " << s;
        EXPECT_EQ(x.radii_mm, y.radii_mm) << "segment " << s;
        EXPECT_EQ(x.proximal_node, y.proximal_node) << "segment " << s;
        EXPECT_EQ(x.distal_node, y.distal_node) << "segment " << s;
        EXPECT_EQ(x.parent, y.parent) << "segment " << s;
        EXPECT_EQ(x.system, y.system) << "segment " << s;
        EXPECT_EQ(x.system_confidence, y.system_confidence) << "segment " << s;
        EXPECT_EQ(x.strahler_order, y.strahler_order) << "segment " << s;
        EXPECT_EQ(x.closes_loop, y.closes_loop) << "segment " << s;
    }
}

}  // namespace hepatica::test
