// SPDX-License-Identifier: GPL-3.0-or-later
// From the contrast to vessel voxels: lines or tubes as seeds, growth in weaker voxels, a minimal
// surface as the wall, and broken branches rejoined.
#include "core/segmentation/vessel_detection.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/image/voxel_loop.h"
#include "core/segmentation/false_line_threshold.h"
#include "core/segmentation/line_coherence.h"
#include "core/segmentation/minimal_surface.h"
#include "core/segmentation/multi_layer.h"
#include "core/segmentation/vessel_growth.h"
#include "core/segmentation/vesselness.h"
#include "core/skeleton/thinning.h"

namespace hepatica {

namespace {

// "Deviations" are standard deviations of the noise after smoothing by surface_sigma_mm.
constexpr double surface_sigma_mm = 0.6;
constexpr double candidate_deviations = 1.5;
constexpr double weak_deviations = 3.0;  // for `vesselness`; `coherent` uses weak_share instead
// Noise is measured at a distance from everything that may be a vessel.
constexpr double suspect_deviations = 2.0;
constexpr double smallest_suspect_mm3 = 20.0;
constexpr double suspect_reach_mm = 2.0;
constexpr double least_deviation_hu = 0.3;  // a CT is stored in whole Hounsfield units
// Slice thickness up to which thin vessels are not dimmed, and from which on they are dimmed fully.
constexpr double undimmed_slices_mm = 1.5;
constexpr double dimming_slices_mm = 3.0;
// In thick slices the organs around mix into the liver this far.
constexpr double dimmed_rim_mm = 1.8;
constexpr double tubular_deviations = 1.5;
// Limits of the excess of one voxel, so that a single bright voxel is not taken for a line.
constexpr double clip_below_deviations = 3.0;
constexpr double clip_above_deviations = 8.0;
constexpr double line_sigma_mm = 0.7;
constexpr double surroundings_sigma_mm = 3.0;
// Edge of the cube with a voxel's volume, for a CT of fine and for one of coarse voxels.
constexpr double fine_voxel_mm = 0.8;
constexpr double coarse_voxel_mm = 1.15;
// In multiples of false_line_hu.
constexpr double strong_share = 1.384;
constexpr double weak_share = 1.12;
constexpr double coarse_strong_share = 1.1;
constexpr double coarse_weak_share = 1.0;
constexpr double thick_slices_share = 0.12;  // how much both are lowered for thick slices
// With coarse voxels the blur is as wide as a thin vessel, which lowers its peak; the wall then
// lies at a larger share of that peak.
constexpr double coarse_level_share = 0.5;
constexpr double coarse_data_weight = 0.75;
constexpr double smallest_strong_mm3 = 8.0;
constexpr double wall_sigma_mm = 0.3;
constexpr double kept_branch_mm = 4.0;
constexpr double growth_mm = 1.6;
const std::vector<double> tube_sigmas_mm{0.8, 1.2, 1.8, 2.7};

// How much the CT's voxel size degrades thin vessels, each from 0 (not) to 1 (fully).
struct Sampling {
    double thick;   // slices: organs above and below mix into the liver
    double coarse;  // voxels: thin vessels are dim, and look wide at half of their peak
};

double ramp(double value, double from, double to) {
    return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

Sampling sampling_of(const Vec3& spacing_mm) {
    return {ramp(spacing_mm.maxCoeff(), undimmed_slices_mm, dimming_slices_mm),
            ramp(std::cbrt(spacing_mm.prod()), fine_voxel_mm, coarse_voxel_mm)};
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

RobustSpread spread_away_from_vessels(const FloatVolume& rise, const Mask& interior, Job& job) {
    const RobustSpread all = robust_spread(rise, interior, job);
    Mask suspects = above(rise, all.median + suspect_deviations * all.deviation, interior);
    job.throw_if_cancelled();
    suspects = hysteresis(suspects, suspects, smallest_suspect_mm3, job);
    job.throw_if_cancelled();
    suspects = dilate(suspects, suspect_reach_mm, job);
    job.throw_if_cancelled();
    Mask quiet = interior;
    for_each_voxel(quiet.voxels.size(), job, [&](std::size_t i) {
        if (suspects.voxels[i]) quiet.voxels[i] = 0;
    });
    const RobustSpread away = robust_spread(rise, quiet, job);
    return {away.deviation > 0.0 ? away.median : all.median,
            std::max(away.deviation, least_deviation_hu)};
}

// The smoothed excess with its median at 0, and its noise; false_line_hu is not measured yet.
LineEvidence smoothed(const TissueContrast& tissue, Job& job) {
    LineEvidence evidence;
    evidence.rise = copied_image(tissue.excess, job);
    gaussian_smooth(evidence.rise, Vec3::Constant(surface_sigma_mm), job);
    job.throw_if_cancelled();
    const RobustSpread spread = spread_away_from_vessels(evidence.rise, tissue.interior, job);
    job.throw_if_cancelled();
    for_each_voxel(evidence.rise.voxels.size(), job, [&](std::size_t i) {
        evidence.rise.voxels[i] -= static_cast<float>(spread.median);
    });
    evidence.deviation_hu = spread.deviation;
    return evidence;
}

// Excess clipped to the limits for one voxel, then smoothed by sigma_mm.
FloatVolume clipped(const TissueContrast& tissue, double deviation, double sigma_mm, Job& job) {
    FloatVolume values = copied_image(tissue.excess, job);
    const auto low = static_cast<float>(-clip_below_deviations * deviation);
    const auto high = static_cast<float>(clip_above_deviations * deviation);
    for_each_voxel(values.voxels.size(), job, [&](std::size_t i) {
        values.voxels[i] = std::clamp(values.voxels[i], low, high);
    });
    gaussian_smooth(values, Vec3::Constant(sigma_mm), job);
    return values;
}

// The voxels of `lines` in `weak` seed the growth within `weak`; small seeds and small results are
// dropped.
Mask grown_from(const Mask& lines, const Mask& weak, Job& job) {
    Mask strong = lines;
    for_each_voxel(strong.voxels.size(), job, [&](std::size_t i) {
        if (!weak.voxels[i]) strong.voxels[i] = 0;
    });
    strong = hysteresis(strong, strong, smallest_strong_mm3, job);
    job.advance(0.3);
    const Mask grown = grow_within(strong, weak, growth_mm);
    job.advance(0.6);
    return hysteresis(grown, grown, smallest_vessel_mm3, job);
}

double share_of(double fine, double coarse, const Sampling& sampling) {
    return std::lerp(fine, coarse, sampling.coarse) - thick_slices_share * sampling.thick;
}

// The lines and their threshold; `evidence` is completed and moved into the result.
MeasuredLines lines_of(const TissueContrast& tissue, const Mask& liver, LineEvidence evidence,
                       const Sampling& sampling, double line_share, Job& job) {
    const double deviation = evidence.deviation_hu;
    const FloatVolume bright =
        in_part(job, 0.0, 0.1, [&] { return clipped(tissue, deviation, line_sigma_mm, job); });
    FloatVolume standing_out = in_part(
        job, 0.1, 0.2, [&] { return clipped(tissue, deviation, surroundings_sigma_mm, job); });
    for_each_voxel(bright.voxels.size(), job, [&](std::size_t i) {
        standing_out.voxels[i] = bright.voxels[i] - standing_out.voxels[i];
    });
    evidence.false_line_hu = in_part(job, 0.2, 0.6, [&] {
        return false_line_threshold(standing_out, deviation, liver, tissue.interior, job);
    });
    MeasuredLines lines;
    lines.strong_share = share_of(strong_share, coarse_strong_share, sampling);
    lines.weak_share = share_of(weak_share, coarse_weak_share, sampling);
    const double weak_hu = lines.weak_share * line_share * evidence.false_line_hu;
    const Mask candidates =
        above(evidence.rise, std::min(candidate_deviations * deviation, weak_hu), liver);
    lines.strength = in_part(
        job, 0.6, 1.0, [&] { return line_coherence(bright, candidates, LineOptions{}, job); });
    lines.evidence = std::move(evidence);
    lines.liver = liver;
    return lines;
}

// Voxels above the user's threshold, whatever the noise.
Mask within_window(const FloatVolume& rise, double threshold_hu, const Mask& liver, Job& job) {
    const Mask bright = above(rise, threshold_hu, liver);
    return grown_from(bright, bright, job);
}

Mask tubular(const TissueContrast& tissue, const Mask& liver, const LineEvidence& evidence,
             const Sampling& sampling, Job& job) {
    const double weak_hu =
        tissue.threshold_hu.value_or((weak_deviations - sampling.thick) * evidence.deviation_hu);
    const FloatVolume response = in_part(job, 0.0, 0.8, [&] {
        return vesselness(clipped(tissue, evidence.deviation_hu, 0.0, job), tube_sigmas_mm, job);
    });
    const Mask tubes = above(response, tubular_deviations * evidence.deviation_hu, liver);
    return in_part(job, 0.8, 1.0,
                   [&] { return grown_from(tubes, above(evidence.rise, weak_hu, liver), job); });
}

SurfaceOptions surface_for(const Sampling& sampling) {
    SurfaceOptions options;
    options.level_share = std::lerp(options.level_share, coarse_level_share, sampling.coarse);
    options.data_weight = std::lerp(options.data_weight, coarse_data_weight, sampling.coarse);
    return options;
}

}  // namespace

void apply_window(const LiverFrame& frame, const std::pair<double, double>& window_hu,
                  TissueContrast& tissue) {
    const auto [low, high] = window_hu;
    if (!(low < high))
        throw InputError(
            "the window runs from " + number_text(low) + " to " + number_text(high) + " HU",
            "window", "Give the lower value first.");
    const double threshold_hu = low - tissue.parenchyma_hu;
    tissue.threshold_hu = threshold_hu;
    // A window below the tissue must not take in what is too bright for it.
    const auto too_bright = static_cast<float>(std::min(0.0, threshold_hu));
    for (std::size_t i = 0; i < tissue.excess.voxels.size(); ++i) {
        const float v = frame.intensity.voxels[i];
        float& excess = tissue.excess.voxels[i];
        excess = 0.0f;
        if (frame.liver.voxels[i] != 0)
            excess = v <= static_cast<float>(high) ? v - static_cast<float>(tissue.parenchyma_hu)
                                                   : too_bright;
    }
}

MeasuredLines measure_lines(const TissueContrast& tissue, const Mask& liver,
                            const Vec3& ct_spacing_mm, double line_share, Job& job) {
    const Sampling sampling = sampling_of(ct_spacing_mm);
    LineEvidence evidence = in_part(job, 0.0, 0.15, [&] { return smoothed(tissue, job); });
    const Mask inner =
        in_part(job, 0.15, 0.2, [&] { return erode(liver, dimmed_rim_mm * sampling.thick, job); });
    const JobPart rest(job, 0.2, 1.0);
    return lines_of(tissue, inner, std::move(evidence), sampling, line_share, job);
}

Mask believed_lines(const MeasuredLines& lines, double line_share, Job& job) {
    const double believed_hu = line_share * lines.evidence.false_line_hu;
    return grown_from(above(lines.strength, lines.strong_share * believed_hu, lines.liver),
                      above(lines.evidence.rise, lines.weak_share * believed_hu, lines.liver), job);
}

Detection detect_vessels(const TissueContrast& tissue, const Mask& liver, const Vec3& ct_spacing_mm,
                         const DetectionOptions& options, Job& job) {
    if (options.method == SegmentationMethod::multi_layer)
        return detect_by_layers(tissue, liver, job);
    const Sampling sampling = sampling_of(ct_spacing_mm);
    LineEvidence evidence;
    Mask vessels, doubtful;
    if (options.method == SegmentationMethod::coherent && !tissue.threshold_hu) {
        MeasuredLines lines = in_part(job, 0.0, 0.6, [&] {
            return measure_lines(tissue, liver, ct_spacing_mm,
                                 options.doubtful_share.value_or(options.line_share), job);
        });
        vessels =
            in_part(job, 0.6, 0.7, [&] { return believed_lines(lines, options.line_share, job); });
        const JobPart part(job, 0.7, 0.75);
        if (options.doubtful_share) doubtful = believed_lines(lines, *options.doubtful_share, job);
        evidence = std::move(lines.evidence);
    } else {
        evidence = in_part(job, 0.0, 0.1, [&] { return smoothed(tissue, job); });
        const Mask inner = in_part(
            job, 0.1, 0.15, [&] { return erode(liver, dimmed_rim_mm * sampling.thick, job); });
        const JobPart part(job, 0.15, 0.75);
        vessels = options.method == SegmentationMethod::coherent
                      ? within_window(evidence.rise, *tissue.threshold_hu, inner, job)
                      : tubular(tissue, inner, evidence, sampling, job);
    }
    FloatVolume wall = copied_image(tissue.excess, job);
    in_part(job, 0.75, 0.8, [&] { gaussian_smooth(wall, Vec3::Constant(wall_sigma_mm), job); });
    const auto with_walls = [&](const Mask& lines) {
        Mask fitted = in_part(job, 0.0, 0.5, [&] {
            return fit_surface(wall, evidence.rise, lines, liver, evidence.deviation_hu,
                               surface_for(sampling), job);
        });
        const Mask skeleton =
            in_part(job, 0.5, 1.0, [&] { return thin(lines, ThinningMethod::queue, job); });
        job.throw_if_cancelled();
        rejoin(skeleton, kept_branch_mm, fitted, job);
        return fitted;
    };
    const double believed = doubtful.voxels.empty() ? 1.0 : 0.9;
    Detection found{in_part(job, 0.8, believed, [&] { return with_walls(vessels); }), Mask(),
                    std::nullopt, Mask()};
    if (!doubtful.voxels.empty()) {
        found.doubtful = in_part(job, 0.9, 1.0, [&] { return with_walls(doubtful); });
        for_each_voxel(found.doubtful.voxels.size(), job,
                       [&](std::size_t i) { found.doubtful.voxels[i] |= found.vessels.voxels[i]; });
    }
    if (evidence.false_line_hu > 0.0) found.evidence = std::move(evidence);
    return found;
}

}  // namespace hepatica
