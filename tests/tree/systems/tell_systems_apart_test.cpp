// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/systems/tell_systems_apart.h"

#include <gtest/gtest.h>

#include <algorithm>

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

TEST(TellSystemsApart, FindsTwoSystemsThatTouchInEightPlaces) {
    for (const int seed : {3, 4, 5}) {
        const Phantom phantom = patient(seed, 2);
        VesselGraph graph = to_graph(phantom.tree);
        touch(graph, 8);
        graph = unnamed(graph);
        const std::vector<int> component = component_of_nodes(graph);
        for (const VesselLink& link : graph.links) ASSERT_EQ(component[link.from], component[0]);
        const SystemsFound found = tell_systems_apart(graph, nullptr, {{}, box_of_liver(phantom)});
        EXPECT_GE(share_right(graph, phantom.tree), 0.95) << seed;
        EXPECT_LT(found.anchors.hilum_mm.z(), found.anchors.confluence_mm.z()) << seed;
        const VesselTree tree = directed(graph, anatomical_roots(graph, found.anchors));
        for (const int root : roots(phantom.tree)) {
            const Vec3 wanted = phantom.tree.segments[root].points_mm.front();
            const VascularSystem system = phantom.tree.segments[root].system;
            EXPECT_TRUE(std::ranges::any_of(roots(tree), [&](int id) {
                return tree.segments[id].system == system &&
                       (tree.segments[id].points_mm.front() - wanted).norm() < 1.0;
            })) << seed;
        }
    }
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

}  // namespace
}  // namespace hepatica
