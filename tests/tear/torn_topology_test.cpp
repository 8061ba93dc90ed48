// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tear/torn_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "core/base/error.h"
#include "core/mesh/brick_mesh.h"
#include "core/mesh/surface.h"

namespace hepatica {
namespace {

std::vector<double> volumes_of(const TetMesh& mesh) {
    std::vector<double> volume;
    for (const auto& [a, b, c, d] : mesh.tetrahedra)
        volume.push_back(signed_volume_mm3(mesh.vertices_mm[a], mesh.vertices_mm[b],
                                           mesh.vertices_mm[c], mesh.vertices_mm[d]));
    return volume;
}

TetMesh torn_mesh(const TetMesh& whole, const TornTopology& topology) {
    TetMesh mesh = whole;
    for (int v = static_cast<int>(mesh.vertices_mm.size()); v < topology.vertex_count(); ++v)
        mesh.vertices_mm.push_back(Vec3(mesh.vertices_mm[topology.parents()[v]]));
    mesh.tetrahedra.assign(topology.tetrahedra().begin(), topology.tetrahedra().end());
    return mesh;
}

// At every vertex all tetrahedra hang together through joints that have not parted.
bool no_hanging_pieces(const TornTopology& topology) {
    const auto joints = topology.joints();
    for (int v = 0; v < topology.vertex_count(); ++v) {
        std::set<int> around, reached;
        for (std::size_t t = 0; t < topology.tetrahedra().size(); ++t)
            for (const int corner : topology.tetrahedra()[t])
                if (corner == v) around.insert(static_cast<int>(t));
        std::vector<int> next{*around.begin()};
        while (!next.empty()) {
            const int t = next.back();
            next.pop_back();
            if (!reached.insert(t).second) continue;
            for (std::size_t j = 0; j < joints.size(); ++j) {
                if (topology.parted(static_cast<int>(j))) continue;
                const auto& [one, other] = joints[j].tetrahedra;
                if (one != t && other != t) continue;
                bool here = false;
                for (int k = 0; k < 3; ++k) here = here || topology.sides(joints[j], k)[0] == v;
                if (here) next.push_back(one == t ? other : one);
            }
        }
        if (reached != around) return false;
    }
    return true;
}

// The joints on the plane x = place.
std::vector<int> on_plane(const TornTopology& topology, double place) {
    std::vector<int> found;
    for (std::size_t j = 0; j < topology.joints().size(); ++j)
        if (std::abs(topology.joints()[j].centre_mm.x() - place) < 1e-9)
            found.push_back(static_cast<int>(j));
    return found;
}

TEST(TornTopology, AWholePlanePartsABrickInTwoClosedPieces) {
    const TetMesh mesh = kuhn_brick(Vec3(4, 2, 2), {4, 2, 2});
    TornTopology topology(mesh);
    topology.part(on_plane(topology, 1.0), volumes_of(mesh));
    EXPECT_EQ(topology.pieces({}), 2);
    EXPECT_EQ(topology.vertex_count(), 5 * 9 + 9);
    EXPECT_TRUE(is_closed_manifold(surface_of(torn_mesh(mesh, topology)).mesh));
}

// One tetrahedron at a corner against all the others.
TEST(TornTopology, TheLargestGroupKeepsTheNumber) {
    const TetMesh mesh = kuhn_brick(Vec3(4, 2, 2), {4, 2, 2});
    TornTopology topology(mesh);
    std::vector<int> around;
    for (std::size_t j = 0; j < topology.joints().size(); ++j)
        for (const int t : topology.joints()[j].tetrahedra)
            if (t == 0) around.push_back(static_cast<int>(j));
    topology.part(around, volumes_of(mesh));
    EXPECT_EQ(topology.pieces({}), 2);
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const bool whole = topology.tetrahedra()[t] == mesh.tetrahedra[t];
        EXPECT_EQ(whole, t != 0) << t;
    }
}

TEST(TornTopology, ItsSurfaceIsTheBoundaryOfTheTornMesh) {
    const TetMesh mesh = kuhn_brick(Vec3(4, 2, 2), {4, 2, 2});
    TornTopology topology(mesh);
    EXPECT_EQ(topology.surface(), boundary_triangles(mesh));
    topology.part(on_plane(topology, 2.0), volumes_of(mesh));
    EXPECT_EQ(topology.surface(), boundary_triangles(torn_mesh(mesh, topology)));
    const std::uint64_t version = topology.version();
    topology.part(std::vector{0, 5, 9}, volumes_of(mesh));
    EXPECT_EQ(topology.surface(), boundary_triangles(torn_mesh(mesh, topology)));
    EXPECT_NE(topology.version(), version);
}

TEST(TornTopology, BareFacesAreThoseThatWereInside) {
    const TetMesh mesh = kuhn_brick(Vec3(4, 2, 2), {4, 2, 2});
    TornTopology topology(mesh);
    EXPECT_EQ(std::ranges::count(topology.bare_faces(), 1), 0);
    topology.part(on_plane(topology, 2.0), volumes_of(mesh));
    const TetMesh torn = torn_mesh(mesh, topology);
    const auto surface = topology.surface();
    const auto bare = topology.bare_faces();
    ASSERT_EQ(bare.size(), surface.size());
    for (std::size_t t = 0; t < surface.size(); ++t) {
        const bool on_plane = std::ranges::all_of(surface[t], [&](int v) {
            return std::abs(torn.vertices_mm[static_cast<std::size_t>(v)].x() - 2.0) < 1e-9;
        });
        EXPECT_EQ(bare[t] != 0, on_plane) << t;
    }
    EXPECT_EQ(std::ranges::count(bare, 1), 16);
}

TEST(TornTopology, AJointInTheMiddlePartsNothing) {
    const TetMesh mesh = kuhn_brick(Vec3(3, 3, 3), {3, 3, 3});
    TornTopology topology(mesh);
    int middle = 0;
    for (std::size_t j = 0; j < topology.joints().size(); ++j)
        if ((topology.joints()[j].centre_mm - Vec3(1.5, 1.5, 1.5)).norm() <
            (topology.joints()[middle].centre_mm - Vec3(1.5, 1.5, 1.5)).norm())
            middle = static_cast<int>(j);
    topology.part(std::vector{middle}, volumes_of(mesh));
    EXPECT_EQ(topology.vertex_count(), 64);
    EXPECT_EQ(topology.pieces({}), 1);
}

TEST(TornTopology, AllPartedThereAreAsManyPiecesAsTetrahedra) {
    const TetMesh mesh = kuhn_brick(Vec3(2, 3, 2), {2, 3, 2});
    TornTopology topology(mesh);
    std::vector<int> all(topology.joints().size());
    std::iota(all.begin(), all.end(), 0);
    topology.part(all, volumes_of(mesh));
    EXPECT_EQ(topology.pieces({}), static_cast<int>(mesh.tetrahedra.size()));
    EXPECT_EQ(topology.vertex_count(), static_cast<int>(4 * mesh.tetrahedra.size()));
}

// In random portions, in random orders: nothing hangs by a point or an edge, surfaces are closed,
// corners come from the vertices they were, and the order of portions does not matter to the
// pieces.
TEST(TornTopology, StaysSoundHoweverItIsTorn) {
    const TetMesh mesh = kuhn_brick(Vec3(3, 2, 2), {3, 2, 2});
    const auto volumes = volumes_of(mesh);
    for (unsigned seed = 0; seed < 12; ++seed) {
        std::mt19937 random(seed);
        TornTopology topology(mesh), at_once(mesh);
        std::vector<int> order(topology.joints().size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::shuffle(order, random);
        order.resize(order.size() * (seed + 1) / 13);
        for (std::size_t first = 0; first < order.size();) {
            const std::size_t count = std::min(order.size() - first, std::size_t{1} + random() % 9);
            topology.part(std::span(order).subspan(first, count), volumes);
            first += count;
            ASSERT_TRUE(no_hanging_pieces(topology)) << "seed " << seed;
        }
        at_once.part(order, volumes);
        EXPECT_EQ(at_once.pieces({}), topology.pieces({}));
        EXPECT_EQ(at_once.vertex_count(), topology.vertex_count());
        EXPECT_NO_THROW(validate_closed(surface_of(torn_mesh(mesh, topology)).mesh));
        for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
            for (int i = 0; i < 4; ++i) {
                int v = topology.tetrahedra()[t][i];
                while (topology.parents()[v] != v) v = topology.parents()[v];
                EXPECT_EQ(v, mesh.tetrahedra[t][i]);
            }
    }
}

TEST(TornTopology, GoesOnFromWhatWasReadOfIt) {
    const TetMesh mesh = kuhn_brick(Vec3(4, 2, 2), {4, 2, 2});
    const auto volumes = volumes_of(mesh);
    TornTopology one(mesh), other(mesh);
    const auto first = on_plane(one, 1.0), second = on_plane(one, 3.0);
    one.part(first, volumes);
    other.restore(first, one.parents(), one.tetrahedra());
    one.part(second, volumes);
    other.part(second, volumes);
    EXPECT_TRUE(std::ranges::equal(one.parents(), other.parents()));
    EXPECT_TRUE(std::ranges::equal(one.tetrahedra(), other.tetrahedra()));
}

TEST(TornTopology, RefusesWhatIsOfAnotherMesh) {
    const TetMesh mesh = kuhn_brick(Vec3(4, 2, 2), {4, 2, 2});
    TornTopology topology(mesh);
    std::vector<int> parents(topology.parents().begin(), topology.parents().end());
    const auto whole = topology.tetrahedra();
    parents.push_back(3);  // a vertex of no tetrahedron
    EXPECT_THROW(topology.restore({}, parents, whole), InputError);
    parents.back() = static_cast<int>(parents.size());
    EXPECT_THROW(topology.restore({}, parents, whole), InputError);
    parents.pop_back();
    EXPECT_THROW(topology.restore(std::vector{-1}, parents, whole), InputError);
    EXPECT_THROW(topology.restore({}, parents, whole.subspan(1)), InputError);
    std::vector<std::array<int, 4>> moved(whole.begin(), whole.end());
    std::swap(moved[0][0], moved[0][1]);
    EXPECT_THROW(topology.restore({}, parents, moved), InputError);
}

TEST(TornTopology, RefusesSidesThatDifferWhereNoJointHasParted) {
    const TetMesh mesh = kuhn_brick(Vec3(3, 1, 1), {3, 1, 1});
    TornTopology topology(mesh);
    std::vector<int> parents(topology.parents().begin(), topology.parents().end());
    std::vector<std::array<int, 4>> moved = mesh.tetrahedra;
    parents.push_back(moved[0][0]);
    moved[0][0] = static_cast<int>(parents.size()) - 1;
    EXPECT_THROW(topology.restore({}, parents, moved), InputError);
}

}  // namespace
}  // namespace hepatica
