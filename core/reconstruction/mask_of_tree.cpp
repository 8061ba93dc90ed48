// SPDX-License-Identifier: GPL-3.0-or-later
// Relabels voxels by the nearest centreline and by majority vote over connected pieces.
#include "core/reconstruction/mask_of_tree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "core/image/morphology.h"
#include "core/image/voxel_loop.h"
#include "core/segmentation/vessel_systems.h"

namespace hepatica {

namespace {

using Votes = std::map<VascularSystem, int>;

// votes[piece]: number of centreline points of each system in a piece.
std::vector<Votes> votes_of(const Components& pieces, const VesselTree& tree) {
    std::vector<Votes> votes(pieces.sizes.size() + 1);
    for (const VesselSegment& segment : tree.segments)
        for (const Vec3& point : segment.points_mm)
            if (holds(pieces.labels.grid, point))
                ++votes[value_at(pieces.labels, point)][segment.system];
    return votes;
}

// Centreline points in the mask; those of bridges lie outside it.
std::vector<VesselSeed> centreline_seeds(const Mask& mask, const VesselTree& tree,
                                         std::vector<VesselSeed> seeds) {
    std::erase_if(seeds, [&](const VesselSeed& seed) {
        return !holds(mask.grid, seed.position_mm) || value_at(mask, seed.position_mm) == 0;
    });
    for (const VesselSegment& segment : tree.segments)
        for (const Vec3& point : segment.points_mm)
            if (value_at(mask, point) != 0) seeds.push_back({point, segment.system});
    return seeds;
}

VascularSystem most_voted(const Votes& votes) {
    return std::ranges::max_element(votes, {}, &Votes::value_type::second)->first;
}

}  // namespace

void follow_tree(Mask& mask, const VesselTree& tree, bool anew, Job& job,
                 const std::vector<VesselSeed>& left_out) {
    if (anew) mask = label_systems(mask, centreline_seeds(mask, tree, left_out), job);
    constexpr auto unknown = static_cast<std::uint8_t>(VascularSystem::unknown);
    Mask open(mask.grid);
    for_each_voxel(mask.voxels.size(), job,
                   [&](std::size_t i) { open.voxels[i] = mask.voxels[i] == unknown; });
    const Components pieces = connected_components(open, Connectivity::all26, job);
    const std::vector<Votes> votes = votes_of(pieces, tree);
    for_each_voxel(mask.voxels.size(), job, [&](std::size_t i) {
        const std::uint32_t piece = pieces.labels.voxels[i];
        if (piece != 0 && !votes[piece].empty())
            mask.voxels[i] = static_cast<std::uint8_t>(most_voted(votes[piece]));
    });
}

}  // namespace hepatica
