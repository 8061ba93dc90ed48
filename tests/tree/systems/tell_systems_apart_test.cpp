// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/systems/tell_systems_apart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/image/brush.h"
#include "core/phantom/phantom.h"
#include "core/tree/extraction/centreline.h"
#include "core/tree/systems/labelled_graph.h"
#include "core/tree/systems/loop_opening.h"
#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

using test::straight_link;

Phantom patient(int seed, int systems) {
    PhantomOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    options.systems = systems;
    options.generations = 6;
    options.dims = {72, 60, 56};  // only its tree is asked for
    options.spacing_mm = Vec3(3.0, 3.0, 3.0);
    Job job;
    return make_phantom(options, job);
}

Eigen::AlignedBox3d box_of_liver(const Phantom& phantom) {
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < phantom.liver.voxels.size(); ++i) {
        if (phantom.liver.voxels[i] == 0) continue;
        const auto [x, y, z] = phantom.liver.grid.index_of(i);
        box.extend(phantom.liver.grid.to_mm(x, y, z));
    }
    return box;
}

struct Place {
    int link;
    double along_mm;
};

// Makes the systems touch `count` times, at the places where they come nearest to each other: the
// two vessels share a node there, as the skeleton of their common outline has it.
void touch(VesselGraph& graph, int count) {
    constexpr double apart_mm = 15.0;
    std::vector<Vec3> touched;
    for (int k = 0; k < count; ++k) {
        double least = 1e9;
        Place portal{-1, 0.0}, hepatic{-1, 0.0};
        for (std::size_t i = 0; i < graph.links.size(); ++i)
            for (std::size_t j = 0; j < graph.links.size(); ++j) {
                const VesselLink &a = graph.links[i], &b = graph.links[j];
                if (a.system != VascularSystem::portal || b.system != VascularSystem::hepatic)
                    continue;
                const auto along_a = arclengths_mm(a.points_mm),
                           along_b = arclengths_mm(b.points_mm);
                for (std::size_t p = 2; p + 2 < a.points_mm.size(); ++p) {
                    const bool taken = std::ranges::any_of(touched, [&](const Vec3& t) {
                        return (t - a.points_mm[p]).norm() < apart_mm;
                    });
                    if (taken) continue;
                    for (std::size_t q = 2; q + 2 < b.points_mm.size(); ++q) {
                        const double d = (a.points_mm[p] - b.points_mm[q]).norm();
                        if (d >= least) continue;
                        least = d;
                        portal = {static_cast<int>(i), along_a[p]};
                        hepatic = {static_cast<int>(j), along_b[q]};
                    }
                }
            }
        const int a = split_link(graph, portal.link, portal.along_mm, 0.0);
        const int b = split_link(graph, hepatic.link, hepatic.along_mm, 0.0);
        const Vec3 middle = 0.5 * (graph.nodes[a].position_mm + graph.nodes[b].position_mm);
        graph.nodes[a].position_mm = middle;
        touched.push_back(middle);
        for (VesselLink& link : graph.links) {
            if (link.from == b) link.from = a;
            if (link.to == b) link.to = a;
            if (link.from == a) link.points_mm.front() = middle;
            if (link.to == a) link.points_mm.back() = middle;
        }
    }
}

// Nearest truth along the centrelines.
VascularSystem truth_at(const VesselTree& truth, const Vec3& point) {
    return truth.segments[nearest_point(truth, point).segment].system;
}

double share_right(const VesselGraph& graph, const VesselTree& truth) {
    double right = 0.0, all = 0.0;
    for (const VesselLink& link : graph.links)
        for (std::size_t i = 1; i < link.points_mm.size(); ++i) {
            const double d = (link.points_mm[i] - link.points_mm[i - 1]).norm();
            all += d;
            if (truth_at(truth, 0.5 * (link.points_mm[i] + link.points_mm[i - 1])) == link.system)
                right += d;
        }
    return right / all;
}

VesselGraph unnamed(VesselGraph graph) {
    for (VesselLink& link : graph.links) {
        link.system = VascularSystem::unknown;
        link.system_confidence = 0.0;
    }
    return graph;
}

// A vein that divides again and again by the same angle under Murray's law.
void grow(VesselGraph& graph, int from, const Vec3& direction, const Vec3& sideways, double radius,
          double length, int generations, VascularSystem system) {
    const int to = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back({graph.nodes[from].position_mm + length * direction, radius});
    graph.links.push_back(straight_link(graph, from, to, radius, 0.95 * radius, system));
    if (generations == 0) return;
    const Vec3 next = direction.cross(sideways).normalized();
    for (const double turn : {0.6, -0.6})
        grow(graph, to, (std::cos(turn) * direction + std::sin(turn) * sideways).normalized(), next,
             radius * std::pow(0.5, 1.0 / 3.0), 0.8 * length, generations - 1, system);
}

// In a box of an adult's liver: hilum and confluence where most people have them.
struct SchematicLiver {
    Eigen::AlignedBox3d box{Vec3(0, 0, 0), Vec3(200, 150, 150)};
    Vec3 hilum{105, 60, 70};
    Vec3 confluence{105, 92, 125};
    VesselGraph graph;

    SchematicLiver() {
        graph.nodes.push_back({hilum, 6.0});
        grow(graph, 0, Vec3(-1, 0.1, 0.1).normalized(), Vec3(0, 0, 1), 6.0, 25.0, 4,
             VascularSystem::portal);
        const int root = static_cast<int>(graph.nodes.size());
        graph.nodes.push_back({confluence, 6.0});
        grow(graph, root, Vec3(-1, -0.2, -0.4).normalized(), Vec3(0, 1, 0), 6.0, 25.0, 4,
             VascularSystem::hepatic);
    }
};

TEST(TellSystemsApart, FindsTwoSchematicVeinsThatTouch) {
    for (const int touches : {0, 1, 3, 5}) {
        SchematicLiver liver;
        const VesselTree truth = directed(liver.graph);
        touch(liver.graph, touches);
        VesselGraph graph = unnamed(liver.graph);
        const SystemsFound found = tell_systems_apart(graph, nullptr, {{}, liver.box});
        EXPECT_GE(share_right(graph, truth), 0.95) << touches;
        const VesselTree tree = directed(graph, anatomical_roots(graph, found.anchors));
        const auto begins_at = [&](const Vec3& place, VascularSystem system) {
            return std::ranges::any_of(roots(tree), [&](int id) {
                return tree.segments[id].system == system &&
                       (tree.segments[id].points_mm.front() - place).norm() < 1.0;
            });
        };
        EXPECT_TRUE(begins_at(liver.hilum, VascularSystem::portal)) << touches;
        EXPECT_TRUE(begins_at(liver.confluence, VascularSystem::hepatic)) << touches;
    }
}

// A stub that leaves a trunk begins in the trunk's lumen, and is not as wide for it: the trunk's
// own end, farther from where the veins are looked for, is the root.
TEST(AnatomicalRoots, AreNoStubsBesideAWideEnd) {
    VesselGraph graph;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(16, 0, 0), Vec3(80, 0, 0), Vec3(16, 9, 0)})
        graph.nodes.push_back({p, 1.0});
    for (const VascularSystem system : {VascularSystem::portal, VascularSystem::hepatic}) {
        graph.links = {test::straight_link(graph, 0, 1, 6, 6, system),
                       test::straight_link(graph, 1, 2, 5, 1, system),
                       test::straight_link(graph, 1, 3, 5.5, 1.0, system)};
        const AnatomicalAnchors anchors{Vec3(16, 12, 0), Vec3(16, 12, 0)};
        const std::vector<RootWish> wishes = anatomical_roots(graph, anchors);
        ASSERT_EQ(wishes.size(), 1u);
        EXPECT_EQ(wishes[0].node, 0);
    }
}

// Grown trees bend and fork any way, which real ones do not; brightness would help, and there is
// none here. Drawing lots gives a half.
TEST(TellSystemsApart, FindsMostOfGrownVeinsThatTouch) {
    double sum = 0.0;
    constexpr int patients = 8;
    for (int seed = 1; seed <= patients; ++seed) {
        const Phantom phantom = patient(seed, 2);
        VesselGraph graph = to_graph(phantom.tree);
        touch(graph, 3);
        graph = unnamed(graph);
        const SystemsFound found = tell_systems_apart(graph, nullptr, {{}, box_of_liver(phantom)});
        const double right = share_right(graph, phantom.tree);
        EXPECT_GE(right, 0.6) << seed;
        EXPECT_GE(found.gain, 10.0) << seed;
        sum += right / patients;
    }
    EXPECT_GE(sum, 0.8);
}

TEST(TellSystemsApart, OneTreeStaysOneAndUnknown) {
    for (const int seed : {6, 7, 8}) {
        const Phantom phantom = patient(seed, 1);
        VesselGraph graph = unnamed(to_graph(phantom.tree));
        tell_systems_apart(graph, nullptr, {{}, box_of_liver(phantom)});
        for (const VesselLink& link : graph.links)
            EXPECT_EQ(link.system, VascularSystem::unknown) << seed;
    }
}

TEST(TellSystemsApart, OneSeedNamesTheOnlySystem) {
    const Phantom phantom = patient(6, 1);
    VesselGraph graph = unnamed(to_graph(phantom.tree));
    const VesselSeed seed{graph.links.front().points_mm[2], VascularSystem::artery};
    tell_systems_apart(graph, nullptr, {{seed}, box_of_liver(phantom)});
    for (const VesselLink& link : graph.links) {
        EXPECT_EQ(link.system, VascularSystem::artery);
        EXPECT_EQ(link.system_confidence, 1.0);
    }
}

// Seeds say the opposite of anatomy, one at each root.
TEST(TellSystemsApart, SeedsOverrideAnatomy) {
    const Phantom phantom = patient(3, 2);
    VesselGraph graph = to_graph(phantom.tree);
    touch(graph, 1);
    graph = unnamed(graph);
    SystemSearch search{{}, box_of_liver(phantom)};
    for (const int root : roots(phantom.tree)) {
        const VesselSegment& trunk = phantom.tree.segments[root];
        search.seeds.push_back({trunk.points_mm[trunk.points_mm.size() / 2],
                                trunk.system == VascularSystem::portal ? VascularSystem::hepatic
                                                                       : VascularSystem::portal});
    }
    tell_systems_apart(graph, nullptr, search);
    for (const VesselSeed& seed : search.seeds) {
        const VesselTree tree = directed(graph);
        EXPECT_EQ(tree.segments[nearest_point(tree, seed.position_mm).segment].system, seed.system);
    }
}

// An end branch of the portal vein was called hepatic before; of the others nothing is known.
TEST(TellSystemsApart, AVesselStaysWhatItWasBefore) {
    const Phantom phantom = patient(3, 2);
    const auto leaf = std::ranges::find_if(phantom.tree.segments, [&](const VesselSegment& s) {
        const auto i = &s - phantom.tree.segments.data();
        return s.system == VascularSystem::portal && length_mm(s) > 12.0 &&
               std::ranges::none_of(phantom.tree.segments,
                                    [&](const VesselSegment& other) { return other.parent == i; });
    });
    ASSERT_NE(leaf, phantom.tree.segments.end());
    Mask before(phantom.liver.grid);
    apply(BrushStroke{leaf->points_mm, 5.0, false}, 2, before);
    const auto system_of_leaf = [&](const Mask* known) {
        VesselGraph graph = unnamed(to_graph(phantom.tree));
        tell_systems_apart(graph, nullptr, {{}, box_of_liver(phantom), known});
        const VesselTree tree = directed(graph);
        const TreePoint end = nearest_point(tree, leaf->points_mm.back());
        return tree.segments[static_cast<std::size_t>(end.segment)].system;
    };
    EXPECT_EQ(system_of_leaf(nullptr), VascularSystem::portal);
    EXPECT_EQ(system_of_leaf(&before), VascularSystem::hepatic);
}

TEST(TellSystemsApart, SameBytesEveryTime) {
    const Phantom phantom = patient(4, 2);
    VesselGraph first = to_graph(phantom.tree);
    touch(first, 5);
    first = unnamed(first);
    VesselGraph second = first;
    tell_systems_apart(first, nullptr, {{}, box_of_liver(phantom)});
    tell_systems_apart(second, nullptr, {{}, box_of_liver(phantom)});
    ASSERT_EQ(first.links.size(), second.links.size());
    for (std::size_t i = 0; i < first.links.size(); ++i) {
        EXPECT_EQ(first.links[i].system, second.links[i].system);
        EXPECT_EQ(first.links[i].system_confidence, second.links[i].system_confidence);
        EXPECT_EQ(first.links[i].points_mm, second.links[i].points_mm);
    }
}

TEST(TellSystemsApart, NothingHasNoSystems) {
    VesselGraph graph;
    tell_systems_apart(graph, nullptr, {});
    EXPECT_TRUE(graph.links.empty());
}

// Two straight vessels cross; their skeleton shares a short link, which each of them needs.
TEST(LabelledGraph, CrossingVesselsStayWhole) {
    VesselGraph graph;
    for (const Vec3& p : {Vec3(-20, 0, 0), Vec3(-0.5, 0, 0), Vec3(0.5, 0, 0), Vec3(20, 0, 0),
                          Vec3(0, -20, 0), Vec3(0, 20, 0)})
        graph.nodes.push_back({p, 1.5});
    graph.links = {straight_link(graph, 0, 1, 1.5, 1.5), straight_link(graph, 1, 2, 1.5, 1.5),
                   straight_link(graph, 2, 3, 1.5, 1.5), straight_link(graph, 1, 4, 1.5, 1.5),
                   straight_link(graph, 2, 5, 1.5, 1.5)};
    const PieceGraph pieces = pieces_of(graph, nullptr);
    ASSERT_EQ(pieces.forks.size(), 1u);
    EXPECT_EQ(pieces.forks.front().size(), 4u);
    EXPECT_EQ(pieces.within_fork, (std::vector<std::uint8_t>{0, 1, 0, 0, 0}));
    std::vector<PieceSystem> systems;
    for (const VesselPiece& piece : pieces.pieces)
        systems.push_back(
            {std::abs(piece.centre_mm.y()) > 1.0 ? VascularSystem::hepatic : VascularSystem::portal,
             0.9});
    const VesselGraph parted = labelled_graph(graph, pieces, systems);
    ASSERT_EQ(parted.links.size(), 2u);
    EXPECT_NEAR(length_mm(parted.links[0]), 40.0, 1e-6);
    EXPECT_NEAR(length_mm(parted.links[1]), 40.0, 1.5);
    EXPECT_NE(parted.links[0].system, parted.links[1].system);
}

// The short link within the fork leads a portal vein on; a hepatic vein that only passes one of its
// ends gets no stub of it.
TEST(LabelledGraph, NoSystemGetsALinkThatLeadsItNowhere) {
    VesselGraph graph;
    for (const Vec3& p : {Vec3(-20, 0, 0), Vec3(-0.5, 0, 0), Vec3(0.5, 0, 0), Vec3(20, 0, 0),
                          Vec3(-0.5, -20, 0), Vec3(-0.5, 20, 0), Vec3(0.5, 0, 20)})
        graph.nodes.push_back({p, 1.5});
    graph.links = {straight_link(graph, 0, 1, 1.5, 1.5), straight_link(graph, 1, 2, 1.5, 1.5),
                   straight_link(graph, 2, 3, 1.5, 1.5), straight_link(graph, 2, 6, 1.5, 1.5),
                   straight_link(graph, 1, 4, 1.5, 1.5), straight_link(graph, 1, 5, 1.5, 1.5)};
    const PieceGraph pieces = pieces_of(graph, nullptr);
    ASSERT_EQ(pieces.within_fork, (std::vector<std::uint8_t>{0, 1, 0, 0, 0, 0}));
    std::vector<PieceSystem> systems;
    for (const VesselPiece& piece : pieces.pieces)
        systems.push_back(
            {std::abs(piece.centre_mm.y()) > 1.0 ? VascularSystem::hepatic : VascularSystem::portal,
             0.9});
    double portal_mm = 0.0, hepatic_mm = 0.0;
    for (const VesselLink& link : labelled_graph(graph, pieces, systems).links)
        (link.system == VascularSystem::portal ? portal_mm : hepatic_mm) += length_mm(link);
    EXPECT_NEAR(portal_mm, 60.0, 0.01);
    EXPECT_NEAR(hepatic_mm, 40.0, 0.01);
}

TEST(LoopOpening, ASideBranchThatTouchesEndsClearOfTheLumen) {
    VesselGraph graph;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(20, 0, 0), Vec3(60, 0, 0), Vec3(100, 0, 0)})
        graph.nodes.push_back({p, 3.0});
    graph.links = {straight_link(graph, 0, 1, 3, 3), straight_link(graph, 1, 2, 3, 3),
                   straight_link(graph, 2, 3, 3, 3)};
    VesselLink arch{1, 2, VascularSystem::portal, 1.0, {}, {}};
    for (int k = 0; k <= 40; ++k) {
        const double x = k / 40.0;
        arch.points_mm.push_back(Vec3(20 + 40 * x, 30 * std::sin(3.14159265358979 * x), 0));
        arch.radii_mm.push_back(1.0);
    }
    for (VesselLink& link : graph.links) link.system = VascularSystem::portal;
    graph.links.push_back(arch);
    const VesselTree looped = directed(graph);
    const OpenedLoops opened = open_loops(looped);
    EXPECT_EQ(opened.count, 1);
    const VesselTree tree = directed(opened.graph);
    EXPECT_TRUE(std::ranges::none_of(tree.segments, &VesselSegment::closes_loop));
    EXPECT_EQ(roots(tree).size(), 1u);
    EXPECT_EQ(end_count(tree), 3);
    EXPECT_GT(length_mm(tree), length_mm(looped) - 8.0);
    EXPECT_LT(length_mm(tree), length_mm(looped) - 3.0);
}

// A segment of a radius of 1 mm along straight pieces, with a point about each millimetre.
VesselSegment segment_along(const std::vector<Vec3>& corners, int proximal, int distal,
                            int parent) {
    VesselSegment segment;
    segment.proximal_node = proximal;
    segment.distal_node = distal;
    segment.parent = parent;
    segment.system = VascularSystem::portal;
    segment.points_mm = {corners.front()};
    for (std::size_t k = 1; k < corners.size(); ++k) {
        const Vec3 way = corners[k] - corners[k - 1];
        const int steps = static_cast<int>(std::lround(way.norm()));
        for (int i = 1; i <= steps; ++i)
            segment.points_mm.push_back(corners[k - 1] + way * i / steps);
    }
    segment.radii_mm.assign(segment.points_mm.size(), 1.0);
    return segment;
}

// Two loops are closed at the fork: `up` leaves it at 37 degrees from the way on of `down`, and
// goes straight on at its own other end; `down` turns by 60 degrees at its other end. As soon as
// `up` is detached from the fork, only the trunk lies there, at a right angle to `down`.
TEST(LoopOpening, ADetachedSegmentIsNoContinuationAtTheNodeThatItLeft) {
    const Vec3 root(-20, 0, 0), origin(0, 0, 0), fork(60, 0, 0), tip(120, 0, 0);
    const Vec3 up(0, 0.6, 0.8), down(0, 0, -1), turned(0, std::sqrt(0.75), -0.5);
    const Vec3 top = fork + 40 * up, bottom = fork + 40 * down;
    VesselTree tree;
    for (const Vec3& p : {root, origin, fork, tip, top, bottom}) tree.nodes.push_back({p, 1.0});
    tree.segments = {segment_along({root, origin}, 0, 1, -1),
                     segment_along({origin, fork}, 1, 2, 0),
                     segment_along({fork, tip}, 2, 3, 1),
                     segment_along({origin, top + 20 * up, top}, 1, 4, 0),
                     segment_along({origin, bottom + 20 * turned, bottom}, 1, 5, 0),
                     segment_along({fork, top}, 2, 4, 1),
                     segment_along({fork, bottom}, 2, 5, 1)};
    tree.segments[5].closes_loop = tree.segments[6].closes_loop = true;
    const OpenedLoops opened = open_loops(tree);
    EXPECT_EQ(opened.count, 2);
    EXPECT_EQ(opened.graph.links.size(), 4u) << "both are detached at the fork";
    for (const Vec3& way : {up, down})  // ends 3 mm from the fork, or at the next point
        EXPECT_TRUE(std::ranges::any_of(opened.graph.nodes, [&](const VesselNode& node) {
            return (node.position_mm - fork - 3.5 * way).norm() < 0.6;
        })) << way.transpose();
}

}  // namespace
}  // namespace hepatica
