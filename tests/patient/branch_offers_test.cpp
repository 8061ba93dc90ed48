// SPDX-License-Identifier: GPL-3.0-or-later
// Branches that are offered with a case, on the tree of parted_patient.h.
#include "core/patient/branch_offers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/patient/corrections.h"
#include "core/tree/editing/tree_edit.h"
#include "tests/patient/parted_patient.h"

namespace hepatica {
namespace {

using testing::ElementsAre;

Bridge branch_along(std::vector<Vec3> path_mm, double confidence = 0.5) {
    Bridge branch;
    const Centreline line = resampled({path_mm, std::vector<double>(path_mm.size(), 0.8)}, 0.7);
    branch.path_mm = line.points_mm;
    branch.radii_mm = line.radii_mm;
    branch.from_radius_mm = branch.to_radius_mm = 0.8;
    branch.gap_mm = arclengths_mm(branch.path_mm).back();
    branch.confidence = confidence;
    return branch;
}

const Vec3 on_trunk(0.05, 10, 1.5);

// From the trunk to the patient's left, and a twig of it upwards.
Bridge branch() {
    return branch_along({on_trunk, Vec3(20, 8, 1)}, 0.6);
}
Bridge twig() {
    return branch_along({Vec3(14, 8.6, 1.1), Vec3(14, 8, 12)}, 0.8);
}

TEST(BranchOffers, LeadOutOfAVesselAndCloseNoLoop) {
    const VesselTree tree = test::parted_tree();
    EXPECT_TRUE(leads_out_of(tree, branch()));
    EXPECT_TRUE(leads_out_of(tree, branch_along({Vec3(3.6, 10, 1.5), Vec3(20, 8, 1)})))
        << "from its wall";
    EXPECT_FALSE(leads_out_of(tree, twig())) << "hangs on nothing yet";
    EXPECT_FALSE(leads_out_of(tree, branch_along({on_trunk, Vec3(0.1, 19, 3)}))) << "within";
    EXPECT_FALSE(leads_out_of(tree, branch_along({on_trunk, Vec3(-20, 20, 5), Vec3(-12, 31, 5)})))
        << "into another";
    EXPECT_FALSE(leads_out_of(VesselTree{}, branch()));
}

TEST(BranchOffers, AreThoseThatHangOnTheTreeOrOnOneAnother) {
    PatientCase patient = test::patient_with_bridges();
    const std::size_t gaps = patient.corrections.bridges.size();
    const Bridge away = branch_along({Vec3(80, 80, 80), Vec3(90, 90, 90)});
    offer_branches({away, twig(), branch()}, patient);
    ASSERT_EQ(patient.corrections.bridges.size(), gaps + 2);
    EXPECT_EQ(patient.corrections.bridges[gaps].path_mm, twig().path_mm) << "the surest first";
    EXPECT_EQ(patient.corrections.bridges[gaps + 1].path_mm, branch().path_mm);
    EXPECT_EQ(state_of_bridge(patient, gaps), BridgeState::needless);
    EXPECT_EQ(state_of_bridge(patient, gaps + 1), BridgeState::open);
    EXPECT_EQ(open_bridges(patient).size(), gaps + 1);
    EXPECT_EQ(open_gaps(patient).size(), gaps);
}

TEST(BranchOffers, ATakenOneIsDrawnAndItsTwigIsOfferedThen) {
    PatientCase patient = test::patient_with_bridges();
    patient.corrections.bridges.clear();
    offer_branches({twig(), branch()}, patient);
    Job job;
    const std::size_t ends = patient.tree.segments.size();
    const PatientCase taken = with_edits(patient, {acceptance_of(branch())}, job);
    EXPECT_EQ(taken.tree.segments.size(), ends + 2) << "the trunk is parted, and the branch";
    EXPECT_EQ(roots(taken.tree).size(), roots(patient.tree).size());
    EXPECT_EQ(state_of_bridge(taken, 1), BridgeState::accepted);
    EXPECT_EQ(state_of_bridge(taken, 0), BridgeState::open);
    // All at once, the twig after what carries it, although it is surer.
    const std::vector<TreeEdit> all = acceptances(patient, 0.5, job);
    EXPECT_THAT(all, ElementsAre(acceptance_of(branch()), acceptance_of(twig())));
    EXPECT_TRUE(acceptances(patient, 0.7, job).empty()) << "what carries the twig is less sure";
    EXPECT_EQ(acceptances(patient, 0.9, job).size(), 0u);
}

TEST(BranchOffers, AreRefusedAndKeptWithTheCase) {
    PatientCase patient = test::patient_with_bridges();
    offer_branches({twig(), branch()}, patient);
    const PatientCase refused = with_edited_tree(patient, {refusal_of(branch())});
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / "branch offers.hep";
    write_case(folder, refused);
    const PatientCase read = read_case(folder);
    ASSERT_EQ(read.corrections.bridges.size(), 4u);
    EXPECT_EQ(state_of_bridge(read, 3), BridgeState::refused);
    EXPECT_EQ(read.corrections.bridges[3].radii_mm, branch().radii_mm);
    EXPECT_EQ(bridges_to_json(read.corrections.bridges),
              bridges_to_json(patient.corrections.bridges));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace hepatica
