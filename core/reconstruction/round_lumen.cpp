// SPDX-License-Identifier: GPL-3.0-or-later
// Represents each tube by overlapping balls and finds the nearest wall of each voxel, layer by
// layer.
#include "core/reconstruction/round_lumen.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"

namespace hepatica {

namespace {

constexpr double outside_reach_mm = 2.0;  // voxels farther outside are left alone
constexpr double step_in_voxels = 0.4;    // between the balls that make up a tube

struct Ball {
    Vec3 index;  // of the centre, in voxels
    double radius_mm;
};

std::vector<Ball> balls_of(const VesselTree& tree, const Grid& grid) {
    const double step_mm = step_in_voxels * grid.spacing_mm.minCoeff();
    std::vector<Ball> balls;
    for (const VesselSegment& segment : tree.segments)
        for (std::size_t p = 1; p < segment.points_mm.size(); ++p) {
            const Vec3 edge = segment.points_mm[p] - segment.points_mm[p - 1];
            const int steps = std::max(1, static_cast<int>(std::ceil(edge.norm() / step_mm)));
            for (int s = 0; s <= steps; ++s) {
                const double t = static_cast<double>(s) / steps;
                balls.push_back({grid.to_index(segment.points_mm[p - 1] + t * edge),
                                 (1.0 - t) * segment.radii_mm[p - 1] + t * segment.radii_mm[p]});
            }
        }
    return balls;
}

// The nearest wall of each voxel in one layer.
struct Layer {
    std::vector<double> outside_mm;  // distance to the wall, negative inside
    std::vector<double> radius_mm;   // of the tube with that wall
};

void add(const Ball& ball, const Grid& grid, int z, Layer& layer) {
    const Vec3& h = grid.spacing_mm;
    const double reach = ball.radius_mm + outside_reach_mm;
    const double dz = (z - ball.index[2]) * h[2];
    if (std::abs(dz) > reach) return;
    const auto low = [&](int axis) {
        return std::max(0, static_cast<int>(std::ceil(ball.index[axis] - reach / h[axis])));
    };
    const auto high = [&](int axis) {
        return std::min(grid.dims[static_cast<std::size_t>(axis)] - 1,
                        static_cast<int>(std::floor(ball.index[axis] + reach / h[axis])));
    };
    for (int y = low(1); y <= high(1); ++y)
        for (int x = low(0); x <= high(0); ++x) {
            const double dx = (x - ball.index[0]) * h[0];
            const double dy = (y - ball.index[1]) * h[1];
            const double outside = std::sqrt(dx * dx + dy * dy + dz * dz) - ball.radius_mm;
            const std::size_t i = grid.offset(x, y, 0);
            if (outside >= layer.outside_mm[i]) continue;
            layer.outside_mm[i] = outside;
            layer.radius_mm[i] = ball.radius_mm;
        }
}

}  // namespace

Mask round_thin_lumens(const Mask& vessels, const VesselTree& tree, double thin_radius_mm,
                       Job& job) {
    const Grid& grid = vessels.grid;
    const std::vector<Ball> balls = balls_of(tree, grid);
    const std::size_t size = grid.offset(0, 0, 1);
    Mask result = vessels;
    parallel_blocks(static_cast<std::size_t>(grid.dims[2]), 1, [&](std::size_t z, std::size_t) {
        job.throw_if_cancelled();
        Layer layer{std::vector<double>(size, outside_reach_mm), std::vector<double>(size, 0.0)};
        for (const Ball& ball : balls) add(ball, grid, static_cast<int>(z), layer);
        for (std::size_t i = 0; i < size; ++i)
            if (layer.outside_mm[i] < outside_reach_mm && layer.radius_mm[i] < thin_radius_mm)
                result.voxels[z * size + i] = layer.outside_mm[i] <= 0.0;
    });
    return result;
}

}  // namespace hepatica
