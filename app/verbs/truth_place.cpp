// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verbs/truth_place.h"

#include <cmath>

#include "core/base/error.h"
#include "core/image/filters.h"

namespace hepatica {

BoxMm box_of(const VesselTree& tree) {
    BoxMm box;
    for (const VesselSegment& segment : tree.segments)
        for (const Vec3& point : segment.points_mm) box.extend(point);
    return box;
}

BoxMm box_of(const Mask& mask) {
    const IndexBox voxels = bounding_box(mask);
    BoxMm box;
    for (int corner = 0; !voxels.empty() && corner < 8; ++corner)
        box.extend(mask.grid.to_mm((corner & 1) != 0 ? voxels.end[0] - 1 : voxels.begin[0],
                                   (corner & 2) != 0 ? voxels.end[1] - 1 : voxels.begin[1],
                                   (corner & 4) != 0 ? voxels.end[2] - 1 : voxels.begin[2]));
    return box;
}

std::string text_of(double millimetres) {
    return std::to_string(std::lround(millimetres)) + " mm";
}

void require_overlap(const BoxMm& of_case, const std::filesystem::path& patient,
                     const BoxMm& of_truth, const std::filesystem::path& truth) {
    if (of_case.isEmpty() || of_truth.isEmpty() || of_case.intersects(of_truth)) return;
    throw InputError("its vessels and those of " + patient.string() + " lie " +
                         text_of(of_case.exteriorDistance(of_truth)) + " apart",
                     truth.string(),
                     "Give the truth of the same patient, in the same coordinates (LPS, mm)");
}

}  // namespace hepatica
