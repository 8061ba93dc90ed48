// SPDX-License-Identifier: GPL-3.0-or-later
// Histograms of the line strength of the image and of its negative, accumulated from the strongest
// lines downwards.
#include "core/segmentation/false_line_threshold.h"

#include <algorithm>
#include <vector>

#include "core/image/voxel_loop.h"
#include "core/segmentation/line_coherence.h"

namespace hepatica {

namespace {

constexpr double false_share = 0.02;
constexpr std::size_t bins_per_deviation = 20;
constexpr std::size_t most_bins = 4 * bins_per_deviation;

// Number of voxels of `where` by the strength of the line through them; the last bin holds all
// stronger ones.
std::vector<std::size_t> histogram_of_lines(const FloatVolume& values, double deviation,
                                            const Mask& liver, const Mask& where, Job& job) {
    Mask candidates(values.grid);
    for_each_voxel(candidates.voxels.size(), job, [&](std::size_t i) {
        candidates.voxels[i] = liver.voxels[i] && values.voxels[i] > static_cast<float>(deviation);
    });
    const FloatVolume lines = line_coherence(values, candidates, LineOptions{}, job);
    std::vector<std::size_t> histogram(most_bins);
    const double bins_per_unit = bins_per_deviation / deviation;
    for_each_voxel_in_order(lines.voxels.size(), job, [&](std::size_t i) {
        if (where.voxels[i] && lines.voxels[i] > 0.0f)
            ++histogram[std::min(most_bins - 1,
                                 static_cast<std::size_t>(lines.voxels[i] * bins_per_unit))];
    });
    return histogram;
}

}  // namespace

double false_line_threshold(const FloatVolume& values, double deviation, const Mask& liver,
                            const Mask& where, Job& job) {
    const std::vector<std::size_t> bright = in_part(
        job, 0.0, 0.5, [&] { return histogram_of_lines(values, deviation, liver, where, job); });
    FloatVolume negative = copied_image(values, job);
    for_each_voxel(negative.voxels.size(), job,
                   [&](std::size_t i) { negative.voxels[i] = -negative.voxels[i]; });
    const std::vector<std::size_t> dark = in_part(
        job, 0.5, 1.0, [&] { return histogram_of_lines(negative, deviation, liver, where, job); });
    std::size_t bin = most_bins;
    double bright_above = 0.0, dark_above = 0.0;
    for (; bin > bins_per_deviation; --bin) {
        bright_above += static_cast<double>(bright[bin - 1]);
        dark_above += static_cast<double>(dark[bin - 1]);
        if (dark_above > false_share * bright_above) break;
    }
    return deviation * static_cast<double>(bin) / static_cast<double>(bins_per_deviation);
}

}  // namespace hepatica
