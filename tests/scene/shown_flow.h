// SPDX-License-Identifier: GPL-3.0-or-later
// Small flow parts with a vertex at each tenth of every segment, and what they show of an
// injection.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "core/scene/flow_part.h"

namespace hepatica::test {

inline const Injection unlike_blood{
    .at = {0, 0.0, 0.0}, .void_fraction = 0.4, .second_phase = "gas"};

// Every place of a tree at tenths of its segments.
inline std::vector<VertexPlace> places_along(const VesselTree& tree) {
    std::vector<VertexPlace> places;
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        double length_mm = 0.0;
        const auto& points = tree.segments[s].points_mm;
        for (std::size_t i = 1; i < points.size(); ++i)
            length_mm += (points[i] - points[i - 1]).norm();
        for (int k = 0; k <= 10; ++k)
            places.push_back({{static_cast<int>(s), 0.1 * k * length_mm, 0.0}, 1.0});
    }
    return places;
}

// A flow part with a vertex at each of these places.
struct Shown {
    explicit Shown(const VesselTree& tree)
        : topology(places_along(tree).size(), {}), part(tree, places_along(tree), {}, topology) {}

    BodyTopology topology;
    FlowPart part;
};

inline std::vector<float> shown(const VesselTree& tree, const Injection& injection) {
    Shown made(tree);
    FlowPart& part = made.part;
    part.inject(injection);
    part.finish_injection();
    EXPECT_LT(part.mass_error_relative(), 1e-9);
    return *part.drug().arrival_s;
}

inline VesselTree tube_of_40_mm() {
    VesselTree tree;
    tree.nodes = {{Vec3(0, 0, 0)}, {Vec3(40, 0, 0)}};
    VesselSegment segment;
    segment.proximal_node = 0;
    segment.distal_node = 1;
    segment.points_mm = {Vec3(0, 0, 0), Vec3(20, 0, 0), Vec3(40, 0, 0)};
    segment.radii_mm = {2.0, 2.0, 2.0};
    tree.segments = {segment};
    return tree;
}

}  // namespace hepatica::test
