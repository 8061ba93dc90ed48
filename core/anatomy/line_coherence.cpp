// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/anatomy/line_coherence.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/parallel.h"

namespace hepatica {

namespace {

std::vector<Vec3> even_directions(int count) {
    std::vector<Vec3> directions;
    for (int k = 0; k < count; ++k) {  // Fibonacci's spiral
        const double z = 1.0 - (2.0 * k + 1.0) / count;
        const double turn = (k + 0.5) * std::numbers::pi * (1.0 + std::sqrt(5.0));
        const double r = std::sqrt(1.0 - z * z);
        directions.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
    }
    return directions;
}

}  // namespace

FloatVolume line_coherence(const FloatVolume& values, const Mask& candidates,
                           const LineOptions& options, Job& job) {
    const Grid& grid = values.grid;
    const int reach =
        std::max(1, static_cast<int>(std::lround(options.half_length_mm / grid.spacing_mm[0])));
    const std::vector<Vec3> directions = even_directions(options.directions);
    const std::ptrdiff_t sy = grid.dims[0];
    const std::ptrdiff_t sz = sy * grid.dims[1];
    std::vector<std::ptrdiff_t> steps;  // `reach` offsets for each direction
    for (const Vec3& d : directions)
        for (int t = 1; t <= reach; ++t)
            steps.push_back(std::lround(d[0] * t) + sy * std::lround(d[1] * t) +
                            sz * std::lround(d[2] * t));
    const double opposite = -std::cos(options.max_bend_deg * std::numbers::pi / 180.0);
    std::vector<std::pair<int, int>> lines;
    for (int a = 0; a < options.directions; ++a)
        for (int b = 0; b < a; ++b)
            if (directions[static_cast<std::size_t>(a)].dot(
                    directions[static_cast<std::size_t>(b)]) < opposite)
                lines.emplace_back(a, b);

    FloatVolume best(grid);
    const float share = 1.0f / static_cast<float>(2 * reach + 1);
    const auto first = static_cast<std::size_t>(reach);
    const auto layers = static_cast<std::size_t>(std::max(0, grid.dims[2] - 2 * reach));
    parallel_blocks(layers, 1, [&](std::size_t begin, std::size_t) {
        job.throw_if_cancelled();
        std::vector<float> half(directions.size());
        const auto z = static_cast<int>(begin + first);
        for (int y = reach; y < grid.dims[1] - reach; ++y)
            for (int x = reach; x < grid.dims[0] - reach; ++x) {
                const std::size_t i = grid.offset(x, y, z);
                if (!candidates.voxels[i]) continue;
                const float* centre = &values.voxels[i];
                const std::ptrdiff_t* step = steps.data();
                for (float& sum : half) {
                    sum = 0.0f;
                    for (int t = 0; t < reach; ++t) sum += centre[*step++];
                }
                float most = -1e30f;
                for (const auto& [a, b] : lines)
                    most = std::max(most, half[static_cast<std::size_t>(a)] +
                                              half[static_cast<std::size_t>(b)]);
                best.voxels[i] = share * (most + *centre);
            }
    });
    return best;
}

}  // namespace hepatica
