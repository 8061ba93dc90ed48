// SPDX-License-Identifier: GPL-3.0-or-later
// Thinning, unit width and extraction on vessels that an expert outlined in a patient, and on a
// phantom by another hand.
#include <gtest/gtest.h>

#include "core/accuracy/accuracy.h"
#include "core/image/volume_reader.h"
#include "core/skeleton/thinning.h"
#include "core/skeleton/topology.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "core/tree/files/tree_io.h"
#include "core/tree/tree_extraction.h"
#include "tests/support/test_data.h"

namespace hepatica {

using namespace test;

class PatientMask : public testing::TestWithParam<std::tuple<const char*, ThinningMethod>> {};

INSTANTIATE_TEST_SUITE_P(
    Ircadb01, PatientMask,
    testing::Combine(testing::Values("portalvein", "venoussystem"),
                     testing::Values(ThinningMethod::queue, ThinningMethod::parallel)),
    [](const auto& instance) {
        return std::string(std::get<0>(instance.param)) +
               (std::get<1>(instance.param) == ThinningMethod::queue ? "Queue" : "Parallel");
    });

TEST_P(PatientMask, SkeletonHasTheTopologyOfTheMaskAndUnitWidth) {
    const auto [name, method] = GetParam();
    const auto file = shared_data() / "ircadb01_case01/masks" / (std::string(name) + ".nii.gz");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
    Job job;
    const Mask mask = read_mask(file, job);
    const Mask skeleton = unit_width(thin(mask, method, job), job);
    EXPECT_EQ(betti_numbers(skeleton), betti_numbers(mask));
    EXPECT_EQ(removable_point_count(skeleton), 0u);
    const VesselTree tree = extract_tree(skeleton, mask, nullptr, {}, job);
    validate(tree);
    EXPECT_GT(tree.segments.size(), 10u);
}

// Three systems at once would touch; each is taken by its own mask.
class OtherPhantom : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Vascusynth, OtherPhantom, testing::Values("portal", "hvein", "artery"));

TEST_P(OtherPhantom, TreeFromItsMaskAndCtIsTheTruth) {
    const auto folder = shared_data() / "vascusynth";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    Job job;
    const std::string name = GetParam();
    const Mask mask = read_mask(folder / ("mask_" + name + ".nii.gz"), job);
    const Volume ct = read_volume(folder / "phantom_ct_hu.nii.gz", job);
    const VesselTree truth =
        read_tree(folder / ("tree_" + name + ".vtp"), {.space = PatientSpace::lps});
    const Mask skeleton = unit_width(thin(mask, ThinningMethod::queue, job), job);
    const VesselTree tree = extract_tree(skeleton, mask, &ct, {}, job);
    AccuracyOptions options;
    options.length_radius_mm = 1.2;
    const Accuracy accuracy = compare(tree, mask, truth, mask, options, job);
    RecordProperty("centreline_mean_mm", std::to_string(accuracy.centreline_mean_mm));
    EXPECT_LT(accuracy.centreline_mean_mm, 0.5 * accuracy.voxel_mm);
    EXPECT_GT(accuracy.length_found, 0.9);
    EXPECT_LT(std::abs(accuracy.radius_bias_mm.value()), 0.1 * accuracy.voxel_mm);
    EXPECT_LT(accuracy.radius_mae_mm.value(), 0.3 * accuracy.voxel_mm);
    EXPECT_GE(accuracy.bifurcation_recall, 0.9);
    EXPECT_GE(accuracy.bifurcation_precision, 0.9);
}

}  // namespace hepatica
