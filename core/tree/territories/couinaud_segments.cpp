// SPDX-License-Identifier: GPL-3.0-or-later
// Labels the portal branches and assigns each voxel to the nearest one.
#include "core/tree/territories/couinaud_segments.h"

#include <algorithm>
#include <cmath>

#include "core/image/filters.h"
#include "core/tree/territories/nearest_branch.h"

namespace hepatica {

namespace {

constexpr double sure = 0.8;

double voxel_ml(const Grid& grid) {
    return grid.spacing_mm.prod() * 1e-3;
}

}  // namespace

std::optional<LabelledPortalVein> label_portal_vein(const VesselTree& tree, const Mask& liver) {
    const std::size_t voxels = object_count(liver);
    const bool portal = std::ranges::any_of(tree.segments, [](const VesselSegment& segment) {
        return segment.system == VascularSystem::portal && !segment.closes_loop;
    });
    if (voxels == 0 || !portal) return std::nullopt;
    const double liver_ml = static_cast<double>(voxels) * voxel_ml(liver.grid);
    LabelledPortalVein found;
    found.frame = couinaud_frame(tree, box_mm(bounding_box(liver), liver.grid), liver_ml);
    found.branches = label_branches(tree, found.frame);
    return found;
}

std::optional<CouinaudSegments> couinaud_segments(const VesselTree& tree, const Mask& liver,
                                                  Job& job) {
    auto portal = label_portal_vein(tree, liver);
    if (!portal) return std::nullopt;
    CouinaudSegments found{{std::move(*portal)}, Mask(liver.grid), 0.0};
    std::vector<std::int32_t> owners(tree.segments.size(), no_owner);
    for (std::size_t s = 0; s < owners.size(); ++s)
        if (found.branches[s].segment != 0) owners[s] = static_cast<std::int32_t>(s);
    const Image<std::int32_t> branch = nearest_branch(liver, tree, owners, job);
    std::size_t unsure = 0;
    for (std::size_t i = 0; i < branch.voxels.size(); ++i) {
        if (branch.voxels[i] == no_owner) continue;
        const BranchLabel& label = found.branches[branch.voxels[i]];
        found.labels.voxels[i] = static_cast<std::uint8_t>(label.segment);
        if (label.confidence < sure) ++unsure;
    }
    found.unsure_share = static_cast<double>(unsure) / static_cast<double>(object_count(liver));
    return found;
}

std::array<double, couinaud_count> segment_volumes_ml(const Mask& labels) {
    std::array<std::size_t, couinaud_count> count{};
    for (const std::uint8_t label : labels.voxels)
        if (label >= 1 && label <= couinaud_count) ++count[label - 1];
    std::array<double, couinaud_count> volume{};
    for (std::size_t k = 0; k < volume.size(); ++k)
        volume[k] = static_cast<double>(count[k]) * voxel_ml(labels.grid);
    return volume;
}

}  // namespace hepatica
