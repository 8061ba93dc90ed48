// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/corrections.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/sha256.h"
#include "core/base/text_file.h"
#include "core/image/volume_reader.h"
#include "core/mesh/manifold_attempts.h"
#include "core/patient/painted_tumours.h"
#include "tests/patient/parted_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

using test::last_gap;
using test::patient_with_bridges;

TreeEdit deletion_at(const Vec3& at) {
    TreeEdit edit;
    edit.kind = TreeEditKind::delete_branch;
    edit.at_mm = at;
    return edit;
}

TEST(Corrections, TheBodyIsMeshedAsTheCaseSays) {
    PatientCase patient;
    patient.source.parameters_json =
        R"({"mesh":{"facet_size_in_radii":0.5,"target_tetrahedra":7000,"minimum_radius_mm":1}})";
    const MeshOptions options = mesh_options_of(patient);
    EXPECT_EQ(options.facet_size_in_radii, 0.5);
    EXPECT_EQ(options.cell_size_in_radii, MeshOptions{}.cell_size_in_radii);
    EXPECT_EQ(options.target_tetrahedra, 7000);
    EXPECT_EQ(options.minimum_radius_mm, 1.0);
}

TEST(Corrections, AParameterOfTheWrongTypeIsNamed) {
    for (const auto& [mesh, problem] :
         {std::pair{R"({"facet_size_in_radii":"fine"})",
                    "its parameter mesh.facet_size_in_radii is \"fine\", not a number"},
          {R"({"cell_size_in_radii":[]})",
           "its parameter mesh.cell_size_in_radii is [], not a number"},
          {R"({"minimum_radius_mm":null})",
           "its parameter mesh.minimum_radius_mm is null, not a number"},
          {R"({"target_tetrahedra":1.5})",
           "its parameter mesh.target_tetrahedra is 1.5, not a whole number in range"},
          {"7", "its parameter mesh is 7, not an object"}}) {
        PatientCase patient;
        patient.source.parameters_json = std::string(R"({"mesh":)") + mesh + "}";
        try {
            mesh_options_of(patient);
            ADD_FAILURE() << mesh;
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), "case.json");
            EXPECT_EQ(error.problem(), problem);
        }
    }
}

TEST(Corrections, ABridgeIsOpenUntilItIsAcceptedOrNeedless) {
    const PatientCase patient = patient_with_bridges();
    ASSERT_EQ(roots(patient.tree).size(), 2u);
    ASSERT_EQ(open_bridges(patient).size(), 2u);
    Job job;
    const PatientCase joined =
        with_edits(patient, {acceptance_of(patient.corrections.bridges[0])}, job);
    validate(joined.tree);
    EXPECT_EQ(roots(joined.tree).size(), 1u);
    EXPECT_TRUE(open_bridges(joined).empty());
    // Marked, and only the gap itself.
    EXPECT_NEAR(bridged_length_mm(joined.tree), 8.4, 0.5);
    EXPECT_EQ(bridged_length_mm(patient.tree), 0.0);
    EXPECT_NE(hash_of(joined), hash_of(patient));
}

TEST(Corrections, ABridgeCanBeRefusedAndOfferedAgain) {
    PatientCase patient = patient_with_bridges();
    EXPECT_EQ(state_of_bridge(patient, 0), BridgeState::open);
    Job job;
    const std::vector<TreeEdit> refusal{refusal_of(patient.corrections.bridges[0])};
    EXPECT_EQ(edits_from_json(edits_to_json(refusal), ""), refusal);
    const PatientCase refused = with_edits(patient, refusal, job);
    EXPECT_EQ(state_of_bridge(refused, 0), BridgeState::refused);
    EXPECT_EQ(state_of_bridge(refused, 1), BridgeState::open);
    ASSERT_EQ(open_bridges(refused).size(), 1u);
    EXPECT_EQ(open_bridges(refused)[0].path_mm, test::other_gap);
    EXPECT_EQ(acceptances(refused, 0.2, job).size(), 0u);
    EXPECT_EQ(tree_edits(refusal).size(), 0u);
    EXPECT_EQ(tumour_strokes(refusal).size(), 0u);
    EXPECT_EQ(hash_of(with_edits(refused, {}, job)), hash_of(patient));
    const PatientCase joined =
        with_edits(patient, {acceptance_of(patient.corrections.bridges[0])}, job);
    EXPECT_EQ(state_of_bridge(joined, 0), BridgeState::accepted);
    EXPECT_EQ(state_of_bridge(joined, 1), BridgeState::needless);
}

// Its ends may have moved a little once the vessels were rebuilt, and may be told in the other
// order.
TEST(Corrections, ARefusalIsOfTheGapBetweenTwoPlacesAndOfNoOther) {
    const PatientCase patient = patient_with_bridges();
    Bridge gap = patient.corrections.bridges[0];
    const TreeEdit refusal = refusal_of(gap);
    EXPECT_TRUE(refuses(refusal, gap));
    EXPECT_FALSE(refuses(refusal, patient.corrections.bridges[1]));
    std::ranges::reverse(gap.path_mm);
    EXPECT_TRUE(refuses(refusal, gap));
    gap.path_mm.back() += Vec3(0.0, 2.9, 0.0);
    EXPECT_TRUE(refuses(refusal, gap));
    gap.path_mm.back() += Vec3(0.0, 0.2, 0.0);
    EXPECT_FALSE(refuses(refusal, gap));
    gap = patient.corrections.bridges[0];
    gap.built = true;
    EXPECT_FALSE(refuses(refusal, gap)) << "one that is built is removed by a cut";
}

// Earlier programs wrote a mark beside the gap.
TEST(Corrections, AMarkOfAnEarlierProgramIsReadAsARefusal) {
    const PatientCase patient = patient_with_bridges();
    const fs::path folder = fs::path(testing::TempDir()) / "marked refusal.hep";
    write_case(folder, patient);
    const fs::path file = folder / "corrections.json";
    auto json = nlohmann::json::parse(read_text_file(file, ""));
    json["bridges"][0]["refused"] = true;
    write_text_atomically(file, json.dump());
    auto header = nlohmann::json::parse(read_text_file(folder / "case.json", ""));
    header["sha256"]["corrections.json"] = sha256_of_file(file);
    write_text_atomically(folder / "case.json", header.dump());
    const PatientCase read = read_case(folder);
    EXPECT_EQ(state_of_bridge(read, 0), BridgeState::refused);
    EXPECT_EQ(state_of_bridge(read, 1), BridgeState::open);
    write_case(folder, read);
    EXPECT_EQ(read_case(folder).corrections.edits, read.corrections.edits);
    fs::remove_all(folder);
}

// The reconstruction built it; refusing parts the vessels again, and undoing that joins them.
TEST(Corrections, ABridgeThatWasBuiltIsRefusedByACut) {
    PatientCase patient = patient_with_bridges();
    patient.tree = edited(patient.tree, acceptance_of(patient.corrections.bridges[0]));
    patient.corrections.bridges[0].built = true;
    ASSERT_EQ(roots(patient.tree).size(), 1u);
    EXPECT_EQ(state_of_bridge(patient, 0), BridgeState::built);
    Job job;
    const PatientCase parted =
        with_edits(patient, {refusal_of(patient.corrections.bridges[0])}, job);
    EXPECT_EQ(roots(parted.tree).size(), 2u);
    EXPECT_EQ(state_of_bridge(parted, 0), BridgeState::refused);
    EXPECT_EQ(state_of_bridge(with_edits(parted, {}, job), 0), BridgeState::built);
}

TEST(Corrections, AcceptsByConfidenceTheBestFirst) {
    const PatientCase patient = patient_with_bridges();
    Job job;
    EXPECT_EQ(acceptances(patient, 0.3, job).size(), 0u);
    EXPECT_EQ(acceptances(patient, 0.2, job).size(), 1u);
    // Both are confident enough, but the first joins what the second would have.
    const auto all = acceptances(patient, 0.0, job);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].path_mm, last_gap);
}

TEST(Corrections, WhatIsOfferedIsLookedForAfterWhatIsWantedAlready) {
    const PatientCase patient = patient_with_bridges();
    Job job;
    const auto wanted = acceptance_of(patient.corrections.bridges[1]);
    EXPECT_EQ(acceptances_after(patient, {}, 0.0, job).size(), 1u);
    EXPECT_TRUE(acceptances_after(patient, {wanted}, 0.0, job).empty())
        << "it makes the other one needless";
    job.cancel();
    EXPECT_THROW(acceptances_after(patient, {}, 0.0, job), Cancelled);
}

// Of which older programs know nothing.
TEST(Corrections, AStepOfEditsIsKeptWithThem) {
    std::vector<TreeEdit> edits(2, acceptance_of(patient_with_bridges().corrections.bridges[0]));
    EXPECT_EQ(edits_to_json(edits).find("step"), std::string::npos);
    edits[1].step = 7;
    EXPECT_EQ(edits_from_json(edits_to_json(edits), ""), edits);
    std::string without = edits_to_json(edits);
    without.replace(without.find("\"step\": 7"), 9, "\"step\": 0");
    EXPECT_THROW(edits_from_json(without, "list"), InputError);
}

// A case does not keep the vessels from before its rebuildings, so these stay where corrections
// from before them are taken back.
TEST(Corrections, WhatIsAddedAfterSomeWereTakenBackComesAfterTheRebuilding) {
    const TreeEdit one = deletion_at(Vec3(1, 0, 0)), two = deletion_at(Vec3(2, 0, 0)),
                   three = deletion_at(Vec3(3, 0, 0));
    PatientCase before;
    before.corrections.edits = {one, two};
    note_rebuilding({}, 4, before);
    const auto after_edits = [](const std::vector<Rebuilding>& rebuilt) {
        std::vector<std::size_t> all;
        for (const Rebuilding& rebuilding : rebuilt) all.push_back(rebuilding.after_edits);
        return all;
    };
    using Sizes = std::vector<std::size_t>;
    const auto among = [&](const std::vector<TreeEdit>& edits) {
        return after_edits(rebuildings_among(edits, before.corrections));
    };
    EXPECT_EQ(among({one, two, three}), Sizes{2});
    EXPECT_EQ(among({one}), Sizes{2}) << "the other may be made again";
    EXPECT_EQ(among({one, three}), Sizes{1});
    EXPECT_EQ(among({three, two}), Sizes{0});
    PatientCase again;
    again.corrections.edits = {one};
    note_rebuilding(before, 1, again);
    EXPECT_EQ(after_edits(again.corrections.rebuilt), (Sizes{1, 1}));
}

TEST(Corrections, TakingAllEditsBackGivesTheCaseBeforeToTheByte) {
    const PatientCase patient = patient_with_bridges();
    Job job;
    const std::vector<TreeEdit> edits{acceptance_of(patient.corrections.bridges[0]),
                                      deletion_at(Vec3(5, 50, -4))};
    const PatientCase edited = with_edits(patient, edits, job);
    EXPECT_EQ(edited.corrections.edits, edits);
    const PatientCase one_less = with_edits(edited, {edits[0]}, job);
    EXPECT_EQ(hash_of(one_less), hash_of(with_edits(patient, {edits[0]}, job)));
    const PatientCase back = with_edits(edited, {}, job);
    EXPECT_EQ(hash_of(back), hash_of(patient));
    EXPECT_TRUE(back.corrections.extracted.segments.empty());
    EXPECT_EQ(open_bridges(back).size(), 2u);
}

// An edit of a case whose vessels touch was refused, which left no way to part them.
TEST(Corrections, ABodyThatMeetsItselfIsWarnedOfAsLongAsItDoes) {
    PatientCase patient = patient_with_bridges();
    patient.warnings = {"of the image", "of the vessels"};
    std::vector<std::string> of_mesh;
    report_unclosed(1, 2, &of_mesh);
    PatientCase touching = patient;
    replace_warnings_of_mesh(of_mesh, touching);
    replace_warnings_of_mesh(of_mesh, touching);
    ASSERT_EQ(touching.warnings.size(), 3u);
    EXPECT_EQ(touching.warnings.back(), of_mesh[0]);
    Job job;
    const PatientCase parted = with_edits(touching, {deletion_at(Vec3(5, 50, -4))}, job);
    EXPECT_EQ(parted.warnings, patient.warnings);
}

TEST(Corrections, ACutShowsAGapBetweenTheSurfaces) {
    const PatientCase patient = patient_with_bridges();
    TreeEdit cut;
    cut.kind = TreeEditKind::cut_link;
    cut.at_mm = Vec3(0.05, 10, 1.5);  // the trunk, 3.85 mm in radius
    Job job;
    const PatientCase parted = with_edits(patient, {cut}, job);
    const Vec3 axis = Vec3(0.1, 20, 3).normalized();
    double before_mm = -HUGE_VAL, behind_mm = HUGE_VAL;
    for (const Vec3& vertex : parted.surface.vertices_mm) {
        const double along_mm = (vertex - cut.at_mm).dot(axis);
        (along_mm < 0.0 ? before_mm : behind_mm) =
            along_mm < 0.0 ? std::max(before_mm, along_mm) : std::min(behind_mm, along_mm);
    }
    EXPECT_NEAR(behind_mm - before_mm, 1.0, 0.3);
    EXPECT_EQ(hash_of(with_edits(parted, {}, job)), hash_of(patient));
}

// From the beginning of the trunk to the vessel that lies apart, across the liver.
TEST(Corrections, ALinkIsDoubtedAsLongAsItJoinsWhatItJoined) {
    PatientCase patient;
    patient.tree = test::parted_tree();
    TreeEdit link, other, cut;
    link.kind = TreeEditKind::add_link;
    link.at_mm = Vec3(0.02, 4, 0.6);
    link.to_mm = Vec3(37, 54.5, 4);
    const Vec3 middle_mm = 0.5 * (link.at_mm + link.to_mm);
    other.kind = TreeEditKind::seed_system;
    other.at_mm = Vec3(-8.6, 28, 4.4);
    other.system = VascularSystem::portal;
    cut.kind = TreeEditKind::cut_link;
    cut.at_mm = middle_mm;
    const auto doubts = [&](const std::vector<TreeEdit>& edits) {
        return doubts_of_links(with_edited_tree(patient, edits));
    };
    EXPECT_TRUE(doubts({}).empty());
    EXPECT_TRUE(doubts({other}).empty());
    ASSERT_EQ(doubts({link}).size(), 1u);
    EXPECT_NE(doubts({link})[0].find("from wall to wall, farther than"), std::string::npos);
    EXPECT_EQ(doubts({other, link}), doubts({link}));
    EXPECT_EQ(doubts({link, other}), doubts({link}));
    EXPECT_TRUE(doubts({link, cut}).empty());
    EXPECT_TRUE(doubts({link, deletion_at(middle_mm)}).empty());
    EXPECT_EQ(doubts({link, cut, link}), doubts({link})) << "once, of the second alone";
}

TEST(Corrections, NamesTheEditThatCannotBeDone) {
    const PatientCase patient = patient_with_bridges();
    Job job;
    try {
        with_edits(patient, {deletion_at(Vec3(5, 50, -4)), deletion_at(Vec3(500, 0, 0))}, job);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("edit 2"), std::string::npos) << error.what();
    }
    EXPECT_THROW(
        with_edits(patient, {deletion_at(Vec3(0, 1, 0)), deletion_at(Vec3(40, 57, 4))}, job),
        InputError);
}

TEST(Corrections, ComeBackFromDisk) {
    const fs::path folder = fs::path(testing::TempDir()) / "corrections.hep";
    fs::remove_all(folder);
    PatientCase patient = patient_with_bridges();
    Grid grid;
    grid.dims = {4, 4, 4};
    patient.mask = Mask(grid, 1);
    Job job;
    const PatientCase edited =
        with_edits(patient, {acceptance_of(patient.corrections.bridges[0])}, job);
    write_case(folder, edited);
    PatientCase back = read_case_without_voxels(folder);
    EXPECT_EQ(back.corrections.edits, edited.corrections.edits);
    ASSERT_EQ(back.corrections.bridges.size(), 2u);
    EXPECT_EQ(back.corrections.bridges[0].path_mm, last_gap);
    EXPECT_EQ(back.corrections.bridges[0].confidence, 0.22);
    EXPECT_EQ(bridged_length_mm(back.tree), bridged_length_mm(edited.tree));
    EXPECT_TRUE(open_bridges(back).empty());
    EXPECT_EQ(hash_of(with_edits(back, {}, job)), hash_of(patient));
    add_voxels(folder, back);
    EXPECT_EQ(back.mask.voxels, edited.mask.voxels);

    fs::remove(folder / "tree_extracted.vtp");
    EXPECT_THROW(read_case(folder), InputError);
    write_case(folder, patient);  // without edits there is no such file
    EXPECT_FALSE(fs::exists(folder / "tree_extracted.vtp"));
    EXPECT_EQ(read_case(folder).corrections.bridges.size(), 2u);
    fs::remove_all(folder);
}

TEST(Corrections, AMaskWithALabelThatDoesNotFitIsRefused) {
    LabelMap labels(Grid{{3, 3, 3}});
    labels.at(1, 1, 1) = 256;  // one byte of it would be 0: no vessel at all
    try {
        narrow_labels(labels, "case.hep/mask.nii.gz");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("256"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("mask.nii.gz"), std::string::npos);
    }
    labels.at(1, 1, 1) = 255;
    EXPECT_EQ(narrow_labels(labels, "").at(1, 1, 1), 255);
}

}  // namespace
}  // namespace hepatica
