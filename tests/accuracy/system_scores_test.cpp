// SPDX-License-Identifier: GPL-3.0-or-later
// Two systems made of straight tubes, and what is known of trees that say otherwise.
#include "core/accuracy/system_scores.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "tests/support/test_masks.h"
#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

using test::straight_link;

constexpr auto portal = VascularSystem::portal, hepatic = VascularSystem::hepatic;

// Nodes 0-2: a portal trunk of 60 mm along y with a node in its middle, from which a branch (3)
// leaves; 4-6: hepatic veins 24 mm beside it, the wide end at the far side.
VesselGraph two_systems() {
    VesselGraph graph;
    for (const auto& [p, r] : {std::pair{Vec3(0, 0, 0), 3.0},
                               {Vec3(0, 30, 0), 3.0},
                               {Vec3(0, 60, 0), 2.0},
                               {Vec3(-20, 50, 0), 2.0},
                               {Vec3(24, 0, 0), 2.0},
                               {Vec3(24, 30, 0), 3.0},
                               {Vec3(24, 60, 0), 4.0}})
        graph.nodes.push_back({p, r});
    graph.links = {
        straight_link(graph, 0, 1, 3, 3, portal), straight_link(graph, 1, 2, 2.5, 2, portal),
        straight_link(graph, 1, 3, 2, 2, portal), straight_link(graph, 4, 5, 2, 3, hepatic),
        straight_link(graph, 5, 6, 3, 4, hepatic)};
    return graph;
}

// Voxels of 1 mm.
Mask lumen(const VesselTree& tree, VascularSystem system) {
    Grid grid;
    grid.dims = {70, 90, 30};
    grid.origin_mm = Vec3(-30, -15, -15);
    return test::mask_where(grid, [&](const Vec3& p) {
        for (const VesselSegment& s : tree.segments) {
            if (s.system != system) continue;
            const Vec3 begin = s.points_mm.front(), axis = s.points_mm.back() - begin;
            const double u = std::clamp((p - begin).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
            const double radius = (1 - u) * s.radii_mm.front() + u * s.radii_mm.back();
            if ((begin + u * axis - p).norm() < radius) return true;
        }
        return false;
    });
}

Mask labels(const VesselTree& tree) {
    Mask mask = lumen(tree, portal);
    const Mask veins = lumen(tree, hepatic);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        if (veins.voxels[i] != 0) mask.voxels[i] = 2;
    return mask;
}

std::vector<SystemTruth> truths(bool with_trees = false) {
    const VesselTree tree = directed(two_systems());
    std::vector<SystemTruth> list;
    for (const VascularSystem system : {portal, hepatic}) {
        list.push_back({system, lumen(tree, system), {}});
        if (!with_trees) continue;
        VesselGraph graph = two_systems();
        std::erase_if(graph.links, [&](const VesselLink& l) { return l.system != system; });
        list.back().tree = directed(graph);
    }
    return list;
}

SystemScores judged(const VesselTree& tree, const std::vector<SystemTruth>& truth = truths(),
                    const Mask* liver = nullptr) {
    Job job;
    return judge_systems(tree, labels(tree), truth, liver, nullptr, {}, job);
}

VesselGraph swapped(VesselGraph graph) {
    for (VesselLink& link : graph.links) link.system = link.system == portal ? hepatic : portal;
    return graph;
}

TEST(SystemScores, ATruthAgainstItselfIsPerfect) {
    for (const bool with_trees : {false, true}) {
        const SystemScores s = judged(directed(two_systems()), truths(with_trees));
        ASSERT_EQ(s.systems.size(), 2u);
        for (const SystemScore& score : {s.systems[0], s.systems[1], s.vessels}) {
            // The skeleton of a mask reaches on into the round ends of the tubes.
            EXPECT_GE(score.length_recall, with_trees ? 1.0 : 0.95);
            EXPECT_DOUBLE_EQ(score.length_precision, 1.0);
            EXPECT_EQ(score.dice, 1.0);
            EXPECT_EQ(score.surface_dice, 1.0);
        }
        EXPECT_NEAR(s.systems[0].tree_length_mm, 60.0 + 20.0 * std::sqrt(2.0), 1e-9);
        EXPECT_NEAR(s.systems[1].tree_length_mm, 60.0, 1e-9);
        EXPECT_NEAR(s.vessels.tree_length_mm, s.attributed_mm, 1e-9);
        EXPECT_DOUBLE_EQ(s.system_right, 1.0);
        EXPECT_EQ(s.false_joins, 0);
        EXPECT_EQ(s.breaks, 0);
        EXPECT_EQ(s.loops, 0);
    }
    const SystemScores exact = judged(directed(two_systems()), truths(true));
    EXPECT_EQ(exact.systems[0].root_error_mm, 0.0);
    EXPECT_EQ(exact.systems[1].root_error_mm, 0.0);
    const SystemScores by_mask = judged(directed(two_systems()));
    EXPECT_LT(by_mask.systems[0].root_error_mm, 4.0);
    EXPECT_LT(by_mask.systems[1].root_error_mm, 5.0);
}

// The portal vein's true trunk goes on beyond the liver, where a wider end is not its end.
TEST(SystemScores, ATrunkEndsWhereItLeavesWhatIsJudged) {
    VesselGraph graph;
    for (const double x : {0.0, 60.0}) graph.nodes.push_back({Vec3(x, 0, 0), 3.0});
    graph.links = {straight_link(graph, 0, 1, 5, 3, portal)};
    const VesselTree known = directed(graph);
    const std::vector<SystemTruth> truth{{portal, lumen(known, portal), {}}};
    Mask liver(truth[0].mask.grid);
    for (std::size_t i = 0; i < liver.voxels.size(); ++i) {
        const auto [x, y, z] = liver.grid.index_of(i);
        liver.voxels[i] = liver.grid.to_mm(x, y, z).x() < 20.5;
    }
    const SystemScores s = judged(known, truth, &liver);
    ASSERT_TRUE(s.systems[0].trunk_at_mm);
    EXPECT_LT((*s.systems[0].trunk_at_mm - Vec3(20, 0, 0)).norm(), 1.5);
    EXPECT_NEAR(*s.systems[0].root_error_mm, 20.0, 1.5);
}

// A portal vein that divides at (0, 0, 0) into branches to the right and to the left, with a trunk
// from (0, 40, 0); what is judged begins 12 mm to the right and 20 mm to the left.
struct DividedOutside {
    VesselGraph graph;
    std::vector<SystemTruth> truth;
    Mask liver;

    DividedOutside() {
        for (const Vec3& p : {Vec3(0, 40, 0), Vec3(0, 0, 0), Vec3(30, 0, 0), Vec3(-28, 0, 0)})
            graph.nodes.push_back({p, 3.0});
        graph.links = {straight_link(graph, 0, 1, 3, 3, portal),
                       straight_link(graph, 1, 2, 4, 3, portal),
                       straight_link(graph, 1, 3, 3, 2, portal)};
        const VesselTree known = directed(graph);
        truth = {{portal, lumen(known, portal), {}}};
        liver = test::mask_where(truth[0].mask.grid,
                                 [](const Vec3& p) { return p.x() > 12 || p.x() < -20; });
    }

    // Of a tree that begins there, at y along the trunk or at x along the right branch.
    double root_error_mm(const Vec3& root) const {
        VesselGraph ours;
        ours.nodes = {{root, 3.0}, {Vec3(30, 0, 0), 3.0}};
        ours.links = {straight_link(ours, 0, 1, 3, 3, portal)};
        const RootWish wish{0, portal};
        Job job;
        return judge_systems(directed(ours, {&wish, 1}), Mask(), truth, &liver, nullptr, {}, job)
            .systems[0]
            .root_error_mm.value();
    }
};

// No tree whose trunk is whole can begin at the border of what is judged, which a branch crosses.
TEST(SystemScores, ATrunkThatDividesOutsideOfWhatIsJudgedEndsThere) {
    const DividedOutside vein;
    EXPECT_NEAR(vein.root_error_mm(Vec3(0, 0, 0)), 0.0, 1.5);
    EXPECT_NEAR(vein.root_error_mm(Vec3(0, 30, 0)), 30.0, 1.5);
    EXPECT_NEAR(vein.root_error_mm(Vec3(12, 0, 0)), 12.0, 1.5) << "where the right branch enters";
}

TEST(SystemScores, SwappedLabelsAreNowhereRight) {
    const SystemScores s = judged(directed(swapped(two_systems())));
    EXPECT_DOUBLE_EQ(s.system_right, 0.0);
    EXPECT_DOUBLE_EQ(s.systems[0].length_recall, 0.0);
    EXPECT_DOUBLE_EQ(s.systems[0].length_precision, 0.0);
    EXPECT_EQ(s.systems[0].dice, 0.0);
    EXPECT_GT(s.vessels.length_recall, 0.95);  // the vessels are there
    EXPECT_EQ(s.vessels.dice, 1.0);
    EXPECT_EQ(s.false_joins, 0);
}

// Of 148.28 mm, 28.28 carry no system.
TEST(SystemScores, UnknownIsWrong) {
    VesselGraph graph = two_systems();
    graph.links[2].system = VascularSystem::unknown;
    const SystemScores s = judged(directed(graph));
    const double branch_mm = 20.0 * std::sqrt(2.0);
    EXPECT_NEAR(s.system_right, 120.0 / (120.0 + branch_mm), 1e-9);
    EXPECT_LT(s.systems[0].length_recall, 0.8);
    EXPECT_DOUBLE_EQ(s.systems[0].length_precision, 1.0);
}

TEST(SystemScores, WhatLiesNearNoTruthIsNotJudgedByItsLabel) {
    VesselGraph graph = two_systems();
    graph.nodes.push_back({Vec3(-25, 0, 0), 1.5});
    graph.nodes.push_back({Vec3(-25, 40, 0), 1.5});
    graph.links.push_back(straight_link(graph, 7, 8, 1.5, 1.5, hepatic));
    const SystemScores s = judged(directed(graph));
    EXPECT_DOUBLE_EQ(s.system_right, 1.0);
    EXPECT_NEAR(s.systems[1].length_precision, 0.6, 1e-9);  // 60 of 100 mm
    EXPECT_EQ(s.false_joins, 0);
}

void bridge(VesselGraph& graph, double y_mm) {
    const int first = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back({Vec3(0, y_mm, 0), 1.0});
    graph.nodes.push_back({Vec3(24, y_mm, 0), 1.0});
    graph.links.push_back(straight_link(graph, first, first + 1, 1, 1, portal));
}

// Joins the links whose ends lie in one place.
VesselGraph welded(VesselGraph graph) {
    for (VesselLink& link : graph.links)
        for (int* node : {&link.from, &link.to})
            for (int other = 0; other < *node; ++other)
                if ((graph.nodes[other].position_mm - graph.nodes[*node].position_mm).norm() < 0.1)
                    *node = other;
    return graph;
}

TEST(SystemScores, ABridgeBetweenSystemsIsOneFalseJoin) {
    VesselGraph graph = two_systems();
    for (VesselLink& link : graph.links) link.system = portal;
    bridge(graph, 30.0);
    EXPECT_EQ(judged(directed(welded(graph))).false_joins, 1);
    // Of the same shape, but open where it would reach the hepatic veins.
    VesselGraph open = two_systems();
    bridge(open, 30.0);
    for (VesselLink& link : open.links) link.system = portal;
    open.links.back().from = 1;
    EXPECT_EQ(judged(directed(open)).false_joins, 0);
}

TEST(SystemScores, BridgesFarApartAreCountedEach) {
    VesselGraph graph = two_systems();
    for (VesselLink& link : graph.links) link.system = portal;
    bridge(graph, 0.0);
    bridge(graph, 30.0);
    bridge(graph, 60.0);
    const SystemScores s = judged(directed(welded(graph)));
    EXPECT_EQ(s.false_joins, 3);
    EXPECT_EQ(s.loops, 2);
}

// Two tubes that cross with 3 mm between their axes: where the tree makes one node of the
// crossing, both arms of either system meet in one place.
TEST(SystemScores, ACrossingThatIsOneNodeIsOneFalseJoin) {
    VesselGraph apart;
    for (const Vec3& p : {Vec3(0, -12, 0), Vec3(0, 70, 0), Vec3(-27, 30, 3), Vec3(36, 30, 3)})
        apart.nodes.push_back({p, 2.0});
    apart.links = {straight_link(apart, 0, 1, 2, 2, portal),
                   straight_link(apart, 2, 3, 2, 2, hepatic)};
    const VesselTree tree = directed(apart);
    const std::vector<SystemTruth> truth{{portal, lumen(tree, portal), {}},
                                         {hepatic, lumen(tree, hepatic), {}}};
    EXPECT_EQ(judged(tree, truth).false_joins, 0);
    EXPECT_DOUBLE_EQ(judged(tree, truth).system_right, 1.0);

    VesselGraph one = apart;
    one.nodes.push_back({Vec3(0, 30, 1.5), 2.0});
    one.links = {straight_link(one, 0, 4, 2, 2, portal), straight_link(one, 4, 1, 2, 2, portal),
                 straight_link(one, 2, 4, 2, 2, portal), straight_link(one, 4, 3, 2, 2, portal)};
    EXPECT_EQ(judged(directed(one), truth).false_joins, 1);
}

// 5.4 mm beside the axis of a portal vein of 6 mm radius, 1.6 mm from that of a thin hepatic one.
TEST(SystemScores, ALumenCountsMoreThanANearerAxis) {
    VesselGraph graph;
    for (const double x : {0.0, 7.0, 5.4})
        for (const double y : {0.0, 60.0}) graph.nodes.push_back({Vec3(x, y, 0), 1.0});
    graph.links = {straight_link(graph, 0, 1, 6, 6, portal),
                   straight_link(graph, 2, 3, 1, 1, hepatic)};
    const VesselTree known = directed(graph);
    const std::vector<SystemTruth> truth{{portal, lumen(known, portal), {}},
                                         {hepatic, lumen(known, hepatic), {}}};
    graph.links = {straight_link(graph, 4, 5, 1, 1, portal)};
    EXPECT_DOUBLE_EQ(judged(directed(graph), truth).system_right, 1.0);
}

// The same with a portal vein of 4 mm radius, in whose lumen both arms lie for 4 mm.
TEST(SystemScores, BothSidesOfAWideCrossingAreOnePlace) {
    VesselGraph apart;
    for (const Vec3& p : {Vec3(0, -10, 0), Vec3(0, 70, 0), Vec3(-27, 30, 5), Vec3(36, 30, 5)})
        apart.nodes.push_back({p, 2.0});
    apart.links = {straight_link(apart, 0, 1, 4, 4, portal),
                   straight_link(apart, 2, 3, 2, 2, hepatic)};
    const VesselTree tree = directed(apart);
    const std::vector<SystemTruth> truth{{portal, lumen(tree, portal), {}},
                                         {hepatic, lumen(tree, hepatic), {}}};
    VesselGraph one = apart;
    one.nodes.push_back({Vec3(0, 30, 0), 4.0});
    one.links = {straight_link(one, 0, 4, 4, 4, portal), straight_link(one, 4, 1, 4, 4, portal),
                 straight_link(one, 2, 4, 2, 4, portal), straight_link(one, 4, 3, 4, 2, portal)};
    EXPECT_EQ(judged(directed(one), truth).false_joins, 1);
}

// A stub shorter than 5 mm along the other system is what an opened touch leaves.
TEST(SystemScores, AStubOfAnOpenedTouchIsNoJoin) {
    for (const double stub_mm : {1.5, 12.0}) {
        VesselGraph graph = two_systems();
        graph.nodes.push_back({Vec3(24, 30, 0), 2.0});
        graph.nodes.push_back({Vec3(24, 30 + stub_mm, 0), 2.0});
        graph.links.push_back(straight_link(graph, 1, 7, 1, 1, portal));
        graph.links.push_back(straight_link(graph, 7, 8, 2, 2, portal));
        EXPECT_EQ(judged(directed(graph)).false_joins, stub_mm > 5.0 ? 1 : 0) << stub_mm;
    }
}

// A trunk cut 3 mm wide.
VesselGraph cut(VesselGraph graph) {
    graph.nodes.push_back({Vec3(24, 13, 0), 2.4});
    graph.nodes.push_back({Vec3(24, 16, 0), 2.5});
    graph.links.erase(graph.links.begin() + 3);
    graph.links.push_back(straight_link(graph, 4, 7, 2, 2.4, hepatic));
    graph.links.push_back(straight_link(graph, 8, 5, 2.5, 3, hepatic));
    return graph;
}

TEST(SystemScores, ACutIsOneBreak) {
    EXPECT_EQ(judged(directed(cut(two_systems()))).breaks, 1);
    const SystemScores s = judged(directed(cut(two_systems())), truths(true));
    EXPECT_EQ(s.breaks, 1);
    EXPECT_DOUBLE_EQ(s.system_right, 1.0);
    EXPECT_DOUBLE_EQ(s.systems[1].length_recall, 1.0);  // the gap lies within the tolerance
    EXPECT_EQ(s.systems[1].root_error_mm, 0.0);         // of the longer piece
}

// What the truth itself does not connect, or what carries another system, breaks nothing.
TEST(SystemScores, ACutThatTheTruthHasTooIsNoBreak) {
    VesselTree tree = directed(cut(two_systems()));
    std::vector<SystemTruth> truth = truths(true);
    VesselGraph veins = cut(two_systems());
    std::erase_if(veins.links, [](const VesselLink& l) { return l.system == portal; });
    truth[1].tree = directed(veins);
    EXPECT_EQ(judged(tree, truth).breaks, 0);
    EXPECT_EQ(judged(directed(swapped(cut(two_systems())))).breaks, 0);
}

TEST(SystemScores, RootsAreJudgedByWhereTheTrunkEnds) {
    VesselGraph graph = two_systems();
    const RootWish wrong[] = {{3, portal}, {4, hepatic}};
    const SystemScores s = judged(directed(graph, wrong), truths(true));
    EXPECT_NEAR(s.systems[0].root_error_mm.value(), std::hypot(20.0, 50.0), 1e-9);
    EXPECT_NEAR(s.systems[1].root_error_mm.value(), 60.0, 1e-9);
    const SystemScores none = judged(VesselTree{});
    EXPECT_FALSE(none.systems[0].root_error_mm.has_value());
    EXPECT_DOUBLE_EQ(none.system_right, 0.0);
    EXPECT_DOUBLE_EQ(none.systems[0].length_recall, 0.0);
}

// The hepatic veins enter a cava of 10 mm radius along z at y = 70: what lies within 4 + 9 mm of
// its axis is left out, and roots are measured to its nearest point there.
TEST(SystemScores, TheCavasNeighbourhoodIsLeftOut) {
    std::vector<SystemTruth> truth = truths();
    for (std::size_t i = 0; i < truth[1].mask.voxels.size(); ++i) {
        const auto [x, y, z] = truth[1].mask.grid.index_of(i);
        const Vec3 p = truth[1].mask.grid.to_mm(x, y, z);
        if (std::hypot(p.x() - 24, p.y() - 70) < 10) truth[1].mask.voxels[i] = 1;
    }
    const SystemScores s = judged(directed(two_systems()), truth);
    EXPECT_NEAR(s.systems[1].tree_length_mm, 57.0, 1.5);
    EXPECT_NEAR(s.systems[1].truth_length_mm, 57.0, 4.0);
    EXPECT_LT(s.systems[1].root_error_mm.value(), 1.5);
    EXPECT_NEAR(s.systems[0].tree_length_mm, 60.0 + 20.0 * std::sqrt(2.0), 1e-9);

    const RootWish far_away[] = {{4, hepatic}};
    EXPECT_NEAR(judged(directed(two_systems(), far_away), truth).systems[1].root_error_mm.value(),
                57.0, 1.5);
}

// Only what lies in the liver is judged, and channels in its mask are closed.
TEST(SystemScores, OnlyTheClosedLiverIsJudged) {
    const VesselTree tree = directed(two_systems());
    const Mask vessels = labels(tree);
    Mask liver(vessels.grid);
    for (std::size_t i = 0; i < liver.voxels.size(); ++i) {
        const auto [x, y, z] = liver.grid.index_of(i);
        liver.voxels[i] = y < 15 + 40 && vessels.voxels[i] == 0;  // 40 mm along both trunks
    }
    const SystemScores s = judged(tree, truths(true), &liver);
    // The last voxels end at 39.5 mm, and the closed channels a little deeper.
    EXPECT_NEAR(s.systems[1].tree_length_mm, 39.0, 1.0);
    EXPECT_NEAR(s.systems[0].tree_length_mm, 39.0 + 9.0 * std::sqrt(2.0), 2.0);
    EXPECT_DOUBLE_EQ(s.systems[0].length_recall, 1.0);
}

TEST(SystemScores, ClassesOfRadiiSumToTheWhole) {
    VesselGraph graph = two_systems();
    graph.links.pop_back();  // the widest vein
    const SystemScores s = judged(directed(graph), truths(true));
    for (const SystemScore& score : s.systems) {
        double truth_mm = 0.0, found_mm = 0.0, tree_mm = 0.0;
        for (const RadiusClass& size : score.by_radius) {
            truth_mm += size.truth_length_mm;
            tree_mm += size.tree_length_mm;
            found_mm += size.truth_length_mm * size.length_recall.value_or(0.0);
            EXPECT_EQ(size.length_recall.has_value(), size.truth_length_mm > 0.0);
        }
        EXPECT_NEAR(truth_mm, score.truth_length_mm, 1e-9);
        EXPECT_NEAR(tree_mm, score.tree_length_mm, 1e-9);
        EXPECT_NEAR(found_mm, score.truth_length_mm * score.length_recall, 1e-9);
    }
    // From 2 to 3 mm over 30 mm, the other 30 mm are missing but for the tolerance.
    EXPECT_NEAR(s.systems[1].by_radius[2].truth_length_mm, 15.0, 1.0);
    EXPECT_EQ(s.systems[1].by_radius[2].length_recall, 1.0);
    EXPECT_NEAR(s.systems[1].by_radius[3].length_recall.value(), 17.0 / 45.0, 0.03);
}

// The case's voxels are half as large and end at y = 40 mm, in the middle of both lumens.
TEST(SystemScores, AMaskOnAGridOfItsOwnIsComparedInSpace) {
    const VesselTree tree = directed(two_systems());
    const Mask whole = labels(tree);
    Mask fine;
    fine.grid = whole.grid;
    for (int& n : fine.grid.dims) n *= 2;
    fine.grid.dims[1] = 2 * (15 + 40);
    fine.grid.spacing_mm /= 2.0;
    fine.grid.origin_mm -= Vec3::Constant(0.25);
    fine.voxels.resize(fine.grid.count());
    double ours = 0.0, theirs = 0.0;
    for (std::size_t i = 0; i < fine.voxels.size(); ++i) {
        const auto [x, y, z] = fine.grid.index_of(i);
        fine.voxels[i] = whole.at(x / 2, y / 2, z / 2);
    }
    for (std::size_t i = 0; i < whole.voxels.size(); ++i) {
        if (whole.voxels[i] != static_cast<int>(hepatic)) continue;
        theirs += 1.0;
        ours += whole.grid.index_of(i)[1] < 15 + 40;
    }
    Job job;
    const SystemScores s = judge_systems(tree, fine, truths(), nullptr, nullptr, {}, job);
    EXPECT_NEAR(s.systems[1].dice.value(), 2.0 * ours / (ours + theirs), 1e-9);
}

// A seed in the trunk lies on its axis, as far from its end as was asked for.
TEST(KnownSystems, NameAPointInEachTrunk) {
    Job job;
    const KnownSystems known(truths(true), nullptr, nullptr, {}, job);
    ASSERT_EQ(known.all().size(), 2u);
    EXPECT_LT((*known.point_in_trunk(known.all()[0], 8.0) - Vec3(0, 8, 0)).norm(), 0.6);
    EXPECT_LT((*known.point_in_trunk(known.all()[1], 8.0) - Vec3(24, 52, 0)).norm(), 0.6);
}

// A cuboid of 2 x 2 voxels on the wall of a tube is no branch.
TEST(CentrelinesOfAMask, HaveNoSpurs) {
    VesselGraph graph;
    graph.nodes = {{Vec3(0, 0, 0), 4.0}, {Vec3(0, 60, 0), 4.0}};
    graph.links = {straight_link(graph, 0, 1, 4, 4, portal)};
    Mask tube = lumen(directed(graph), portal);
    for (int y = 40; y < 42; ++y)
        for (int x = 33; x < 36; ++x)
            for (int z = 14; z < 16; ++z) tube.at(x, y, z) = 1;
    Job job;
    EXPECT_EQ(centrelines_of(tube, job).segments.size(), 1u);
}

// One voxel has no line: its truth has a lumen and no centreline.
TEST(SystemScores, ATruthWithoutALineHasNoBreaks) {
    const VesselTree tree = directed(two_systems());
    std::vector<SystemTruth> truth = truths();
    Mask& vein = truth[1].mask;
    const Eigen::Vector3i on_axis = vein.grid.to_index(Vec3(24, 30, 0)).array().round().cast<int>();
    std::ranges::fill(vein.voxels, std::uint8_t{0});
    vein.at(on_axis.x(), on_axis.y(), on_axis.z()) = 1;
    Job job;
    ASSERT_TRUE(centrelines_of(truth[1].mask, job).segments.empty());
    const SystemScores s = judged(tree, truth);
    EXPECT_EQ(s.breaks, 0);
    EXPECT_EQ(s.systems[1].truth_length_mm, 0.0);
    EXPECT_DOUBLE_EQ(s.systems[0].length_precision, 1.0);
}

TEST(SystemScores, WhatCannotBeJudgedIsRefused) {
    Job job;
    const VesselTree tree = directed(two_systems());
    std::vector<SystemTruth> truth = truths();
    EXPECT_THROW(judge_systems(tree, {}, {}, nullptr, nullptr, {}, job), InputError);
    const Mask small(test::cube_grid(8), 1);
    EXPECT_THROW(judge_systems(tree, {}, truth, &small, nullptr, {}, job), InputError);
    EXPECT_FALSE(judge_systems(tree, {}, truth, nullptr, nullptr, {}, job).systems[0].dice);
    const Mask no_liver(truth[0].mask.grid);
    try {
        judge_systems(tree, {}, truth, &no_liver, nullptr, {}, job);
        ADD_FAILURE() << "everything was judged nowhere";
    } catch (const InputError& refusal) {
        EXPECT_EQ(refusal.problem(), "the liver's mask is empty");
    }
    truth[1].mask = small;
    EXPECT_THROW(judge_systems(tree, {}, truth, nullptr, nullptr, {}, job), InputError);
    truth[1].mask = Mask(truth[0].mask.grid);
    EXPECT_THROW(judge_systems(tree, {}, truth, nullptr, nullptr, {}, job), InputError);
}

}  // namespace
}  // namespace hepatica
