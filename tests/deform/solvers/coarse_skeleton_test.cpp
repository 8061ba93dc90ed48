// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/coarse_skeleton.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "core/base/error.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

int roots_of(const CoarseSkeleton& skeleton) {
    return static_cast<int>(std::count(skeleton.parent.begin(), skeleton.parent.end(), -1));
}

TEST(CoarseSkeleton, ResamplesToHalfADiameterAndKeepsTheTree) {
    //   0 ------- 20 ---- 26
    //              \--- thin, 4 long
    const std::vector<SkeletonPolyline> lines{
        {{Vec3(0, 0, 0), Vec3(7, 0, 0), Vec3(20, 0, 0)}, {2.0, 2.0, 2.0}, -1},
        {{Vec3(20, 0, 0), Vec3(26, 0, 0)}, {1.5, 1.5}, 0},
        {{Vec3(20, 0, 0), Vec3(20, 4, 0)}, {1.0, 1.0}, 0},
        {{Vec3(20, 4, 0), Vec3(20, 4.2, 0)}, {1.0, 1.0}, 2}};
    const CoarseSkeleton skeleton = resample(lines);
    ASSERT_NO_THROW(validate(skeleton));
    EXPECT_EQ(skeleton.size(), 1 + 10 + 4 + 4);  // the last line is too short for a node
    EXPECT_EQ(roots_of(skeleton), 1);
    for (int n = 1; n < skeleton.size(); ++n) {
        const double gap =
            (skeleton.positions_mm[n] - skeleton.positions_mm[skeleton.parent[n]]).norm();
        EXPECT_NEAR(gap, skeleton.radii_mm[n], 1e-12);
    }
}

TEST(CoarseSkeleton, RejectsWhatIsNoTree) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const SkeletonPolyline bad_point{{Vec3(0, nan, 0)}, {1.0}, -1};
    const SkeletonPolyline bad_radius{{Vec3(0, 0, 0)}, {0.0}, -1};
    const SkeletonPolyline bad_parent{{Vec3(0, 0, 0)}, {1.0}, 0};
    const SkeletonPolyline bad_size{{Vec3(0, 0, 0)}, {}, -1};
    for (const auto& line : {bad_point, bad_radius, bad_parent, bad_size}) {
        EXPECT_THROW(resample(std::span(&line, 1)), InputError);
    }
    try {
        validate({{Vec3::Zero()}, {-1}, {-1e-9}});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "the radius is -1e-09 mm");
    }
    EXPECT_THROW(validate({{Vec3::Zero()}, {0}, {1.0}}), InputError);
    EXPECT_THROW(validate({{Vec3::Zero()}, {-1}, {}}), InputError);
}

TEST(CoarseSkeleton, BindsLinearlyAndLikeBruteForce) {
    std::mt19937 random(7);
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    CoarseSkeleton skeleton;
    for (int n = 0; n < 200; ++n) {
        skeleton.positions_mm.emplace_back(40 * uniform(), 40 * uniform(), 40 * uniform());
        skeleton.radii_mm.push_back(0.5 + 3 * uniform());
        skeleton.parent.push_back(n % 50 == 0 ? -1 : n - 1 - static_cast<int>(random() % (n % 50)));
    }
    std::vector<Vec3> points;
    for (int i = 0; i < 300; ++i) {
        points.emplace_back(80 * uniform() - 20, 80 * uniform() - 20, 80 * uniform() - 20);
    }
    points.push_back(Vec3(1e6, 0, 0));
    const SkeletonBinding binding = bind_vertices(skeleton, points);
    for (std::size_t v = 0; v < points.size(); ++v) {
        const auto [a, b] = binding.nodes[v];
        const auto [wa, wb] = binding.weights[v];
        ASSERT_TRUE(a == b || skeleton.parent[b] == a);
        EXPECT_NEAR(wa + wb, 1.0, 1e-15);
        const auto ratio = [&](int p, int c, double t) {
            const Vec3 foot = (1 - t) * skeleton.positions_mm[p] + t * skeleton.positions_mm[c];
            return (foot - points[v]).norm() /
                   ((1 - t) * skeleton.radii_mm[p] + t * skeleton.radii_mm[c]);
        };
        double best = std::numeric_limits<double>::infinity();
        for (int n = 0; n < skeleton.size(); ++n) {
            const int p = skeleton.parent[n];
            if (p < 0) continue;
            const Vec3 along = skeleton.positions_mm[n] - skeleton.positions_mm[p];
            const double t =
                (points[v] - skeleton.positions_mm[p]).dot(along) / along.squaredNorm();
            best = std::min(best, ratio(p, n, std::clamp(t, 0.0, 1.0)));
        }
        EXPECT_NEAR(ratio(a, b, wb), best, 1e-9 * best);
    }
}

TEST(CoarseSkeleton, OneNodeTakesEverything) {
    const std::vector<Vec3> points{Vec3(1, 2, 3), Vec3(-100, 0, 0)};
    const SkeletonBinding binding = bind_vertices({{Vec3::Zero()}, {-1}, {1.0}}, points);
    for (std::size_t v = 0; v < points.size(); ++v) {
        EXPECT_EQ(binding.nodes[v], (std::array<int, 2>{0, 0}));
        EXPECT_EQ(binding.weights[v], (std::array<double, 2>{1.0, 0.0}));
    }
}

TEST(MeshSkeleton, FollowsABar) {
    const auto body = test::make_bar(60.0, 4.0, 30, 2);
    const CoarseSkeleton skeleton = skeleton_of_mesh(body.mesh);
    ASSERT_NO_THROW(validate(skeleton));
    EXPECT_EQ(roots_of(skeleton), 1);
    EXPECT_GE(skeleton.size(), 15);
    EXPECT_LE(skeleton.size(), 45);
    std::vector<int> children(static_cast<std::size_t>(skeleton.size()), 0);
    for (int n = 1; n < skeleton.size(); ++n) ++children[skeleton.parent[n]];
    EXPECT_LE(std::count(children.begin(), children.end(), 0), skeleton.size() / 5);  // twigs
}

// Powers of two scale without rounding.
TEST(MeshSkeleton, GrowsWithItsMesh) {
    const auto body = test::make_bar(60.0, 4.0, 30, 2);
    const CoarseSkeleton skeleton = skeleton_of_mesh(body.mesh);
    for (const double factor : {1.0 / 64.0, 16.0}) {
        TetMesh scaled = body.mesh;
        for (Vec3& x : scaled.vertices_mm) x *= factor;
        const CoarseSkeleton found = skeleton_of_mesh(scaled);
        ASSERT_EQ(found.parent, skeleton.parent) << factor;
        for (int n = 0; n < found.size(); ++n) {
            EXPECT_EQ(found.positions_mm[n], factor * skeleton.positions_mm[n]);
            EXPECT_EQ(found.radii_mm[n], factor * skeleton.radii_mm[n]);
        }
    }
}

TEST(MeshSkeleton, OneTreePerPieceAndATwigPerFork) {
    auto body = test::make_brick_tree(3, 3.0, 1.2);
    const int before = static_cast<int>(body.mesh.vertices_mm.size());
    TetMesh other = body.mesh;
    for (Vec3& x : other.vertices_mm) x += Vec3(0, 0, 1000);
    body.mesh.vertices_mm.insert(body.mesh.vertices_mm.end(), other.vertices_mm.begin(),
                                 other.vertices_mm.end());
    for (auto t : other.tetrahedra) {
        for (int& v : t) v += before;
        body.mesh.tetrahedra.push_back(t);
    }
    const CoarseSkeleton skeleton = skeleton_of_mesh(body.mesh);
    ASSERT_NO_THROW(validate(skeleton));
    EXPECT_EQ(roots_of(skeleton), 2);
    std::vector<int> children(static_cast<std::size_t>(skeleton.size()), 0);
    for (const int parent : skeleton.parent) {
        if (parent >= 0) ++children[parent];
    }
    // Four tips a tree, and the end that the ranking starts from is one of the five ends.
    EXPECT_GE(std::count(children.begin(), children.end(), 0), 8);
}

TEST(MeshSkeleton, OneTetrahedronAndFlatOnesGetANode) {
    TetMesh mesh;
    mesh.vertices_mm = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    mesh.tetrahedra = {{0, 1, 2, 3}};
    EXPECT_GE(skeleton_of_mesh(mesh).size(), 1);
    mesh.vertices_mm[3] = Vec3(1, 1, 0);
    ASSERT_NO_THROW(validate(skeleton_of_mesh(mesh)));
    mesh.vertices_mm.assign(4, Vec3::Zero());
    ASSERT_NO_THROW(validate(skeleton_of_mesh(mesh)));
    mesh.vertices_mm.assign(1, Vec3::Zero());
    mesh.tetrahedra.clear();
    EXPECT_EQ(skeleton_of_mesh(mesh).size(), 1);
    EXPECT_EQ(skeleton_of_mesh({}).size(), 0);
}

}  // namespace
}  // namespace hepatica
