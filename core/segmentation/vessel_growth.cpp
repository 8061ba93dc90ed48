// SPDX-License-Identifier: GPL-3.0-or-later
// Connected components and breadth-first growth on masks.
#include "core/segmentation/vessel_growth.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/image/morphology.h"
#include "core/image/voxel_loop.h"
#include "core/segmentation/neighbours.h"

namespace hepatica {

Mask hysteresis(const Mask& strong, const Mask& weak, double minimum_mm3, const Job& job) {
    const Components pieces = connected_components(weak, Connectivity::all26, job);
    std::vector<std::uint8_t> kept(pieces.sizes.size() + 1, 0);
    for_each_voxel_in_order(weak.voxels.size(), job, [&](std::size_t i) {
        if (strong.voxels[i]) kept[pieces.labels.voxels[i]] = 1;
    });
    kept[0] = 0;
    const double voxel_mm3 = weak.grid.spacing_mm.prod();
    for (std::size_t p = 0; p < pieces.sizes.size(); ++p)
        if (static_cast<double>(pieces.sizes[p]) * voxel_mm3 < minimum_mm3) kept[p + 1] = 0;
    Mask mask(weak.grid);
    for_each_voxel(mask.voxels.size(), job,
                   [&](std::size_t i) { mask.voxels[i] = kept[pieces.labels.voxels[i]]; });
    return mask;
}

Mask grow_within(const Mask& strong, const Mask& weak, double reach_mm) {
    const Grid& grid = weak.grid;
    Mask grown(grid);
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < grown.voxels.size(); ++i)
        if (strong.voxels[i] && weak.voxels[i]) {
            grown.voxels[i] = 1;
            front.push_back(i);
        }
    const auto rounds = static_cast<int>(std::lround(reach_mm / grid.spacing_mm[0]));
    for (int round = 0; round < rounds; ++round) {
        std::vector<std::size_t> next;
        for (const std::size_t i : front)
            for_each_neighbour(grid, i, [&](std::size_t n) {
                if (!weak.voxels[n] || grown.voxels[n]) return;
                grown.voxels[n] = 1;
                next.push_back(n);
            });
        front.swap(next);
    }
    return grown;
}

Mask pieces_within(const Mask& mask, const Mask& where, double least_share, const Job& job) {
    const Components pieces = connected_components(mask, Connectivity::all26, job);
    std::vector<std::size_t> inner(pieces.sizes.size() + 1, 0);
    for_each_voxel_in_order(mask.voxels.size(), job, [&](std::size_t i) {
        if (where.voxels[i]) ++inner[pieces.labels.voxels[i]];
    });
    Mask kept(mask.grid);
    for_each_voxel(kept.voxels.size(), job, [&](std::size_t i) {
        const std::uint32_t piece = pieces.labels.voxels[i];
        if (piece != 0 && static_cast<double>(inner[piece]) >=
                              least_share * static_cast<double>(pieces.sizes[piece - 1]))
            kept.voxels[i] = mask.voxels[i];
    });
    return kept;
}

void rejoin(const Mask& skeleton, double kept_mm, Mask& surface, const Job& job) {
    const Grid& grid = surface.grid;
    Mask outside(grid);
    for_each_voxel(outside.voxels.size(), job, [&](std::size_t i) {
        outside.voxels[i] = skeleton.voxels[i] && !surface.voxels[i];
    });
    const Components pieces = connected_components(outside, Connectivity::all26, job);
    const Components parts = connected_components(surface, Connectivity::all26, job);
    // The first part of the surface that a piece touches.
    std::vector<std::uint32_t> touched(pieces.sizes.size() + 1, 0);
    std::vector<std::uint8_t> kept(pieces.sizes.size() + 1, 0);
    const double step = grid.spacing_mm.mean();
    for (std::size_t p = 0; p < pieces.sizes.size(); ++p)
        kept[p + 1] = static_cast<double>(pieces.sizes[p]) * step > kept_mm;
    for_each_voxel_in_order(outside.voxels.size(), job, [&](std::size_t i) {
        const std::uint32_t piece = pieces.labels.voxels[i];
        if (piece == 0 || kept[piece]) return;
        for_each_neighbour(grid, i, [&](std::size_t n) {
            const std::uint32_t part = parts.labels.voxels[n];
            if (part == 0) return;
            if (touched[piece] == 0) touched[piece] = part;
            if (touched[piece] != part) kept[piece] = 1;
        });
    });
    for_each_voxel(outside.voxels.size(), job, [&](std::size_t i) {
        if (kept[pieces.labels.voxels[i]]) surface.voxels[i] = 1;
    });
}

}  // namespace hepatica
