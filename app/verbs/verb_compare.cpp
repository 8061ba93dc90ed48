// SPDX-License-Identifier: GPL-3.0-or-later
// compare: judges a case by a known truth of the same patient (core/accuracy).
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/verbs/compare_systems.h"
#include "app/verbs/flow_options.h"
#include "app/verbs/truth_place.h"
#include "app/verbs/verbs.h"
#include "core/accuracy/accuracy.h"
#include "core/base/error.h"
#include "core/image/volume_reader.h"
#include "core/patient/patient_case.h"
#include "core/tree/files/tree_json.h"

namespace hepatica {

namespace {

struct CompareChoices {
    std::filesystem::path patient;
    std::filesystem::path truth_tree;
    TreeFileOptions tree_file;  // for the truth
    std::vector<std::string> truth_masks;
    std::filesystem::path liver_mask, cava_mask;  // only where each system has its own mask
};

// A warning if the two trees are probably not of one patient. The vessels of any two livers come
// near each other in places, so the median distance decides, not the least one; and the smaller of
// both medians, because a truth may hold one of two systems, and a case half of a truth.
std::vector<std::string> doubts(const CompareChoices& options, const Accuracy& found) {
    constexpr double same_vessels_mm = 5.0;
    if (!found.centreline_median_mm || !found.truth_median_mm) return {};
    const double nearer_mm = std::min(*found.centreline_median_mm, *found.truth_median_mm);
    if (nearer_mm <= same_vessels_mm) return {};
    return {"Half of the vessels of " + options.patient.string() + " lie more than " +
            text_of(nearer_mm) + " from those of " + options.truth_tree.string() +
            ", and the reverse: are both of the same patient? Check --truth-tree and "
            "--truth-mask."};
}

Json compare_with_tree(const CompareChoices& options, Job& job) {
    if (options.truth_masks.size() != 1 || names_a_system(options.truth_masks[0]))
        throw UsageError("a true tree is judged with one mask of all its vessels", "--truth-mask",
                         "Give one FILE without a name, or leave --truth-tree out");
    if (!options.liver_mask.empty() || !options.cava_mask.empty())
        throw UsageError("organs are left out only where each system has its own mask",
                         options.liver_mask.empty() ? "--cava-mask" : "--liver-mask",
                         "Leave it out, or give --truth-mask NAME=FILE in place of --truth-tree");
    const std::filesystem::path mask_file = options.truth_masks[0];
    job.expect_stages(2);
    const PatientCase patient = read_case(options.patient);
    const VesselTree truth_tree = read_tree(options.truth_tree, options.tree_file.facts());
    const Mask truth_mask = read_mask(mask_file, job);
    require_overlap(box_of(patient.tree), options.patient, box_of(truth_tree), options.truth_tree);
    require_overlap(box_of(patient.tree), options.patient, box_of(truth_mask), mask_file);
    job.begin_stage("Comparing");
    const Accuracy found =
        compare(patient.tree, patient.mask, truth_tree, truth_mask, AccuracyOptions{}, job);
    const std::vector<std::string> warnings = doubts(options, found);
    for (const std::string& warning : warnings) spdlog::warn("{}", warning);
    const auto measured = [](std::optional<double> value) {
        return value && std::isfinite(*value) ? Json(*value) : Json();
    };
    return {{"dice", found.dice},
            {"cldice", found.cldice},
            {"centreline_mean_mm", measured(found.centreline_mean_mm)},
            {"centreline_p95_mm", measured(found.centreline_p95_mm)},
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
    auto options = std::make_shared<CompareChoices>();
    CLI::App& verb = line.add_verb(
        "compare", "Judge a case by a known truth of the same patient",
        [options](Job& job) {
            if (!options->truth_tree.empty()) return compare_with_tree(*options, job);
            return compare_systems(
                {options->patient, options->truth_masks, options->liver_mask, options->cava_mask},
                job);
        },
        [options](const Json& answer) {
            return options->truth_tree.empty() ? tables_of_systems(answer) : answer;
        });
    verb.add_option("case", options->patient, "Case to judge")->required();
    CLI::Option* truth_tree =
        verb.add_option("--truth-tree", options->truth_tree,
                        "Centrelines with radii (.vtp, .swc or .json); refused where they lie "
                        "elsewhere, with a warning where half of both trees is 5 mm apart");
    options->tree_file.add_to(verb);
    for (const char* of_tree : {"--tree-space", "--radius-mm"})
        verb.get_option(of_tree)->needs(truth_tree);
    verb.add_option("--truth-mask", options->truth_masks,
                    "Vessel voxels (NIfTI ...): one FILE beside --truth-tree, else NAME=FILE for "
                    "each system: portal, hepatic, artery")
        ->required()
        ->allow_extra_args(false);
    verb.add_option("--liver-mask", options->liver_mask,
                    "With NAME=FILE: judge only what lies in this liver, vessels closed");
    verb.add_option("--cava-mask", options->cava_mask,
                    "With NAME=FILE: leave out what lies within 3 mm of this vena cava; where the "
                    "hepatic mask is wider than 6 mm in radius it is left out anyway");
}

}  // namespace hepatica
