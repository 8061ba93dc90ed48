// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/editing/tree_edit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/tree/extraction/centreline.h"
#include "tests/support/test_trees.h"

namespace hepatica {

using namespace test;

namespace {

// Places on the tree of test_trees.h.
const Vec3 on_trunk(0.05, 10, 1.5);
const Vec3 on_left_branch(-6, 25.5, 4);
const Vec3 on_right_branch(4.5, 26.5, 2);
const Vec3 on_last_branch(15.5, 39, 1.5);

TreeEdit edit_at(TreeEditKind kind, const Vec3& at,
                 VascularSystem system = VascularSystem::unknown) {
    TreeEdit edit;
    edit.kind = kind;
    edit.at_mm = at;
    edit.system = system;
    return edit;
}

// Between the walls of parts that nothing joins, over all pairs of points.
double narrowest_gap_mm(const VesselTree& tree) {
    const VesselGraph graph = to_graph(tree);
    const std::vector<int> component = component_of_nodes(graph);
    double least = std::numeric_limits<double>::infinity();
    for (const VesselLink& a : graph.links)
        for (const VesselLink& b : graph.links) {
            if (component[a.from] == component[b.from]) continue;
            const Centreline x = resampled({a.points_mm, a.radii_mm}, 0.2);
            const Centreline y = resampled({b.points_mm, b.radii_mm}, 0.2);
            for (std::size_t i = 0; i < x.points_mm.size(); ++i)
                for (std::size_t k = 0; k < y.points_mm.size(); ++k)
                    least = std::min(least, (x.points_mm[i] - y.points_mm[k]).norm() -
                                                x.radii_mm[i] - y.radii_mm[k]);
        }
    return least;
}

}  // namespace

TEST(TreeEdit, CutMakesTwoTreesWithAGapBetween) {
    const VesselTree before = forked_tree();
    const VesselTree after = edited(before, edit_at(TreeEditKind::cut_link, on_right_branch));
    validate(after);
    EXPECT_EQ(roots(after).size(), 2u);
    EXPECT_EQ(bifurcation_count(after), 2);
    EXPECT_GE(narrowest_gap_mm(after), 1.0 - 1e-9);
    EXPECT_LE(narrowest_gap_mm(after), 1.0 + 0.3);
    EXPECT_GT(nearest_point(after, on_right_branch).distance_mm, 3.0);
}

TEST(TreeEdit, CutAnywhereLeavesAGap) {
    const VesselTree before = forked_tree();
    for (std::size_t s = 0; s < before.segments.size(); ++s) {
        const bool is_end = node_degrees(before)[before.segments[s].distal_node] == 1;
        for (const Vec3& place : before.segments[s].points_mm) {
            const VesselTree after = edited(before, edit_at(TreeEditKind::cut_link, place));
            validate(after);
            EXPECT_LT(length_mm(after), length_mm(before));
            EXPECT_GE(roots(after).size(), s == 0 || is_end ? 1u : 2u) << place.transpose();
            // Beside a narrowing vessel the gap is measured to the foot on its axis.
            EXPECT_GE(narrowest_gap_mm(after), 0.97) << place.transpose();
        }
    }
}

TEST(TreeEdit, CutInABendLeavesAGap) {
    VesselGraph graph;
    VesselLink link{0, 1, VascularSystem::unknown, 0.0, {}, {}};
    for (int i = 0; i <= 40; ++i) {
        const double angle = M_PI * i / 40.0;
        link.points_mm.emplace_back(8.0 * std::cos(angle), 8.0 * std::sin(angle), 0.0);
        link.radii_mm.push_back(2.5);
    }
    graph.nodes = {{link.points_mm.front(), 2.5}, {link.points_mm.back(), 2.5}};
    graph.links = {link};
    const VesselTree after =
        edited(directed(graph), edit_at(TreeEditKind::cut_link, Vec3(0, 8, 0)));
    EXPECT_EQ(roots(after).size(), 2u);
    EXPECT_GE(narrowest_gap_mm(after), 1.0 - 1e-9);
    EXPECT_LE(narrowest_gap_mm(after), 1.0 + 0.3);
}

TEST(TreeEdit, CutKeepsTheRootsAndBeginsTheRestAtTheGap) {
    const VesselTree after = edited(forked_tree(), edit_at(TreeEditKind::cut_link, on_last_branch));
    const std::vector<int> begins = roots(after);
    ASSERT_EQ(begins.size(), 2u);
    EXPECT_EQ(after.segments[begins[0]].points_mm.front(), Vec3(0, 0, 0));
    EXPECT_EQ(after.segments[begins[1]].points_mm.back(), Vec3(22, 45, 2));
}

TEST(TreeEdit, CutAtTheTipTakesTheTipAway) {
    const VesselTree after =
        edited(forked_tree(), edit_at(TreeEditKind::cut_link, Vec3(22, 45, 2)));
    validate(after);
    EXPECT_EQ(roots(after).size(), 1u);
    EXPECT_EQ(after.segments.size(), forked_tree().segments.size());
    EXPECT_NEAR(length_mm(forked_tree()) - length_mm(after), 0.5 + 2.2, 0.2);
}

TEST(TreeEdit, CutBetweenForksTooCloseForAGapIsRefused) {
    VesselGraph graph = forked_graph();
    graph.nodes[3].position_mm = Vec3(5, 23, 2);  // 5.8 mm from the other fork, radii 3.7 and 3.3
    graph.links = {straight_link(graph, 0, 1, 4.0, 3.7), straight_link(graph, 1, 2, 2.5, 2.1),
                   straight_link(graph, 1, 3, 3.3, 3.0), straight_link(graph, 3, 4, 1.9, 1.6),
                   straight_link(graph, 3, 5, 2.4, 2.2)};
    EXPECT_THROW(edited(directed(graph), edit_at(TreeEditKind::cut_link, Vec3(2.5, 21.5, 2.5))),
                 InputError);
}

TEST(TreeEdit, LinkJoinsWhatACutParted) {
    const VesselTree cut = edited(forked_tree(), edit_at(TreeEditKind::cut_link, on_right_branch));
    TreeEdit link = edit_at(TreeEditKind::add_link, on_right_branch - Vec3(0.4, 0.6, -0.1));
    link.to_mm = on_right_branch + Vec3(0.4, 0.6, -0.1);
    const VesselTree joined = edited(cut, link);
    validate(joined);
    EXPECT_EQ(roots(joined).size(), 1u);
    EXPECT_EQ(joined.segments.size(), forked_tree().segments.size());
    EXPECT_NEAR(length_mm(joined), length_mm(forked_tree()), 0.05);
}

// Two systems that touch have nodes of their own at one position. A link between these has no
// length, and no case with it can be read again.
TEST(TreeEdit, LinkWithinThePointWhereTwoSystemsTouchIsRefused) {
    VesselGraph graph = forked_graph();
    graph.links[0].system = VascularSystem::portal;
    for (std::size_t i = 1; i < graph.links.size(); ++i)
        graph.links[i].system = VascularSystem::hepatic;
    const VesselTree touching = directed(graph);
    ASSERT_EQ(roots(touching).size(), 2u);
    const Vec3 touch = graph.nodes[1].position_mm;
    const auto from_touch = [&](int node) {
        return Vec3(touch + 0.5 * (graph.nodes[node].position_mm - touch).normalized());
    };
    TreeEdit link = edit_at(TreeEditKind::add_link, from_touch(0));
    link.to_mm = from_touch(2);
    EXPECT_THROW(edited(touching, link), InputError);
    std::swap(link.at_mm, link.to_mm);
    EXPECT_THROW(edited(touching, link), InputError);
    link.at_mm = graph.nodes[2].position_mm;  // elsewhere it joins them
    EXPECT_EQ(roots(edited(touching, link)).size(), 1u);
}

// A ring has no end to begin at: its root is a node where two segments begin, one of which closes
// the loop.
TEST(TreeEdit, DeletingATreeTakesAllOfARing) {
    VesselGraph graph = forked_graph();
    const std::size_t forked = graph.links.size();
    const int first = static_cast<int>(graph.nodes.size());
    for (const Vec3& corner : {Vec3(50, 0, 0), Vec3(70, 0, 0), Vec3(60, 15, 0)})
        graph.nodes.push_back({corner, 2.0});
    // The root is an end of the widest side; the narrowest, at that end too, closes the loop.
    for (const auto& [side, radius_mm] : {std::pair{0, 2.0}, {1, 3.0}, {2, 2.5}})
        graph.links.push_back(
            straight_link(graph, first + side, first + (side + 1) % 3, radius_mm, radius_mm));
    const VesselTree with_ring = directed(graph);
    ASSERT_TRUE(std::ranges::any_of(with_ring.segments, [](const VesselSegment& segment) {
        return segment.closes_loop && segment.parent < 0;
    }));
    ASSERT_EQ(with_ring.segments.size(), forked + 3);
    for (const Vec3& on_ring : {Vec3(60, 0, 0), Vec3(65, 7.5, 0), Vec3(55, 7.5, 0)}) {
        const VesselTree after = edited(with_ring, edit_at(TreeEditKind::delete_tree, on_ring));
        EXPECT_EQ(after.segments.size(), forked) << on_ring.transpose();
        EXPECT_GT(nearest_point(after, on_ring).distance_mm, 20.0);
    }
}

TEST(TreeEdit, LinkInsideOneTreeClosesALoop) {
    TreeEdit link = edit_at(TreeEditKind::add_link, on_left_branch);
    link.to_mm = on_last_branch;
    link.path_mm = {Vec3(0, 34, 3), Vec3(8, 38, 2)};
    const VesselTree after = edited(forked_tree(), link);
    validate(after);
    EXPECT_EQ(roots(after).size(), 1u);
    EXPECT_EQ(std::ranges::count_if(after.segments, [](const auto& s) { return s.closes_loop; }),
              1);
}

// Splitting a vessel for the link may move the list of links: it is full at a power of two.
TEST(TreeEdit, ALinkTakesTheSystemOfTheVesselItLeaves) {
    for (const int count : {1, 2, 4, 8}) {
        VesselGraph graph;
        for (int i = 0; i < count; ++i) {
            graph.nodes.push_back({Vec3(0, 20.0 * i, 0), 2.0});
            graph.nodes.push_back({Vec3(40, 20.0 * i, 0), 2.0});
            graph.links.push_back(
                straight_link(graph, 2 * i, 2 * i + 1, 2.0, 2.0, VascularSystem::portal));
        }
        TreeEdit link = edit_at(TreeEditKind::add_link, Vec3(10, 0, 0));
        link.to_mm = count == 1 ? Vec3(30, 0, 0) : Vec3(30, 20, 0);
        link.path_mm = {Vec3(20, 10, 0)};
        const VesselTree linked = edited(directed(graph), link);
        EXPECT_GT(linked.segments.size(), graph.links.size());
        for (const VesselSegment& segment : linked.segments)
            EXPECT_EQ(segment.system, VascularSystem::portal) << count;
    }
}

// A bridge may begin at the open end of a piece whose system nobody knows.
TEST(TreeEdit, ALinkFromAVesselOfUnknownSystemLeavesTheOtherItsSystem) {
    VesselGraph graph = forked_graph();
    for (VesselLink& link : graph.links) link.system = VascularSystem::portal;
    const int first = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back({Vec3(40, 0, 0), 2.0});
    graph.nodes.push_back({Vec3(40, 30, 0), 2.0});
    graph.links.push_back(straight_link(graph, first, first + 1, 2.0, 2.0));
    TreeEdit link = edit_at(TreeEditKind::add_link, Vec3(40, 15, 0));
    link.to_mm = on_trunk;
    const VesselTree linked = edited(directed(graph), link);
    validate(linked);
    ASSERT_EQ(roots(linked).size(), 1u);
    EXPECT_EQ(linked.segments[static_cast<std::size_t>(roots(linked).front())].points_mm.front(),
              graph.nodes[0].position_mm);
    for (const VesselSegment& segment : linked.segments)
        EXPECT_EQ(segment.system, VascularSystem::portal);
}

TEST(TreeEdit, DeletingATreeTakesAllOfItAndNothingElse) {
    const VesselTree cut = edited(forked_tree(), edit_at(TreeEditKind::cut_link, on_right_branch));
    ASSERT_EQ(roots(cut).size(), 2u);
    const VesselTree without = edited(cut, edit_at(TreeEditKind::delete_tree, on_last_branch));
    validate(without);
    EXPECT_EQ(roots(without).size(), 1u);
    EXPECT_GT(nearest_point(without, on_last_branch).distance_mm, 5.0);
    const VesselTree rest = edited(cut, edit_at(TreeEditKind::delete_tree, on_left_branch));
    EXPECT_EQ(roots(rest).size(), 1u);
    EXPECT_GT(nearest_point(rest, on_trunk).distance_mm, 5.0);
    EXPECT_NEAR(length_mm(without) + length_mm(rest), length_mm(cut), 1e-9);
    // From wherever it is clicked: the last branch hangs on a branch of the trunk.
    const TreeEdit all = edit_at(TreeEditKind::delete_tree, on_last_branch);
    EXPECT_TRUE(edited(forked_tree(), all).segments.empty());
}

TEST(TreeEdit, DeletingABranchTakesAllThatHangsOnIt) {
    const VesselTree after =
        edited(forked_tree(), edit_at(TreeEditKind::delete_branch, on_right_branch));
    validate(after);
    EXPECT_EQ(after.segments.size(), 1u);  // trunk and left branch have become one
    EXPECT_EQ(bifurcation_count(after), 0);
    EXPECT_TRUE(edited(after, edit_at(TreeEditKind::delete_branch, on_trunk)).segments.empty());
}

TEST(TreeEdit, RootMovesToTheNearestEnd) {
    const Vec3 end(22, 45, 2);
    const VesselTree after = edited(forked_tree(), edit_at(TreeEditKind::set_root, end));
    validate(after);
    ASSERT_EQ(roots(after).size(), 1u);
    EXPECT_EQ(after.segments[roots(after)[0]].points_mm.front(), end);
    EXPECT_DOUBLE_EQ(length_mm(after), length_mm(forked_tree()));
    // Later edits keep it.
    const VesselTree later = edited(after, edit_at(TreeEditKind::delete_branch, on_left_branch));
    EXPECT_EQ(later.segments[roots(later)[0]].points_mm.front(), end);
}

TEST(TreeEdit, ReassigningIsOneStepThereAndOneStepBack) {
    const VesselTree other =
        edited(forked_tree(),
               edit_at(TreeEditKind::reassign_system, on_right_branch, VascularSystem::portal));
    validate(other);
    ASSERT_EQ(roots(other).size(), 2u);
    EXPECT_EQ(std::ranges::count_if(
                  other.segments, [](const auto& s) { return s.system == VascularSystem::portal; }),
              3);
    for (const VesselSegment& s : other.segments)
        EXPECT_EQ(s.system_confidence, s.system == VascularSystem::portal ? 1.0 : 0.0);
    const VesselTree back = edited(
        other, edit_at(TreeEditKind::reassign_system, on_right_branch, VascularSystem::unknown));
    expect_equal(back, forked_tree());
}

// Both branches of the trunk are given to another system: they begin at the fork, in the middle of
// what would be one vessel without the trunk.
TEST(TreeEdit, ARootInTheMiddleOfAVesselStaysThere) {
    const VascularSystem system = VascularSystem::portal;
    VesselTree given = forked_tree();
    const Vec3 fork = given.nodes[given.segments[0].distal_node].position_mm;
    for (const Vec3& branch : {on_left_branch, on_right_branch})
        given = edited(given, edit_at(TreeEditKind::reassign_system, branch, system));
    const auto begins = [system](const VesselTree& tree) {
        std::vector<Vec3> places;
        for (const int id : roots(tree))
            if (tree.segments[id].system == system)
                places.push_back(tree.segments[id].points_mm.front());
        return places;
    };
    const std::vector<Vec3> both(2, fork);
    ASSERT_EQ(begins(given), both);
    const VesselTree shorter = edited(given, edit_at(TreeEditKind::delete_branch, on_last_branch));
    validate(shorter);
    EXPECT_EQ(begins(shorter), both);
    const VesselTree alone = edited(shorter, edit_at(TreeEditKind::delete_tree, on_trunk));
    validate(alone);
    EXPECT_EQ(begins(alone), both);
    EXPECT_EQ(alone.segments.size(), 2u);
    // Another root takes its place, and what is between its ends is one vessel.
    const Vec3 end(-12, 31, 5);
    const VesselTree moved = edited(alone, edit_at(TreeEditKind::set_root, end));
    validate(moved);
    EXPECT_EQ(begins(moved), std::vector{end});
    EXPECT_EQ(moved.segments.size(), 1u);
}

TEST(TreeEdit, PlacesFarFromAnyVesselAreRefused) {
    EXPECT_THROW(edited(forked_tree(), edit_at(TreeEditKind::cut_link, Vec3(200, 0, 0))),
                 InputError);
    EXPECT_THROW(edited(VesselTree{}, edit_at(TreeEditKind::set_root, on_trunk)), InputError);
    TreeEdit nothing = edit_at(TreeEditKind::add_link, on_trunk);
    nothing.to_mm = on_trunk;
    EXPECT_THROW(edited(forked_tree(), nothing), InputError);
}

TEST(TreeEditor, UndoAndRedo) {
    TreeEditor editor(forked_tree());
    EXPECT_FALSE(editor.can_undo());
    editor.apply(edit_at(TreeEditKind::cut_link, on_right_branch));
    editor.apply(edit_at(TreeEditKind::delete_branch, on_left_branch));
    const VesselTree last = editor.tree();
    editor.undo();
    editor.undo();
    expect_equal(editor.tree(), forked_tree());
    EXPECT_TRUE(editor.edits().empty());
    editor.redo();
    editor.redo();
    expect_equal(editor.tree(), last);
    editor.undo();
    editor.apply(edit_at(TreeEditKind::set_root, Vec3(-12, 31, 5)));
    EXPECT_FALSE(editor.can_redo());
    ASSERT_EQ(editor.edits().size(), 2u);
    EXPECT_EQ(editor.edits()[1].kind, TreeEditKind::set_root);
}

TEST(TreeEditor, FailedEditChangesNothing) {
    TreeEditor editor(forked_tree());
    EXPECT_THROW(editor.apply(edit_at(TreeEditKind::cut_link, Vec3(500, 0, 0))), InputError);
    expect_equal(editor.tree(), forked_tree());
    EXPECT_FALSE(editor.can_undo());
}

TEST(TreeEditJson, ComesBackAndGivesTheSameTree) {
    TreeEditor editor(forked_tree());
    editor.apply(edit_at(TreeEditKind::cut_link, on_right_branch));
    TreeEdit link = edit_at(TreeEditKind::add_link, on_left_branch);
    link.to_mm = on_last_branch;
    link.path_mm = {Vec3(0.1, 34, 3), Vec3(8, 38.3, 2)};
    editor.apply(link);
    editor.apply(edit_at(TreeEditKind::set_root, Vec3(22, 45, 2)));
    editor.apply(edit_at(TreeEditKind::reassign_system, Vec3(7, 41, -1), VascularSystem::hepatic));
    TreeEditor again(forked_tree());
    for (const TreeEdit& edit : edits_from_json(edits_to_json(editor.edits()), "case.json"))
        again.apply(edit);
    expect_equal(again.tree(), editor.tree());
}

TEST(TreeEditJson, ASystemIsANameOrANumber) {
    for (const char* system : {"2", "\"2\"", "\"hepatic\""}) {
        const std::string text =
            std::string(R"([{"edit":"reassign_system","at_mm":[1,2,3],"system":)") + system + "}]";
        EXPECT_EQ(edits_from_json(text, "").at(0).system, VascularSystem::hepatic) << text;
    }
    const TreeEdit edit = edit_at(TreeEditKind::reassign_system, on_trunk, VascularSystem::artery);
    EXPECT_NE(edits_to_json({edit}).find("\"artery\""), std::string::npos);
}

TEST(TreeEditJson, ASystemThatIsUnknownComesBack) {
    for (const TreeEditKind kind : {TreeEditKind::reassign_system, TreeEditKind::seed_system}) {
        const std::vector<TreeEdit> edits{edit_at(kind, on_trunk, VascularSystem::unknown)};
        EXPECT_EQ(edits_from_json(edits_to_json(edits), "case.json"), edits);
    }
}

TEST(TreeEditJson, StrokesAtTumoursComeBackAndLeaveTheTree) {
    TreeEdit stroke = edit_at(TreeEditKind::paint_tumour, on_trunk);
    stroke.path_mm = {on_trunk, on_left_branch};
    stroke.radii_mm = {4.5};
    stroke.tumour = 246;
    TreeEdit dab = edit_at(TreeEditKind::erase_tumour, on_trunk);
    dab.path_mm = {on_trunk};
    dab.radii_mm = {0.1};
    const std::vector<TreeEdit> edits{stroke, dab};
    EXPECT_EQ(edits_from_json(edits_to_json(edits), "case.json"), edits);
    for (const TreeEdit& edit : edits) expect_equal(edited(forked_tree(), edit), forked_tree());
    EXPECT_EQ(edited(VesselTree{}, dab).segments.size(), 0u) << "nor is one needed";
}

// With thinner vessels the tree of a case could be written, but not read again.
TEST(TreeEditJson, ADrawnVesselIsNoThinnerThanFilesOfTreesHold) {
    const auto text_of = [](const std::string& radius) {
        return R"([{"edit":"draw_vessel","at_mm":[40,0,0],"path_mm":[[40,0,0],[50,0,0]],)"
               R"("radii_mm":[1,)" +
               radius + "]}]";
    };
    EXPECT_THROW(edits_from_json(text_of("0.0005"), ""), InputError);
    EXPECT_EQ(edits_from_json(text_of("0.001"), "").at(0).radii_mm[1], 0.001);
    EXPECT_EQ(edits_from_json(text_of("50"), "").at(0).radii_mm[1], 50.0);
}

TEST(TreeEditJson, WhatIsWrongIsNamedByTheNumberOfItsEdit) {
    const std::string good = R"({"edit":"cut_link","at_mm":[1,2,3]})";
    for (const char* bad :
         {R"({"edit":"cut"})", R"({"edit":"cut_link"})", "7",
          R"({"edit":"cut_link","at_mm":[1,2,"x"]})", R"({"edit":"cut_link","at_mm":[1,2,1e9]})"}) {
        try {
            edits_from_json("[" + good + "," + bad + "," + good + "]", "more.json");
            ADD_FAILURE() << bad;
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), "more.json, edit 2") << bad;
        }
    }
}

// The last of the two was taken in silence.
TEST(TreeEditJson, AKeyThatIsGivenTwiceIsRefused) {
    try {
        edits_from_json(R"([{"edit":"cut_link","at_mm":[1,2,3],"at_mm":[4,5,6]}])", "more.json");
        ADD_FAILURE() << "one of the two was taken";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "more.json");
        EXPECT_EQ(error.problem(), "at_mm is given twice");
        EXPECT_EQ(error.remedy(), "Leave one of the two out");
    }
}

TEST(TreeEditJson, TheNumberOfAnotherStepCanAlwaysBeRead) {
    TreeEdit edit;
    EXPECT_EQ(next_step({}), 1);
    for (const auto& [last, next] : {std::pair(0, 1), {7, 8}, {most_steps, 1}}) {
        edit.step = last;
        EXPECT_EQ(next_step(std::vector{edit}), next);
        EXPECT_EQ(edits_from_json(edits_to_json({edit}), "case.json"), std::vector{edit});
    }
}

TEST(TreeEditJson, BadTextIsRefused) {
    for (const char* text :
         {"[{\"edit\":\"paint_tumour\",\"at_mm\":[0,0,0],\"radius_mm\":2}]",
          "[{\"edit\":\"paint_tumour\",\"at_mm\":[0,0,0],\"radius_mm\":2,\"tumour\":0}]",
          "[{\"edit\":\"paint_tumour\",\"at_mm\":[0,0,0],\"radius_mm\":2,\"tumour\":247}]",
          "[{\"edit\":\"paint_tumour\",\"at_mm\":[0,0,0],\"radius_mm\":0,\"tumour\":1}]",
          "[{\"edit\":\"erase_tumour\",\"at_mm\":[0,0,0],\"radius_mm\":50.1}]",
          "[{\"edit\":\"erase_tumour\",\"at_mm\":[0,0,0]}]",
          "[{\"edit\":\"erase_tumour\",\"path_mm\":[],\"radius_mm\":2}]",
          "[{\"edit\":\"erase_tumour\",\"path_mm\":[[0,0,1e21]],\"radius_mm\":2}]", "", "{}", "[1]",
          "[{\"edit\":\"fly\",\"at_mm\":[0,0,0]}]", "[{\"edit\":\"cut_link\"}]",
          "[{\"edit\":\"cut_link\",\"at_mm\":[0,0,0],\"step\":0}]",
          "[{\"edit\":\"cut_link\",\"at_mm\":[0,0,0],\"step\":1000001}]",
          "[{\"edit\":\"cut_link\",\"at_mm\":[0,0]}]",
          "[{\"edit\":\"cut_link\",\"at_mm\":[0,0,1e21]}]",
          "[{\"edit\":\"reassign_system\",\"at_mm\":[0,0,0],\"system\":7}]",
          "[{\"edit\":\"reassign_system\",\"at_mm\":[0,0,0],\"system\":\"bile\"}]"})
        EXPECT_THROW(edits_from_json(text, "case.json"), InputError) << text;
}

}  // namespace hepatica
