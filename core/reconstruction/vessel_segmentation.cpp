// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the segmentation: detect, choose by the model, redraw thin vessels, add the hilum, refine
// the surface.
#include "core/reconstruction/vessel_segmentation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/reconstruction/chosen_vessels.h"
#include "core/reconstruction/detected_vessels.h"
#include "core/reconstruction/plausible_skeleton.h"
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

constexpr double coarse_slices_mm = 1.5;
constexpr double thin_radius_mm = 1.6;
constexpr double kept_branch_mm = 4.0;
// Below this contrast, in standard deviations of the noise, a radius is no more precise than an
// outline.
constexpr double measurable_contrast = 4.5;

Mask with_thin_vessels_round(const Mask& vessels, const Mask& skeleton, const VesselTree& tree,
                             Job& job) {
    Mask round = round_thin_lumens(vessels, tree, thin_radius_mm, job);
    rejoin(skeleton, kept_branch_mm, round, job);
    return hysteresis(skeleton, round, 0.0, job);  // removes loose parts of the old outline
}

// Adds the vessels of the hilum and returns where the portal trunk enters.
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
        result.warnings.push_back("The slices are " + fixed_text(coarsest, 1) +
                                  " mm apart: thin branches may be broken or missing. Up to 1.5 mm "
                                  "is better.");
    const LinkModel* model = options.model ? &*options.model : nullptr;
    const LinkModel* offers = !model && options.offers ? &*options.offers : nullptr;
    DetectedVessels found = detect_in_liver(
        ct, options, model ? model->line_share : 1.0,
        offers ? std::optional(std::min(offers->line_share, 1.0)) : std::nullopt, job);
    if (model && found.detection.evidence)
        result.offered = keep_chosen(*model, ct.grid.spacing_mm, found, job);
    if (!offers) found.detection.evidence.reset();
    result.statistics = in_part(job, 1.0, 1.0, [&] { return contrast_of(found, job); });
    require_contrast(result.statistics, found, options.window_hu);
    job.begin_stage("Drawing thin vessels");
    const Mask lines = in_part(
        job, 0.0, 0.1, [&] { return thin(found.detection.vessels, ThinningMethod::queue, job); });
    require_plausible_skeleton(lines, job);
    const Mask skeleton = in_part(job, 0.1, 0.2, [&] { return unit_width(lines, job); });
    const VesselTree tree = in_part(job, 0.2, 0.7, [&] {
        return extract_tree(skeleton, found.detection.vessels, &ct, TreeOptions{}, job);
    });
    if (options.method == SegmentationMethod::coherent &&
        result.statistics.contrast_hu() >= measurable_contrast * found.tissue.noise_hu)
        found.detection.vessels =
            with_thin_vessels_round(found.detection.vessels, skeleton, tree, job);
    job.advance(0.8);
    result.trunk_mm = in_part(job, 0.8, 1.0, [&] {
        return add_hilum(found.frame, tree, result.statistics, found.detection.vessels, job);
    });

    if (!found.detection.doubtful.voxels.empty())
        result.offered =
            doubtful_branches(*offers, ct.grid.spacing_mm, found, found.detection.vessels, job);
    result.liver = std::move(found.liver);
    job.begin_stage("Refining the surface");
    result.mask = in_part(job, 0.0, 0.5, [&] {
        return refine(found.detection.vessels, options.refinement_recursions, job);
    });
    result.centreline = std::move(found.detection.centreline);
    for (std::uint8_t& voxel : result.mask.voxels)
        if (voxel != 0) voxel = static_cast<std::uint8_t>(VascularSystem::unknown);
    result.components =
        static_cast<int>(connected_components(result.mask, Connectivity::all26, job).sizes.size());
    result.intensity = std::move(found.frame.intensity);
    return result;
}

}  // namespace hepatica
