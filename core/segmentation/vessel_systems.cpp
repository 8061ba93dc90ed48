// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/vessel_systems.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/segmentation/fast_marching.h"

namespace hepatica {

namespace {

constexpr double seed_reach_mm = 3.0;

std::string in_words(const Vec3& position) {
    return std::to_string(position[0]) + ", " + std::to_string(position[1]) + ", " +
           std::to_string(position[2]) + " mm";
}

// The object voxel nearest to a position, within seed_reach_mm; ties by index.
std::size_t voxel_near(const Mask& vessels, const VesselSeed& seed) {
    const Grid& grid = vessels.grid;
    if (!seed.position_mm.allFinite())
        throw InputError("a seed's place is no number", "seed", "Give three finite numbers in mm.");
    const Vec3 index = grid.to_index(seed.position_mm);
    std::optional<std::size_t> nearest;
    double nearest_mm = seed_reach_mm;
    Index3 from{};
    Index3 to{};
    for (std::size_t a = 0; a < 3; ++a) {
        const auto axis = static_cast<Eigen::Index>(a);
        const double reach = seed_reach_mm / grid.spacing_mm[axis];
        const double last = grid.dims[a] - 1.0;
        from[a] = static_cast<int>(std::clamp(std::floor(index[axis] - reach), 0.0, last + 1.0));
        to[a] = static_cast<int>(std::clamp(std::ceil(index[axis] + reach), -1.0, last));
    }
    for (int z = from[2]; z <= to[2]; ++z)
        for (int y = from[1]; y <= to[1]; ++y)
            for (int x = from[0]; x <= to[0]; ++x) {
                if (!vessels.voxels[grid.offset(x, y, z)]) continue;
                const double distance = (grid.to_mm(x, y, z) - seed.position_mm).norm();
                if (distance > nearest_mm || (nearest && distance == nearest_mm)) continue;
                nearest = grid.offset(x, y, z);
                nearest_mm = distance;
            }
    if (!nearest)
        throw InputError("no vessel lies within 3 mm of the seed at " + in_words(seed.position_mm),
                         "seed", "Place the seed inside a vessel that the segmentation found.");
    return *nearest;
}

// Speed grows with the distance from the wall: the middle of a trunk runs ahead.
FloatVolume speed_in(const Mask& vessels, Job& job) {
    FloatVolume speed = distance_from_boundary(vessels, MarchingOrder::first, job);
    for (float& s : speed.voxels) s *= s;
    return speed;
}

}  // namespace

Mask label_systems(const Mask& vessels, const std::vector<VesselSeed>& seeds, Job& job) {
    std::vector<std::uint8_t> systems;
    for (const VesselSeed& seed : seeds) {
        if (seed.system == 0)
            throw InputError("a seed names system 0", "seed", "Number the systems from 1.");
        systems.push_back(seed.system);
    }
    std::sort(systems.begin(), systems.end());
    systems.erase(std::unique(systems.begin(), systems.end()), systems.end());

    const FloatVolume speed = speed_in(vessels, job);
    Mask labels(vessels.grid);
    FloatVolume first(vessels.grid, std::numeric_limits<float>::infinity());
    for (const std::uint8_t system : systems) {
        std::vector<std::size_t> starts;
        for (const VesselSeed& seed : seeds)
            if (seed.system == system) starts.push_back(voxel_near(vessels, seed));
        const FloatVolume arrival = arrival_times(speed, starts, MarchingOrder::first, job);
        for (std::size_t i = 0; i < labels.voxels.size(); ++i)
            if (arrival.voxels[i] < first.voxels[i]) {
                first.voxels[i] = arrival.voxels[i];
                labels.voxels[i] = system;
            }
    }
    return labels;
}

std::size_t reassign_overlap(Mask& systems, const std::vector<VesselSeed>& seeds,
                             const VesselSeed& correction, Job& job) {
    const std::size_t start = voxel_near(systems, correction);
    const std::uint8_t owner = systems.voxels[start];
    if (owner == correction.system) return 0;
    Mask within(systems.grid);
    for (std::size_t i = 0; i < within.voxels.size(); ++i)
        within.voxels[i] = systems.voxels[i] == owner;
    std::vector<std::size_t> own;
    for (const VesselSeed& seed : seeds)
        if (seed.system == owner) own.push_back(voxel_near(within, seed));
    const FloatVolume speed = speed_in(within, job);
    const FloatVolume ours = arrival_times(speed, {start}, MarchingOrder::first, job);
    const FloatVolume theirs = arrival_times(speed, own, MarchingOrder::first, job);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < systems.voxels.size(); ++i)
        if (ours.voxels[i] < theirs.voxels[i]) {
            systems.voxels[i] = correction.system;
            ++changed;
        }
    return changed;
}

}  // namespace hepatica
