// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "app/verbs/verbs.h"
#include "core/anatomy/accuracy.h"
#include "core/anatomy/tree_files/tree_io.h"
#include "core/image/volume_reader.h"
#include "core/patient/patient_case.h"

namespace hepatica {

namespace {

struct Options {
    std::filesystem::path patient;
    std::filesystem::path truth_tree;
    std::filesystem::path truth_mask;
};

Json run(const Options& options, Job& job) {
    const PatientCase patient = read_case(options.patient);
    const VesselTree truth_tree = read_tree(options.truth_tree);
    const Mask truth_mask = read_mask(options.truth_mask, job);
    job.begin_stage("Comparing");
    const Accuracy found =
        compare(patient.tree, patient.mask, truth_tree, truth_mask, AccuracyOptions{}, job);
    const auto measured = [](std::optional<double> value) { return value ? Json(*value) : Json(); };
    return {{"dice", found.dice},
            {"cldice", found.cldice},
            {"centreline_mean_mm", found.centreline_mean_mm},
            {"centreline_p95_mm", found.centreline_p95_mm},
            {"length_found", found.length_found},
            {"radius_mae_mm", measured(found.radius_mae_mm)},
            {"radius_bias_mm", measured(found.radius_bias_mm)},
            {"bifurcation_recall", found.bifurcation_recall},
            {"bifurcation_precision", found.bifurcation_precision},
            {"truth_bifurcations", found.truth_bifurcations},
            {"tree_bifurcations", found.tree_bifurcations},
            {"components", found.components},
            {"truth_components", found.truth_components},
            {"voxel_mm", found.voxel_mm}};
}

}  // namespace

void add_compare(CommandLine& line) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = line.add_verb("compare", "Judge a case by a known truth",
                                   [options](Job& job) { return run(*options, job); });
    verb.add_option("case", options->patient, "Case to judge")->required();
    verb.add_option("--truth-tree", options->truth_tree,
                    "Centrelines with radii (.vtp, .swc or .json)")
        ->required();
    verb.add_option("--truth-mask", options->truth_mask, "Vessel voxels (NIfTI ...)")->required();
}

}  // namespace hepatica
