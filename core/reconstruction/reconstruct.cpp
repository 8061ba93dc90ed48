// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/reconstruct.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/image/volume_reader.h"
#include "core/mesh/surface.h"
#include "core/segmentation/gaussian_refinement.h"
#include "core/skeleton/thinning.h"
#include "core/skeleton/topology.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "core/tree/extraction/tree_extraction.h"

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

std::string text_of(const Vec3& position_mm) {
    char text[96];
    std::snprintf(text, sizeof text, "%.6g,%.6g,%.6g", position_mm.x(), position_mm.y(),
                  position_mm.z());
    return text;
}

void require_seeds_in_image(const ReconstructOptions& options, const Grid& grid) {
    for (const VesselSeed& seed : options.seeds) {
        const Vec3 index = grid.to_index(seed.position_mm);
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis)
            inside = inside && index[axis] >= -0.5 && index[axis] <= grid.dims[axis] - 0.5;
        if (inside) continue;
        const Vec3 corner = grid.to_mm(0, 0, 0);
        const Vec3 opposite = grid.to_mm(grid.dims[0] - 1, grid.dims[1] - 1, grid.dims[2] - 1);
        throw InputError(text_of(seed.position_mm) +
                             " lies outside the image, which reaches from " + text_of(corner) +
                             " to " + text_of(opposite),
                         "--seed-mm",
                         "Give a place inside a vessel in patient space (LPS, mm); other programs "
                         "may show RAS: there change the sign of X and Y");
    }
}

// The trunks leave the liver, but not far from it.
void require_seeds_near_liver(const ReconstructOptions& options, const Mask& liver) {
    constexpr double reach_mm = 10.0;
    for (const VesselSeed& seed : options.seeds) {
        double nearest_mm = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < liver.voxels.size(); ++i) {
            if (liver.voxels[i] == 0) continue;
            const auto [x, y, z] = liver.grid.index_of(i);
            nearest_mm =
                std::min(nearest_mm, (liver.grid.to_mm(x, y, z) - seed.position_mm).norm());
            if (nearest_mm <= reach_mm) break;
        }
        if (nearest_mm <= reach_mm) continue;
        throw InputError(text_of(seed.position_mm) + " lies " +
                             std::to_string(std::lround(nearest_mm)) + " mm from the liver of " +
                             options.liver_mask->string(),
                         "--seed-mm", "Give a place inside a vessel in or at the liver (LPS, mm)");
    }
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
        require_seeds_near_liver(options, *segmentation.liver);
    }
    Segmentation found = segment_vessels(ct, segmentation, job);
    warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
    require_vessels(found.mask, options.ct.string());
    return std::move(found.mask);
}

// Portal and hepatic veins that touch make loops, which a tree of one system has none of.
void warn_of_loops(const VesselTree& tree, std::vector<std::string>& warnings) {
    const auto loops = std::ranges::count_if(
        tree.segments, [](const VesselSegment& segment) { return segment.closes_loop; });
    const bool one_system = std::ranges::all_of(tree.segments, [&](const VesselSegment& segment) {
        return segment.system == tree.segments.front().system;
    });
    if (loops == 0 || !one_system) return;
    warnings.push_back(
        "The vessels are one system with " + std::to_string(loops) +
        (loops == 1 ? " loop" : " loops") +
        ", made where branches touch or where portal and hepatic veins do. If both veins are in "
        "it, "
        "tell them apart by a seed inside each, --seed-mm X,Y,Z,1 and --seed-mm X,Y,Z,2; other "
        "loops can be cut: hepatica-cli edit.");
}

// `warnings` holds what was found so far, also where it throws.
Reconstruction reconstruct(const ReconstructOptions& options, std::vector<std::string>& warnings,
                           Job& job) {
    Reconstruction result;
    PatientCase& patient = result.patient;
    const Volume ct = read_volume(options.ct, job, &warnings, options.series);
    require_plausible_ct(ct, options.ct.string());
    require_seeds_in_image(options, ct.grid);
    patient.source = {options.ct.string(), ct.grid, parameters_of(options).dump()};

    patient.mask = options.vessel_mask ? given_vessels(options, ct.grid, job)
                                       : segmented_vessels(options, ct, warnings, job);
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
    warn_of_loops(patient.tree, warnings);

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
    constexpr int reading = 1, from_skeleton_to_mesh = 4;
    constexpr int given_mask = 2, segmentation = 6, telling_systems_apart = 1;
    if (options.vessel_mask) return reading + given_mask + from_skeleton_to_mesh;
    return reading + segmentation + (options.seeds.empty() ? 0 : telling_systems_apart) +
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
