// SPDX-License-Identifier: GPL-3.0-or-later
// Random vessel trees for property tests: gently bent branches that halve by Murray's law and stay
// apart from each other.
#pragma once

#include <cmath>
#include <random>

#include "core/tree/vessel_tree.h"

namespace hepatica::test {

inline double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

inline int add_node(VesselTree& tree, const Vec3& position_mm, double radius_mm) {
    tree.nodes.push_back({position_mm, radius_mm});
    return static_cast<int>(tree.nodes.size()) - 1;
}

// A vessel of `length_mm` from a node along `direction`, bent sideways by a tenth of its length.
inline int add_vessel(VesselTree& tree, int proximal, int parent, const Vec3& direction,
                      double length_mm, double radius_begin_mm, double radius_end_mm) {
    VesselSegment segment;
    segment.proximal_node = proximal;
    segment.parent = parent;
    const Vec3 start = tree.nodes[proximal].position_mm;
    const Vec3 side = direction.unitOrthogonal();
    const int pieces = 12;
    for (int i = 0; i <= pieces; ++i) {
        const double share = static_cast<double>(i) / pieces;
        segment.points_mm.push_back(start + share * length_mm * direction +
                                    0.1 * length_mm * std::sin(M_PI * share) * side);
        segment.radii_mm.push_back((1.0 - share) * radius_begin_mm + share * radius_end_mm);
    }
    segment.distal_node = add_node(tree, segment.points_mm.back(), radius_end_mm);
    tree.segments.push_back(segment);
    return static_cast<int>(tree.segments.size()) - 1;
}

// A binary tree: `generations` 1 is a single vessel, 4 has 15 vessels and 8 ends. Siblings part
// by 60 to 90 degrees in planes that turn, so that branches keep clear of each other.
inline VesselTree random_tree(std::uint64_t seed, int generations, double root_radius_mm = 5.0) {
    std::mt19937_64 random(seed);
    VesselTree tree;
    const int root = add_node(tree, Vec3::Zero(), root_radius_mm);
    struct Tip {
        int segment;
        Vec3 direction, plane;
        double length_mm, radius_mm;
    };
    const double first_length_mm = 14.0 * root_radius_mm;
    const Vec3 up = Vec3::UnitZ();
    std::vector<Tip> tips{
        {add_vessel(tree, root, -1, up, first_length_mm, root_radius_mm, 0.9 * root_radius_mm), up,
         Vec3::UnitX(), first_length_mm, 0.9 * root_radius_mm}};
    for (int generation = 1; generation < generations; ++generation) {
        std::vector<Tip> next;
        for (const Tip& tip : tips) {
            const double share = uniform(random, 0.4, 0.6);  // of the flow, to the first child
            const Vec3 side =
                (tip.plane - tip.plane.dot(tip.direction) * tip.direction).normalized();
            for (const auto& [sign, part] : {std::pair{1.0, share}, std::pair{-1.0, 1.0 - share}}) {
                const double angle = sign * uniform(random, 0.5, 0.75);
                const Vec3 direction =
                    (std::cos(angle) * tip.direction + std::sin(angle) * side).normalized();
                const double radius = tip.radius_mm * std::cbrt(part);
                const double length = 0.7 * tip.length_mm;
                const int segment =
                    add_vessel(tree, tree.segments[tip.segment].distal_node, tip.segment, direction,
                               length, radius, 0.9 * radius);
                next.push_back(
                    {segment, direction, direction.cross(side).normalized(), length, 0.9 * radius});
            }
        }
        tips = std::move(next);
    }
    return tree;
}

}  // namespace hepatica::test
