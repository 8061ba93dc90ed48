// SPDX-License-Identifier: GPL-3.0-or-later
// For each candidate voxel, rays along the 26 grid directions are followed until they meet the
// organ, fat, gas or bone, leave the image or are 60 mm long. Cost: 26 such rays per candidate, in
// parallel over slices.
#include "core/segmentation/enclosed_tissue.h"

#include <vector>

#include "core/base/parallel.h"
#include "core/image/morphology.h"
#include "core/segmentation/neighbours.h"

namespace hepatica {

namespace {

constexpr double way_mm = 60.0;
constexpr double least_share = 0.65;
constexpr int least_ways = 9;
constexpr float tissue_from_hu = -10.0f, tissue_to_hu = 250.0f;
constexpr float fat_below_hu = -40.0f;  // below tissue_from_hu, so that noise does not end a ray
constexpr double thinnest_radius_mm = 4.0;

struct Way {
    Index3 step;
    int steps;
};

std::vector<Way> ways_of(const Grid& grid) {
    std::vector<Way> ways;
    for (const auto& [step, length_mm] : neighbour_steps(grid))
        ways.push_back({step, static_cast<int>(way_mm / length_mm)});
    return ways;
}

enum class End { organ, elsewhere, unseen };

// The axis of the grid that runs most along the body, whichever way the slices were stored.
std::size_t body_axis(const Grid& grid) {
    Eigen::Index axis = 0;
    grid.direction.row(2).cwiseAbs().maxCoeff(&axis);
    return static_cast<std::size_t>(axis);
}

// Unseen is a ray that leaves the image and also runs along the body: a scan often ends within the
// body there, where the rest of the organ may lie; across it shows all of the body.
End end_of(const Way& way, Index3 at, const FloatVolume& smooth, const Mask& organ,
           std::size_t along_body) {
    for (int step = 0; step < way.steps; ++step) {
        for (std::size_t a = 0; a < 3; ++a) at[a] += way.step[a];
        if (!smooth.grid.contains(at[0], at[1], at[2]))
            return way.step[along_body] != 0 ? End::unseen : End::elsewhere;
        if (organ.at(at[0], at[1], at[2]) != 0) return End::organ;
        const float hu = smooth.at(at[0], at[1], at[2]);
        if (hu < fat_below_hu || hu > tissue_to_hu) return End::elsewhere;
    }
    return End::elsewhere;
}

bool encloses(const Mask& organ, const FloatVolume& smooth, const Index3& at,
              const std::vector<Way>& ways, std::size_t along_body) {
    int seen = 0, reached = 0;
    for (const Way& way : ways) {
        const End end = end_of(way, at, smooth, organ, along_body);
        if (end == End::unseen) continue;
        ++seen;
        if (end == End::organ) ++reached;
    }
    return seen >= least_ways && reached >= least_share * seen;
}

}  // namespace

Mask enclosed_tissue(const FloatVolume& smooth, const Mask& organ, Job& job) {
    const Grid& grid = smooth.grid;
    const std::vector<Way> ways = ways_of(grid);
    const std::size_t along_body = body_axis(grid);
    Mask enclosed = organ;
    parallel_blocks(static_cast<std::size_t>(grid.dims[2]), 1, [&](std::size_t slice, std::size_t) {
        job.throw_if_cancelled();
        const auto z = static_cast<int>(slice);
        for (int y = 0; y < grid.dims[1]; ++y)
            for (int x = 0; x < grid.dims[0]; ++x) {
                const float hu = smooth.at(x, y, z);
                if (organ.at(x, y, z) == 0 && hu >= tissue_from_hu && hu <= tissue_to_hu &&
                    encloses(organ, smooth, {x, y, z}, ways, along_body))
                    enclosed.at(x, y, z) = 1;
            }
    });
    // The opening includes the organ, so that the rim of a wide piece is not removed as thin.
    enclosed = open(enclosed, thinnest_radius_mm, job);
    for (std::size_t i = 0; i < enclosed.voxels.size(); ++i)
        if (organ.voxels[i] != 0) enclosed.voxels[i] = 0;
    return enclosed;
}

}  // namespace hepatica
