// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/editing/system_seed.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/tree/editing/tree_edit.h"

namespace hepatica {
namespace {

constexpr auto portal = VascularSystem::portal, hepatic = VascularSystem::hepatic;

// Straight, a point per mm.
VesselLink straight(const VesselGraph& graph, int from, int to, VascularSystem system,
                    double radius_mm) {
    VesselLink link{from, to, system, 0.75, {}, {}};
    const Vec3 a = graph.nodes[from].position_mm, b = graph.nodes[to].position_mm;
    const int steps = static_cast<int>((b - a).norm());
    for (int i = 0; i <= steps; ++i) {
        link.points_mm.push_back(a + (b - a) * i / steps);
        link.radii_mm.push_back(radius_mm);
    }
    link.points_mm.back() = b;
    return link;
}

// A hepatic trunk (root at the origin) with a straight branch on. At (0,60,0) a vessel of another
// direction was joined to it by mistake; it goes on straight from (-50,60,0) to (50,60,0), bears
// two twigs, and with `touching` comes out of a portal trunk at its far end.
VesselTree mistaken_tree(bool touching) {
    VesselGraph graph;
    for (const Vec3& place :
         {Vec3(0, 0, 0), Vec3(0, 60, 0), Vec3(0, 120, 0), Vec3(50, 60, 0), Vec3(80, 85, 0),
          Vec3(80, 35, 0), Vec3(-50, 60, 0), Vec3(-110, 60, 0)})
        graph.nodes.push_back({place, 3.0});
    graph.links = {straight(graph, 0, 1, hepatic, 5.0), straight(graph, 1, 2, hepatic, 4.0),
                   straight(graph, 1, 3, hepatic, 3.0), straight(graph, 3, 4, hepatic, 2.0),
                   straight(graph, 3, 5, hepatic, 2.0), straight(graph, 1, 6, hepatic, 3.0)};
    if (touching) graph.links.push_back(straight(graph, 6, 7, portal, 4.0));
    const std::vector<RootWish> wishes{{0, hepatic}, {7, portal}};
    return directed(graph, std::span(wishes).first(touching ? 2 : 1));
}

TreeEdit seed_at(const Vec3& at_mm, VascularSystem system) {
    TreeEdit edit;
    edit.kind = TreeEditKind::seed_system;
    edit.at_mm = at_mm;
    edit.system = system;
    return edit;
}

VascularSystem system_at(const VesselTree& tree, const Vec3& place_mm) {
    return tree.segments[static_cast<std::size_t>(nearest_point(tree, place_mm).segment)].system;
}

}  // namespace

TEST(SystemSeed, TakesAlongWhatHangsOnTheVesselAndLeavesTheTrunk) {
    const VesselTree before = mistaken_tree(false);
    const VesselTree after = edited(before, seed_at({30, 60, 0}, portal));
    validate(after);
    for (const Vec3& place : {Vec3(30, 60, 0), Vec3(45, 60, 0), Vec3(70, 77, 0), Vec3(70, 43, 0)})
        EXPECT_EQ(system_at(after, place), portal) << place.transpose();
    for (const Vec3& place : {Vec3(0, 5, 0), Vec3(0, 50, 0), Vec3(0, 110, 0)})
        EXPECT_EQ(system_at(after, place), hepatic) << place.transpose();
    EXPECT_NEAR(length_mm(after), length_mm(before), 1e-9);
    EXPECT_EQ(after.segments[nearest_point(after, {70, 77, 0}).segment].system_confidence, 1.0);
    EXPECT_EQ(after.segments[nearest_point(after, {0, 5, 0}).segment].system_confidence, 0.75);
}

// One click far out: the way back to the portal trunk, straight through the false fork, comes too.
TEST(SystemSeed, ReachesUpstreamToTheSystemThatTheVesselComesFrom) {
    const VesselTree before = mistaken_tree(true);
    EXPECT_EQ(system_at(before, {-30, 60, 0}), hepatic);
    const VesselTree after = edited(before, seed_at({30, 60, 0}, portal));
    validate(after);
    for (const Vec3& place : {Vec3(-30, 60, 0), Vec3(10, 60, 0), Vec3(70, 77, 0)})
        EXPECT_EQ(system_at(after, place), portal) << place.transpose();
    for (const Vec3& place : {Vec3(0, 5, 0), Vec3(0, 110, 0)})
        EXPECT_EQ(system_at(after, place), hepatic) << place.transpose();
    // One portal tree from its old root, one hepatic from its own.
    ASSERT_EQ(roots(after).size(), 2u);
    EXPECT_EQ(after.segments[roots(after)[0]].points_mm.front(), Vec3(-110, 60, 0));
    EXPECT_EQ(after.segments[roots(after)[1]].points_mm.front(), Vec3(0, 0, 0));
}

TEST(SystemSeed, OnTheTrunkSpeaksForTheWholeTree) {
    const VesselTree after = edited(mistaken_tree(false), seed_at({0, 10, 0}, portal));
    for (const VesselSegment& segment : after.segments) EXPECT_NE(segment.system, hepatic);
}

TEST(SystemSeed, IsUndoneAndKept) {
    TreeEditor editor(mistaken_tree(true));
    editor.apply(seed_at({30, 60, 0}, VascularSystem::artery));
    EXPECT_EQ(system_at(editor.tree(), {70, 77, 0}), VascularSystem::artery);
    const std::vector<TreeEdit> again = edits_from_json(edits_to_json(editor.edits()), "case.json");
    EXPECT_EQ(again, editor.edits());
    editor.undo();
    EXPECT_EQ(system_at(editor.tree(), {70, 77, 0}), hepatic);
}

TEST(SystemSeed, WhatSaysNothingNewOrLiesBesideEveryVesselIsRefused) {
    EXPECT_THROW(edited(mistaken_tree(true), seed_at({30, 60, 0}, hepatic)), InputError);
    EXPECT_THROW(edited(mistaken_tree(true), seed_at({30, 60, 40}, portal)), InputError);
    EXPECT_THROW(edits_from_json(R"([{"edit":"seed_system","at_mm":[1,2,3]}])", "c"), InputError);
}

}  // namespace hepatica
