// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/gap_bridging.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/skeleton/thinning.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "core/tree/tree_extraction.h"
#include "tests/support/test_masks.h"
#include "tests/support/test_trees.h"

namespace hepatica {

using namespace test;

namespace {

double distance_to_stretch(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - a - share * (b - a)).norm();
}

struct Scene {
    Mask mask;
    Volume ct;
};

// A wide trunk along x and a branch along +y that leaves it at x = 20; the mask lacks the branch
// between y = from and y = to, the CT shows it there with the given brightness.
Scene broken_branch(double from, double to, double hu_in_gap) {
    Grid grid;
    grid.dims = {60, 60, 30};
    Scene scene{Mask(grid), Volume(grid, 110)};
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p(x, y, z);
        const bool trunk = distance_to_stretch(p, Vec3(4, 15, 15), Vec3(55, 15, 15)) < 4.0;
        const bool branch = distance_to_stretch(p, Vec3(20, 15, 15), Vec3(24, 54, 15)) < 2.2;
        const bool gap = !trunk && branch && p.y() > from && p.y() < to;
        scene.mask.voxels[i] = trunk || (branch && !gap) ? 1 : 0;
        if (trunk || branch)
            scene.ct.voxels[i] = static_cast<std::int16_t>(gap ? hu_in_gap : 175.0);
    }
    return scene;
}

TreeExtraction extraction_of(const Scene& scene, bool with_ct, const TreeOptions& options = {}) {
    Job job;
    const Mask skeleton = unit_width(thin(scene.mask, ThinningMethod::queue, job), job);
    return extract_tree_and_bridges(skeleton, scene.mask, with_ct ? &scene.ct : nullptr, options,
                                    job);
}

}  // namespace

TEST(GapBridging, BrightGapIsBridgedWithConfidence) {
    const TreeExtraction found = extraction_of(broken_branch(26, 34, 160), true);
    ASSERT_EQ(found.bridges.size(), 1u);
    EXPECT_TRUE(found.bridges[0].built);
    EXPECT_GT(found.bridges[0].confidence, 0.6);
    EXPECT_NEAR(found.bridges[0].gap_mm, 8.0, 2.0);
    validate(found.tree);
    EXPECT_EQ(roots(found.tree).size(), 1u);
    EXPECT_EQ(bifurcation_count(found.tree), 1);
    // The path runs where the branch was.
    EXPECT_LT(nearest_point(found.tree, Vec3(21.5, 30, 15)).distance_mm, 1.0);
}

TEST(GapBridging, IsBuiltFromTheConfidenceOnThatIsAskedFor) {
    const Scene scene = broken_branch(26, 34, 160);
    const double confidence = extraction_of(scene, true).bridges.at(0).confidence;
    TreeOptions options;
    options.bridging.confidence = confidence;
    EXPECT_TRUE(extraction_of(scene, true, options).bridges.at(0).built);
    options.bridging.confidence = std::nextafter(confidence, 1.0);
    EXPECT_FALSE(extraction_of(scene, true, options).bridges.at(0).built);
}

// No stub of the branch is left on its trunk: the bridge leads to the side of the trunk, which is
// the first link, and parts it.
TEST(GapBridging, BrightGapAtTheWallOfTheTrunkIsBridgedToItsSide) {
    const TreeExtraction found = extraction_of(broken_branch(15, 26, 160), true);
    ASSERT_EQ(found.bridges.size(), 1u);
    EXPECT_TRUE(found.bridges[0].built);
    validate(found.tree);
    EXPECT_EQ(roots(found.tree).size(), 1u);
    EXPECT_EQ(bifurcation_count(found.tree), 1);
    // Inside the lumen of the branch, whose radius is 2.2 mm.
    EXPECT_LT(nearest_point(found.tree, Vec3(20.7, 22, 15)).distance_mm, 2.2);
}

TEST(GapBridging, DarkGapIsOfferedButNotBuilt) {
    const TreeExtraction found = extraction_of(broken_branch(24, 28, 110), true);
    ASSERT_EQ(found.bridges.size(), 1u);
    EXPECT_FALSE(found.bridges[0].built);
    EXPECT_LT(found.bridges[0].confidence, 0.25);
    EXPECT_EQ(roots(found.tree).size(), 2u);
}

TEST(GapBridging, WideDarkGapIsNotEvenOffered) {
    EXPECT_TRUE(extraction_of(broken_branch(24, 40, 110), true).bridges.empty());
}

TEST(GapBridging, WithoutCtOnlyNarrowGapsAreBridged) {
    EXPECT_TRUE(extraction_of(broken_branch(26, 28, 110), false).bridges.at(0).built);
    const auto wide = extraction_of(broken_branch(24, 40, 110), false).bridges;
    EXPECT_TRUE(wide.empty() || !wide[0].built);
}

// Noise taken for vessels makes thousands of ends, each of which looks at all points of the others.
TEST(GapBridging, AsksBeforeEachEndLooksForOthersInReach) {
    Grid grid;
    grid.dims = {40, 8, 8};
    Mask mask(grid);
    VesselGraph graph;
    for (const int x : {2, 36}) {  // 34 mm apart: none is in reach
        const int from = static_cast<int>(graph.nodes.size());
        graph.nodes.push_back({Vec3(x, 2, 4), 1.0});
        graph.nodes.push_back({Vec3(x, 6, 4), 1.0});
        graph.links.push_back(straight_link(graph, from, from + 1, 1.0, 1.0));
        for (int y = 2; y <= 6; ++y) mask.at(x, y, 4) = 1;
    }
    int asked = 0;
    EXPECT_TRUE(
        bridge_gaps(graph, mask, nullptr, BridgeOptions{}, [&](double) { ++asked; }).empty());
    EXPECT_EQ(asked, 4);
}

// For each bridge that is built the graph's points are searched; the search for paths ends before a
// share of 1.
TEST(GapBridging, AsksBeforeEachBridgeThatIsBuilt) {
    Grid grid;
    grid.dims = {52, 9, 9};
    Mask mask(grid);
    VesselGraph graph;
    for (const int x : {2, 18, 34}) {  // three pieces of a line, 3 voxels apart
        const int from = static_cast<int>(graph.nodes.size());
        graph.nodes.push_back({Vec3(x, 4, 4), 1.0});
        graph.nodes.push_back({Vec3(x + 12, 4, 4), 1.0});
        graph.links.push_back(straight_link(graph, from, from + 1, 1.0, 1.0));
        for (int along = 0; along <= 12; ++along) mask.at(x + along, 4, 4) = 1;
    }
    std::atomic<int> asked = 0;
    const std::vector<Bridge> bridges = bridge_gaps(graph, mask, nullptr, BridgeOptions{},
                                                    [&](double share) { asked += share == 1.0; });
    ASSERT_EQ(std::ranges::count_if(bridges, &Bridge::built), 2);
    EXPECT_EQ(asked, 2);
}

// Two trees whose thin ends meet tip to tip are two systems, not one vessel with a gap.
TEST(GapBridging, ThinEndsOfTwoSystemsAreNotJoined) {
    Grid grid;
    grid.dims = {90, 40, 40};
    Scene scene{Mask(grid), Volume(grid, 110)};
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const double along = x < 45 ? x : 89.0 - x;  // mirror image
        const double radius = 6.0 - 4.6 * along / 43.0;
        const bool vessel = along > 3 && along < 43 && std::hypot(y - 20.0, z - 20.0) < radius;
        scene.mask.voxels[i] = vessel ? 1 : 0;
        if (vessel) scene.ct.voxels[i] = 175;
    }
    const TreeExtraction found = extraction_of(scene, true);
    EXPECT_EQ(roots(found.tree).size(), 2u);
    for (const Bridge& bridge : found.bridges) EXPECT_FALSE(bridge.built);
}

}  // namespace hepatica
