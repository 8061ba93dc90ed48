// SPDX-License-Identifier: GPL-3.0-or-later
// Gaussian smoothing at each scale, central second differences, and closed-form eigenvalues.
#include "core/segmentation/vesselness.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/image/filters.h"

namespace hepatica {

std::array<float, 3> eigenvalues(const Symmetric3& matrix) {
    // Smith (1961), with the deviator scaled to unit size to suit float precision.
    const auto [xx, yy, zz, xy, xz, yz] = matrix;
    const float mean = (xx + yy + zz) / 3.0f;
    const float dx = xx - mean;
    const float dy = yy - mean;
    const float dz = zz - mean;
    const float squared = dx * dx + dy * dy + dz * dz + 2.0f * (xy * xy + xz * xz + yz * yz);
    const float size = std::sqrt(squared / 6.0f);
    if (!(size > 1e-6f * std::abs(mean)) || size == 0.0f) return {mean, mean, mean};
    const float s = 1.0f / size;
    const float a = dx * s;
    const float b = dy * s;
    const float c = dz * s;
    const float d = xy * s;
    const float e = xz * s;
    const float f = yz * s;
    const float half_determinant =
        0.5f * (a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e));
    const float angle = std::acos(std::clamp(half_determinant, -1.0f, 1.0f)) / 3.0f;
    const float third = 2.0f * std::numbers::pi_v<float> / 3.0f;
    const float high = 2.0f * std::cos(angle);
    const float low = 2.0f * std::cos(angle + third);
    return {mean + size * low, mean - size * (high + low), mean + size * high};
}

namespace {

// The strength of a bright tube: the weaker of the two cross-sectional curvatures, which is small
// for a sheet, lowered by a curvature along the third axis, which a blob has.
float tube_response(const Symmetric3& hessian) {
    const auto [strong, weak, along] = eigenvalues(hessian);
    if (weak >= 0.0f) return 0.0f;
    const float blob = std::max(-along, 0.0f) / -weak;  // 0 for a tube, 1 for a ball
    return -weak * std::sqrt(std::max(0.0f, 1.0f - blob));
}

// Raises the maximum so far to the response at one scale. Border voxels, where no curvature can be
// measured, are left alone.
void add_scale(const FloatVolume& smooth, float gain, FloatVolume& response, Job& job) {
    const Grid& grid = smooth.grid;
    const std::ptrdiff_t sy = grid.dims[0];
    const std::ptrdiff_t sz = sy * grid.dims[1];
    parallel_blocks(
        static_cast<std::size_t>(std::max(grid.dims[2] - 2, 0)), 2,
        [&](std::size_t begin, std::size_t end) {
            job.throw_if_cancelled();
            for (auto z = static_cast<int>(begin) + 1; z < static_cast<int>(end) + 1; ++z)
                for (int y = 1; y + 1 < grid.dims[1]; ++y) {
                    const float* row = &smooth.voxels[grid.offset(0, y, z)];
                    float* out = &response.voxels[grid.offset(0, y, z)];
                    for (int x = 1; x + 1 < grid.dims[0]; ++x) {
                        const float* p = row + x;
                        const float twice = 2.0f * p[0];
                        const float xx = p[1] - twice + p[-1];
                        const float yy = p[sy] - twice + p[-sy];
                        const float zz = p[sz] - twice + p[-sz];
                        if (xx + yy + zz >= 0.0f) continue;  // a bright tube has a negative trace
                        const float xy = 0.25f * (p[1 + sy] - p[1 - sy] - p[sy - 1] + p[-1 - sy]);
                        const float xz = 0.25f * (p[1 + sz] - p[1 - sz] - p[sz - 1] + p[-1 - sz]);
                        const float yz =
                            0.25f * (p[sy + sz] - p[sy - sz] - p[sz - sy] + p[-sy - sz]);
                        out[x] = std::max(out[x], gain * tube_response({xx, yy, zz, xy, xz, yz}));
                    }
                }
        });
}

}  // namespace

FloatVolume vesselness(const FloatVolume& intensity, const std::vector<double>& sigmas_mm,
                       Job& job) {
    const double h = intensity.grid.spacing_mm[0];
    for (const double s : {intensity.grid.spacing_mm[1], intensity.grid.spacing_mm[2]})
        if (std::abs(s - h) > 0.01 * h)
            throw InputError("vesselness needs cubic voxels, these are " + number_text(h) + " by " +
                                 number_text(s) + " mm",
                             "", "Resample the volume to one spacing first.");
    FloatVolume response(intensity.grid);
    const auto count = static_cast<double>(sigmas_mm.size());
    double done = 0.0;
    for (const double sigma : sigmas_mm) {
        if (!(sigma >= 0.5 * h))
            throw InputError(
                "a vesselness scale of " + number_text(sigma) + " mm is below half a voxel", "",
                "Use scales of at least half the spacing.");
        const JobPart part(job, done / count, (done + 1.0) / count);
        FloatVolume smooth = intensity;
        gaussian_smooth(smooth, Vec3::Constant(sigma), job);
        add_scale(smooth, static_cast<float>(sigma * sigma / (h * h)), response, job);
        job.advance(1.0);
        done += 1.0;
    }
    return response;
}

}  // namespace hepatica
