// SPDX-License-Identifier: GPL-3.0-or-later
// Histogram of voxels with a small gradient, its peaks, and the eroded band of intensities around
// each peak.
#include "core/segmentation/soft_organ.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/image/mask.h"
#include "core/image/morphology.h"

namespace hepatica {

namespace {

constexpr double organ_spacing_mm = 3.0;
constexpr double homogeneous_hu_per_mm = 3.5;  // steeper slopes are borders between organs
constexpr int histogram_bin_hu = 2;
// Half the band of intensities of an organ, in standard deviations of its peak in the smoothed
// histogram: narrow enough to exclude a heart that is 20 HU brighter, where the noise permits it.
constexpr double band_deviations = 2.2;
constexpr double narrowest_band_hu = 12.0;
constexpr double widest_band_hu = 24.0;
constexpr double neck_radius_mm = 6.0;  // organs that touch through less are separated
constexpr double rim_mm = 4.0;          // lost at the surface, where smoothing mixes it with fat
constexpr double rim_below_hu = 90.0;
constexpr double rim_above_hu = 30.0;

// A peak in the histogram of homogeneous soft tissue: an organ, or a group of them.
struct TissueMode {
    double hu = 0.0;
    double half_band_hu = 0.0;
};

// Half the width of a peak at half its height, on its narrower side.
double half_width_hu(const std::vector<double>& histogram, std::size_t peak) {
    std::size_t reach = 1;
    while (peak >= reach && peak + reach < histogram.size() &&
           std::min(histogram[peak - reach], histogram[peak + reach]) > 0.5 * histogram[peak])
        ++reach;
    return static_cast<double>(reach) * histogram_bin_hu;
}

std::vector<TissueMode> tissue_modes(const FloatVolume& smooth) {
    constexpr int bins = static_cast<int>(soft_organ_to_hu - soft_organ_from_hu) / histogram_bin_hu;
    std::vector<double> histogram(bins, 0.0);
    const Grid& grid = smooth.grid;
    for (int z = 0; z < grid.dims[2]; ++z)
        for (int y = 0; y < grid.dims[1]; ++y)
            for (int x = 0; x < grid.dims[0]; ++x) {
                const double v = smooth.at(x, y, z);
                if (v < soft_organ_from_hu || v >= soft_organ_to_hu) continue;
                if (slope_at(smooth, x, y, z) > homogeneous_hu_per_mm) continue;
                const auto bin = static_cast<int>((v - soft_organ_from_hu) / histogram_bin_hu);
                histogram[static_cast<std::size_t>(std::min(bin, bins - 1))] += 1.0;
            }
    std::vector<double> even(histogram.size(), 0.0);
    for (int i = 0; i < bins; ++i)
        for (int k = -6; k <= 6; ++k)
            if (i + k >= 0 && i + k < bins)
                even[static_cast<std::size_t>(i)] +=
                    histogram[static_cast<std::size_t>(i + k)] * std::exp(-k * k / 8.0);
    const double highest = *std::max_element(even.begin(), even.end());
    std::vector<TissueMode> modes;
    for (std::size_t i = 1; i + 1 < even.size(); ++i)
        if (even[i] > even[i - 1] && even[i] >= even[i + 1] && even[i] > 0.05 * highest)
            modes.push_back({soft_organ_from_hu + (static_cast<double>(i) + 0.5) * histogram_bin_hu,
                             std::clamp(band_deviations * half_width_hu(even, i) / 1.177,
                                        narrowest_band_hu, widest_band_hu)});
    return modes;
}

Mask band(const FloatVolume& smooth, double centre, double half_width) {
    Mask mask(smooth.grid);
    std::transform(smooth.voxels.begin(), smooth.voxels.end(), mask.voxels.begin(), [&](float v) {
        return static_cast<std::uint8_t>(std::abs(v - centre) < half_width);
    });
    return mask;
}

void intersect(Mask& mask, const Mask& with) {
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        if (!with.voxels[i]) mask.voxels[i] = 0;
}

double volume_ml(const Mask& mask) {
    return static_cast<double>(object_count(mask)) * mask.grid.spacing_mm.prod() / 1000.0;
}

}  // namespace

FloatVolume coarsened(const Volume& ct, Job& job) {
    std::array<int, 3> block{};
    Grid grid = ct.grid;
    Vec3 first_centre;
    for (std::size_t a = 0; a < 3; ++a) {
        const auto axis = static_cast<Eigen::Index>(a);
        block[a] =
            std::clamp(static_cast<int>(std::lround(organ_spacing_mm / ct.grid.spacing_mm[axis])),
                       1, ct.grid.dims[a]);
        grid.dims[a] = ct.grid.dims[a] / block[a];
        grid.spacing_mm[axis] *= block[a];
        first_centre[axis] = 0.5 * (block[a] - 1);
    }
    grid.origin_mm = ct.grid.to_mm(first_centre);
    FloatVolume mean(grid);
    const float share = 1.0f / static_cast<float>(block[0] * block[1] * block[2]);
    parallel_blocks(static_cast<std::size_t>(grid.dims[2]), 2,
                    [&](std::size_t begin, std::size_t end) {
                        job.throw_if_cancelled();
                        for (auto z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
                            for (int dz = 0; dz < block[2]; ++dz)
                                for (int y = 0; y < grid.dims[1] * block[1]; ++y) {
                                    const std::int16_t* row = &ct.at(0, y, z * block[2] + dz);
                                    float* out = &mean.at(0, y / block[1], z);
                                    for (int x = 0; x < grid.dims[0] * block[0]; ++x)
                                        out[x / block[0]] += share * static_cast<float>(row[x]);
                                }
                    });
    return mean;
}

float slope_at(const FloatVolume& hu, int x, int y, int z) {
    const Grid& grid = hu.grid;
    const auto along = [&](int dx, int dy, int dz, double spacing) {
        if (!grid.contains(x + dx, y + dy, z + dz) || !grid.contains(x - dx, y - dy, z - dz))
            return 0.0;
        return (hu.at(x + dx, y + dy, z + dz) - hu.at(x - dx, y - dy, z - dz)) / (2.0 * spacing);
    };
    const Vec3 gradient(along(1, 0, 0, grid.spacing_mm[0]), along(0, 1, 0, grid.spacing_mm[1]),
                        along(0, 0, 1, grid.spacing_mm[2]));
    return static_cast<float>(gradient.norm());
}

SoftOrgan largest_soft_organ(const FloatVolume& smooth, Job& job) {
    SoftOrgan largest;
    const std::vector<TissueMode> modes = tissue_modes(smooth);
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const auto share = [&](std::size_t done) {
            return static_cast<double>(done) / static_cast<double>(modes.size());
        };
        const JobPart part(job, share(i), share(i + 1));
        Mask core = largest_components(
            erode(band(smooth, modes[i].hu, modes[i].half_band_hu), neck_radius_mm, job),
            Connectivity::faces6);
        const double ml = volume_ml(core);
        if (ml > largest.core_ml)
            largest = {modes[i].hu, modes[i].half_band_hu, ml, std::move(core)};
        job.throw_if_cancelled();
    }
    return largest;
}

Mask with_all_alike(const SoftOrgan& organ, const FloatVolume& smooth, Job& job) {
    Mask alike = dilate(organ.core, neck_radius_mm, job);
    intersect(alike, band(smooth, organ.hu, organ.half_band_hu));
    Mask rim = dilate(alike, rim_mm, job);
    intersect(rim, band(smooth, organ.hu + 0.5 * (rim_above_hu - rim_below_hu),
                        0.5 * (rim_above_hu + rim_below_hu)));
    for (std::size_t i = 0; i < alike.voxels.size(); ++i) alike.voxels[i] |= rim.voxels[i];
    return largest_components(alike, Connectivity::faces6);
}

}  // namespace hepatica
