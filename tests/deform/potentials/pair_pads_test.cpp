// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/pair_pads.h"

#include <gtest/gtest.h>

#include "core/deform/potentials/pad_barrier.h"

namespace hepatica {
namespace {

FeaturePair of_vertex(int v, int a, int b, int c) {
    return {.of_edges = false, .nodes = {v, a, b, c}};
}

FeaturePair of_edges(int a, int b, int c, int d) {
    return {.of_edges = true, .nodes = {a, b, c, d}};
}

// Nodes 8 and 9 were 0 and 1.
const std::vector<int> node_before{0, 1, 2, 3, 4, 5, 6, 7, 0, 1};

TEST(PairPads, APairThatWasPressedKeepsItsForce) {
    const PressedPair before{of_vertex(0, 5, 6, 7), 0.1, 2.0, 0.03};
    // Vertex 0 was split, and its parts have three times its area between them, because faces were
    // laid bare.
    const std::vector<PressedPair> after{{of_vertex(0, 6, 7, 5), 0.1, 4.0, 0.03},
                                         {of_vertex(8, 7, 5, 6), 0.1, 2.0, 0.03}};
    const auto pads = pads_after_split(std::span(&before, 1), after, node_before);
    ASSERT_EQ(pads.size(), 2u);
    double force = 0.0, energy = 0.0;
    for (const PressedPair& pair : after) {
        const PairPad* const pad = find_pad(pads, pair.of);
        ASSERT_NE(pad, nullptr);
        const PadBarrier now = pad_barrier(pair.gap_mm, pad->pad_mm, pad->share * pair.area_mm2);
        force += now.force_un;
        energy += now.energy_nj;
    }
    const PadBarrier was = pad_barrier(before.gap_mm, before.pad_mm, before.area_mm2);
    EXPECT_NEAR(force, was.force_un, 1e-14 * was.force_un);
    EXPECT_NEAR(energy, was.energy_nj, 1e-14 * was.energy_nj);
}

TEST(PairPads, ANewPairBeginsWithAPadAsThinAsItsGap) {
    const PressedPair after{of_edges(3, 2, 9, 8), 0.1, 4.0, 0.03};
    auto pads = pads_after_split({}, std::span(&after, 1), node_before);
    ASSERT_EQ(pads.size(), 1u);
    EXPECT_EQ(pads[0].pad_mm, 0.03);
    EXPECT_EQ(pads[0].most_mm, 0.1);
    EXPECT_EQ(pads[0].share, 1.0);
    // In whatever order its nodes are named.
    EXPECT_EQ(find_pad(pads, of_edges(8, 9, 2, 3)), &pads[0]);
    EXPECT_EQ(find_pad(pads, of_edges(8, 2, 9, 3)), nullptr);
    EXPECT_EQ(find_pad(pads, of_vertex(2, 3, 8, 9)), nullptr);
    // A nearer gap leaves it as it is, a wider one makes it grow, and it ends as what it would be.
    EXPECT_TRUE(grow(pads[0], 0.02));
    EXPECT_EQ(pads[0].pad_mm, 0.03);
    EXPECT_TRUE(grow(pads[0], 0.05));
    EXPECT_EQ(pads[0].pad_mm, 0.05);
    EXPECT_FALSE(grow(pads[0], 0.1));
}

TEST(PairPads, WhatOpensHasAllOfItsAreaAgain) {
    const PressedPair before{of_vertex(0, 5, 6, 7), 0.04, 2.0, 0.03};
    const PressedPair after{of_vertex(0, 5, 6, 7), 0.1, 8.0, 0.03};
    auto pads = pads_after_split(std::span(&before, 1), std::span(&after, 1), node_before);
    ASSERT_EQ(pads.size(), 1u);
    EXPECT_EQ(pads[0].pad_mm, 0.04);
    EXPECT_EQ(pads[0].share, 0.25);
    EXPECT_TRUE(grow(pads[0], 0.039));
    EXPECT_EQ(pads[0].share, 0.25);
    EXPECT_TRUE(grow(pads[0], 0.06));
    EXPECT_EQ(pads[0].share, 1.0);
    EXPECT_EQ(pads[0].pad_mm, 0.06);
}

TEST(PairPads, WhatDidNotChangeHasNone) {
    const PressedPair pair{of_vertex(4, 5, 6, 7), 0.1, 2.0, 0.03};
    EXPECT_TRUE(pads_after_split(std::span(&pair, 1), std::span(&pair, 1), node_before).empty());
    // One that lost area presses less: it is not made to press more.
    PressedPair smaller = pair;
    smaller.area_mm2 = 1.0;
    EXPECT_TRUE(pads_after_split(std::span(&pair, 1), std::span(&smaller, 1), node_before).empty());
}

TEST(PairPads, AreAddedOnceWhereTheyAreNear) {
    const std::vector<Vec3> x{{0, 0, 0.02}, {0, 0, 0.5}, {-1, -1, 0}, {1, -1, 0}, {0, 2, 0}};
    std::vector<PairPad> pads{{{0, 2, 3, 4}, 1, 0.01, 0.1, 0.5}};
    add_new(std::vector{of_vertex(0, 2, 3, 4), of_vertex(1, 2, 3, 4)}, x, 0.1, pads);
    ASSERT_EQ(pads.size(), 1u);
    EXPECT_EQ(pads[0].pad_mm, 0.01);
    pads.clear();
    add_new(std::vector{of_vertex(0, 3, 4, 2), of_vertex(0, 2, 3, 4)}, x, 0.1, pads);
    ASSERT_EQ(pads.size(), 1u);
    EXPECT_DOUBLE_EQ(pads[0].pad_mm, 0.02);
    EXPECT_TRUE(are_pads(pads, 5));
}

TEST(PairPads, OfACheckpointMustBeInOrderAndWithinTheirLimits) {
    const PairPad good{{0, 2, 3, 4}, 1, 0.01, 0.1, 0.5};
    const auto are = [&](auto change) {
        PairPad pad = good;
        change(pad);
        return are_pads(std::vector{pad}, 5);
    };
    EXPECT_TRUE(are([](PairPad&) {}));
    EXPECT_FALSE(are([](PairPad& p) { p.nodes[3] = 5; }));
    EXPECT_FALSE(are([](PairPad& p) { p.nodes[0] = -1; }));
    EXPECT_FALSE(are([](PairPad& p) { p.nodes = {0, 3, 2, 4}; }));
    EXPECT_FALSE(are([](PairPad& p) { p.in_first = 3; }));
    EXPECT_FALSE(are([](PairPad& p) { p.pad_mm = 0.0; }));
    EXPECT_FALSE(are([](PairPad& p) { p.pad_mm = 0.2; }));
    EXPECT_FALSE(are([](PairPad& p) { p.share = 0.0; }));
    EXPECT_FALSE(are([](PairPad& p) { p.share = 1.1; }));
    EXPECT_FALSE(are_pads(std::vector{good, good}, 5));
}

}  // namespace
}  // namespace hepatica
