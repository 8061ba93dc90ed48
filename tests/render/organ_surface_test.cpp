// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of bodies whose volume is known.
#include "render/organ_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

namespace hepatica {
namespace {

constexpr std::uint8_t organ = 3;

// A ball in voxels of unequal sides, on axes that are turned, and left-handed where asked for.
Mask ball(const Vec3& centre_mm, double radius_mm, bool left_handed = false) {
    Grid grid;
    grid.dims = {70, 60, 40};
    grid.spacing_mm = Vec3(1.0, 1.2, 2.5);
    grid.direction = Eigen::AngleAxisd(0.3, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    if (left_handed) grid.direction.col(2) *= -1.0;
    grid.origin_mm = -(grid.direction * Vec3(35.0, 36.0, 50.0));
    Mask mask(grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        if ((grid.to_mm(x, y, z) - centre_mm).norm() < radius_mm) mask.voxels[i] = organ;
    }
    return mask;
}

double volume_ml(const TriangleMesh& mesh) {
    double six_volumes = 0.0;
    for (const auto& [a, b, c] : mesh.triangles)
        six_volumes += mesh.vertices_mm[a].dot(mesh.vertices_mm[b].cross(mesh.vertices_mm[c]));
    return six_volumes / 6000.0;
}

// Every edge belongs to two triangles, which run along it in opposite directions.
bool is_closed(const TriangleMesh& mesh) {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++uses[{triangle[k], triangle[(k + 1) % 3]}];
    return !uses.empty() && std::ranges::all_of(uses, [&](const auto& edge) {
        const auto back = uses.find({edge.first.second, edge.first.first});
        return edge.second == 1 && back != uses.end() && back->second == 1;
    });
}

// Smoothing by s draws the surface of a ball in by s^2 / R, for s much smaller than R.
TEST(OrganSurface, OfABallIsTheBall) {
    const Vec3 centre(2.0, -3.0, 1.0);
    const double radius = 25.0;
    const double smoothing = 2.0;
    const double drawn = radius - smoothing * smoothing / radius;
    const double ml = 4.0 / 3.0 * std::numbers::pi * std::pow(drawn, 3) / 1000.0;
    for (const bool left_handed : {false, true}) {
        Job job;
        const TriangleMesh surface = organ_surface(ball(centre, radius, left_handed), organ, job);
        EXPECT_TRUE(is_closed(surface));
        EXPECT_NEAR(volume_ml(surface), ml, 0.01 * ml) << "counter-clockwise from outside";
        for (const Vec3& vertex : surface.vertices_mm)
            EXPECT_NEAR((vertex - centre).norm(), drawn, 0.8);
    }
}

// Of two tumours one is a single voxel, which no smoothing would leave.
TEST(OrganSurface, OfTumoursShowsEachPieceHoweverSmall) {
    const Vec3 centre(2.0, -3.0, 1.0);
    const double radius = 12.0, smoothing = 0.8;
    Mask tumours = ball(centre, radius);
    tumours.at(4, 4, 4) = 2;
    Job job;
    const TriangleMesh surface = tumour_surface(tumours, job);
    EXPECT_TRUE(is_closed(surface));
    const double drawn = radius - smoothing * smoothing / radius;
    const double ml = 4.0 / 3.0 * std::numbers::pi * std::pow(drawn, 3) / 1000.0;
    EXPECT_NEAR(volume_ml(surface), ml, 0.02 * ml);
    const Vec3 alone = tumours.grid.to_mm(4, 4, 4);
    EXPECT_TRUE(std::ranges::any_of(
        surface.vertices_mm, [&](const Vec3& vertex) { return (vertex - alone).norm() < 2.0; }));
    EXPECT_TRUE(tumour_surface(Mask(tumours.grid), job).triangles.empty());
}

TEST(OrganSurface, IsClosedWhereTheOrganLeavesTheImage) {
    Job job;
    const TriangleMesh surface = organ_surface(ball(Vec3(30.0, 0.0, 0.0), 25.0), organ, job);
    EXPECT_TRUE(is_closed(surface));
    const Mask all = [] {
        Mask mask = ball(Vec3::Zero(), 1.0);
        std::ranges::fill(mask.voxels, organ);
        return mask;
    }();
    EXPECT_TRUE(is_closed(organ_surface(all, organ, job)));
}

TEST(OrganSurface, OfALabelThatIsNotThereIsEmpty) {
    Job job;
    EXPECT_TRUE(organ_surface(ball(Vec3::Zero(), 20.0), organ + 1, job).triangles.empty());
    EXPECT_TRUE(organ_surface(Mask(), organ, job).triangles.empty());
}

}  // namespace
}  // namespace hepatica
