// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/obstacle_actors.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace hepatica {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

// Strips of triangles that wander about, each a part of its own.
TriangleMesh random_strips(std::mt19937& random, int strips, int triangles) {
    std::uniform_real_distribution<double> anywhere(-30.0, 30.0), step(-2.0, 2.0);
    TriangleMesh mesh;
    for (int s = 0; s < strips; ++s) {
        const auto first = static_cast<int>(mesh.vertices_mm.size());
        Vec3 at(anywhere(random), anywhere(random), anywhere(random));
        for (int v = 0; v < triangles + 2; ++v) {
            mesh.vertices_mm.push_back(at);
            at += Vec3(step(random), step(random), step(random));
        }
        for (int t = 0; t < triangles; ++t)
            mesh.triangles.push_back({first + t, first + t + 1, first + t + 2});
    }
    std::ranges::shuffle(mesh.triangles, random);
    return mesh;
}

// A part is beside where any of its vertices is further than 4.5 mm from all of the solids'.
Triangles beside_by_comparing_all(const TriangleMesh& surface, const TriangleMesh& solid,
                                  int per_strip) {
    Triangles beside;
    const auto far = [&](int vertex) {
        const Vec3& at = surface.vertices_mm[static_cast<std::size_t>(vertex)];
        return std::ranges::none_of(solid.vertices_mm, [&at](const Vec3& one) {
            return (one - at).squaredNorm() <= 4.5 * 4.5;
        });
    };
    for (const auto& triangle : surface.triangles) {
        const int first = triangle[0] / per_strip * per_strip;
        bool any = false;
        for (int v = first; v < first + per_strip; ++v) any |= far(v);
        if (any) beside.push_back(triangle);
    }
    return beside;
}

TEST(PartsBesideSolids, AreThoseThatAComparisonOfAllWithAllFinds) {
    std::mt19937 random(17);
    std::size_t beside = 0, at_solids = 0;
    for (int round = 0; round < 12; ++round) {
        constexpr int triangles = 4, strips = 60;
        const TriangleMesh solid = random_strips(random, 40 + 60 * round, 6);
        const TriangleMesh shell = random_strips(random, 20, 6);
        const TriangleMesh surface = random_strips(random, strips, triangles);
        vtkNew<vtkRenderer> renderer;
        ObstacleActors actors(*renderer);
        actors.update(std::make_shared<const Obstacles>(
            Obstacles{{{solid, SurfaceKind::solid}, {shell, SurfaceKind::shell}}}));
        const TriangleMesh found = actors.parts_beside_solids(surface);
        EXPECT_EQ(found.triangles, beside_by_comparing_all(surface, solid, triangles + 2)) << round;
        EXPECT_EQ(found.vertices_mm, surface.vertices_mm);
        beside += found.triangles.size();
        at_solids += surface.triangles.size() - found.triangles.size();
    }
    EXPECT_GT(beside, 100u);
    EXPECT_GT(at_solids, 100u);
}

TEST(PartsBesideSolids, AreAllWithoutASolid) {
    std::mt19937 random(3);
    const TriangleMesh surface = random_strips(random, 5, 4);
    vtkNew<vtkRenderer> renderer;
    EXPECT_EQ(ObstacleActors(*renderer).parts_beside_solids(surface).triangles, surface.triangles);
}

}  // namespace
}  // namespace hepatica
