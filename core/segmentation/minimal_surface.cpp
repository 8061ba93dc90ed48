// SPDX-License-Identifier: GPL-3.0-or-later
// The primal-dual iteration of Chambolle and Pock on the voxels near the vessels only.
#include "core/segmentation/minimal_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/parallel.h"
#include "core/image/voxel_loop.h"
#include "core/segmentation/vessel_growth.h"

namespace hepatica {

namespace {

constexpr std::size_t block = 8192;
constexpr float outside_cost = 2.0f;  // keeps a voxel outside whatever surface it would save
// Converges: 12, the squared norm of the gradient, times both steps is below 1.
constexpr float primal_step = 0.28f;
constexpr float dual_step = 0.28f;

// The voxels of the vessels and two layers around them; all other voxels are outside.
struct Band {
    std::vector<std::size_t> voxels;
    // Index in the band of the neighbours at +x, +y, +z and -x, -y, -z; -1 outside the band.
    std::vector<std::array<std::int32_t, 6>> neighbours;
    std::vector<std::uint8_t> free;  // in the liver, and in the vessels or next to them
};

Band band_around(const Mask& vessels, const Mask& liver, Job& job) {
    const Grid& grid = vessels.grid;
    const Mask everywhere(grid, 1);
    const double h = grid.spacing_mm[0];
    const Mask near = grow_within(vessels, liver, h);
    job.throw_if_cancelled();
    const Mask wide = grow_within(near, everywhere, h);
    job.throw_if_cancelled();
    Band band;
    Image<std::int32_t> place = filled_image(grid, std::int32_t{-1}, job);
    for_each_voxel_in_order(wide.voxels.size(), job, [&](std::size_t i) {
        if (!wide.voxels[i]) return;
        place.voxels[i] = static_cast<std::int32_t>(band.voxels.size());
        band.voxels.push_back(i);
        band.free.push_back(near.voxels[i]);
    });
    job.throw_if_cancelled();
    for (const std::size_t i : band.voxels) {
        const Index3 at = grid.index_of(i);
        std::array<std::int32_t, 6> around;
        for (std::size_t k = 0; k < 6; ++k) {
            Index3 n = at;
            n[k % 3] += k < 3 ? 1 : -1;
            around[k] =
                grid.contains(n[0], n[1], n[2]) ? place.voxels[grid.offset(n[0], n[1], n[2])] : -1;
        }
        band.neighbours.push_back(around);
    }
    return band;
}

// The highest rise inside the vessels within `ball` around a voxel.
float peak_near(const FloatVolume& rise, const Mask& vessels, std::size_t voxel,
                const std::vector<Index3>& ball) {
    const Grid& grid = rise.grid;
    const Index3 at = grid.index_of(voxel);
    float peak = 0.0f;
    for (const Index3& d : ball) {
        if (!grid.contains(at[0] + d[0], at[1] + d[1], at[2] + d[2])) continue;
        const std::size_t n = grid.offset(at[0] + d[0], at[1] + d[1], at[2] + d[2]);
        if (vessels.voxels[n]) peak = std::max(peak, rise.voxels[n]);
    }
    return peak;
}

std::vector<Index3> ball_of(double radius_voxels) {
    const int reach = static_cast<int>(radius_voxels);
    std::vector<Index3> ball;
    for (int z = -reach; z <= reach; ++z)
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x)
                if (x * x + y * y + z * z <= radius_voxels * radius_voxels)
                    ball.push_back({x, y, z});
    return ball;
}

// Minimises total variation(u) + sum cost u over 0 <= u <= 1.
std::vector<float> minimise(const Band& band, const std::vector<float>& cost, int iterations,
                            Job& job) {
    const std::size_t n = band.voxels.size();
    std::vector<float> u(n);
    for (std::size_t i = 0; i < n; ++i) u[i] = cost[i] < 0.0f ? 1.0f : 0.0f;
    std::vector<float> ahead = u;
    std::vector<std::array<float, 3>> dual(n, {0.0f, 0.0f, 0.0f});
    for (int iteration = 0; iteration < iterations; ++iteration) {
        job.advance(static_cast<double>(iteration) / iterations);
        parallel_blocks(n, block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                float squares = 0.0f;
                for (std::size_t a = 0; a < 3; ++a) {
                    const std::int32_t next = band.neighbours[i][a];
                    const float there = next < 0 ? 0.0f : ahead[static_cast<std::size_t>(next)];
                    dual[i][a] += dual_step * (there - ahead[i]);
                    squares += dual[i][a] * dual[i][a];
                }
                if (squares > 1.0f)
                    for (float& d : dual[i]) d /= std::sqrt(squares);
            }
        });
        parallel_blocks(n, block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                float divergence = 0.0f;
                for (std::size_t a = 0; a < 3; ++a) {
                    divergence += dual[i][a];
                    const std::int32_t before = band.neighbours[i][a + 3];
                    if (before >= 0) divergence -= dual[static_cast<std::size_t>(before)][a];
                }
                const float moved =
                    std::clamp(u[i] + primal_step * (divergence - cost[i]), 0.0f, 1.0f);
                ahead[i] = 2.0f * moved - u[i];
                u[i] = moved;
            }
        });
    }
    return u;
}

}  // namespace

Mask fit_surface(const FloatVolume& intensity, const FloatVolume& rise, const Mask& vessels,
                 const Mask& liver, double deviation, const SurfaceOptions& options, Job& job) {
    const Band band = band_around(vessels, liver, job);
    job.throw_if_cancelled();
    const std::vector<Index3> ball = ball_of(options.peak_reach_mm / rise.grid.spacing_mm[0]);
    const auto weight = static_cast<float>(options.data_weight / deviation);
    const auto least = static_cast<float>(options.least_deviations * deviation);
    const auto pull = static_cast<float>(options.pull_deviations * deviation);
    std::vector<float> cost(band.voxels.size());
    parallel_blocks(cost.size(), block, [&](std::size_t begin, std::size_t end) {
        job.throw_if_cancelled();
        for (std::size_t i = begin; i < end; ++i) {
            const float peak = peak_near(rise, vessels, band.voxels[i], ball);
            const float level =
                std::max(least, static_cast<float>(options.level_share) * peak - pull);
            cost[i] =
                band.free[i] ? weight * (level - intensity.voxels[band.voxels[i]]) : outside_cost;
        }
    });
    const std::vector<float> inside = minimise(band, cost, options.iterations, job);
    Mask surface(vessels.grid);
    for (std::size_t i = 0; i < inside.size(); ++i)
        surface.voxels[band.voxels[i]] = inside[i] > 0.5f;
    return surface;
}

}  // namespace hepatica
