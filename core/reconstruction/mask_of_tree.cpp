// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/mask_of_tree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "core/image/morphology.h"

namespace hepatica {

namespace {

using Votes = std::map<VascularSystem, int>;

// votes[piece]: how many points of each system lie in it.
std::vector<Votes> votes_of(const Components& pieces, const VesselTree& tree) {
    std::vector<Votes> votes(pieces.sizes.size() + 1);
    const Grid& grid = pieces.labels.grid;
    for (const VesselSegment& segment : tree.segments)
        for (const Vec3& point : segment.points_mm) {
            const Vec3 index = grid.to_index(point);
            const auto x = static_cast<int>(std::lround(index.x()));
            const auto y = static_cast<int>(std::lround(index.y()));
            const auto z = static_cast<int>(std::lround(index.z()));
            if (grid.contains(x, y, z)) ++votes[pieces.labels.at(x, y, z)][segment.system];
        }
    return votes;
}

VascularSystem most_voted(const Votes& votes) {
    return std::ranges::max_element(votes, {}, &Votes::value_type::second)->first;
}

}  // namespace

bool follow_tree(Mask& mask, const VesselTree& tree, bool only_tree) {
    constexpr auto unknown = static_cast<std::uint8_t>(VascularSystem::unknown);
    Mask open(mask.grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) open.voxels[i] = mask.voxels[i] == unknown;
    const Components pieces = connected_components(open, Connectivity::all26);
    const std::vector<Votes> votes = votes_of(pieces, tree);
    bool removed = false;
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const std::uint32_t piece = pieces.labels.voxels[i];
        if (piece == 0) continue;
        if (!votes[piece].empty()) {
            mask.voxels[i] = static_cast<std::uint8_t>(most_voted(votes[piece]));
        } else if (only_tree) {
            mask.voxels[i] = 0;
            removed = true;
        }
    }
    return removed;
}

}  // namespace hepatica
