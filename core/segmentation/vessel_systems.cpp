// SPDX-License-Identifier: GPL-3.0-or-later
// One Dijkstra search from all seeds at once, with a cost per mm of 1 / (distance from the wall)^2.
#include "core/segmentation/vessel_systems.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/image/voxel_loop.h"
#include "core/segmentation/fast_marching.h"
#include "core/segmentation/neighbours.h"

namespace hepatica {

namespace {

constexpr double seed_reach_mm = 3.0;

std::string in_words(const Vec3& position) {
    return number_text(position[0]) + ", " + number_text(position[1]) + ", " +
           number_text(position[2]) + " mm";
}

// The object voxel that contains a position, if any.
std::optional<std::size_t> object_voxel_around(const Mask& vessels, const Vec3& position_mm) {
    const std::optional<Index3> voxel = voxel_at(vessels.grid, position_mm);
    if (!voxel) return std::nullopt;
    const std::size_t offset = vessels.grid.offset((*voxel)[0], (*voxel)[1], (*voxel)[2]);
    return vessels.voxels[offset] != 0 ? std::optional(offset) : std::nullopt;
}

// The object voxel whose centre is nearest to a position, within seed_reach_mm; ties by index. In
// slices thicker than twice that reach, also the one that contains the position. Throws InputError
// where there is none.
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
    if (!nearest) nearest = object_voxel_around(vessels, seed.position_mm);
    if (!nearest)
        throw InputError("no vessel lies within 3 mm of the seed at " + in_words(seed.position_mm),
                         "seed", "Place the seed inside a vessel that the segmentation found.");
    return *nearest;
}

constexpr auto unknown = static_cast<std::uint8_t>(VascularSystem::unknown);

// Time that a front needs per millimetre: 1 / (distance from the wall)^2, so it is fastest in the
// middle of wide vessels.
FloatVolume slowness_in(const Mask& vessels, Job& job) {
    FloatVolume slowness = distance_from_boundary(vessels, MarchingOrder::first, job);
    for_each_voxel(slowness.voxels.size(), job, [&](std::size_t i) {
        float& s = slowness.voxels[i];
        if (s > 0.0f) s = 1.0f / (s * s);
    });
    return slowness;
}

// Fronts of all systems in one queue. Voxels are settled by time, then by index, and of two fronts
// that reach a voxel at the same time the first keeps it, so the result is deterministic.
class Fronts {
  public:
    Fronts(const Mask& vessels, Job& job)
        : vessels_(vessels),
          slowness_(in_part(job, 0.0, 0.5, [&] { return slowness_in(vessels, job); })),
          steps_(neighbour_steps(vessels.grid)),
          time_(filled_image(vessels.grid, std::numeric_limits<double>::infinity(), job)),
          labels_(vessels.grid) {
        for_each_voxel_in_order(vessels.voxels.size(), job, [&](std::size_t i) {
            if (vessels.voxels[i] == 0) return;
            labels_.voxels[i] = unknown;
            ++objects_;
        });
    }

    void start(std::size_t voxel, VascularSystem system) { arrive(voxel, 0.0, system); }

    Mask run(Job& job) {
        const JobPart part(job, 0.5, 1.0);
        std::size_t settled = 0;
        while (!queue_.empty()) {
            const auto [time, voxel] = queue_.top();
            queue_.pop();
            if (time > time_.voxels[voxel]) continue;  // reached earlier by another path
            if (++settled % 16384 == 0)
                job.advance(static_cast<double>(settled) / static_cast<double>(objects_));
            spread(voxel);
        }
        return std::move(labels_);
    }

  private:
    void arrive(std::size_t voxel, double time, VascularSystem system) {
        if (time >= time_.voxels[voxel]) return;
        time_.voxels[voxel] = time;
        labels_.voxels[voxel] = static_cast<std::uint8_t>(system);
        queue_.emplace(time, voxel);
    }

    void spread(std::size_t voxel) {
        const Grid& grid = vessels_.grid;
        const auto [x, y, z] = grid.index_of(voxel);
        for (const auto& [step, length_mm] : steps_) {
            if (!grid.contains(x + step[0], y + step[1], z + step[2])) continue;
            const std::size_t next = grid.offset(x + step[0], y + step[1], z + step[2]);
            if (vessels_.voxels[next] == 0) continue;
            const double mean = 0.5 * (slowness_.voxels[voxel] + slowness_.voxels[next]);
            arrive(next, time_.voxels[voxel] + mean * length_mm,
                   VascularSystem{labels_.voxels[voxel]});
        }
    }

    using Arrival = std::pair<double, std::size_t>;  // time, voxel

    const Mask& vessels_;
    FloatVolume slowness_;
    std::array<NeighbourStep, 26> steps_;
    Image<double> time_;
    Mask labels_;
    std::size_t objects_ = 0;
    std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> queue_;
};

}  // namespace

void require_seeds_in_vessels(const Mask& vessels, const std::vector<VesselSeed>& seeds) {
    for (const VesselSeed& seed : seeds) voxel_near(vessels, seed);
}

Mask label_systems(const Mask& vessels, const std::vector<VesselSeed>& seeds, Job& job) {
    Fronts fronts(vessels, job);
    for (const VesselSeed& seed : seeds) {
        const std::size_t voxel = voxel_near(vessels, seed);
        if (seed.system != VascularSystem::unknown) fronts.start(voxel, seed.system);
    }
    return fronts.run(job);
}

}  // namespace hepatica
