// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reconstruction/closed_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "tests/support/test_data.h"

namespace hepatica::testing_support {
namespace {

void append_box(ClosedSurface& surface, const Vec3& low, const Vec3& high, bool inside_out) {
    const int first = static_cast<int>(surface.points_mm.size());
    for (int corner = 0; corner < 8; ++corner)
        surface.points_mm.emplace_back(corner & 1 ? high.x() : low.x(),
                                       corner & 2 ? high.y() : low.y(),
                                       corner & 4 ? high.z() : low.z());
    for (auto [a, b, c, d] : {std::array{0, 2, 3, 1},
                              {4, 5, 7, 6},
                              {0, 1, 5, 4},
                              {2, 6, 7, 3},
                              {0, 4, 6, 2},
                              {1, 3, 7, 5}}) {
        if (inside_out) std::swap(b, d);
        surface.triangles.push_back({first + a, first + b, first + c});
        surface.triangles.push_back({first + a, first + c, first + d});
    }
}

Grid grid_of(int n, double spacing_mm) {
    Grid grid;
    grid.dims = {n, n, n};
    grid.spacing_mm = Vec3(spacing_mm, 1.5 * spacing_mm, 2.0 * spacing_mm);
    grid.origin_mm = Vec3(-3, -4, -5);
    return grid;
}

double volume_mm3(const ClosedSurface& surface, const Grid& grid) {
    double volume = 0.0;
    for (const std::uint8_t share : inside_share(surface, grid).voxels)
        volume += share / 64.0 * grid.spacing_mm.prod();
    return volume;
}

// Walls half-way between sample points, so that the volume is exact.
TEST(ClosedSurface, BoxesHaveTheirVolumeWhicheverWayTheyAreOriented) {
    const Grid grid = grid_of(24, 0.5);  // sample points at multiples of 1/8, 3/16 and 1/4 mm
    for (const bool inside_out : {false, true}) {
        ClosedSurface surface;
        append_box(surface, grid.origin_mm + Vec3(1, 1.5, 2), grid.origin_mm + Vec3(4, 4.5, 6),
                   inside_out);
        EXPECT_NEAR(volume_mm3(surface, grid), 3.0 * 3.0 * 4.0, 1e-9);
        // One that overlaps it by a third and one that lies apart.
        append_box(surface, grid.origin_mm + Vec3(3, 1.5, 2), grid.origin_mm + Vec3(6, 4.5, 6),
                   inside_out);
        append_box(surface, grid.origin_mm + Vec3(8, 9, 10), grid.origin_mm + Vec3(9, 10.5, 12),
                   inside_out);
        EXPECT_NEAR(volume_mm3(surface, grid), 5.0 * 3.0 * 4.0 + 3.0, 1e-9);
    }
}

TEST(ClosedSurface, OfARealLiverHoldsItsVessels) {
    const auto models = test::shared_data() / "sksurgery_liver/models";
    if (!std::filesystem::exists(models)) GTEST_SKIP() << models << " is not there";
    const ClosedSurface liver = read_surface(models / "liver.vtk");
    Eigen::AlignedBox3d box;
    for (const Vec3& p : liver.points_mm) box.extend(p);
    Grid grid;
    grid.spacing_mm = Vec3::Constant(2.0);
    grid.origin_mm = box.min() - Vec3::Constant(4.0);
    for (int a = 0; a < 3; ++a) grid.dims[a] = static_cast<int>(box.sizes()[a] / 2.0) + 5;
    // The volume that the surface encloses, by the divergence theorem.
    double enclosed = 0.0;
    for (const auto& [a, b, c] : liver.triangles)
        enclosed +=
            (liver.points_mm[a] - box.min())
                .dot((liver.points_mm[b] - box.min()).cross(liver.points_mm[c] - box.min())) /
            6.0;
    EXPECT_NEAR(volume_mm3(liver, grid) / std::abs(enclosed), 1.0, 1e-3);
    EXPECT_THROW(read_surface(models / "none.vtk"), InputError);
}

}  // namespace
}  // namespace hepatica::testing_support
