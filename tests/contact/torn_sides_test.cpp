// SPDX-License-Identifier: GPL-3.0-or-later
// A bar of 6 x 2 x 2 mm that is slit, or cut in two, along z = 0 from its end at x > 0 on: when do
// its sides count against each other?
#include "core/contact/torn_sides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/mesh/surface.h"
#include "tests/contact/bodies.h"

namespace hepatica {
namespace {

constexpr double opening_mm = 0.01;

// The upper half has vertices of its own for x > `tip_mm`.
struct SlitBar {
    TetMesh mesh = kuhn_brick(Vec3(6, 2, 2), {6, 2, 2});
    std::vector<int> node_before;
    std::vector<char> above;  // per node: of the upper side
    std::vector<std::array<int, 2>> twins;
    SurfaceFeatures features;

    explicit SlitBar(double tip_mm) : features(slit(tip_mm)) {}

    // The upper side lifted by angle * distance from the tip, the lower one as it was.
    std::vector<Vec3> opened(double angle, double tip_mm) const {
        std::vector<Vec3> x = mesh.vertices_mm;
        for (std::size_t v = 0; v < x.size(); ++v)
            if (above[v]) x[v].z() += angle * std::max(0.0, x[v].x() - tip_mm);
        return x;
    }
    TornSides torn() const {
        TornSides sides(features);
        sides.follow_split({}, node_before, node_before);
        return sides;
    }

  private:
    SurfaceFeatures slit(double tip_mm) {
        const std::size_t whole = mesh.vertices_mm.size();
        for (std::size_t v = 0; v < whole; ++v) {
            node_before.push_back(static_cast<int>(v));
            above.push_back(mesh.vertices_mm[v].z() > 1.1);
        }
        std::map<int, int> copy;
        for (auto& nodes : mesh.tetrahedra) {
            double height = 0.0;
            for (const int v : nodes) height += mesh.vertices_mm[v].z();
            if (height < 4.0) continue;
            for (int& v : nodes) {
                const Vec3 at = mesh.vertices_mm[v];
                if (std::abs(at.z() - 1.0) > 1e-9 || at.x() < tip_mm + 1e-9) continue;
                const auto [entry, made] =
                    copy.emplace(v, static_cast<int>(mesh.vertices_mm.size()));
                if (made) {
                    mesh.vertices_mm.push_back(at);
                    node_before.push_back(v);
                    above.push_back(1);
                    twins.push_back({v, entry->second});
                }
                v = entry->second;
            }
        }
        std::ranges::sort(twins);
        return {SurfacePatches(boundary_triangles(mesh), 8), mesh.vertices_mm};
    }
};

FeaturePair vertex_and_triangle(int v, const std::array<int, 3>& corners) {
    return {.of_edges = false, .nodes = {v, corners[0], corners[1], corners[2]}};
}

TEST(TornSides, LieOnEachOtherUntilTheyHaveOpened) {
    const SlitBar bar(2.0);
    TornSides sides = bar.torn();
    EXPECT_EQ(sides.lying(), bar.twins);
    for (const double angle : {0.0, 1e-4})
        EXPECT_TRUE(sides.let_go(bar.opened(angle, 2.0), opening_mm).empty());
    // At the first row beyond the tip the sides are nearer than the opening; those behind are not.
    const auto x = bar.opened(0.008, 2.0);
    EXPECT_FALSE(sides.let_go(x, opening_mm).empty());
    for (const auto& [v, w] : bar.twins)
        EXPECT_EQ(std::ranges::count(sides.lying(), std::array{v, w}), x[v].x() < 3.5 ? 1 : 0)
            << x[v].transpose();
    // It is for good: what closes again still counts.
    const TornSides::Twins lying = sides.lying();
    EXPECT_TRUE(sides.let_go(bar.opened(0.0, 2.0), opening_mm).empty());
    EXPECT_EQ(sides.lying(), lying);
}

TEST(TornSides, DoNotCountWhereTheyHavePassedThroughEachOther) {
    const SlitBar bar(2.0);
    TornSides sides = bar.torn();
    EXPECT_TRUE(sides.let_go(bar.opened(-0.1, 2.0), opening_mm).empty());
    EXPECT_EQ(sides.lying(), bar.twins);
    // The right way round they do, however far.
    EXPECT_FALSE(sides.let_go(bar.opened(0.1, 2.0), opening_mm).empty());
    EXPECT_TRUE(sides.lying().empty());
}

// Each pair of features around twins counts exactly when none of its twins lies any more, and is
// named once it does.
TEST(TornSides, NameThePairsThatCountFromNowOn) {
    const SlitBar bar(2.0);
    TornSides sides = bar.torn();
    const auto& triangles = bar.features.surface().triangles();
    // Pairs that share a vertex are no contacts.
    const auto share = [](const FeaturePair& pair) {
        return std::set<int>(pair.nodes.begin(), pair.nodes.end()).size() < 4;
    };
    const auto held_back = [&] {
        int count = 0;
        const auto look_at = [&](const FeaturePair& pair) {
            count += !share(pair) && sides.lie_on_each_other(pair) ? 1 : 0;
        };
        for (const int v : bar.features.nodes())
            for (const auto& corners : triangles) look_at(vertex_and_triangle(v, corners));
        for (const auto& e : bar.features.edges())
            for (const auto& f : bar.features.edges())
                if (e < f) look_at({.of_edges = true, .nodes = {e[0], e[1], f[0], f[1]}});
        return count;
    };
    int before = held_back();
    ASSERT_GT(before, 100);
    for (const double angle : {0.004, 0.006, 0.02}) {
        std::set<std::array<int, 5>> named;
        for (const FeaturePair& pair : sides.let_go(bar.opened(angle, 2.0), opening_mm)) {
            EXPECT_FALSE(sides.lie_on_each_other(pair));
            EXPECT_TRUE(sides.shared_a_vertex(pair));
            EXPECT_FALSE(share(pair));
            auto n = pair.nodes;
            std::sort(n.begin() + (pair.of_edges ? 2 : 1), n.end());
            if (pair.of_edges && n[1] < n[0]) std::swap(n[0], n[1]);
            if (pair.of_edges && n[2] < n[0]) n = {n[2], n[3], n[0], n[1]};
            named.insert({pair.of_edges ? 1 : 0, n[0], n[1], n[2], n[3]});
        }
        const int now = held_back();
        EXPECT_EQ(before - now, static_cast<int>(named.size())) << angle;
        before = now;
    }
    EXPECT_EQ(before, 0);
}

TEST(TornSides, ChildrenAreAsTheirParentsWere) {
    const SlitBar bar(2.0);
    TornSides sides = bar.torn();
    sides.let_go(bar.opened(0.008, 2.0), opening_mm);
    const TornSides::Twins left = sides.lying();
    // Nothing else splits: only what lay on each other still does.
    std::vector<int> same(bar.mesh.vertices_mm.size());
    for (std::size_t v = 0; v < same.size(); ++v) same[v] = static_cast<int>(v);
    TornSides after(bar.features);
    after.follow_split(left, same, bar.node_before);
    EXPECT_EQ(after.lying(), left);
    // What is looked at without a past is judged by where it is.
    TornSides found = bar.torn();
    found.find(bar.opened(0.008, 2.0), opening_mm);
    EXPECT_EQ(found.lying(), left);
}

// What a cut parts is left to Overlaps, as patches.
TEST(TornSides, OfTwoPiecesAreThePatchesAroundThem) {
    const SlitBar bar(-1.0);
    ASSERT_EQ(bar.features.pieces(), 2);
    TornSides sides(bar.features);
    const TornSides::PatchPairs parted = sides.follow_split({}, bar.node_before, bar.node_before);
    EXPECT_TRUE(sides.lying().empty());
    EXPECT_TRUE(std::ranges::is_sorted(parted));
    for (const auto& [v, w] : bar.twins)
        for (const int p : bar.features.patches_of_node(v))
            for (const int q : bar.features.patches_of_node(w))
                EXPECT_TRUE(
                    std::ranges::binary_search(parted, std::array{std::min(p, q), std::max(p, q)}));
    for (const auto& [p, q] : parted)
        EXPECT_NE(bar.features.piece_of_patch(p), bar.features.piece_of_patch(q));
    // Twins that had come apart in one piece are none now: they go on counting.
    std::vector<int> same(bar.mesh.vertices_mm.size());
    for (std::size_t v = 0; v < same.size(); ++v) same[v] = static_cast<int>(v);
    EXPECT_TRUE(sides.follow_split({}, same, bar.node_before).empty());
    EXPECT_FALSE(sides.set({bar.twins.front()}));
}

TEST(TornSides, TakeOnlyTwins) {
    const SlitBar bar(2.0);
    TornSides sides = bar.torn();
    const auto [v, w] = bar.twins.front();
    for (const TornSides::Twins& bad :
         {TornSides::Twins{{w, v}}, TornSides::Twins{{v, v}}, TornSides::Twins{{v, w}, {v, w}},
          TornSides::Twins{{0, w}}, TornSides::Twins{{-1, w}},
          TornSides::Twins{{v, static_cast<int>(bar.node_before.size())}}}) {
        EXPECT_FALSE(sides.set(bad));
        EXPECT_EQ(sides.lying(), bar.twins);
    }
    EXPECT_TRUE(sides.set({{v, w}}));
    EXPECT_EQ(sides.lying(), (TornSides::Twins{{v, w}}));
    EXPECT_FALSE(TornSides(bar.features).set({{v, w}})) << "of a body that is whole";
}

}  // namespace
}  // namespace hepatica
