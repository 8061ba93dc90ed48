// SPDX-License-Identifier: GPL-3.0-or-later
// Lobes judged by size and position relative to the right lobe, then thin parts found by an
// opening.
#include "core/segmentation/liver_neighbours.h"

#include <vector>

#include "core/image/morphology.h"
#include "core/segmentation/organ_lobes.h"

namespace hepatica {

namespace {

// Tuned on synthetic bodies (tests/segmentation/random_abdomen.h).
constexpr double smallest_ml = 8.0;
constexpr double left_mm = 40.0;
constexpr double lobe_behind_below_mm = 15.0;
constexpr double thin_behind_below_mm = 25.0;
constexpr double heart_left_mm = 20.0, heart_above_mm = 55.0;
constexpr double thin_radius_mm = 14.0;
constexpr double thin_margin_mm = 3.0;  // corners that the opening rounds off are not thin
constexpr double crumb_radius_mm = 4.0;

Vec3 centre_of(const Mask& mask) {
    Vec3 sum = Vec3::Zero();
    std::size_t count = 0;
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        if (mask.voxels[i] == 0) continue;
        const auto [x, y, z] = mask.grid.index_of(i);
        sum += mask.grid.to_mm(x, y, z);
        ++count;
    }
    return count > 0 ? Vec3(sum / static_cast<double>(count)) : sum;
}

bool behind_or_below(const Vec3& from_seat, double by_mm) {
    return from_seat.x() > left_mm && from_seat.y() - from_seat.z() > by_mm;
}

// For each lobe, whether it belongs to another organ.
std::vector<char> foreign_lobes(const Lobes& found, const Vec3& seat_mm) {
    const double voxel_ml = found.labels.grid.spacing_mm.prod() / 1000.0;
    std::vector<char> foreign(found.lobes.size(), 0);
    for (std::size_t k = 0; k < foreign.size(); ++k) {
        const Lobe& lobe = found.lobes[k];
        const Vec3 at = lobe.centre_mm - seat_mm;
        if (lobe.parent >= 0 && static_cast<double>(lobe.voxels) * voxel_ml >= smallest_ml)
            foreign[k] = behind_or_below(at, lobe_behind_below_mm) ||
                         (at.x() > heart_left_mm && at.z() > heart_above_mm);
    }
    // As many passes as the longest chain of parents can need.
    for (std::size_t pass = 0; pass < foreign.size(); ++pass)
        for (std::size_t k = 0; k < foreign.size(); ++k) {
            const Lobe& lobe = found.lobes[k];
            if (lobe.parent >= 0 && foreign[static_cast<std::size_t>(lobe.parent)] != 0 &&
                lobe.centre_mm.x() - seat_mm.x() > left_mm)
                foreign[k] = 1;
        }
    return foreign;
}

// Parenchyma that an opening by thin_radius_mm removes, where the liver is never that thin.
Mask thin_parts(const Mask& region, const Mask& parenchyma, const Vec3& seat_mm, Job& job) {
    const Mask thick = dilate(open(region, thin_radius_mm, job), thin_margin_mm, job);
    Mask thin(region.grid);
    for (std::size_t i = 0; i < thin.voxels.size(); ++i) {
        if (parenchyma.voxels[i] == 0 || thick.voxels[i] != 0) continue;
        const auto [x, y, z] = thin.grid.index_of(i);
        thin.voxels[i] = behind_or_below(thin.grid.to_mm(x, y, z) - seat_mm, thin_behind_below_mm);
    }
    return open(thin, crumb_radius_mm, job);
}

}  // namespace

Mask neighbours_in(const Mask& parenchyma, const Mask& enclosed, const Mask& seat, Job& job) {
    Mask region = parenchyma;
    for (std::size_t i = 0; i < region.voxels.size(); ++i)
        region.voxels[i] = parenchyma.voxels[i] != 0 || enclosed.voxels[i] != 0;
    const Vec3 seat_mm = centre_of(seat);
    const Lobes found = lobes_of(region, job);
    job.throw_if_cancelled();
    const std::vector<char> foreign = foreign_lobes(found, seat_mm);
    Mask neighbours(region.grid);
    for (std::size_t i = 0; i < region.voxels.size(); ++i) {
        const std::uint32_t label = found.labels.voxels[i];
        if (label == 0 || foreign[label - 1] == 0) continue;
        neighbours.voxels[i] = 1;
        region.voxels[i] = 0;
    }
    const Mask thin = thin_parts(region, parenchyma, seat_mm, job);
    for (std::size_t i = 0; i < thin.voxels.size(); ++i)
        if (thin.voxels[i] != 0) neighbours.voxels[i] = 1;
    return neighbours;
}

}  // namespace hepatica
