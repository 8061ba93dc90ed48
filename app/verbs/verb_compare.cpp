// SPDX-License-Identifier: GPL-3.0-or-later
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "app/verbs/flow_options.h"
#include "app/verbs/verbs.h"
#include "core/accuracy/accuracy.h"
#include "core/base/error.h"
#include "core/image/filters.h"
#include "core/image/volume_reader.h"
#include "core/patient/patient_case.h"
#include "core/tree/files/tree_json.h"

namespace hepatica {

namespace {

struct Options {
    std::filesystem::path patient;
    std::filesystem::path truth_tree;
    TreeFileOptions tree_file;  // of the truth
    std::filesystem::path truth_mask;
};

using Box = Eigen::AlignedBox3d;

Box box_of(const VesselTree& tree) {
    Box box;
    for (const VesselSegment& segment : tree.segments)
        for (const Vec3& point : segment.points_mm) box.extend(point);
    return box;
}

Box box_of(const Mask& mask) {
    const IndexBox voxels = bounding_box(mask);
    Box box;
    for (int corner = 0; !voxels.empty() && corner < 8; ++corner)
        box.extend(mask.grid.to_mm((corner & 1) != 0 ? voxels.end[0] - 1 : voxels.begin[0],
                                   (corner & 2) != 0 ? voxels.end[1] - 1 : voxels.begin[1],
                                   (corner & 4) != 0 ? voxels.end[2] - 1 : voxels.begin[2]));
    return box;
}

std::string text_of(double millimetres) {
    return std::to_string(std::lround(millimetres)) + " mm";
}

// Vessels of one patient's scan share a place, however badly they were found.
void require_overlap(const Box& of_case, const std::filesystem::path& patient, const Box& of_truth,
                     const std::filesystem::path& truth) {
    if (of_case.isEmpty() || of_truth.isEmpty() || of_case.intersects(of_truth)) return;
    throw InputError("its vessels and those of " + patient.string() + " lie " +
                         text_of(of_case.exteriorDistance(of_truth)) + " apart",
                     truth.string(),
                     "Give the truth of the same patient, in the same coordinates (LPS, mm)");
}

// Nothing where the two trees may well be one patient's. In a liver the vessels of any two patients
// lie near each other here and there, so that the median is asked and not the least distance; and
// the smaller of the two, since a truth may hold one system of two, and a case half of a truth.
std::vector<std::string> doubts(const Options& options, const Accuracy& found) {
    constexpr double same_vessels_mm = 5.0;
    if (!found.centreline_median_mm || !found.truth_median_mm) return {};
    const double nearer_mm = std::min(*found.centreline_median_mm, *found.truth_median_mm);
    if (nearer_mm <= same_vessels_mm) return {};
    return {"Half of the vessels of " + options.patient.string() + " lie more than " +
            text_of(nearer_mm) + " from those of " + options.truth_tree.string() +
            ", and the reverse: are both of the same patient? Check --truth-tree and "
            "--truth-mask."};
}

Json run(const Options& options, Job& job) {
    job.expect_stages(2);
    const PatientCase patient = read_case(options.patient);
    const VesselTree truth_tree = read_tree(options.truth_tree, options.tree_file.facts());
    const Mask truth_mask = read_mask(options.truth_mask, job);
    require_overlap(box_of(patient.tree), options.patient, box_of(truth_tree), options.truth_tree);
    require_overlap(box_of(patient.tree), options.patient, box_of(truth_mask), options.truth_mask);
    job.begin_stage("Comparing");
    const Accuracy found =
        compare(patient.tree, patient.mask, truth_tree, truth_mask, AccuracyOptions{}, job);
    const std::vector<std::string> warnings = doubts(options, found);
    for (const std::string& warning : warnings) spdlog::warn("{}", warning);
    const auto measured = [](std::optional<double> value) { return value ? Json(*value) : Json(); };
    return {{"dice", found.dice},
            {"cldice", found.cldice},
            {"centreline_mean_mm", found.centreline_mean_mm},
            {"centreline_p95_mm", found.centreline_p95_mm},
            {"centreline_median_mm", measured(found.centreline_median_mm)},
            {"truth_median_mm", measured(found.truth_median_mm)},
            {"length_found", found.length_found},
            {"radius_mae_mm", measured(found.radius_mae_mm)},
            {"radius_bias_mm", measured(found.radius_bias_mm)},
            {"bifurcation_recall", found.bifurcation_recall},
            {"bifurcation_precision", found.bifurcation_precision},
            {"truth_bifurcations", found.truth_bifurcations},
            {"tree_bifurcations", found.tree_bifurcations},
            {"components", found.components},
            {"truth_components", found.truth_components},
            {"voxel_mm", found.voxel_mm},
            {"systems", json_of(systems_of(patient.tree))},
            {"warnings", warnings}};
}

}  // namespace

void add_compare(CommandLine& line) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = line.add_verb("compare", "Judge a case by a known truth of the same patient",
                                   [options](Job& job) { return run(*options, job); });
    verb.add_option("case", options->patient, "Case to judge")->required();
    verb.add_option("--truth-tree", options->truth_tree,
                    "Centrelines with radii (.vtp, .swc or .json); refused where they lie "
                    "elsewhere, with a warning where half of both trees is 5 mm apart")
        ->required();
    options->tree_file.add_to(verb);
    verb.add_option("--truth-mask", options->truth_mask, "Vessel voxels (NIfTI ...)")->required();
}

}  // namespace hepatica
