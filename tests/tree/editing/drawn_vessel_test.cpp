// SPDX-License-Identifier: GPL-3.0-or-later
// Vessels drawn by hand into the tree of test_trees.h.
#include "core/tree/editing/drawn_vessel.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/tree/editing/tree_edit.h"
#include "tests/support/test_trees.h"

namespace hepatica {

using namespace test;

namespace {

// A straight vessel with points a millimetre apart.
Centreline straight(const Vec3& from, const Vec3& to, double radius_mm) {
    Centreline line;
    const int steps = static_cast<int>((to - from).norm()) + 1;
    for (int i = 0; i <= steps; ++i) {
        line.points_mm.push_back(from + (to - from) * i / steps);
        line.radii_mm.push_back(radius_mm);
    }
    return line;
}

const Vec3 in_trunk(1.5, 10, 1.5);  // 1.5 mm beside its axis, radius 3.8
const Vec3 free_place(30, 8, 0);

VesselTree tree_of(VascularSystem trunk) {
    VesselGraph graph = forked_graph();
    for (VesselLink& link : graph.links) link.system = trunk;
    return directed(std::move(graph));
}

std::string problem_of(const VesselTree& tree, const Centreline& line) {
    try {
        edited(tree, drawing_of(line));
    } catch (const InputError& error) {
        return error.problem();
    }
    return {};
}

TEST(DrawnVessel, GrowsOutOfTheVesselItBeginsIn) {
    const VesselTree before = tree_of(VascularSystem::portal);
    Centreline line = straight(in_trunk, free_place, 1.2);
    // Within the trunk its radius would be measured as the trunk's.
    for (std::size_t i = 0; line.points_mm[i].x() < 3.0; ++i) line.radii_mm[i] = 3.5;
    const VesselTree after = edited(before, drawing_of(line));
    validate(after);
    EXPECT_EQ(roots(after).size(), 1u);
    EXPECT_EQ(bifurcation_count(after), bifurcation_count(before) + 1);
    EXPECT_EQ(end_count(after), end_count(before) + 1);
    const TreePoint tip = nearest_point(after, free_place);
    EXPECT_LT(tip.distance_mm, 1e-9);
    const VesselSegment& drawn = after.segments[static_cast<std::size_t>(tip.segment)];
    EXPECT_EQ(drawn.system, VascularSystem::portal);
    EXPECT_EQ(drawn.system_confidence, 1.0);
    EXPECT_EQ(drawn.points_mm.back(), free_place);  // blood flows the way it was drawn
    // From the trunk's centreline on, and never as wide as the trunk.
    EXPECT_LT(nearest_point(before, drawn.points_mm.front()).distance_mm, 1e-6);
    for (const double radius : drawn.radii_mm) EXPECT_NEAR(radius, 1.2, 1e-9);
}

// The lumens of trunk and branch are one bright region where they meet: sections there are measured
// as wide as both. Slanting branches stay beside the trunk for longer.
TEST(DrawnVessel, IsNoFunnelBesideTheTrunkWhicheverWayItIsDrawn) {
    const VesselTree before = tree_of(VascularSystem::portal);
    for (const double slant_mm : {0.0, 8.0, 16.0})
        for (const bool outwards : {true, false}) {
            const Vec3 tip(24, 10 + slant_mm, 1.5);
            Centreline line = straight(in_trunk, tip, 1.2);
            for (std::size_t i = 0; i < line.points_mm.size(); ++i) {
                const double beyond_wall = line.points_mm[i].x() - 3.6;
                line.radii_mm[i] = std::max(1.2, 3.5 - 0.8 * std::max(0.0, beyond_wall));
            }
            if (!outwards) {
                std::ranges::reverse(line.points_mm);
                std::ranges::reverse(line.radii_mm);
            }
            const VesselTree after = edited(before, drawing_of(line));
            const TreePoint end = nearest_point(after, tip);
            const VesselSegment& drawn = after.segments[static_cast<std::size_t>(end.segment)];
            // 2.0 is where the funnel is as wide as it is far from the wall.
            for (const double radius : drawn.radii_mm) EXPECT_LT(radius, 2.1) << slant_mm;
            EXPECT_NEAR(drawn.radii_mm.back(), 1.2, 1e-9);
        }
}

TEST(DrawnVessel, DrawnTowardsTheTreeItHangsOnItAsWell) {
    const VesselTree before = tree_of(VascularSystem::hepatic);
    Centreline line = straight(free_place, in_trunk, 1.2);
    // Within the trunk its radius would be measured as the trunk's.
    for (std::size_t i = line.points_mm.size(); line.points_mm[--i].x() < 3.0;)
        line.radii_mm[i] = 3.5;
    const VesselTree after = edited(before, drawing_of(line));
    validate(after);
    EXPECT_EQ(roots(after).size(), 1u);
    const TreePoint tip = nearest_point(after, free_place);
    const VesselSegment& drawn = after.segments[static_cast<std::size_t>(tip.segment)];
    EXPECT_EQ(drawn.system, VascularSystem::hepatic);
    EXPECT_EQ(drawn.points_mm.back(), free_place);
    for (const double radius : drawn.radii_mm) EXPECT_NEAR(radius, 1.2, 1e-9);
}

// From the trunk's axis to the side: its wall lies 3.85 mm away.
TEST(DrawnVessel, IsRefusedWhereMoreThanHalfOfItIsThereAlready) {
    const Vec3 axis(0.05, 10, 1.5);
    const auto problem = [&](double length_mm) {
        return problem_of(forked_tree(), straight(axis, axis + Vec3(length_mm, 0, 0), 1.0));
    };
    EXPECT_NE(problem(7.0).find("more than half"), std::string::npos) << "5 of 9 points";
    EXPECT_EQ(problem(8.5), "") << "5 of 10 points";
}

TEST(DrawnVessel, ReachesAWallThatItEndsBeside) {
    // 0.8 mm beyond the wall; 1.5 mm beyond it is a vessel of its own.
    for (const auto& [gap_mm, joined] : {std::pair{0.8, true}, std::pair{1.5, false}}) {
        const VesselTree before = forked_tree();
        const Vec3 begin(0.05 + 3.85 + gap_mm, 10, 1.5);
        const VesselTree after = edited(before, drawing_of(straight(begin, free_place, 1.0)));
        validate(after);
        EXPECT_EQ(roots(after).size(), joined ? 1u : 2u) << gap_mm;
    }
}

TEST(DrawnVessel, StandsAloneWhereItTouchesNothing) {
    const TreeEdit edit =
        drawing_of(straight(Vec3(40, 0, 0), Vec3(60, 0, 0), 2.0), VascularSystem::hepatic);
    const VesselTree after = edited(forked_tree(), edit);
    validate(after);
    ASSERT_EQ(roots(after).size(), 2u);
    const int own = nearest_point(after, Vec3(50, 0, 0)).segment;
    const VesselSegment& drawn = after.segments[static_cast<std::size_t>(own)];
    EXPECT_EQ(drawn.parent, -1);
    EXPECT_EQ(drawn.points_mm.front(), Vec3(40, 0, 0));  // where blood comes in
    EXPECT_EQ(drawn.system, VascularSystem::hepatic);
}

// A portal tree, and beside it a vessel of another system.
VesselTree portal_tree_beside(VascularSystem system) {
    VesselGraph graph = forked_graph();
    for (VesselLink& link : graph.links) link.system = VascularSystem::portal;
    const int far = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back({Vec3(40, 0, 0), 2.0});
    graph.nodes.push_back({Vec3(40, 30, 0), 2.0});
    graph.links.push_back(straight_link(graph, far, far + 1, 2.0, 2.0, system));
    return directed(std::move(graph));
}

TEST(DrawnVessel, FromOneKnownSystemIntoAnotherIsRefusedWithBothNames) {
    const Centreline across = straight(in_trunk, Vec3(39, 10, 0), 1.0);
    const std::string problem = problem_of(portal_tree_beside(VascularSystem::hepatic), across);
    EXPECT_NE(problem.find(title_of(VascularSystem::portal)), std::string::npos) << problem;
    EXPECT_NE(problem.find(title_of(VascularSystem::hepatic)), std::string::npos) << problem;
}

TEST(DrawnVessel, JoinsTwoTreesAndTheSecondTakesTheSystemOfTheFirst) {
    const VesselTree before = portal_tree_beside(VascularSystem::unknown);
    const VesselTree after = edited(before, drawing_of(straight(in_trunk, Vec3(39, 10, 0), 1.0)));
    validate(after);
    EXPECT_EQ(roots(after).size(), 1u);
    for (const VesselSegment& segment : after.segments)
        EXPECT_EQ(segment.system, VascularSystem::portal);
}

// Drawn the other way, from the vessel of no system, it must not take that of the tree away.
TEST(DrawnVessel, OutOfAVesselOfUnknownSystemTakesThatOfTheTreeItReaches) {
    const VesselTree before = portal_tree_beside(VascularSystem::unknown);
    const VesselTree after = edited(before, drawing_of(straight(Vec3(39, 10, 0), in_trunk, 1.0)));
    validate(after);
    ASSERT_EQ(roots(after).size(), 1u);
    EXPECT_EQ(after.segments[static_cast<std::size_t>(roots(after).front())].points_mm.front(),
              Vec3(0, 0, 0));  // the root of the portal tree
    for (const VesselSegment& segment : after.segments)
        EXPECT_EQ(segment.system, VascularSystem::portal);
}

// A tree with two equal points in a row is refused when its case is opened again.
TEST(DrawnVessel, ThatTurnsBackBeforeItsEndHasNoPointTwice) {
    const Centreline line{{Vec3(40, 0, 0), Vec3(43, 0, 0), Vec3(43.25, 0, 0), Vec3(43, 0, 0)},
                          {1.0, 1.0, 1.0, 1.0}};
    EXPECT_NO_THROW(validate(edited(forked_tree(), drawing_of(line))));
}

TEST(DrawnVessel, RefusesWhatIsThereAlready) {
    const VesselTree tree = forked_tree();
    const Vec3 along = (tree.nodes[1].position_mm - tree.nodes[0].position_mm).normalized();
    const auto inside = straight(Vec3(0.5, 2, 0.3), Vec3(0.5, 2, 0.3) + 14.0 * along, 1.0);
    EXPECT_NE(problem_of(tree, inside).find("more than half"), std::string::npos);
    // Out of the trunk and back to the same place of it.
    Centreline hairpin = straight(in_trunk, free_place, 1.0);
    for (std::size_t i = hairpin.points_mm.size() - 1; i-- > 0;) {
        hairpin.points_mm.push_back(hairpin.points_mm[i]);
        hairpin.radii_mm.push_back(1.0);
    }
    EXPECT_NE(problem_of(tree, hairpin).find("one point"), std::string::npos);
}

// Away from all vessels its ends get two nodes at one position, and a curve of one point between.
TEST(DrawnVessel, IsRefusedWhereAllItsPointsAreOne) {
    const Vec3 away(40, 0, 0);
    for (const std::size_t points : {2u, 3u}) {
        const Centreline dot{std::vector<Vec3>(points, away), std::vector<double>(points, 1.0)};
        EXPECT_EQ(problem_of(forked_tree(), dot), "both ends of the vessel lie at one point");
    }
}

// A short one would be a link of two points at one place, with which no case can be read again.
TEST(DrawnVessel, IsRefusedWhereItEndsWhereItBegan) {
    for (const double reach_mm : {0.3, 3.0}) {
        const Centreline loop{{Vec3(40, 0, 0), Vec3(40 + reach_mm, 0, 0), Vec3(40, 0, 0)},
                              {1.0, 1.0, 1.0}};
        EXPECT_EQ(problem_of(forked_tree(), loop), "both ends of the vessel lie at one point");
    }
}

TEST(DrawnVessel, IsTheSameAfterItsFile) {
    const TreeEdit drawn = drawing_of(straight(in_trunk, free_place, 1.2), VascularSystem::hepatic);
    const std::vector<TreeEdit> read = edits_from_json(edits_to_json({drawn}), "here");
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0], drawn);
    const TreeEdit alone = drawing_of(straight(in_trunk, free_place, 1.2));
    EXPECT_EQ(edits_from_json(edits_to_json({alone}), "here")[0], alone);
}

TEST(DrawnVessel, AFileWithoutPathOrRadiiIsRefused) {
    const auto read = [](const std::string& more) {
        return edits_from_json(R"([{"edit": "draw_vessel", )" + more + "}]", "drawn.json");
    };
    const std::string path = R"("path_mm": [[0, 0, 0], [5, 0, 0]])";
    EXPECT_EQ(read(path + R"(, "radii_mm": [1, 1])").size(), 1u);
    for (const std::string& more :
         {path, path + R"(, "radii_mm": [1])", path + R"(, "radii_mm": [1, 0])",
          path + R"(, "radii_mm": [1, -1])", path + R"(, "radii_mm": [1, 51])",
          path + R"(, "radii_mm": [1, null])", path + R"(, "radii_mm": [1, 1], "system": "gut")",
          std::string(R"("path_mm": [[0, 0, 0]], "radii_mm": [1])"),
          std::string(R"("path_mm": [], "radii_mm": [])"),
          std::string(R"("path_mm": [[0, 0, 0], [1e9, 0, 0]], "radii_mm": [1, 1])")})
        EXPECT_THROW(read(more), InputError) << more;
}

}  // namespace
}  // namespace hepatica
