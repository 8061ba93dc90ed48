// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the steps after the segmentation: fill cavities, thin, extract the tree, label voxels and
// segments, mesh.
#include "core/reconstruction/from_voxels.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/image/filters.h"
#include "core/image/mask.h"
#include "core/image/morphology.h"
#include "core/image/voxel_loop.h"
#include "core/mesh/surface.h"
#include "core/patient/liver_segments.h"
#include "core/reconstruction/mask_of_tree.h"
#include "core/reconstruction/plausible_skeleton.h"
#include "core/skeleton/topology.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "core/tree/tree_extraction.h"

namespace hepatica {

namespace {

// The liver's segments end the stage in which systems are told apart: its share before them.
constexpr double segments_from = 0.6;

// Holes inside a vessel are noise or clots and would become closed surfaces in the skeleton. A
// filled voxel takes the system of the voxel before it in the row, which is filled or vessel.
void fill_cavities(Mask& mask, const Job& job) {
    const Mask filled = fill_holes(mask, job);
    for_each_voxel_in_order(mask.voxels.size(), job, [&](std::size_t i) {
        if (i > 0 && mask.voxels[i] == 0 && filled.voxels[i] != 0)
            mask.voxels[i] = mask.voxels[i - 1];
    });
}

VoxelCounts counts_of(const Mask& mask) {
    const Betti betti = betti_numbers(mask);
    return {object_count(mask), betti.components, betti.tunnels, betti.cavities};
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
    say(extraction.beside_trunk, " of vessels",
        "what joins the portal trunk before it divides mostly comes from other organs");
}

// Fills tree, gaps and doubts of the case; its voxels take the systems of the tree.
void extract(const FromVoxelsOptions& options, const Volume& ct, PatientCase& patient,
             std::vector<std::string>& warnings, Job& job) {
    TreeOptions tree_options;
    tree_options.seeds = options.seeds;
    tree_options.kept_mm = options.kept_mm;
    tree_options.find_systems = options.find_systems;
    tree_options.systems_before = options.systems_before;
    tree_options.liver_mm = box_mm(bounding_box(patient.organs), patient.organs.grid);
    tree_options.portal_trunk_mm = options.portal_trunk_mm;
    tree_options.shorten_trunk = options.shorten_trunk;
    tree_options.bridging.confidence = options.bridge_confidence;
    job.begin_stage("Extracting the tree");
    TreeExtraction extraction = in_part(job, 0.0, 1.0, [&] {
        return extract_tree_and_bridges(patient.skeleton, patient.mask, &ct, tree_options, job);
    });
    warn_of_left_out(extraction, tree_options, warnings);
    patient.tree = std::move(extraction.tree);
    patient.corrections = {};
    patient.corrections.bridges = std::move(extraction.bridges);
    patient.doubts = doubts_of(patient.tree);
    patient.doubts->opened_loops = extraction.opened_loops;
    patient.doubts->contrast_hu = options.of_image.contrast_hu;
    patient.doubts->noise_hu = options.of_image.noise_hu;
    patient.doubts->coarsest_spacing_mm = options.of_image.coarsest_spacing_mm;
    job.begin_stage("Telling the systems apart");
    in_part(job, 0.0, segments_from, [&] {
        follow_tree(patient.mask, patient.tree, tree_options.find_systems, job,
                    extraction.trunk_left_out);
    });
}

}  // namespace

VoxelChecks make_tree(const FromVoxelsOptions& options, const Volume& ct, PatientCase& patient,
                      std::vector<std::string>& warnings, Job& job) {
    VoxelChecks checks;
    fill_cavities(patient.mask, job);
    job.advance(0.8);
    checks.mask = counts_of(patient.mask);
    job.advance(1.0);
    job.begin_stage("Thinning to the skeleton");
    const Mask skeleton = thin(patient.mask, options.thinning, job);
    if (options.find_systems) require_plausible_skeleton(skeleton, job);
    job.begin_stage("Making the skeleton one voxel wide");
    patient.skeleton = unit_width(skeleton, job);
    checks.skeleton = counts_of(patient.skeleton);
    checks.crowded_points = crowded_point_count(patient.skeleton);
    extract(options, ct, patient, warnings, job);
    return checks;
}

void make_body(const MeshOptions& options, PatientCase& patient, std::vector<std::string>& warnings,
               Job& job) {
    in_part(job, segments_from, 1.0, [&] { label_segments(patient, job); });
    patient.warnings = warnings;
    patient.warnings_of_image = 0;
    std::ranges::copy(sentences(patient.doubts, patient.tree), std::back_inserter(warnings));
    job.begin_stage("Meshing the vessels");
    std::vector<std::string> of_mesh;
    patient.mesh = in_part(job, 0.0, 1.0,
                           [&] { return tetrahedralize(patient.tree, options, job, &of_mesh); });
    for (std::vector<std::string>* list : {&patient.warnings, &warnings})
        list->insert(list->end(), of_mesh.begin(), of_mesh.end());
    job.throw_if_cancelled();
    patient.surface = surface_of(patient.mesh).mesh;
}

}  // namespace hepatica
