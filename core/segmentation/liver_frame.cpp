// SPDX-License-Identifier: GPL-3.0-or-later
// Crop, anti-aliasing blur, linear resampling to cubes, and closing of the liver mask.
#include "core/segmentation/liver_frame.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/image/filters.h"
#include "core/image/memory_limit.h"
#include "core/image/voxel_loop.h"
#include "core/segmentation/liver_region.h"

namespace hepatica {

namespace {

constexpr double margin_mm = 6.0;
// Expert masks leave out the main branches of the portal vein and part of the vena cava.
constexpr double closing_mm = 8.0;
// At least: measure_tissue() has five images of floats and two masks at once, other steps have
// more. A mask of the whole body in place of the liver makes 500 million cubes.
constexpr std::int64_t bytes_per_cube = 22;

// The box of CT voxels that contains the liver, with a margin.
IndexBox box_in(const Grid& ct, const Mask& liver) {
    const IndexBox box = bounding_box(liver);
    if (box.empty())
        throw InputError("the liver mask is empty", "liver mask",
                         "Give a mask in which the liver is not 0.");
    Vec3 low = Vec3::Constant(1e30);
    Vec3 high = Vec3::Constant(-1e30);
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 index;
        for (std::size_t a = 0; a < 3; ++a)
            index[static_cast<Eigen::Index>(a)] =
                (corner >> a & 1) ? box.end[a] - 1.0 : box.begin[a];
        const Vec3 in_ct = ct.to_index(liver.grid.to_mm(index));
        low = low.cwiseMin(in_ct);
        high = high.cwiseMax(in_ct);
    }
    IndexBox in_ct;
    for (std::size_t a = 0; a < 3; ++a) {
        const auto axis = static_cast<Eigen::Index>(a);
        const double margin = margin_mm / ct.spacing_mm[axis];
        in_ct.begin[a] = std::max(0, static_cast<int>(std::floor(low[axis] - margin)));
        in_ct.end[a] = std::min(ct.dims[a], static_cast<int>(std::ceil(high[axis] + margin)) + 1);
    }
    if (in_ct.empty())
        throw InputError("the liver mask lies outside the CT", "liver mask",
                         "Give the mask of the same patient, in the same space as the CT.");
    return in_ct;
}

// to_float(crop(ct, box)). Throws Cancelled.
FloatVolume part_of(const Volume& ct, const IndexBox& box, const Job& job) {
    FloatVolume part = filled_image(crop(ct.grid, box), 0.0f, job);
    for (int z = 0; z < part.grid.dims[2]; ++z) {
        job.throw_if_cancelled();
        for (int y = 0; y < part.grid.dims[1]; ++y)
            std::copy_n(&ct.at(box.begin[0], box.begin[1] + y, box.begin[2] + z), part.grid.dims[0],
                        &part.at(0, y, z));
    }
    return part;
}

}  // namespace

LiverFrame make_liver_frame(const Volume& ct, const Mask& liver, double spacing_mm, Job& job) {
    if (!(spacing_mm >= 0.3 && spacing_mm <= 1.5))
        throw InputError("a working spacing of " + number_text(spacing_mm) + " mm was asked for",
                         "segmentation", "Use 0.3 to 1.5 mm.");
    FloatVolume part = part_of(ct, box_in(ct.grid, liver), job);
    Vec3 blur = Vec3::Zero();  // prevents aliasing where the cubes are coarser than the voxels
    for (Eigen::Index a = 0; a < 3; ++a) {
        const double ratio = spacing_mm / part.grid.spacing_mm[a];
        if (ratio > 1.01) blur[a] = 0.4 * part.grid.spacing_mm[a] * std::sqrt(ratio * ratio - 1.0);
    }
    in_part(job, 0.1, 0.3, [&] { gaussian_smooth(part, blur, job); });
    LiverFrame frame;
    const Grid cubes = respaced(part.grid, Vec3::Constant(spacing_mm));
    require_memory(bytes_of(cubes.dims[0], cubes.dims[1], cubes.dims[2], bytes_per_cube),
                   "liver mask");
    frame.intensity =
        in_part(job, 0.3, 0.5, [&] { return resample(part, cubes, Interpolation::linear, job); });
    part = FloatVolume();
    const Mask resampled =
        in_part(job, 0.5, 0.6, [&] { return resample_within(liver, cubes, job); });
    const JobPart rest(job, 0.6, 1.0);
    frame.liver = close_liver(resampled, closing_mm, job);
    return frame;
}

}  // namespace hepatica
