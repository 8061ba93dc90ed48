// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/fork_placement.h"

#include <gtest/gtest.h>

#include "core/tree/extraction/centreline.h"

namespace hepatica {
namespace {

constexpr double radius_mm = 3.0;
constexpr double voxel_mm = 0.5;
constexpr double straight_mm = 20.0;
const Vec3 fork(10, -4, 7);
const std::vector<Vec3> axes{Vec3(0, -1, 0.1).normalized(), Vec3(0.6, 1, 0).normalized(),
                             Vec3(-0.7, 0.8, 0.3).normalized()};

struct Sample {
    VesselGraph graph;
    std::vector<std::vector<std::uint8_t>> reliable;
};

// Three vessels whose axes meet in `fork`, but whose node lies elsewhere: the links run from there
// to where they leave the lumen, as thinning has it. Every other link is told from its far end.
Sample forked_at(const Vec3& node_mm) {
    Sample sample;
    sample.graph.nodes.push_back({node_mm, radius_mm});
    for (const Vec3& axis : axes) {
        const int end = static_cast<int>(sample.graph.nodes.size());
        sample.graph.nodes.push_back({fork + straight_mm * axis, radius_mm});
        VesselLink link{0, end, VascularSystem::unknown, 0.0, {}, {}};
        for (double along = 0.0; along <= straight_mm + 1e-9; along += voxel_mm) {
            const double share = std::min(1.0, along / (1.5 * radius_mm));
            link.points_mm.push_back(fork + along * axis + (1.0 - share) * (node_mm - fork));
            link.radii_mm.push_back(radius_mm);
        }
        std::vector<std::uint8_t> reliable;
        for (const Vec3& p : link.points_mm)
            reliable.push_back((p - fork).norm() >= 1.5 * radius_mm ? 1 : 0);
        if (end % 2 == 0) {
            std::swap(link.from, link.to);
            std::ranges::reverse(link.points_mm);
            std::ranges::reverse(reliable);
        }
        sample.graph.links.push_back(link);
        sample.reliable.push_back(reliable);
    }
    return sample;
}

TEST(ForkPlacement, AForkGoesToWhereTheAxesOfItsBranchesMeet) {
    for (const Vec3& off : {Vec3(1.5, 2.0, 0), Vec3(-1, 0, 2.5), Vec3(0, -2, -1)}) {
        Sample sample = forked_at(fork + off);
        place_forks(sample.graph, sample.reliable, voxel_mm);
        // The pull to the old place is a fiftieth of one axis.
        EXPECT_LT((sample.graph.nodes[0].position_mm - fork).norm(), 0.04 * off.norm());
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const VesselLink& link = sample.graph.links[i];
            EXPECT_EQ(link.points_mm.front(), sample.graph.nodes[link.from].position_mm);
            EXPECT_EQ(link.points_mm.back(), sample.graph.nodes[link.to].position_mm);
            // Straight from the fork to the axis and along it: no point is off it any more.
            for (const Vec3& p : link.points_mm)
                EXPECT_LT((p - fork).cross(axes[i]).norm(), 0.05 * off.norm());
        }
        for (int end = 1; end <= 3; ++end)
            EXPECT_EQ(sample.graph.nodes[end].position_mm, fork + straight_mm * axes[end - 1]);
    }
}

TEST(ForkPlacement, AForkMovesNoFurtherThanItsRadiusAndTwoVoxels) {
    const Vec3 far = fork + Vec3(30, 0, 0);
    Sample sample = forked_at(fork);
    sample.graph.nodes[0].position_mm = far;
    place_forks(sample.graph, sample.reliable, voxel_mm);
    EXPECT_NEAR((sample.graph.nodes[0].position_mm - far).norm(), radius_mm + 2.0 * voxel_mm, 1e-9);
}

TEST(ForkPlacement, WithoutTwoAxesNothingMoves) {
    const Vec3 node = fork + Vec3(1, 1, 0);
    Sample sample = forked_at(node);
    for (std::size_t i = 1; i < 3; ++i) std::ranges::fill(sample.reliable[i], std::uint8_t{0});
    const VesselGraph before = sample.graph;
    place_forks(sample.graph, sample.reliable, voxel_mm);
    EXPECT_EQ(sample.graph.nodes[0].position_mm, node);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(sample.graph.links[i].points_mm, before.links[i].points_mm);
}

TEST(ForkPlacement, ANodeThatTwoVesselsPassIsNoFork) {
    const Vec3 node = fork + Vec3(1, 1, 0);
    Sample sample = forked_at(node);
    sample.graph.links.pop_back();
    sample.reliable.pop_back();
    place_forks(sample.graph, sample.reliable, voxel_mm);
    EXPECT_EQ(sample.graph.nodes[0].position_mm, node);
}

}  // namespace
}  // namespace hepatica
