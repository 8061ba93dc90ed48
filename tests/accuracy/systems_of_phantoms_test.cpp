// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold of the scores of any patient, on phantoms whose trees are spoilt at random in a
// way that can be counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/accuracy/system_scores.h"
#include "core/phantom/phantom.h"
#include "core/tree/extraction/vessel_graph.h"
#include "tests/support/test_masks.h"

namespace hepatica {
namespace {

class SystemsOfPhantoms : public testing::TestWithParam<int> {
  protected:
    void SetUp() override {
        PhantomOptions options;
        options.seed = static_cast<std::uint64_t>(GetParam());
        options.systems = 2;
        options.generations = 4;
        options.dims = {128, 128, 96};
        options.spacing_mm = Vec3(1.6, 1.6, 1.7);
        phantom_ = make_phantom(options, job_);
        random_.seed(options.seed);
        for (const VascularSystem system : {VascularSystem::portal, VascularSystem::hepatic}) {
            SystemTruth truth{system, phantom_.vessels, {}};
            for (std::uint8_t& voxel : truth.mask.voxels)
                voxel = voxel == static_cast<std::uint8_t>(system);
            VesselGraph graph = to_graph(phantom_.tree);
            std::erase_if(graph.links, [&](const VesselLink& l) { return l.system != system; });
            truth.tree = directed(graph, root_wishes(phantom_.tree));
            truths_.push_back(std::move(truth));
        }
    }

    SystemScores judged(const VesselTree& tree) {
        return judge_systems(tree, phantom_.vessels, truths_, nullptr, nullptr, {}, job_);
    }

    Job job_;
    Phantom phantom_;
    std::vector<SystemTruth> truths_;
    std::mt19937_64 random_;
};

INSTANTIATE_TEST_SUITE_P(Seeds, SystemsOfPhantoms, testing::Range(1, 6));

TEST_P(SystemsOfPhantoms, TheTruthIsPerfect) {
    const SystemScores s = judged(phantom_.tree);
    EXPECT_DOUBLE_EQ(s.system_right, 1.0);
    EXPECT_EQ(s.false_joins, 0);
    EXPECT_EQ(s.breaks, 0);
    for (const SystemScore& score : s.systems) {
        EXPECT_DOUBLE_EQ(score.length_recall, 1.0);
        EXPECT_DOUBLE_EQ(score.length_precision, 1.0);
        EXPECT_EQ(score.dice, 1.0);
        EXPECT_EQ(score.root_error_mm, 0.0);
    }
}

// The share that is right is the share of the length that kept its label.
TEST_P(SystemsOfPhantoms, LabelsChangedAtRandomCostTheirLength) {
    VesselTree tree = phantom_.tree;
    double kept_mm = 0.0;
    for (VesselSegment& segment : tree.segments) {
        if (test::uniform(random_) < 0.3) {
            segment.system = test::uniform(random_) < 0.5               ? VascularSystem::unknown
                             : segment.system == VascularSystem::portal ? VascularSystem::hepatic
                                                                        : VascularSystem::portal;
        } else {
            kept_mm += length_mm(segment);
        }
    }
    const SystemScores s = judged(tree);
    // Samples cut corners.
    EXPECT_NEAR(s.system_right, kept_mm / length_mm(tree), 1e-3);
    EXPECT_NEAR(s.attributed_mm, length_mm(tree), 2e-3 * length_mm(tree));
}

// Straight links from the middle of portal branches to that of the nearest hepatic ones, every pair
// a place of its own.
TEST_P(SystemsOfPhantoms, EveryBridgeIsAFalseJoin) {
    VesselGraph graph = to_graph(phantom_.tree);
    const std::size_t own = graph.links.size();
    std::vector<int> portal, hepatic;
    for (std::size_t i = 0; i < own; ++i)
        if (length_mm(graph.links[i]) > 25.0)
            (graph.links[i].system == VascularSystem::portal ? portal : hepatic)
                .push_back(static_cast<int>(i));
    const int bridges = 1 + static_cast<int>(random_() % 3);
    ASSERT_GE(static_cast<int>(std::min(portal.size(), hepatic.size())), bridges);
    for (int i = 0; i < bridges; ++i) {
        const auto middle = [&](int link) {
            const std::vector<Vec3>& points = graph.links[link].points_mm;
            return points[points.size() / 2];
        };
        const auto nearest = std::ranges::min_element(
            hepatic, {}, [&](int link) { return (middle(link) - middle(portal[i])).norm(); });
        const auto half = [&](int link) {
            return split_link(graph, link, 0.5 * length_mm(graph.links[link]), 0.0);
        };
        VesselLink link;
        link.from = half(portal[i]);
        link.to = half(*nearest);
        hepatic.erase(nearest);
        link.points_mm = {graph.nodes[link.from].position_mm, graph.nodes[link.to].position_mm};
        link.radii_mm = {1.0, 1.0};
        graph.links.push_back(std::move(link));
    }
    // A tree that calls everything by one name keeps its links together.
    for (VesselLink& link : graph.links) link.system = VascularSystem::portal;
    EXPECT_EQ(judged(directed(graph)).false_joins, bridges);
}

TEST_P(SystemsOfPhantoms, EveryCutIsABreak) {
    VesselGraph graph = to_graph(phantom_.tree);
    const std::size_t own = graph.links.size();
    int cuts = 0;
    for (std::size_t i = 0; i < own && cuts < 3; ++i) {
        if (length_mm(graph.links[i]) < 25.0) continue;
        const int place =
            split_link(graph, static_cast<int>(i), 0.5 * length_mm(graph.links[i]), 0.0);
        graph.nodes.push_back(VesselNode(graph.nodes[place]));
        graph.links.back().from = static_cast<int>(graph.nodes.size()) - 1;
        ++cuts;
    }
    ASSERT_GT(cuts, 0);
    EXPECT_EQ(judged(directed(graph)).breaks, cuts);
}

// The widest end of a system's mask is where its trunk enters, within its own width.
TEST_P(SystemsOfPhantoms, TheTrunkEndsWhereTheTreeBegins) {
    for (SystemTruth& truth : truths_) {
        const Vec3 root = truth.tree.segments[roots(truth.tree)[0]].points_mm.front();
        const CentrelineSamples line = sampled(centrelines_of(truth.mask, job_), 0.5, nullptr);
        const std::optional<int> end = widest_end(line);
        ASSERT_TRUE(end.has_value());
        EXPECT_LT((line.samples[*end].position_mm - root).norm(), 10.0) << name_of(truth.system);
    }
}

}  // namespace
}  // namespace hepatica
