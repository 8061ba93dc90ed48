// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/reconstruct.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/base/error.h"
#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/image/volume_reader.h"
#include "core/mesh/surface.h"
#include "core/patient/image_digest.h"
#include "core/patient/liver_segments.h"
#include "core/reconstruction/mask_of_tree.h"
#include "core/reconstruction/reconstruct_parameters.h"
#include "core/reconstruction/seed_checks.h"
#include "core/reconstruction/tumours.h"
#include "core/segmentation/gaussian_refinement.h"
#include "core/segmentation/vessel_systems.h"
#include "core/skeleton/thinning.h"
#include "core/skeleton/topology.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "core/tree/systems/doubtful_roots.h"
#include "core/tree/tree_extraction.h"

namespace hepatica {

namespace {

// Holes inside a vessel are noise or clots, and would become shells in the skeleton. A filled voxel
// takes the system of the voxel before it in the row, which borders the hole.
void fill_cavities(Mask& mask) {
    const Mask filled = fill_holes(mask);
    for (std::size_t i = 1; i < mask.voxels.size(); ++i)
        if (mask.voxels[i] == 0 && filled.voxels[i] != 0) mask.voxels[i] = mask.voxels[i - 1];
}

VoxelCounts counts_of(const Mask& mask) {
    const Betti betti = betti_numbers(mask);
    const auto voxels = std::ranges::count_if(mask.voxels, [](auto v) { return v != 0; });
    return {static_cast<std::size_t>(voxels), betti.components, betti.tunnels, betti.cavities};
}

void require_vessels(const Mask& mask, const std::string& place) {
    if (std::ranges::none_of(mask.voxels, [](auto v) { return v != 0; }))
        throw InputError("no vessels were found", place,
                         "Give a window (--window LO,HI), a seed inside a vessel (--seed-mm) or a "
                         "vessel mask (--vessel-mask)");
}

// What the image shows or somebody drew, before it becomes a tree.
struct Anatomy {
    Mask vessels;                 // numbers of systems
    Mask organs;                  // organ_label; empty where no liver was given or found
    ContrastStatistics contrast;  // zero where the vessels were given
    std::optional<Vec3> portal_trunk_mm;
};

// The liver as a case keeps it, cut to what it fills.
Mask organs_of(const Mask& liver) {
    constexpr double margin_mm = 2.0;
    Mask organs = crop(liver, grow_box(bounding_box(liver), liver.grid, margin_mm));
    for (std::uint8_t& voxel : organs.voxels)
        if (voxel != 0) voxel = organ_label::liver;
    return organs;
}

// What of them lies in the box of the liver.
void mark_tumours(const ReconstructOptions& options, const Grid& ct_grid, Mask& organs, Job& job) {
    if (options.tumour_masks.empty()) return;
    if (organs.voxels.empty())
        throw InputError("tumours are given without a liver", options.tumour_masks.front().string(),
                         "Give the liver, too (--liver-mask): blood reaches tumours through it");
    add_tumours(read_tumours(options.tumour_masks, ct_grid, job), organs);
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
    anatomy.vessels = refine(mask, options.refinement_recursions, job);
    return anatomy;
}

Anatomy segmented_anatomy(const ReconstructOptions& options, const Volume& ct,
                          std::vector<std::string>& warnings, Job& job) {
    SegmentationOptions segmentation;
    segmentation.method = options.method;
    segmentation.window_hu = options.window_hu;
    segmentation.refinement_recursions = options.refinement_recursions;
    segmentation.spacing_mm = options.spacing_mm;
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
    if (!segmentation.liver) anatomy.organs = organs_of(found.liver);
    return anatomy;
}

void warn_of_left_out(const TreeExtraction& extraction, const TreeOptions& options,
                      std::vector<std::string>& warnings) {
    const auto say = [&](const RemovedPieces& pieces, const std::string& what,
                         const std::string& why) {
        if (pieces.count == 0) return;
        const bool one = pieces.count == 1;
        warnings.push_back(std::to_string(pieces.count) + (one ? " piece" : " pieces") + what +
                           ", " + std::to_string(std::lround(pieces.length_mm)) + " mm in all, " +
                           (one ? "was" : "were") + " left out of the tree: " + why +
                           ". A seed inside such a piece keeps it.");
    };
    say(extraction.too_short, " of vessels",
        "pieces shorter than " + std::to_string(std::lround(options.minimum_component_mm)) +
            " mm that nothing joins are often noise");
    say(extraction.blobs, " as wide as an organ",
        "what hangs on a vessel by a neck and is wide and short is hardly one");
}

// Whether somebody has said already which voxels belong to which system.
bool has_systems(const Mask& vessels) {
    return std::ranges::any_of(vessels.voxels, [](std::uint8_t v) {
        return v != 0 && v != static_cast<std::uint8_t>(VascularSystem::unknown);
    });
}

// Fills tree and bridges of the case; its voxels take the systems of the tree.
void build_tree(const ReconstructOptions& options, const Volume& ct,
                const std::optional<Vec3>& portal_trunk_mm, Reconstruction& result,
                std::vector<std::string>& warnings, Job& job) {
    PatientCase& patient = result.patient;
    TreeOptions tree_options;
    tree_options.seeds = options.seeds;
    tree_options.find_systems = !options.seeds.empty() || !has_systems(patient.mask);
    tree_options.liver_mm = box_mm(bounding_box(patient.organs), patient.organs.grid);
    tree_options.portal_trunk_mm = portal_trunk_mm;
    tree_options.bridging.confidence = options.bridge_confidence;
    job.begin_stage("Extracting the tree");
    TreeExtraction extraction =
        extract_tree_and_bridges(patient.skeleton, patient.mask, &ct, tree_options, job);
    warn_of_left_out(extraction, tree_options, warnings);
    patient.tree = std::move(extraction.tree);
    patient.doubts = doubts_of(patient.tree);
    patient.doubts->opened_loops = extraction.opened_loops;
    patient.corrections.bridges = std::move(extraction.bridges);
    job.begin_stage("Telling the systems apart");
    follow_tree(patient.mask, patient.tree, tree_options.find_systems, job);
}

// `warnings` holds what was found so far, also where it throws.
Reconstruction reconstruct(const ReconstructOptions& options, std::vector<std::string>& warnings,
                           Job& job) {
    Reconstruction result;
    PatientCase& patient = result.patient;
    const Volume ct = read_volume(options.ct, job, &warnings, options.series);
    require_plausible_ct(ct, options.ct.string());
    require_seeds_in_image(options.seeds, ct.grid);
    patient.source = {options.name, digest_of(ct), ct.grid, parameters_json(options)};

    Anatomy anatomy = options.vessel_mask ? given_anatomy(options, ct.grid, warnings, job)
                                          : segmented_anatomy(options, ct, warnings, job);
    patient.mask = std::move(anatomy.vessels);
    patient.organs = std::move(anatomy.organs);
    mark_tumours(options, ct.grid, patient.organs, job);
    require_seeds_in_vessels(patient.mask, options.seeds);
    fill_cavities(patient.mask);
    job.advance(0.8);
    result.mask = counts_of(patient.mask);
    job.advance(1.0);

    job.begin_stage("Thinning to the skeleton");
    const Mask skeleton = thin(patient.mask, options.thinning, job);
    job.begin_stage("Making the skeleton one voxel wide");
    patient.skeleton = unit_width(skeleton, job);
    result.skeleton = counts_of(patient.skeleton);
    result.crowded_points = crowded_point_count(patient.skeleton);

    build_tree(options, ct, anatomy.portal_trunk_mm, result, warnings, job);
    patient.doubts->contrast_hu = anatomy.contrast.contrast_hu();
    patient.doubts->noise_hu = anatomy.contrast.noise_hu;
    patient.doubts->coarsest_spacing_mm = ct.grid.spacing_mm.maxCoeff();
    if (patient.tree.segments.empty())
        throw InputError("the vessels found are too small for a tree", options.ct.string(),
                         "Give a window (--window LO,HI) or a vessel mask (--vessel-mask)");
    label_segments(patient, job);
    std::ranges::copy(sentences(*patient.doubts), std::back_inserter(warnings));
    std::ranges::copy(sentences(doubtful_roots(patient.tree)), std::back_inserter(warnings));

    job.begin_stage("Meshing the vessels");
    patient.mesh = tetrahedralize(patient.tree, options.mesh, job, &warnings);
    job.throw_if_cancelled();
    patient.surface = surface_of(patient.mesh).mesh;
    result.stages = job.stage_times();
    result.warnings = warnings;
    return result;
}

}  // namespace

int stage_count(const ReconstructOptions& options) {
    constexpr int reading = 1, from_skeleton_to_mesh = 5;
    constexpr int given_mask = 2, segmentation = 6;
    const int given_liver = options.liver_mask ? 1 : 0;
    const int tumours = static_cast<int>(options.tumour_masks.size());
    return reading + tumours + (options.vessel_mask ? given_liver + given_mask : segmentation) +
           from_skeleton_to_mesh;
}

Reconstruction reconstruct(const ReconstructOptions& options, Job& job) {
    job.throw_if_cancelled();
    job.expect_stages(stage_count(options));
    std::vector<std::string> warnings;
    try {
        return reconstruct(options, warnings, job);
    } catch (const InputError& error) {
        // What was odd about the image may be the reason.
        std::string problem = error.problem();
        for (const std::string& warning : warnings) problem += "; " + warning;
        throw InputError(problem, error.place(), error.remedy());
    }
}

}  // namespace hepatica
