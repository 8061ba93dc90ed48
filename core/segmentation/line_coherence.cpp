// SPDX-License-Identifier: GPL-3.0-or-later
// Sums along evenly spread half-lines from each candidate voxel, combined in nearly opposite pairs.
// Cost: directions x half-length reads and about 0.05 directions^2 pairs per candidate.
#include "core/segmentation/line_coherence.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/image/voxel_loop.h"

namespace hepatica {

namespace {

std::vector<Vec3> even_directions(int count) {
    std::vector<Vec3> directions;
    for (int k = 0; k < count; ++k) {  // a Fibonacci spiral
        const double z = 1.0 - (2.0 * k + 1.0) / count;
        const double turn = (k + 0.5) * std::numbers::pi * (1.0 + std::sqrt(5.0));
        const double r = std::sqrt(1.0 - z * z);
        directions.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
    }
    return directions;
}

// The voxels along every direction, as index steps and as offsets in memory.
struct Rays {
    Rays(const Grid& grid, const LineOptions& options)
        : reach(std::max(
              1, static_cast<int>(std::lround(options.half_length_mm / grid.spacing_mm[0])))) {
        const std::vector<Vec3> directions = even_directions(options.directions);
        const std::ptrdiff_t sy = grid.dims[0];
        const std::ptrdiff_t sz = sy * grid.dims[1];
        for (const Vec3& d : directions)
            for (int t = 1; t <= reach; ++t) {
                const Index3 step{static_cast<int>(std::lround(d[0] * t)),
                                  static_cast<int>(std::lround(d[1] * t)),
                                  static_cast<int>(std::lround(d[2] * t))};
                steps.push_back(step);
                offsets.push_back(step[0] + sy * step[1] + sz * step[2]);
            }
        const double opposite = -std::cos(options.max_bend_deg * std::numbers::pi / 180.0);
        for (std::size_t a = 0; a < directions.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                if (directions[a].dot(directions[b]) < opposite) pairs.emplace_back(a, b);
    }

    int reach;
    std::vector<Index3> steps;  // `reach` for each direction
    std::vector<std::ptrdiff_t> offsets;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;  // nearly opposite directions
};

// Sums along every direction; outside the grid the border value is repeated.
void sum_rays(const FloatVolume& values, const Rays& rays, const Index3& at,
              std::vector<float>& sums) {
    const Grid& grid = values.grid;
    const auto well_inside = [&](std::size_t axis) {
        return at[axis] >= rays.reach && at[axis] + rays.reach < grid.dims[axis];
    };
    std::size_t k = 0;
    if (well_inside(0) && well_inside(1) && well_inside(2)) {
        const float* centre = &values.voxels[grid.offset(at[0], at[1], at[2])];
        for (float& sum : sums) {
            sum = 0.0f;
            for (int t = 0; t < rays.reach; ++t) sum += centre[rays.offsets[k++]];
        }
        return;
    }
    for (float& sum : sums) {
        sum = 0.0f;
        for (int t = 0; t < rays.reach; ++t, ++k)
            sum += values.at(std::clamp(at[0] + rays.steps[k][0], 0, grid.dims[0] - 1),
                             std::clamp(at[1] + rays.steps[k][1], 0, grid.dims[1] - 1),
                             std::clamp(at[2] + rays.steps[k][2], 0, grid.dims[2] - 1));
    }
}

}  // namespace

FloatVolume line_coherence(const FloatVolume& values, const Mask& candidates,
                           const LineOptions& options, Job& job) {
    const Grid& grid = values.grid;
    const Rays rays(grid, options);
    FloatVolume best = filled_image(grid, 0.0f, job);
    const float share = 1.0f / static_cast<float>(2 * rays.reach + 1);
    const JobPart whole(job, 0.0, 1.0);  // threads report in another order than they count
    std::atomic<int> done{0};
    parallel_blocks(static_cast<std::size_t>(grid.dims[2]), 1, [&](std::size_t layer, std::size_t) {
        job.advance(static_cast<double>(done++) / grid.dims[2]);
        std::vector<float> half(static_cast<std::size_t>(options.directions));
        const auto z = static_cast<int>(layer);
        std::size_t i = grid.offset(0, 0, z);
        for (int y = 0; y < grid.dims[1]; ++y)
            for (int x = 0; x < grid.dims[0]; ++x, ++i) {
                if (!candidates.voxels[i]) continue;
                sum_rays(values, rays, {x, y, z}, half);
                float most = std::numeric_limits<float>::lowest();
                for (const auto& [a, b] : rays.pairs) most = std::max(most, half[a] + half[b]);
                best.voxels[i] = share * (most + values.voxels[i]);
            }
    });
    return best;
}

}  // namespace hepatica
