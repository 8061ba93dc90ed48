// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of features against every pair there is, at many moments of every motion; and what overlaps
// against boxes, whose insides are known.
#include "core/contact/near_pairs.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/contact/overlaps.h"
#include "core/contact/pair_cover.h"
#include "tests/contact/bodies.h"

namespace hepatica {
namespace {

using test::Bar;
using test::Boxes;

using Key = std::array<int, 3>;

std::vector<Vec3> between(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double share) {
    std::vector<Vec3> x(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) x[i] = a[i] + share * (b[i] - a[i]);
    return x;
}

// Without any search.
std::set<Key> all_nearer(const SurfaceFeatures& features, const std::vector<Vec3>& x,
                         double reach_mm) {
    std::set<Key> found;
    const auto& triangles = features.surface().triangles();
    for (const int v : features.nodes())
        for (std::size_t t = 0; t < triangles.size(); ++t)
            if (std::ranges::count(triangles[t], v) == 0 &&
                closest(x[v], corners_of(triangles[t], x)).squared_mm2 <= reach_mm * reach_mm)
                found.insert({0, v, static_cast<int>(t)});
    const auto& edges = features.edges();
    for (std::size_t e = 0; e < edges.size(); ++e)
        for (std::size_t f = e + 1; f < edges.size(); ++f) {
            const auto &a = edges[e], &b = edges[f];
            if (a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) continue;
            if (closest(Segment{x[a[0]], x[a[1]]}, Segment{x[b[0]], x[b[1]]}).squared_mm2 <=
                reach_mm * reach_mm)
                found.insert({1, static_cast<int>(e), static_cast<int>(f)});
        }
    return found;
}

std::set<Key> keys_of(const std::vector<FeaturePair>& pairs) {
    std::set<Key> keys;
    for (const FeaturePair& pair : pairs) {
        EXPECT_TRUE(keys.insert({pair.of_edges ? 1 : 0, pair.first, pair.second}).second);
        // What has a node in common is never apart.
        const int of_first = pair.of_edges ? 2 : 1;
        for (int a = 0; a < of_first; ++a)
            for (int b = of_first; b < 4; ++b) EXPECT_NE(pair.nodes[a], pair.nodes[b]);
    }
    return keys;
}

bool none_left_out(int, int) {
    return false;
}

// Neighbours searched like strangers.
std::vector<FeaturePair> without_memory(const SurfaceFeatures& features, NearPairs& search,
                                        const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                                        double reach_mm) {
    const Sweep sweep{from, to, reach_mm};
    std::vector<FeaturePair> found;
    search.add_between_strangers(sweep, none_left_out, std::nullopt, found);
    PatchPairSearch of_two(features);
    for (int p = 0; p < static_cast<int>(features.surface().size()); ++p) {
        of_two.add_pairs_of(p, p, sweep, found);
        for (const int q : features.neighbours_above(p)) of_two.add_pairs_of(p, q, sweep, found);
    }
    return found;
}

TEST(NearPairs, FindsWhatComesNearAtAnyMoment) {
    Boxes boxes;
    boxes.add(Vec3(0, 0, 0), 0.0);
    boxes.add(Vec3(0.3, 0.2, 2.4), 1.3);
    boxes.add(Vec3(7.0, 0.5, 0.3), 0.4);
    const SurfaceFeatures features = boxes.features();
    EXPECT_EQ(features.pieces(), 3);
    const std::vector<Vec3>& from = boxes.mesh.vertices_mm;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> in(-1.0, 1.0);
    NearPairs search(features, 0.12);
    PairCover cover(features, 0.4, 0.3);
    std::size_t met = 0;
    for (const double size : {0.0, 0.2, 1.0, 4.0, 50.0})
        for (int trial = 0; trial < 4; ++trial) {
            std::vector<Vec3> to = from;
            const std::size_t third = to.size() / 3;
            for (int piece = 0; piece < 3; ++piece) {
                const Vec3 way = size * Vec3(in(random), in(random), in(random));
                for (std::size_t i = piece * third; i < (piece + 1) * third; ++i)
                    to[i] += way + 0.1 * size * Vec3(in(random), in(random), in(random));
            }
            const auto found = keys_of(without_memory(features, search, from, to, 0.4));
            const auto covered = keys_of(cover.along(from, to, none_left_out));
            for (int k = 0; k <= 20; ++k) {
                const std::vector<Vec3> x = between(from, to, k / 20.0);
                for (const Key& key : all_nearer(features, x, 0.4)) {
                    EXPECT_TRUE(found.contains(key)) << size << " at " << k;
                    EXPECT_TRUE(covered.contains(key)) << size << " at " << k;
                    ++met;
                }
                // The same search holds for places on the way.
                const auto there = keys_of(cover.along(x, x, none_left_out));
                for (const Key& key : all_nearer(features, x, 0.4))
                    EXPECT_TRUE(there.contains(key)) << size << " at " << k;
            }
        }
    EXPECT_GT(met, 1000u);
}

// A bar that bends, turns and flies: what is near along it is found, and what keeps its shape is
// not searched again.
TEST(NearPairs, KnowNeighboursThatTurnAndBend) {
    std::mt19937 random(7);
    const Bar bar(random);
    const SurfaceFeatures features(SurfacePatches(boundary_triangles(bar.mesh)), bar.rest);
    const double reach = 0.35;
    PairCover cover(features, reach, 0.2);
    const Vec3 axis = Vec3(1, 2, 3).normalized();
    std::vector<Vec3> from = bar.bent(1e-3, Eigen::AngleAxisd(0.0, axis), Vec3::Zero());
    std::size_t met = 0;
    int after_first = 0;
    for (int step = 1; step <= 12; ++step) {
        const double curvature = step <= 6 ? 1e-3 + 1e-4 * step : 1e-3 + 0.04 * (step - 6);
        const std::vector<Vec3> to =
            bar.bent(curvature, Eigen::AngleAxisd(0.7 * step, axis), 5.0 * step * Vec3::UnitX());
        const auto covered = keys_of(cover.along(from, to, none_left_out));
        for (int k = 0; k <= 4; ++k)
            for (const Key& key : all_nearer(features, between(from, to, k / 4.0), reach)) {
                EXPECT_TRUE(covered.contains(key)) << step << " at " << k;
                ++met;
            }
        if (step == 1) after_first = cover.searches();
        if (step <= 6) {
            EXPECT_EQ(cover.searches(), after_first) << step;
        }
        from = step == 9 ? bar.bent(0.2, Eigen::AngleAxisd(0.0, axis), Vec3::Zero()) : to;
    }
    EXPECT_GT(met, 1000u);
    EXPECT_GT(cover.searches(), after_first);  // those that bent
}

// Boxes that lie on each other, creep and roll together: no pair is lost between searches, though
// these are few; and what is thrown apart is found when it comes back.
TEST(NearPairs, KeepWhatLiesOnAnother) {
    Boxes boxes;
    boxes.add(Vec3(0, 0, 0), 0.0);
    boxes.add(Vec3(0.3, 0.2, 2.1), 1.3);
    boxes.add(Vec3(0.5, 0.1, 4.25), 0.4);
    const SurfaceFeatures features = boxes.features(4);
    const double reach = 0.3;
    PairCover cover(features, reach, 0.2);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> in(-1.0, 1.0);
    const std::size_t third = boxes.mesh.vertices_mm.size() / 3;
    std::vector<Vec3> from = boxes.mesh.vertices_mm;
    std::size_t met = 0;
    int after_first = 0;
    for (int step = 0; step < 40; ++step) {
        const Eigen::AngleAxisd roll(0.2 * in(random), Vec3(1, 2, 3).normalized());
        const Vec3 fly = 2.0 * Vec3(in(random), in(random), in(random));
        std::vector<Vec3> to = from;
        for (std::size_t i = 0; i < to.size(); ++i) {
            const Vec3 creep = 0.003 * Vec3(in(random), in(random), in(random)) +
                               0.004 * static_cast<double>(i / third) * Vec3::UnitX();
            to[i] = roll * Vec3(from[i] + creep) + fly;
            if (step == 30 && i >= 2 * third) to[i] += Vec3(0, 0, 5);
            if (step == 31 && i >= 2 * third) to[i] -= Vec3(0, 0, 5);
        }
        const auto covered = keys_of(cover.along(from, to, none_left_out));
        for (int k = 0; k <= 4; ++k)
            for (const Key& key : all_nearer(features, between(from, to, k / 4.0), reach)) {
                EXPECT_TRUE(covered.contains(key)) << step << " at " << k;
                ++met;
            }
        if (step == 0) after_first = cover.searches_of_strangers();
        from = to;
    }
    EXPECT_GT(met, 10000u);
    EXPECT_GT(after_first, 0);
    EXPECT_LT(cover.searches_of_strangers(), 20 * after_first);  // of 40 steps
}

// What was known of two patches when they met last says nothing of where they come from now, though
// they have been apart by little.
TEST(NearPairs, ForgetWhereTheyWereBeforeTheyParted) {
    Boxes boxes;
    boxes.add(Vec3(0, 0, 0), 0.0);
    boxes.add(Vec3(0.3, 0.2, 2.1), 0.3);
    const SurfaceFeatures features = boxes.features();
    const double reach = 0.3;
    const std::vector<Vec3>& near = boxes.mesh.vertices_mm;
    const auto at_end = all_nearer(features, near, reach);
    std::size_t only_on_the_way = 0;
    for (int turn = 0; turn < 12; ++turn) {
        PairCover cover(features, reach, 0.2);
        std::vector<Vec3> far = near;
        const Vec3 aside = Eigen::AngleAxisd(0.5 * turn, Vec3::UnitZ()) * Vec3(1.5, 0, 0.5);
        for (std::size_t i = far.size() / 2; i < far.size(); ++i) far[i] += aside;
        cover.along(near, near, none_left_out);
        cover.along(far, far, none_left_out);
        const auto covered = keys_of(cover.along(far, near, none_left_out));
        for (int k = 0; k <= 20; ++k)
            for (const Key& key : all_nearer(features, between(far, near, k / 20.0), reach)) {
                EXPECT_TRUE(covered.contains(key)) << turn << " at " << k;
                only_on_the_way += at_end.contains(key) ? 0 : 1;
            }
    }
    EXPECT_GT(only_on_the_way, 100u);
}

// What is left out is a pair of patches, not the features on their borders: these count with the
// triangles beside.
TEST(NearPairs, CountOnTheBorderOfWhatIsLeftOut) {
    Boxes boxes;
    boxes.add(Vec3(0, 0, 0), 0.0);
    boxes.add(Vec3(0.3, 0.2, 2.1), 1.3);
    const SurfaceFeatures features = boxes.features(4);
    const std::vector<Vec3>& x = boxes.mesh.vertices_mm;
    const auto& triangles = features.surface().triangles();
    const auto has = [&](int t, int node) { return std::ranges::count(triangles[t], node) > 0; };
    const auto has_edge = [&](int t, int e) {
        return has(t, features.edges()[e][0]) && has(t, features.edges()[e][1]);
    };
    std::size_t counted = 0, gone = 0;
    for (int patch = 0; patch < static_cast<int>(features.surface().size()); ++patch) {
        const auto left_out = [&](int p, int q) {
            return (p == patch || q == patch) &&
                   features.piece_of_patch(p) != features.piece_of_patch(q);
        };
        PairCover cover(features, 0.5, 0.3);
        const auto found = keys_of(cover.along(x, x, left_out));
        for (const Key& key : all_nearer(features, x, 0.5)) {
            bool counts = false;
            for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
                for (int s = 0; s < static_cast<int>(triangles.size()) && !counts; ++s)
                    counts = (key[0] == 1 ? has_edge(t, key[1]) && has_edge(s, key[2])
                                          : has(t, key[1]) && s == key[2]) &&
                             !left_out(features.patch_of(t), features.patch_of(s));
            EXPECT_EQ(found.contains(key), counts) << patch;
            (counts ? counted : gone) += 1;
        }
    }
    EXPECT_GT(counted, 100u);
    EXPECT_GT(gone, 10u);
}

TEST(Overlaps, KnowWhatLiesInWhat) {
    Boxes boxes;
    boxes.add(Vec3(0, 0, 0), 0.0);
    boxes.add(Vec3(0, 0, 0), 0.3, 0.3);  // within the first
    boxes.add(Vec3(0.1, 0, 1.8), 1.2);   // half in it
    boxes.add(Vec3(20, 0, 0), 0.0);      // far away
    const SurfaceFeatures features = boxes.features(4);
    Overlaps overlaps(features);
    overlaps.find(boxes.mesh.vertices_mm, 0.01);
    const auto patches_of = [&](int piece) {
        std::vector<int> patches;
        for (int p = 0; p < static_cast<int>(features.surface().size()); ++p)
            if (features.piece_of_patch(p) == piece) patches.push_back(p);
        return patches;
    };
    std::size_t buried = 0, crossing = 0;
    for (const int p : patches_of(0)) {
        for (const int q : patches_of(1)) buried += overlaps.left_out(q, p) ? 1 : 0;
        for (const int q : patches_of(2)) crossing += overlaps.left_out(p, q) ? 1 : 0;
        for (const int q : patches_of(3)) EXPECT_FALSE(overlaps.left_out(p, q));
        for (const int q : patches_of(0)) EXPECT_FALSE(overlaps.left_out(p, q));
    }
    EXPECT_EQ(buried, patches_of(0).size() * patches_of(1).size());
    EXPECT_GT(crossing, 0u);
    EXPECT_LT(crossing, patches_of(0).size() * patches_of(2).size());
    EXPECT_FALSE(overlaps.let_go(boxes.mesh.vertices_mm, 0.2));
    // Taken out one after the other.
    std::vector<Vec3> x = boxes.mesh.vertices_mm;
    const std::size_t quarter = x.size() / 4;
    for (std::size_t i = 2 * quarter; i < 3 * quarter; ++i) x[i].z() += 1.0;
    EXPECT_TRUE(overlaps.let_go(x, 0.2));
    EXPECT_TRUE(overlaps.any());
    for (std::size_t i = quarter; i < 2 * quarter; ++i) x[i].y() += 1.65;  // out by less than that
    EXPECT_TRUE(overlaps.let_go(x, 0.2));
    EXPECT_TRUE(overlaps.any());
    EXPECT_TRUE(overlaps.buried().empty());
    for (std::size_t i = quarter; i < 2 * quarter; ++i) x[i].y() += 0.3;
    EXPECT_TRUE(overlaps.let_go(x, 0.2));
    EXPECT_FALSE(overlaps.any());
    // What has come apart does not overlap again.
    EXPECT_FALSE(overlaps.let_go(boxes.mesh.vertices_mm, 0.2));
    EXPECT_FALSE(overlaps.any());
    EXPECT_FALSE(overlaps.set({{0, 1000000}}, {}));
    EXPECT_TRUE(overlaps.set({{0, 9}}, {{1, 2}}));
}

TEST(NearPairs, WhatFliesTogetherMeetsNothingNewAndWhatIsBackForgets) {
    const TetMesh bar = kuhn_brick(Vec3(60, 1, 1), {120, 2, 2});
    const SurfaceFeatures features(SurfacePatches(boundary_triangles(bar)), bar.vertices_mm);
    NearPairs near(features, 0.05);
    const auto ask = [&](std::span<const Vec3> from, std::span<const Vec3> to) {
        std::vector<FeaturePair> found;
        near.add_between_strangers(
            {from, to, 0.02}, [](int, int) { return false; }, std::nullopt, found);
    };
    const std::vector<Vec3>& rest = bar.vertices_mm;
    std::vector<Vec3> flown = rest, apart = rest;
    for (Vec3& x : flown) x += Vec3(100, 0, 0);
    for (Vec3& x : apart) x.x() *= 3.0;
    ask(rest, rest);
    const std::size_t at_rest = near.bytes();
    ask(rest, flown);
    EXPECT_LT(near.bytes(), 2 * at_rest);
    ask(flown, rest);
    ask(rest, apart);
    ask(apart, rest);
    EXPECT_GT(near.bytes(), 2 * at_rest) << "else there is nothing to forget";
    for (int k = 0; k < 64; ++k) ask(rest, rest);
    EXPECT_LT(near.bytes(), 2 * at_rest);
}

}  // namespace
}  // namespace hepatica
