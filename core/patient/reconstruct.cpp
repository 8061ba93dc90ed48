// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/reconstruct.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/anatomy/segmentation/gaussian_refinement.h"
#include "core/anatomy/skeleton/thinning.h"
#include "core/anatomy/skeleton/topology.h"
#include "core/anatomy/skeleton/unit_width_skeleton.h"
#include "core/anatomy/tree/tree_extraction.h"
#include "core/base/error.h"
#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/image/volume_reader.h"
#include "core/mesh/surface.h"

namespace hepatica {

namespace {

std::string name_of(SegmentationMethod method) {
    switch (method) {
        case SegmentationMethod::multi_layer:
            return "multi_layer";
        case SegmentationMethod::vesselness:
            return "vesselness";
        case SegmentationMethod::coherent:
            break;
    }
    return "coherent";
}

nlohmann::ordered_json parameters_of(const ReconstructOptions& options) {
    nlohmann::ordered_json json;
    json["liver_mask"] = options.liver_mask ? options.liver_mask->string() : "";
    json["vessel_mask"] = options.vessel_mask ? options.vessel_mask->string() : "";
    json["method"] = name_of(options.method);
    if (options.window_hu)
        json["window_hu"] = {options.window_hu->first, options.window_hu->second};
    for (const VesselSeed& seed : options.seeds)
        json["seeds"].push_back(
            {{"position_mm", {seed.position_mm.x(), seed.position_mm.y(), seed.position_mm.z()}},
             {"system", seed.system}});
    if (!options.liver_labels.empty()) json["liver_labels"] = options.liver_labels;
    if (!options.vessel_labels.empty()) json["vessel_labels"] = options.vessel_labels;
    json["thinning"] = options.thinning == ThinningMethod::queue ? "queue" : "parallel";
    json["bridge_confidence"] = options.bridge_confidence;
    json["refinement_recursions"] = options.refinement_recursions;
    json["spacing_mm"] = options.spacing_mm;
    json["mesh"] = {{"facet_size_in_radii", options.mesh.facet_size_in_radii},
                    {"cell_size_in_radii", options.mesh.cell_size_in_radii},
                    {"target_tetrahedra", options.mesh.target_tetrahedra},
                    {"minimum_radius_mm", options.mesh.minimum_radius_mm}};
    return json;
}

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

// Labels that are named become 1, 2 ..., the others 0; without names all stay what they are.
void keep_named(LabelMap& labels, const std::vector<int>& names) {
    if (names.empty()) return;
    for (std::uint16_t& label : labels.voxels) {
        const auto name = std::ranges::find(names, static_cast<int>(label));
        label = name == names.end() ? 0 : static_cast<std::uint16_t>(name - names.begin() + 1);
    }
}

// A map of all organs is no mask of vessels.
void require_few_systems(const Mask& mask, const std::string& place) {
    constexpr int most_systems = 16;
    std::array<std::uint8_t, 256> seen{};
    for (const std::uint8_t label : mask.voxels) seen[label] = 1;
    const auto labels = std::count(seen.begin() + 1, seen.end(), 1);
    if (labels > most_systems)
        throw InputError("holds " + std::to_string(labels) + " labels", place,
                         "Name those that are vessels, one label a system: --vessel-label A,B");
}

// A mask that somebody drew, cut to what it holds.
Mask given_vessels(const ReconstructOptions& options, const Grid& ct_grid, Job& job) {
    LabelMap labels = on_grid_of(ct_grid, read_label_map(*options.vessel_mask, job),
                                 options.vessel_mask->string());
    keep_named(labels, options.vessel_labels);
    Mask mask = narrow_labels(labels, options.vessel_mask->string());
    require_few_systems(mask, options.vessel_mask->string());
    require_vessels(mask, options.vessel_mask->string());
    constexpr double margin_mm = 5.0;
    mask = crop(mask, grow_box(bounding_box(mask), mask.grid, margin_mm));
    job.begin_stage("Smoothing the vessels");
    return refine(mask, options.refinement_recursions, job);
}

Mask segmented_vessels(const ReconstructOptions& options, const Volume& ct,
                       std::vector<std::string>& warnings, Job& job) {
    SegmentationOptions segmentation;
    segmentation.method = options.method;
    segmentation.window_hu = options.window_hu;
    segmentation.seeds = options.seeds;
    segmentation.refinement_recursions = options.refinement_recursions;
    segmentation.spacing_mm = options.spacing_mm;
    if (options.liver_mask) {
        segmentation.liver =
            on_grid_of(ct.grid, read_mask(*options.liver_mask, job, options.liver_labels),
                       options.liver_mask->string());
    }
    Segmentation found = segment_vessels(ct, segmentation, job);
    warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
    require_vessels(found.mask, options.ct.string());
    return std::move(found.mask);
}

int stage_count(const ReconstructOptions& options) {
    constexpr int reading = 1, from_skeleton_to_mesh = 4, writing_by_the_caller = 1;
    constexpr int given_mask = 2, segmentation = 6;
    const int systems = options.seeds.empty() ? 0 : 1;
    return reading + (options.vessel_mask ? given_mask : segmentation + systems) +
           from_skeleton_to_mesh + writing_by_the_caller;
}

}  // namespace

Reconstruction reconstruct(const ReconstructOptions& options, Job& job) {
    job.throw_if_cancelled();
    job.expect_stages(stage_count(options));
    Reconstruction result;
    PatientCase& patient = result.patient;
    const Volume ct = read_volume(options.ct, job, &result.warnings);
    require_plausible_ct(ct, options.ct.string());
    patient.source = {options.ct.string(), ct.grid, parameters_of(options).dump()};

    patient.mask = options.vessel_mask ? given_vessels(options, ct.grid, job)
                                       : segmented_vessels(options, ct, result.warnings, job);
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

    job.begin_stage("Extracting the tree");
    TreeOptions tree_options;
    for (const VesselSeed& seed : options.seeds)
        tree_options.seeds.push_back({seed.position_mm, seed.system});
    tree_options.bridging.confidence = options.bridge_confidence;
    TreeExtraction extraction =
        extract_tree_and_bridges(patient.skeleton, patient.mask, &ct, tree_options, job);
    patient.tree = std::move(extraction.tree);
    patient.corrections.bridges = std::move(extraction.bridges);
    if (patient.tree.segments.empty())
        throw InputError("the vessels found are too small for a tree", options.ct.string(),
                         "Give a window (--window LO,HI) or a vessel mask (--vessel-mask)");

    job.begin_stage("Meshing the vessels");
    patient.mesh = tetrahedralize(patient.tree, options.mesh, job);
    job.throw_if_cancelled();
    patient.surface = surface_of(patient.mesh).mesh;
    result.stages = job.stage_times();
    return result;
}

}  // namespace hepatica
