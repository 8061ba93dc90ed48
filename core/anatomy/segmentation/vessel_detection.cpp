// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/anatomy/segmentation/vessel_detection.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/anatomy/segmentation/line_coherence.h"
#include "core/anatomy/segmentation/minimal_surface.h"
#include "core/anatomy/segmentation/multi_layer.h"
#include "core/anatomy/segmentation/vessel_growth.h"
#include "core/anatomy/segmentation/vesselness.h"
#include "core/anatomy/skeleton/thinning.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/filters.h"
#include "core/image/morphology.h"

namespace hepatica {

namespace {

// All in multiples of the deviation that is left after smoothing by surface_sigma_mm.
constexpr double surface_sigma_mm = 0.6;
constexpr double candidate_deviations = 1.5;
constexpr double weak_deviations = 3.0;
constexpr double coherent_deviations = 3.5;
// Thick slices dim the thin vessels that lie in them: both are lowered by up to one deviation.
constexpr double undimmed_slices_mm = 1.5;
constexpr double dimming_slices_mm = 3.0;
// Between thick slices the organs around shine this far into the liver.
constexpr double dimmed_rim_mm = 1.8;
constexpr double tubular_deviations = 1.5;
// No single voxel says more than this, however bright: a line is many voxels.
constexpr double clip_below_deviations = 3.0;
constexpr double clip_above_deviations = 8.0;
constexpr double line_sigma_mm = 0.9;
constexpr double smallest_strong_mm3 = 8.0;
constexpr double smallest_vessel_mm3 = 200.0;
constexpr double wall_sigma_mm = 0.3;
constexpr double kept_branch_mm = 4.0;
constexpr double growth_mm = 1.6;
const std::vector<double> tube_sigmas_mm{0.8, 1.2, 1.8, 2.7};

struct Evidence {
    FloatVolume rise;  // smoothed excess
    double deviation = 0.0;
    double weak_hu = 0.0;
    double coherent_hu = 0.0;
};

double dimming(double slice_mm) {
    return std::clamp((slice_mm - undimmed_slices_mm) / (dimming_slices_mm - undimmed_slices_mm),
                      0.0, 1.0);
}

Evidence smoothed(const TissueContrast& tissue, double slice_mm, Job& job) {
    Evidence evidence;
    evidence.rise = tissue.excess;
    gaussian_smooth(evidence.rise, Vec3::Constant(surface_sigma_mm), job);
    job.throw_if_cancelled();
    const RobustSpread spread = robust_spread(evidence.rise, tissue.interior);
    job.throw_if_cancelled();
    for (float& v : evidence.rise.voxels) v -= static_cast<float>(spread.median);
    evidence.deviation = spread.deviation;
    evidence.weak_hu =
        tissue.threshold_hu.value_or((weak_deviations - dimming(slice_mm)) * spread.deviation);
    evidence.coherent_hu = (coherent_deviations - dimming(slice_mm)) * spread.deviation;
    return evidence;
}

Mask above(const FloatVolume& values, double threshold, const Mask& where) {
    Mask mask(values.grid);
    const auto limit = static_cast<float>(threshold);
    parallel_blocks(mask.voxels.size(), 65536, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            mask.voxels[i] = where.voxels[i] != 0 && values.voxels[i] > limit;
    });
    return mask;
}

// Excess clipped to what one voxel may say, smoothed by sigma_mm.
FloatVolume clipped(const TissueContrast& tissue, double deviation, double sigma_mm, Job& job) {
    FloatVolume values = tissue.excess;
    const auto low = static_cast<float>(-clip_below_deviations * deviation);
    const auto high = static_cast<float>(clip_above_deviations * deviation);
    for (float& v : values.voxels) v = std::clamp(v, low, high);
    gaussian_smooth(values, Vec3::Constant(sigma_mm), job);
    return values;
}

Mask coherent(const TissueContrast& tissue, const Mask& liver, const Evidence& evidence, Job& job) {
    const Mask candidates =
        above(evidence.rise, std::min(candidate_deviations * evidence.deviation, evidence.weak_hu),
              liver);
    job.advance(0.3);
    return above(line_coherence(clipped(tissue, evidence.deviation, line_sigma_mm, job), candidates,
                                LineOptions{}, job),
                 evidence.coherent_hu, liver);
}

Mask tubular(const TissueContrast& tissue, const Mask& liver, const Evidence& evidence, Job& job) {
    return above(vesselness(clipped(tissue, evidence.deviation, 0.0, job), tube_sigmas_mm, job),
                 tubular_deviations * evidence.deviation, liver);
}

}  // namespace

void apply_window(const LiverFrame& frame, const std::pair<double, double>& window_hu,
                  TissueContrast& tissue) {
    const auto [low, high] = window_hu;
    if (!(low < high))
        throw InputError(
            "the window runs from " + std::to_string(low) + " to " + std::to_string(high) + " HU",
            "window", "Give the lower value first.");
    tissue.threshold_hu = low - tissue.parenchyma_hu;
    for (std::size_t i = 0; i < tissue.excess.voxels.size(); ++i) {
        const float v = frame.intensity.voxels[i];
        tissue.excess.voxels[i] = frame.liver.voxels[i] && v <= static_cast<float>(high)
                                      ? v - static_cast<float>(tissue.parenchyma_hu)
                                      : 0.0f;
    }
}

Detection detect_vessels(const TissueContrast& tissue, const Mask& liver, double slice_mm,
                         SegmentationMethod method, Job& job) {
    if (method == SegmentationMethod::multi_layer) return detect_by_layers(tissue, liver, job);
    const Evidence evidence = smoothed(tissue, slice_mm, job);
    job.advance(0.1);
    const Mask inner = erode(liver, dimmed_rim_mm * dimming(slice_mm), job);
    const Mask weak = above(evidence.rise, evidence.weak_hu, inner);
    Mask strong = method == SegmentationMethod::coherent ? coherent(tissue, inner, evidence, job)
                                                         : tubular(tissue, inner, evidence, job);
    for (std::size_t i = 0; i < strong.voxels.size(); ++i)
        if (!weak.voxels[i]) strong.voxels[i] = 0;
    job.advance(0.6);
    strong = hysteresis(strong, strong, smallest_strong_mm3);
    job.advance(0.65);
    const Mask grown = grow_within(strong, weak, growth_mm);
    job.advance(0.7);
    const Mask vessels = hysteresis(grown, grown, smallest_vessel_mm3);
    job.advance(0.75);
    const FloatVolume wall = clipped(tissue, evidence.deviation, wall_sigma_mm, job);
    job.advance(0.8);
    Mask fitted =
        fit_surface(wall, evidence.rise, vessels, liver, evidence.deviation, SurfaceOptions{}, job);
    job.advance(0.9);
    const Mask skeleton = thin(vessels, ThinningMethod::queue, job);
    job.throw_if_cancelled();
    rejoin(skeleton, kept_branch_mm, fitted);
    return {std::move(fitted), Mask()};
}

}  // namespace hepatica
