// SPDX-License-Identifier: GPL-3.0-or-later
// Crops the CT to the box, smooths it with a Gaussian and resamples it to cubes.
#include "core/opening/ct_around_liver.h"

#include <algorithm>
#include <cmath>

#include "core/image/filters.h"
#include "core/image/voxel_loop.h"
#include "core/patient/liver_segments.h"

namespace hepatica {
namespace {

constexpr double around_liver_mm = 30.0;    // shows ribs and spine
constexpr double around_vessels_mm = 50.0;  // the liver extends beyond its vessels
constexpr double smoothing_mm = 1.1;        // standard deviation
constexpr double voxel_mm = 1.25;
constexpr int most_voxels = 256;

Eigen::AlignedBox3d box_of_vessels(const VesselTree& tree) {
    Eigen::AlignedBox3d box;
    for (const VesselSegment& segment : tree.segments)
        for (const Vec3& point : segment.points_mm) box.extend(point);
    return box;
}

// The voxels of a box in space with a margin around it; empty where the grid holds none of them.
IndexBox voxels_within(const Eigen::AlignedBox3d& box_mm, double margin_mm, const Grid& grid) {
    Eigen::AlignedBox3d indices;
    for (int corner = 0; corner < 8; ++corner)
        indices.extend(
            grid.to_index(box_mm.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))));
    IndexBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        const double margin = margin_mm / grid.spacing_mm[i];
        box.begin[axis] = static_cast<int>(
            std::clamp(std::floor(indices.min()[i] - margin), 0.0, double(grid.dims[axis])));
        box.end[axis] = static_cast<int>(
            std::clamp(std::ceil(indices.max()[i] + margin) + 1.0, 0.0, double(grid.dims[axis])));
    }
    return box;
}

Vec3 cubes_for(const Grid& grid) {
    double longest_mm = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        longest_mm = std::max(longest_mm,
                              grid.dims[axis] * grid.spacing_mm[static_cast<Eigen::Index>(axis)]);
    return Vec3::Constant(std::max(voxel_mm, longest_mm / most_voxels));
}

}  // namespace

Volume ct_around_liver(const Volume& ct, const PatientCase& patient, const Mask& organs, Job& job) {
    Eigen::AlignedBox3d liver;
    if (!organs.voxels.empty()) liver = box_mm(bounding_box(liver_of(organs)), organs.grid);
    const bool known = !liver.isEmpty();
    const Eigen::AlignedBox3d about = known ? liver : box_of_vessels(patient.tree);
    if (about.isEmpty()) return {};
    const IndexBox box = voxels_within(about, known ? around_liver_mm : around_vessels_mm, ct.grid);
    if (box.empty()) return {};
    FloatVolume part = to_float(crop(ct, box));
    job.throw_if_cancelled();
    in_part(job, 0.0, 0.5, [&] { gaussian_smooth(part, Vec3::Constant(smoothing_mm), job); });
    const FloatVolume cubes = in_part(job, 0.5, 1.0, [&] {
        return resample(part, respaced(part.grid, cubes_for(part.grid)), Interpolation::cubic, job);
    });
    Volume drawn(cubes.grid);
    for_each_voxel(cubes.voxels.size(), job, [&](std::size_t i) {
        drawn.voxels[i] = static_cast<std::int16_t>(
            std::lround(std::clamp(cubes.voxels[i], -32768.0F, 32767.0F)));
    });
    return drawn;
}

}  // namespace hepatica
