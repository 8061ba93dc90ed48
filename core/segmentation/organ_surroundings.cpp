// SPDX-License-Identifier: GPL-3.0-or-later
// Shares of bone and lung in a shell around the organ, and the limits for a liver.
#include "core/segmentation/organ_surroundings.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "core/image/morphology.h"

namespace hepatica {

namespace {

constexpr double near_mm = 12.0;
constexpr float bone_from_hu = 250.0f;
constexpr float lung_from_hu = -950.0f, lung_to_hu = -400.0f;
// Half-way between a synthetic liver (no bone, 0.15 of lung) and a synthetic head (0.65 of bone) or
// chest (0.56 of lung).
constexpr double most_bone = 0.33;
constexpr double most_lung = 0.35;

std::string percent(double share) {
    return std::to_string(std::lround(100.0 * share)) + " %";
}

}  // namespace

OrganSurroundings surroundings_of(const Mask& organ, const FloatVolume& hu, Job& job) {
    if (std::ranges::count(organ.voxels, 0) == std::ssize(organ.voxels))
        throw NoLiverFound(
            "no liver was found: the largest soft organ has no border that it is told by", "CT",
            "Check that the scan shows the liver, or give a liver mask.");
    const Mask grown = dilate(organ, near_mm, job);
    std::size_t all = 0, bone = 0, lung = 0;
    for (std::size_t i = 0; i < grown.voxels.size(); ++i) {
        if (grown.voxels[i] == 0 || organ.voxels[i] != 0) continue;
        const float value = hu.voxels[i];
        ++all;
        if (value > bone_from_hu) ++bone;
        if (value > lung_from_hu && value < lung_to_hu) ++lung;
    }
    if (all == 0) return {};
    return {static_cast<double>(bone) / static_cast<double>(all),
            static_cast<double>(lung) / static_cast<double>(all)};
}

void require_surroundings_of_liver(const OrganSurroundings& around) {
    const std::string remedy =
        "Choose a CT of the upper abdomen; where it does show the liver, give a liver mask.";
    if (around.bone > most_bone)
        throw NoLiverFound("no liver was found: the largest soft organ is enclosed by bone (" +
                               percent(around.bone) + " of what lies around it), as a brain is",
                           "CT", remedy);
    if (around.lung > most_lung)
        throw NoLiverFound("no liver was found: the largest soft organ lies between the lungs (" +
                               percent(around.lung) + " of what lies around it), as a heart does",
                           "CT", remedy);
}

}  // namespace hepatica
