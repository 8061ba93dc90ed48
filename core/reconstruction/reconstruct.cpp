// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the whole reconstruction, from reading the CT to the mesh.
#include "core/reconstruction/reconstruct.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/base/error.h"
#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/image/volume_reader.h"
#include "core/patient/branch_offers.h"
#include "core/patient/image_digest.h"
#include "core/reconstruction/liver_side.h"
#include "core/reconstruction/reconstruct_parameters.h"
#include "core/reconstruction/seed_checks.h"
#include "core/reconstruction/tumours.h"
#include "core/segmentation/gaussian_refinement.h"
#include "core/segmentation/vessel_systems.h"

namespace hepatica {

namespace {

void require_vessels(const Mask& mask, const std::string& place) {
    if (std::ranges::none_of(mask.voxels, [](auto v) { return v != 0; }))
        throw InputError("no vessels were found", place,
                         "Give a window (--window LO,HI), a seed inside a vessel (--seed-mm) or a "
                         "vessel mask (--vessel-mask)");
}

void require_tree(const VesselTree& tree, const ReconstructOptions& options) {
    if (!tree.segments.empty()) return;
    const std::string problem = "the vessels found are too small for a tree";
    if (options.vessel_mask)
        throw InputError(problem, options.vessel_mask->string(),
                         "Choose a mask that holds whole vessels");
    throw InputError(problem, options.ct.string(),
                     "Give a window (--window LO,HI) or a vessel mask (--vessel-mask)");
}

// The vessels and organs that the image shows or that were given, before the tree is made.
struct Anatomy {
    Mask vessels;                 // numbers of systems
    Mask organs;                  // organ_label; empty where no liver was given or found
    ContrastStatistics contrast;  // zero where the vessels were given
    std::optional<Vec3> portal_trunk_mm;
    std::vector<Bridge> offered;  // branches that may be vessels
};

// The liver as a case keeps it: cut to its bounding box with a margin.
Mask organs_of(const Mask& liver) {
    constexpr double margin_mm = 2.0;
    Mask organs = crop(liver, grow_box(bounding_box(liver), liver.grid, margin_mm));
    for (std::uint8_t& voxel : organs.voxels)
        if (voxel != 0) voxel = organ_label::liver;
    return organs;
}

// The given tumours, cut to the box around them; empty where none are given.
Mask given_tumours(const ReconstructOptions& options, const Grid& ct_grid,
                   std::vector<std::string>& warnings, Job& job) {
    if (options.tumour_masks.empty()) return {};
    // Where vessels are given no liver is looked for.
    if (options.vessel_mask && !options.liver_mask)
        throw InputError("tumours are given without a liver", options.tumour_masks.front().string(),
                         "Give the liver, too (--liver-mask): blood reaches tumours through it");
    const Mask tumours = read_tumours(options.tumour_masks, ct_grid, warnings, job);
    return crop(tumours, bounding_box(tumours));
}

// Marks the part of the tumours that lies in the box of the liver.
void mark_tumours(const Mask& tumours, Mask& organs, std::vector<std::string>& warnings, Job& job) {
    if (tumours.voxels.empty()) return;
    warn_of_tumours_outside(tumours, organs.grid, warnings, job);
    add_tumours(tumours, organs);
}

std::optional<Mask> given_liver(const ReconstructOptions& options, const Grid& ct_grid, Job& job) {
    if (!options.liver_mask) return std::nullopt;
    return on_grid_of(ct_grid, read_mask(*options.liver_mask, job, options.liver_labels),
                      options.liver_mask->string());
}

Anatomy given_anatomy(const ReconstructOptions& options, const Grid& ct_grid,
                      std::vector<std::string>& warnings, Job& job) {
    Anatomy anatomy;
    if (const auto liver = given_liver(options, ct_grid, job)) anatomy.organs = organs_of(*liver);
    const Mask mask =
        read_given_vessels(*options.vessel_mask, options.vessel_labels, ct_grid, warnings, job);
    job.begin_stage("Smoothing the vessels");
    anatomy.vessels =
        in_part(job, 0.0, 0.5, [&] { return refine(mask, options.refinement_recursions, job); });
    return anatomy;
}

struct Models {
    std::optional<LinkModel> chooses, offers;
};

Models models_of(const ReconstructOptions& options) {
    Models models;
    if (!takes_models(options)) return models;
    if (options.model)
        models.chooses = read_link_model(*options.model);
    else if (options.offers)
        models.offers = read_link_model(*options.offers);
    return models;
}

Anatomy segmented_anatomy(const ReconstructOptions& options, Models models, const Volume& ct,
                          std::vector<std::string>& warnings, Job& job) {
    SegmentationOptions segmentation;
    segmentation.method = options.method;
    segmentation.window_hu = options.window_hu;
    segmentation.refinement_recursions = options.refinement_recursions;
    segmentation.spacing_mm = options.spacing_mm;
    segmentation.model = std::move(models.chooses);
    segmentation.offers = std::move(models.offers);
    segmentation.liver = given_liver(options, ct.grid, job);
    Anatomy anatomy;
    if (segmentation.liver) {
        require_seeds_near_liver(options.seeds, *segmentation.liver, options.liver_mask->string());
        anatomy.organs = organs_of(*segmentation.liver);
    }
    Segmentation found = segment_vessels(ct, segmentation, job);
    warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
    require_vessels(found.mask, options.ct.string());
    anatomy.vessels = std::move(found.mask);
    anatomy.contrast = found.statistics;
    anatomy.portal_trunk_mm = found.trunk_mm;
    anatomy.offered = std::move(found.offered);
    if (!segmentation.liver) anatomy.organs = organs_of(found.liver);
    return anatomy;
}

// Whether the voxels hold systems already.
bool has_systems(const Mask& vessels) {
    return std::ranges::any_of(vessels.voxels, [](std::uint8_t v) {
        return v != 0 && v != static_cast<std::uint8_t>(VascularSystem::unknown);
    });
}

// Leaves in `warnings` what was found so far, even where it throws.
Reconstruction reconstruct(const ReconstructOptions& options, std::vector<std::string>& warnings,
                           Job& job, const ImageRead& image_read) {
    Reconstruction result;
    PatientCase& patient = result.patient;
    // Read first, so that a wrong file is refused before the long work.
    Models models = models_of(options);
    const auto read =
        std::make_shared<const Volume>(read_volume(options.ct, job, &warnings, options.series));
    const Volume& ct = *read;
    require_plausible_ct(ct, options.ct.string(), job);
    if (image_read) image_read(read);
    require_seeds_in_image(options.seeds, ct.grid);
    const std::string digest = in_part(job, 1.0, 1.0, [&] { return digest_of(ct, job); });
    patient.source = {options.name, digest, ct.grid, parameters_json(options)};
    // A mask that does not fit is refused before the long work, too.
    const Mask tumours = given_tumours(options, ct.grid, warnings, job);

    Anatomy anatomy = options.vessel_mask
                          ? given_anatomy(options, ct.grid, warnings, job)
                          : segmented_anatomy(options, std::move(models), ct, warnings, job);
    patient.mask = std::move(anatomy.vessels);
    patient.organs = std::move(anatomy.organs);
    if (lies_on_the_left(patient.organs, ct, job))
        warnings.push_back(
            "The liver lies on the patient's left: the image may be mirrored, or say wrongly how "
            "he "
            "lies. Left and right are then exchanged everywhere");
    mark_tumours(tumours, patient.organs, warnings, job);
    require_seeds_in_vessels(patient.mask, options.seeds);
    keep_portal_trunk(anatomy.portal_trunk_mm, patient.source.parameters_json);
    if (options.vessel_mask)
        keep_systems_given(has_systems(patient.mask), patient.source.parameters_json);
    FromVoxelsOptions from_voxels;
    from_voxels.seeds = options.seeds;
    from_voxels.find_systems = !options.seeds.empty() || !has_systems(patient.mask);
    from_voxels.bridge_confidence = options.bridge_confidence;
    from_voxels.thinning = options.thinning;
    from_voxels.portal_trunk_mm = anatomy.portal_trunk_mm;
    from_voxels.shorten_trunk = anatomy.portal_trunk_mm.has_value();
    from_voxels.of_image.contrast_hu = anatomy.contrast.contrast_hu();
    from_voxels.of_image.noise_hu = anatomy.contrast.noise_hu;
    from_voxels.of_image.coarsest_spacing_mm = ct.grid.spacing_mm.maxCoeff();
    result.warnings_of_image = warnings.size();
    result.checks = make_tree(from_voxels, ct, patient, warnings, job);
    require_tree(patient.tree, options);
    offer_branches(anatomy.offered, patient);
    make_body(options.mesh, patient, warnings, job);
    patient.warnings_of_image = result.warnings_of_image;
    result.stages = job.stage_times();
    result.warnings = warnings;
    return result;
}

// The file that an error of a later step means, which knows none.
std::string file_of(const std::string& place, const ReconstructOptions& options) {
    if (place == "CT") return options.ct.string();
    if (place == "liver mask") return options.liver_mask.value_or(options.ct).string();
    if (place == "vessels") return options.vessel_mask.value_or(options.ct).string();
    return place;
}

}  // namespace

int stage_count(const ReconstructOptions& options) {
    constexpr int reading = 1;
    constexpr int given_mask = 2, segmentation = 6;
    const int given_liver = options.liver_mask ? 1 : 0;
    const int tumours = static_cast<int>(options.tumour_masks.size());
    const bool has_model = takes_models(options) && (options.model || options.offers);
    return reading + tumours + (has_model ? 1 : 0) +
           (options.vessel_mask ? given_liver + given_mask : segmentation) + make_tree_stages +
           make_body_stages;
}

Reconstruction reconstruct(const ReconstructOptions& options, Job& job,
                           const ImageRead& image_read) {
    job.throw_if_cancelled();
    job.expect_stages(stage_count(options));
    std::vector<std::string> warnings;
    try {
        return reconstruct(options, warnings, job, image_read);
    } catch (const InputError& error) {
        // The warnings about the image may be the reason.
        std::string problem = error.problem();
        for (const std::string& warning : warnings) problem += "; " + warning;
        throw InputError(problem, file_of(error.place(), options), error.remedy());
    }
}

}  // namespace hepatica
