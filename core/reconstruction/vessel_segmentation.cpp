// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/vessel_segmentation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/image/voxel_loop.h"
#include "core/reconstruction/round_lumen.h"
#include "core/segmentation/gaussian_refinement.h"
#include "core/segmentation/hilum_vessels.h"
#include "core/segmentation/liver_frame.h"
#include "core/segmentation/liver_region.h"
#include "core/segmentation/tissue_contrast.h"
#include "core/segmentation/vessel_detection.h"
#include "core/segmentation/vessel_growth.h"
#include "core/skeleton/thinning.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "core/tree/systems/anatomical_anchors.h"
#include "core/tree/tree_extraction.h"

namespace hepatica {

namespace {

constexpr double default_spacing_mm = 0.65;
constexpr double coarse_slices_mm = 1.5;
// A CT in the arterial or portal phase shows 1 to 4 % of the liver as vessels, 38 to 92 HU above
// it.
constexpr double least_vessel_share = 0.002;
constexpr double least_contrast_hu = 15.0;
// Of a piece's voxels. The liver's border runs through the walls of heart, ribs and kidneys: pieces
// that lie mostly in its rim are theirs.
constexpr double least_inner_share = 0.65;
// The same in the liver that was found, which may lack a tenth of the organ.
constexpr double least_liver_share = 0.3;
constexpr double thin_radius_mm = 1.6;
constexpr double kept_branch_mm = 4.0;
// Below this contrast, in deviations of the noise, a radius is not measured any better than an
// outline.
constexpr double measurable_contrast = 4.5;

std::string rounded(double value, int decimals = 0) {
    std::string text = std::to_string(value);
    return text.substr(
        0, text.find('.') + (decimals > 0 ? static_cast<std::size_t>(decimals) + 1 : 0));
}

std::size_t object_count(const Mask& mask) {
    return mask.voxels.size() - static_cast<std::size_t>(std::count(
                                    mask.voxels.begin(), mask.voxels.end(), std::uint8_t{0}));
}

// The vessels away from the liver's border, where ribs, kidneys and heart shine in.
Mask within(const Mask& vessels, const Mask& interior) {
    Mask inner = vessels;
    for (std::size_t i = 0; i < inner.voxels.size(); ++i)
        if (!interior.voxels[i]) inner.voxels[i] = 0;
    return inner;
}

// Median of the excess a voxel away from the vessels' walls where they are wide enough for that,
// else anywhere in them.
double vessel_excess(const FloatVolume& excess, const Mask& vessels, Job& job) {
    constexpr double wall_mm = 1.0;
    const Mask inner = erode(vessels, wall_mm, job);
    constexpr std::size_t enough = 200;
    return robust_spread(excess, object_count(inner) >= enough ? inner : vessels, job).median;
}

// Drops the pieces that lie elsewhere for the most part.
void keep_within(const Mask& where, double least_share, Detection& detection, const Job& job) {
    detection.vessels = pieces_within(detection.vessels, where, least_share, job);
    for (std::size_t i = 0; i < detection.centreline.voxels.size(); ++i)
        if (!detection.vessels.voxels[i]) detection.centreline.voxels[i] = 0;
}

void require_contrast(const ContrastStatistics& found, const Mask& vessels, const Mask& liver,
                      const std::optional<std::pair<double, double>>& window_hu) {
    const std::size_t size = object_count(liver);
    if (size == 0)
        throw InputError("the liver mask is so thin that nothing of it is further than 3 mm inside",
                         "liver mask", "Give a mask of the whole liver.");
    const double share = static_cast<double>(object_count(vessels)) / static_cast<double>(size);
    if (share >= least_vessel_share && found.contrast_hu() >= least_contrast_hu) return;
    if (window_hu)
        throw InputError("only " + rounded(100.0 * share, 2) + " % of the liver lie between " +
                             rounded(window_hu->first) + " and " + rounded(window_hu->second) +
                             " HU and hang together as vessels do; the tissue itself has " +
                             rounded(found.parenchyma_hu) + " HU",
                         "window",
                         "Choose a window that reaches from between tissue and vessels to above "
                         "the brightest vessel, or give none.");
    throw InputError(
        "the vessels do not stand out from the liver: the brightest structures cover " +
            rounded(100.0 * share, 2) + " % of it and rise " +
            rounded(share > 0.0 ? found.contrast_hu() : 0.0) + " HU above its " +
            rounded(found.parenchyma_hu) + " HU, where the noise is " + rounded(found.noise_hu) +
            " HU",
        "CT",
        "Use a scan with contrast medium (portal-venous phase for veins, arterial "
        "phase for arteries), or give a vessel mask.");
}

Mask with_thin_vessels_round(const Mask& vessels, const Mask& skeleton, const VesselTree& tree,
                             Job& job) {
    Mask round = round_thin_lumens(vessels, tree, thin_radius_mm, job);
    rejoin(skeleton, kept_branch_mm, round, job);
    return hysteresis(skeleton, round, 0.0, job);  // no crumbs of the outline
}

// Adds the vessels of the hilum and returns where the trunk comes in.
std::optional<Vec3> add_hilum(const LiverFrame& frame, const VesselTree& tree,
                              const ContrastStatistics& found, Mask& vessels, Job& job) {
    const AnatomicalAnchors anchors = find_anchors(pieces_of(to_graph(tree), nullptr).pieces,
                                                   box_mm(bounding_box(frame.liver), vessels.grid));
    const HilumVessels hilum = hilum_vessels(frame, vessels,
                                             {.at_mm = anchors.hilum_mm,
                                              .confluence_mm = anchors.confluence_mm,
                                              .parenchyma_hu = found.parenchyma_hu,
                                              .vessel_hu = found.vessel_hu},
                                             job);
    for (std::size_t i = 0; i < vessels.voxels.size(); ++i)
        vessels.voxels[i] |= hilum.vessels.voxels[i];
    return hilum.trunk_mm;
}

}  // namespace

Segmentation segment_vessels(const Volume& ct, const SegmentationOptions& options, Job& job) {
    Segmentation result;
    const double coarsest = ct.grid.spacing_mm.maxCoeff();
    if (coarsest > coarse_slices_mm)
        result.warnings.push_back("The slices are " + rounded(coarsest, 1) +
                                  " mm apart: thin branches may be broken or missing. Up to 1.5 mm "
                                  "is better.");
    FoundLiver found;
    if (!options.liver) {
        job.begin_stage("Finding the liver");
        found = find_liver(ct, job);
    }
    job.begin_stage("Resampling the liver");
    const double spacing = options.spacing_mm > 0.0 ? options.spacing_mm : default_spacing_mm;
    LiverFrame frame =
        make_liver_frame(ct, options.liver ? *options.liver : found.vessel_region, spacing, job);
    found.vessel_region = Mask();

    job.begin_stage("Measuring the contrast");
    TissueContrast tissue = measure_tissue(frame.intensity, frame.liver, job);
    if (options.window_hu) apply_window(frame, *options.window_hu, tissue);

    job.begin_stage("Segmenting the vessels");
    Detection detection =
        detect_vessels(tissue, frame.liver, ct.grid.spacing_mm, options.method, job);
    job.throw_if_cancelled();
    keep_within(tissue.interior, least_inner_share, detection, job);
    job.throw_if_cancelled();
    result.liver = options.liver
                       ? frame.liver
                       : resample(found.liver, frame.liver.grid, Interpolation::linear, job);
    // Spleen, pancreas and heart may hang together with the region that was searched.
    if (!options.liver) keep_within(result.liver, least_liver_share, detection, job);
    job.throw_if_cancelled();
    const Mask inner = within(detection.vessels, tissue.interior);
    result.statistics = {tissue.parenchyma_hu, tissue.noise_hu,
                         tissue.parenchyma_hu + vessel_excess(tissue.excess, inner, job)};
    require_contrast(result.statistics, inner, tissue.interior, options.window_hu);

    job.begin_stage("Drawing thin vessels");
    const Mask skeleton = unit_width(thin(detection.vessels, ThinningMethod::queue, job), job);
    const VesselTree tree = extract_tree(skeleton, detection.vessels, &ct, TreeOptions{}, job);
    if (options.method == SegmentationMethod::coherent &&
        result.statistics.contrast_hu() >= measurable_contrast * tissue.noise_hu)
        detection.vessels = with_thin_vessels_round(detection.vessels, skeleton, tree, job);
    job.advance(0.8);
    result.trunk_mm = add_hilum(frame, tree, result.statistics, detection.vessels, job);

    job.begin_stage("Refining the surface");
    result.mask = refine(detection.vessels, options.refinement_recursions, job);
    result.centreline = std::move(detection.centreline);
    for (std::uint8_t& voxel : result.mask.voxels)
        if (voxel != 0) voxel = static_cast<std::uint8_t>(VascularSystem::unknown);
    result.components =
        static_cast<int>(connected_components(result.mask, Connectivity::all26, job).sizes.size());
    result.intensity = std::move(frame.intensity);
    return result;
}

}  // namespace hepatica
