// SPDX-License-Identifier: GPL-3.0-or-later
// format_1.hep was written by the program as it was when it wrote format 1, from the synthetic
// patient in a folder called after a (made up) person: a mask in two systems by the seeds 1 and 2,
// and an edit that gave a branch to 3.
#include "core/patient/format_1.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/patient/corrections.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path fixture = HEPATICA_FORMAT_1_CASE;

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool holds(const VesselTree& tree, VascularSystem system) {
    return std::ranges::find(tree.segments, system, &VesselSegment::system) != tree.segments.end();
}

class Format1 : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_EQ(Json::parse(text_of(fixture / "case.json")).at("version"), 1);
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_ = fs::path(testing::TempDir()) / "hepatica format 1";
};

TEST_F(Format1, IsReadWithItsSystemsAndEdits) {
    const PatientCase patient = read_case(fixture);
    for (const VascularSystem system :
         {VascularSystem::portal, VascularSystem::hepatic, VascularSystem::artery})
        EXPECT_TRUE(holds(patient.tree, system)) << name_of(system);
    EXPECT_FALSE(holds(patient.tree, VascularSystem::unknown));
    ASSERT_EQ(patient.corrections.edits.size(), 1u);
    EXPECT_EQ(patient.corrections.edits[0].system, VascularSystem::artery);
    EXPECT_FALSE(holds(patient.corrections.extracted, VascularSystem::artery));
    EXPECT_TRUE(patient.source.image_sha256.empty());
    EXPECT_TRUE(patient.source.name.empty());
    EXPECT_EQ(patient.source.image_grid.dims, (Index3{40, 40, 32}));
    // The mask held one label for both systems.
    EXPECT_GT(std::ranges::count(patient.mask.voxels, 255), 50);
    EXPECT_GT(patient.mesh.tetrahedra.size(), 100u);
    // The list of edits still makes the tree that the case holds.
    Job job;
    EXPECT_EQ(hash_of(with_edited_tree(patient, patient.corrections.edits)), hash_of(patient));
    const Json parameters = Json::parse(patient.source.parameters_json);
    EXPECT_EQ(parameters.at("seeds").at(0).at("system"), "portal");
    EXPECT_EQ(parameters.at("vessel_mask_given"), true);
    EXPECT_EQ(parameters.at("liver_mask_given"), false);
}

TEST_F(Format1, IsWrittenAsFormat2WithoutThePathsThatItHeld) {
    ASSERT_NE(text_of(fixture / "case.json").find("MUELLER"), std::string::npos);
    const PatientCase patient = read_case(fixture);
    write_case(folder_ / "new.hep", patient);
    EXPECT_EQ(Json::parse(text_of(folder_ / "new.hep" / "case.json")).at("version"), 2);
    for (const auto& entry : fs::directory_iterator(folder_ / "new.hep"))
        EXPECT_EQ(text_of(entry.path()).find("MUELLER"), std::string::npos) << entry.path();
    const PatientCase again = read_case(folder_ / "new.hep");
    EXPECT_EQ(hash_of(again), hash_of(patient));
    EXPECT_EQ(again.mask.voxels, patient.mask.voxels);
    EXPECT_EQ(again.corrections.edits, patient.corrections.edits);
}

TEST_F(Format1, IsRefusedWhereAFileIsNotItsOwn) {
    fs::copy(fixture, folder_ / "changed.hep");
    std::ofstream(folder_ / "changed.hep" / "tree.vtp", std::ios::app) << " ";
    EXPECT_THROW(read_case(folder_ / "changed.hep"), InputError);
}

// Where no seed was set, 0 was everything, and the window called 1 hepatic veins and 2 artery.
TEST(Format1Words, NumbersOfAnUnseededCaseAreThoseOfTheWindow) {
    const std::string edits =
        R"([{"edit":"reassign_system","at_mm":[0,0,0],"system":1},
            {"edit":"reassign_system","at_mm":[0,0,0],"system":0},
            {"edit":"cut_link","at_mm":[1,2,3]}])";
    const auto unseeded = edits_from_json(edits_of_format_1(edits, false), "");
    EXPECT_EQ(unseeded.at(0).system, VascularSystem::hepatic);
    EXPECT_EQ(unseeded.at(1).system, VascularSystem::unknown);
    EXPECT_EQ(unseeded.at(2).kind, TreeEditKind::cut_link);
    EXPECT_EQ(edits_from_json(edits_of_format_1(edits, true), "").at(0).system,
              VascularSystem::portal);
}

TEST(Format1Words, LabelsOfAMaskAreSystemsOnlyWhereThereAreSeveral) {
    using Voxels = std::vector<std::uint8_t>;
    const auto relabelled = [](const Voxels& voxels, const std::vector<VascularSystem>& systems) {
        Mask mask(Grid{{static_cast<int>(voxels.size()), 1, 1}});
        mask.voxels = voxels;
        VesselTree tree;
        for (const VascularSystem system : systems) tree.segments.emplace_back().system = system;
        relabel_format_1(mask, tree);
        return mask.voxels;
    };
    using enum VascularSystem;
    EXPECT_EQ(relabelled({0, 1, 2, 9}, {portal, hepatic}), (Voxels{0, 1, 2, 255}));
    EXPECT_EQ(relabelled({0, 1, 1}, {portal, hepatic}), (Voxels{0, 255, 255}));
    EXPECT_EQ(relabelled({0, 1, 1}, {hepatic}), (Voxels{0, 2, 2}));
    EXPECT_EQ(relabelled({0, 1, 1}, {unknown}), (Voxels{0, 255, 255}));
}

}  // namespace
}  // namespace hepatica
