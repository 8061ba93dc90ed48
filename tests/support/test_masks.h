// SPDX-License-Identifier: GPL-3.0-or-later
// Random and hand-made masks whose topology is known or must be kept.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "core/image/volume.h"

namespace hepatica::test {

inline Grid cube_grid(int n) {
    Grid grid;
    grid.dims = {n, n, n};
    return grid;
}

inline double uniform(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

// Each voxel is object with the given probability.
inline Mask bernoulli_mask(int n, double probability, std::mt19937_64& random) {
    Mask mask(cube_grid(n));
    for (auto& voxel : mask.voxels) voxel = uniform(random) < probability ? 1 : 0;
    return mask;
}

// Noise averaged over 3 x 3 x 3 voxels a few times and cut at a threshold: blobs with tunnels and
// cavities.
inline Mask blob_mask(int n, double fill, std::mt19937_64& random) {
    const Grid grid = cube_grid(n);
    FloatVolume noise(grid);
    for (auto& voxel : noise.voxels) voxel = static_cast<float>(uniform(random));
    for (int pass = 0; pass < 2; ++pass)
        for (int axis = 0; axis < 3; ++axis) {
            FloatVolume next(grid);
            for (std::size_t i = 0; i < grid.count(); ++i) {
                float sum = 0.0f;
                for (int d = -1; d <= 1; ++d) {
                    Index3 p = grid.index_of(i);
                    p[axis] = std::min(std::max(p[axis] + d, 0), n - 1);
                    sum += noise.at(p[0], p[1], p[2]);
                }
                next.voxels[i] = sum / 3.0f;
            }
            noise = next;
        }
    std::vector<float> sorted = noise.voxels;
    const auto nth = sorted.begin() +
                     static_cast<std::ptrdiff_t>((1.0 - fill) * static_cast<double>(grid.count()));
    std::nth_element(sorted.begin(), nth, sorted.end());
    Mask mask(grid);
    for (std::size_t i = 0; i < grid.count(); ++i) mask.voxels[i] = noise.voxels[i] > *nth ? 1 : 0;
    return mask;
}

template <class Inside>
Mask mask_where(const Grid& grid, const Inside& inside) {
    Mask mask(grid);
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        mask.voxels[i] = inside(grid.to_mm(x, y, z)) ? 1 : 0;
    }
    return mask;
}

inline Mask torus_mask() {
    return mask_where(cube_grid(32), [](const Vec3& p) {
        const Vec3 q = p - Vec3(15.5, 15.5, 15.5);
        return std::hypot(std::hypot(q.x(), q.y()) - 10.0, q.z()) < 3.2;
    });
}

inline Mask hollow_cube_mask() {
    return mask_where(cube_grid(20), [](const Vec3& p) {
        const double r = (p - Vec3(9.5, 9.5, 9.5)).cwiseAbs().maxCoeff();
        return r < 7.0 && r > 4.0;
    });
}

// Two tubes that cross at an angle and touch where they pass each other.
inline Mask touching_tubes_mask() {
    return mask_where(cube_grid(40), [](const Vec3& p) {
        const bool first = std::hypot(p.y() - 16.0, p.z() - 20.0) < 3.5 && p.x() > 3 && p.x() < 36;
        const bool second = std::hypot(p.x() - 20.0, p.z() - 20.0 - 0.2 * (p.y() - 20.0)) < 3.0 &&
                            p.y() > 18 && p.y() < 37;
        return first || second;
    });
}

inline Mask bar_mask(int width, int length) {
    Mask mask(cube_grid(length + 6));
    for (int z = 3; z < 3 + length; ++z)
        for (int y = 3; y < 3 + width; ++y)
            for (int x = 3; x < 3 + width; ++x) mask.at(x, y, z) = 1;
    return mask;
}

inline std::size_t count_object(const Mask& mask) {
    std::size_t count = 0;
    for (const auto voxel : mask.voxels) count += voxel != 0;
    return count;
}

}  // namespace hepatica::test
