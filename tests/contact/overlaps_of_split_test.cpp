// SPDX-License-Identifier: GPL-3.0-or-later
// What is left out of contact after a tear: whatever crosses, and nothing that counted before.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "core/contact/overlaps.h"
#include "core/contact/torn_sides.h"
#include "core/mesh/brick_mesh.h"
#include "core/mesh/surface.h"

namespace hepatica {
namespace {

constexpr double reach_mm = 0.1;
constexpr int in_patch = 16;

void add(const TetMesh& part, const Eigen::Affine3d& place, TetMesh& mesh) {
    const int first = static_cast<int>(mesh.vertices_mm.size());
    for (const Vec3& x : part.vertices_mm) mesh.vertices_mm.push_back(place * x);
    for (auto nodes : part.tetrahedra) {
        for (int& node : nodes) node += first;
        mesh.tetrahedra.push_back(nodes);
    }
}

// Cuts the first brick, of this many tetrahedra, at x = at_mm, or slits it there up to z = 1. The
// former node of each node.
std::vector<int> cut_first(TetMesh& mesh, std::size_t tetrahedra, double at_mm, bool slit) {
    std::vector<int> before(mesh.vertices_mm.size());
    std::iota(before.begin(), before.end(), 0);
    std::map<int, int> copy;
    for (std::size_t t = 0; t < tetrahedra; ++t) {
        double sum_mm = 0.0;
        for (const int v : mesh.tetrahedra[t]) sum_mm += mesh.vertices_mm[v].x();
        if (sum_mm < 4.0 * at_mm) continue;
        for (int& v : mesh.tetrahedra[t]) {
            const Vec3 at = mesh.vertices_mm[v];
            if (std::abs(at.x() - at_mm) > 1e-9 || (slit && at.z() > 0.9)) continue;
            const auto [entry, made] =
                copy.try_emplace(v, static_cast<int>(mesh.vertices_mm.size()));
            if (made) {
                mesh.vertices_mm.push_back(at);
                before.push_back(v);
            }
            v = entry->second;
        }
    }
    return before;
}

SurfaceFeatures features_of(const TetMesh& mesh) {
    return {SurfacePatches(boundary_triangles(mesh), in_patch), mesh.vertices_mm};
}

// Of pairs of triangles of two pieces that have a point in common: all, and those that count.
struct Crossings {
    int all = 0, counting = 0;
};

Crossings crossings(const std::vector<Vec3>& x, const SurfaceFeatures& features,
                    const Overlaps& overlaps) {
    Crossings found;
    const auto& triangles = features.surface().triangles();
    for (std::size_t s = 0; s < triangles.size(); ++s)
        for (std::size_t t = s + 1; t < triangles.size(); ++t) {
            const int p = features.patch_of(static_cast<int>(s));
            const int q = features.patch_of(static_cast<int>(t));
            if (features.piece_of_patch(p) == features.piece_of_patch(q)) continue;
            const Triangle one = corners_of(triangles[s], x);
            const Triangle other = corners_of(triangles[t], x);
            if (!box_around(one).meets(box_around(other)) || squared_distance_mm2(one, other) > 0.0)
                continue;
            ++found.all;
            found.counting += overlaps.left_out(p, q) ? 0 : 1;
        }
    return found;
}

// A bar within a block. It is found there, moves until it reaches out of it, and is cut or slit.
// Its patches are large: a part of one that has vertices in the block may pass through the wall
// without any.
TEST(OverlapsOfSplit, WhatCrossesIsLeftOut) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> in(-1.0, 1.0);
    const TetMesh bar = kuhn_brick(Vec3(6, 2, 2), {6, 2, 2});
    int crossing = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const bool slit = trial % 2 == 0;
        TetMesh mesh;
        add(bar, Eigen::Affine3d::Identity(), mesh);
        add(kuhn_brick(Vec3(8, 8, 8), {3, 3, 3}),
            Eigen::Affine3d(Eigen::Translation3d(-1.0, -3.0, -3.0)), mesh);
        const SurfaceFeatures whole = features_of(mesh);
        Overlaps overlaps(whole);
        overlaps.find(mesh.vertices_mm, 0.01);
        const std::vector<int> node_before =
            cut_first(mesh, bar.tetrahedra.size(), 1.0 + static_cast<double>(trial % 5), slit);
        std::vector<Vec3> x = mesh.vertices_mm;
        const Eigen::AngleAxisd turn(3.0 * in(random),
                                     Vec3(in(random), in(random), in(random)).normalized());
        const Vec3 way(2.5 * in(random), 2.5 * in(random), 2.5 * in(random));
        for (std::size_t v = 0; v < x.size(); ++v)
            if (node_before[v] < static_cast<int>(bar.vertices_mm.size()))
                x[v] = turn * (x[v] - Vec3(3, 1, 1)) + Vec3(3, 1, 1) + way;
        overlaps.let_go(x, reach_mm);
        ASSERT_EQ(crossings(x, whole, overlaps).counting, 0);

        const SurfaceFeatures torn = features_of(mesh);
        TornSides sides(torn);
        const auto parted = sides.follow_split({}, node_before, node_before);
        EXPECT_EQ(parted.empty(), slit) << "only a cut parts two pieces";
        Overlaps after(torn);
        after.follow_split({whole, overlaps.touching(), overlaps.buried()}, node_before, x,
                           reach_mm, &parted);
        const Crossings found = crossings(x, torn, after);
        ASSERT_EQ(found.counting, 0) << trial;
        crossing += found.all;
    }
    EXPECT_GT(crossing, 1000) << "hardly anything crosses";
}

// A block beside the bar, nearer than the reach.
TEST(OverlapsOfSplit, WhatCountedStillCounts) {
    TetMesh mesh;
    const TetMesh bar = kuhn_brick(Vec3(6, 2, 2), {6, 2, 2});
    add(bar, Eigen::Affine3d::Identity(), mesh);
    add(kuhn_brick(Vec3(1.5, 1.2, 0.9), {2, 2, 2}),
        Eigen::Affine3d(Eigen::Translation3d(2.2, 0.4, 2.0 + 0.5 * reach_mm)), mesh);
    const SurfaceFeatures whole = features_of(mesh);
    const std::vector<int> node_before = cut_first(mesh, bar.tetrahedra.size(), 3.0, false);
    const SurfaceFeatures torn = features_of(mesh);
    TornSides sides(torn);
    const auto parted = sides.follow_split({}, node_before, node_before);
    Overlaps after(torn);
    after.follow_split({whole, {}, {}}, node_before, mesh.vertices_mm, reach_mm, &parted);
    EXPECT_EQ(after.touching(), parted) << "the two sides of the cut alone";
    EXPECT_TRUE(after.buried().empty());
}

}  // namespace
}  // namespace hepatica
