// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the liver and detects its vessels; checks that their contrast is plausible.
#include "core/reconstruction/detected_vessels.h"

#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/image/filters.h"
#include "core/image/mask.h"
#include "core/image/morphology.h"
#include "core/segmentation/liver_region.h"
#include "core/segmentation/vessel_growth.h"

namespace hepatica {

namespace {

constexpr double default_spacing_mm = 0.65;
// A CT in the arterial or portal phase shows 1 to 4 % of the liver as vessels, 38 to 92 HU above
// it.
constexpr double least_vessel_share = 0.002;
constexpr double least_contrast_hu = 15.0;
// Least share of a piece's voxels. The liver's border runs through the walls of heart, ribs and
// kidneys; pieces that lie mostly in its rim belong to those.
constexpr double least_inner_share = 0.65;
// The same for the liver that was found, which may lack a tenth of the organ.
constexpr double least_liver_share = 0.3;

constexpr const char* choose_a_window =
    "Choose a window that reaches from between tissue and vessels to above the brightest vessel, "
    "or give none.";

// Half of the liver and more would be vessels: minutes go into such a tangle before it is refused.
void require_window_beside_tissue(const std::pair<double, double>& window_hu,
                                  double parenchyma_hu) {
    const auto [low, high] = window_hu;
    if (!(low < parenchyma_hu && parenchyma_hu < high)) return;
    throw InputError("the window from " + fixed_text(low, 0) + " to " + fixed_text(high, 0) +
                         " HU takes in the liver's own tissue, which has " +
                         fixed_text(parenchyma_hu, 0) + " HU",
                     "window", choose_a_window);
}

// Why the window does not show vessels: they are too few in it (`share` of the liver), or too
// faint.
[[noreturn]] void refuse_window(const std::pair<double, double>& window_hu, double share,
                                const ContrastStatistics& measured) {
    const std::string range =
        fixed_text(window_hu.first, 0) + " and " + fixed_text(window_hu.second, 0) + " HU";
    const std::string tissue = fixed_text(measured.parenchyma_hu, 0) + " HU";
    if (share < least_vessel_share)
        throw InputError("only " + fixed_text(100.0 * share, 2) + " % of the liver lie between " +
                             range + " and hang together as vessels do; the tissue itself has " +
                             tissue,
                         "window", choose_a_window);
    if (measured.contrast_hu() < 0.0)
        throw InputError(
            "what lies between " + range + " is darker than the tissue, which has " + tissue,
            "window", choose_a_window);
    throw InputError(
        "what lies between " + range + " and hangs together as vessels do rises only " +
            fixed_text(measured.contrast_hu(), 0) + " HU above the tissue, which has " + tissue,
        "window", choose_a_window);
}

// The vessels away from the liver's border, where ribs, kidneys and heart show through.
Mask within(const Mask& vessels, const Mask& interior) {
    Mask inner = vessels;
    for (std::size_t i = 0; i < inner.voxels.size(); ++i)
        if (!interior.voxels[i]) inner.voxels[i] = 0;
    return inner;
}

// Median excess in vessels, at least 1 mm from their walls where enough voxels lie there, else in
// all of them.
double vessel_excess(const FloatVolume& excess, const Mask& vessels, Job& job) {
    constexpr double wall_mm = 1.0;
    const Mask inner = erode(vessels, wall_mm, job);
    constexpr std::size_t enough = 200;
    return robust_spread(excess, object_count(inner) >= enough ? inner : vessels, job).median;
}

}  // namespace

MeasuredLiver measure_liver(const Volume& ct, const SegmentationOptions& options, Job& job) {
    MeasuredLiver result;
    FoundLiver found;
    if (!options.liver) {
        job.begin_stage("Finding the liver");
        found = find_liver(ct, job);
    }
    job.begin_stage("Resampling the liver");
    const double spacing = options.spacing_mm > 0.0 ? options.spacing_mm : default_spacing_mm;
    result.frame = in_part(job, 0.0, 0.9, [&] {
        return make_liver_frame(ct, options.liver ? *options.liver : found.vessel_region, spacing,
                                job);
    });
    const LiverFrame& frame = result.frame;
    result.liver_was_given = options.liver.has_value();
    result.liver = in_part(job, 0.9, 1.0, [&] {
        return options.liver ? frame.liver
                             : resample(found.liver, frame.liver.grid, Interpolation::linear, job);
    });

    job.begin_stage("Measuring the contrast");
    result.tissue = measure_tissue(frame.intensity, frame.liver, job);
    if (options.window_hu) {
        require_window_beside_tissue(*options.window_hu, result.tissue.parenchyma_hu);
        apply_window(frame, *options.window_hu, result.tissue);
    }
    return result;
}

Mask without_others(const MeasuredLiver& measured, const Mask& vessels, const Job& job) {
    const Mask inner = pieces_within(vessels, measured.tissue.interior, least_inner_share, job);
    // The searched region may include spleen, pancreas and heart.
    return measured.liver_was_given ? inner
                                    : pieces_within(inner, measured.liver, least_liver_share, job);
}

DetectedVessels detect_in_liver(const Volume& ct, const SegmentationOptions& options,
                                double line_share, const std::optional<double>& doubtful_share,
                                Job& job) {
    DetectedVessels result{measure_liver(ct, options, job), {}};
    job.begin_stage("Segmenting the vessels");
    Detection& detection = result.detection;
    detection = detect_vessels(result.tissue, result.frame.liver, ct.grid.spacing_mm,
                               {options.method, line_share, doubtful_share}, job);
    detection.vessels = without_others(result, detection.vessels, job);
    if (!detection.doubtful.voxels.empty())
        detection.doubtful = without_others(result, detection.doubtful, job);
    for (std::size_t i = 0; i < detection.centreline.voxels.size(); ++i)
        if (!detection.vessels.voxels[i]) detection.centreline.voxels[i] = 0;
    return result;
}

ContrastStatistics contrast_of(const DetectedVessels& found, Job& job) {
    const TissueContrast& tissue = found.tissue;
    const Mask inner = within(found.detection.vessels, tissue.interior);
    return {tissue.parenchyma_hu, tissue.noise_hu,
            tissue.parenchyma_hu + vessel_excess(tissue.excess, inner, job)};
}

void require_contrast(const ContrastStatistics& measured, const DetectedVessels& found,
                      const std::optional<std::pair<double, double>>& window_hu) {
    const Mask& interior = found.tissue.interior;
    const std::size_t size = object_count(interior);
    const std::vector<std::uint8_t>& vessels = found.detection.vessels.voxels;
    std::size_t inner = 0;
    for (std::size_t i = 0; i < vessels.size(); ++i) inner += vessels[i] && interior.voxels[i];
    const double share = static_cast<double>(inner) / static_cast<double>(size);
    if (share >= least_vessel_share && measured.contrast_hu() >= least_contrast_hu) return;
    if (window_hu) refuse_window(*window_hu, share, measured);
    throw InputError(
        "the vessels do not stand out from the liver: the brightest structures cover " +
            fixed_text(100.0 * share, 2) + " % of it and rise " +
            fixed_text(share > 0.0 ? measured.contrast_hu() : 0.0, 0) + " HU above its " +
            fixed_text(measured.parenchyma_hu, 0) + " HU, where the noise is " +
            fixed_text(measured.noise_hu, 0) + " HU",
        "CT",
        "Use a scan with contrast medium (portal-venous phase for veins, arterial "
        "phase for arteries), or give a vessel mask.");
}

}  // namespace hepatica
