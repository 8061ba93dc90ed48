// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patient/patient_case.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/error.h"
#include "core/base/job.h"
#include "core/base/quoted_name.h"
#include "core/base/sha256.h"
#include "core/patient/case_header.h"
#include "core/patient/corrections.h"
#include "tests/patient/some_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

using test::some_patient;

class PatientCaseTest : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string text_of(const fs::path& file) const {
        std::ifstream in(file);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    // The message of the InputError that reading the case throws.
    std::string refusal(const fs::path& folder) const {
        try {
            read_case(folder);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    fs::path folder_ = fs::path(testing::TempDir()) / "hepatica patient";
    fs::path case_ = folder_ / "p.hep";
};

TEST_F(PatientCaseTest, ReadsBackWhatItWrote) {
    const PatientCase patient = some_patient();
    write_case(case_, patient);
    const PatientCase back = read_case(case_);
    EXPECT_EQ(hash_of(back), hash_of(patient));
    EXPECT_EQ(back.mask.voxels, patient.mask.voxels);
    EXPECT_EQ(back.mask.grid.origin_mm, patient.mask.grid.origin_mm) << "to the bit";
    EXPECT_EQ(back.mask.grid.spacing_mm, patient.mask.grid.spacing_mm);
    EXPECT_EQ(back.mask.grid.direction, patient.mask.grid.direction);
    EXPECT_EQ(back.skeleton.grid.origin_mm, patient.skeleton.grid.origin_mm);
    EXPECT_EQ(back.skeleton.voxels, patient.skeleton.voxels);
    EXPECT_EQ(back.surface.triangles, patient.surface.triangles);
    EXPECT_EQ(back.organs.voxels, patient.organs.voxels);
    EXPECT_EQ(back.source.name, patient.source.name);
    EXPECT_EQ(back.source.image_sha256, patient.source.image_sha256);
    EXPECT_EQ(back.source.parameters_json, patient.source.parameters_json);
    EXPECT_TRUE(same_grid(back.source.image_grid, patient.source.image_grid));
    EXPECT_TRUE(read_case_without_voxels(case_).mask.voxels.empty());
    EXPECT_TRUE(read_case_without_voxels(case_).organs.voxels.empty());
    for (const char* name : {"tree.vtp", "tree.swc", "surface.vtp", "mesh.vtu", "organs.nii.gz"})
        EXPECT_TRUE(fs::exists(case_ / name)) << name;
}

// What was done stands in the list of corrections after the case is opened again, too.
TEST_F(PatientCaseTest, KnowsHowItsVesselsWereRebuilt) {
    const PatientCase before = some_patient();
    EXPECT_TRUE(before.corrections.rebuilt.empty());
    PatientCase after = some_patient();
    note_rebuilding(before, 3, after);
    PatientCase last = some_patient();
    note_rebuilding(after, 0, last);
    write_case(case_, last);
    const std::vector<Rebuilding> expected{{0, 3}, {0, 0}};
    EXPECT_EQ(read_case(case_).corrections.rebuilt, expected);
    EXPECT_EQ(read_case_without_voxels(case_).corrections.rebuilt, expected);
}

// Another program may have put another patient in its place since it was opened.
TEST_F(PatientCaseTest, GivesItsVoxelsToNoOtherPatient) {
    write_case(case_, some_patient());
    PatientCase opened = read_case_without_voxels(case_);
    PatientCase other = some_patient();
    other.source.image_sha256 = std::string(64, '7');
    write_case(case_, other);
    EXPECT_THROW(add_voxels(case_, opened), InputError);
    EXPECT_TRUE(opened.mask.voxels.empty());
    write_case(case_, some_patient());
    add_voxels(case_, opened);
    EXPECT_EQ(opened.mask.voxels, some_patient().mask.voxels);
}

// The voxels go on being those that he was read with, also where his case was moved away or is
// another one by now.
TEST_F(PatientCaseTest, KeepsItsVoxelsWhateverBecomesOfItsPlace) {
    PatientCase patient = some_patient();
    patient.corrections.unpainted = patient.organs;
    write_case(case_, patient);
    const PatientCase opened = read_case_without_voxels(case_);
    patient.mask.at(1, 1, 1) = 2;
    write_case(case_, patient);
    PatientCase beside_another = opened;
    add_kept_voxels(beside_another);
    EXPECT_EQ(beside_another.mask.voxels, some_patient().mask.voxels);
    fs::remove_all(case_);
    PatientCase alone = opened;
    add_kept_voxels(alone);
    EXPECT_EQ(alone.mask.voxels, some_patient().mask.voxels);
    EXPECT_EQ(alone.mask.grid.origin_mm, some_patient().mask.grid.origin_mm) << "to the bit";
    EXPECT_EQ(alone.skeleton.voxels, some_patient().skeleton.voxels);
    EXPECT_EQ(alone.organs.voxels, some_patient().organs.voxels);
    EXPECT_EQ(alone.corrections.unpainted.voxels, some_patient().organs.voxels);
    EXPECT_EQ(alone.kept_voxels, nullptr) << "they are held once";
}

TEST_F(PatientCaseTest, WritesTheSameBytesEveryTime) {
    write_case(case_, some_patient());
    write_case(folder_ / "again.hep", some_patient());
    EXPECT_EQ(text_of(case_ / "case.json"), text_of(folder_ / "again.hep" / "case.json"));
}

// Another program can check them, and read what the case holds without opening the tree.
TEST_F(PatientCaseTest, CaseJsonHoldsTheDigestsAndTheSystems) {
    PatientCase patient = some_patient();
    for (VesselSegment& segment : patient.tree.segments) {
        segment.system = VascularSystem::portal;
        segment.system_confidence = 0.75;
    }
    write_case(case_, patient);
    const auto json = nlohmann::json::parse(text_of(case_ / "case.json"));
    EXPECT_EQ(json.at("version"), 2);
    EXPECT_EQ(json.at("sha256").size(), 7u);
    for (const auto& [name, digest] : json.at("sha256").items())
        EXPECT_EQ(digest, sha256_of_file(case_ / name)) << name;
    ASSERT_EQ(json.at("tree").at("systems").size(), 1u);
    const auto& system = json.at("tree").at("systems").at(0);
    EXPECT_EQ(system.at("system"), "portal");
    EXPECT_NEAR(system.at("length_mm").get<double>(), length_mm(patient.tree), 1e-9);
    EXPECT_NEAR(system.at("confidence").get<double>(), 0.75, 1e-12);
    EXPECT_EQ(system.at("loops"), 0);
    EXPECT_EQ(system.at("roots").size(), roots(patient.tree).size());
    EXPECT_EQ(system.at("roots").at(0).at("at_mm").size(), 3u);
    EXPECT_GT(system.at("roots").at(0).at("radius_mm"), 0.0);
    PatientCase unnamed = patient;
    unnamed.source.name.clear();
    write_case(case_, unnamed);
    EXPECT_FALSE(nlohmann::json::parse(text_of(case_ / "case.json")).contains("name"));
}

TEST_F(PatientCaseTest, KeepsWhatItsReconstructionWarnedOf) {
    PatientCase patient = some_patient();
    write_case(case_, patient);
    EXPECT_FALSE(nlohmann::json::parse(text_of(case_ / "case.json")).contains("warnings"));
    EXPECT_TRUE(read_case(case_).warnings.empty());
    patient.warnings = {"The slices are 1.6 mm apart", "in " + quoted_name("Anna") + " is a loop"};
    patient.warnings_of_image = 1;
    write_case(case_, patient);
    for (const PatientCase& back : {read_case(case_), read_case_without_voxels(case_)}) {
        EXPECT_EQ(back.warnings,
                  (std::vector<std::string>{"The slices are 1.6 mm apart", "in “…” is a loop"}));
        EXPECT_EQ(back.warnings_of_image, 1u);
    }
    EXPECT_EQ(text_of(case_ / "case.json").find("Anna"), std::string::npos);
}

TEST_F(PatientCaseTest, RefusesAChangedAMissingAndAForeignFile) {
    write_case(case_, some_patient());
    std::ofstream(case_ / "mesh.vtu", std::ios::app) << " ";
    EXPECT_NE(refusal(case_).find("mesh.vtu"), std::string::npos);
    write_case(case_, some_patient());
    fs::remove(case_ / "tree.vtp");
    EXPECT_NE(refusal(case_).find("missing"), std::string::npos);
    write_case(case_, some_patient());
    std::ofstream(case_ / "case.json") << R"({"format": "hepatica-case", "version": 99})";
    EXPECT_NE(refusal(case_).find("version 99"), std::string::npos);
    std::ofstream(case_ / "case.json") << R"({"format": "hepatica-case", "version": 1})";
    EXPECT_FALSE(refusal(case_).empty());
    for (const char* wrong :
         {R"({"format": 1})", R"({"format": "hepatica-case", "version": "x"})"}) {
        std::ofstream(case_ / "case.json") << wrong;
        EXPECT_NE(refusal(case_).find("damaged"), std::string::npos) << wrong;
    }
    std::ofstream(case_ / "case.json") << "text";
    EXPECT_NE(refusal(case_).find("damaged"), std::string::npos);
    EXPECT_FALSE(refusal(folder_).empty());
}

TEST_F(PatientCaseTest, ReplacesAnOlderCaseButNothingElse) {
    write_case(case_, some_patient());
    EXPECT_NO_THROW(write_case(case_, some_patient()));
    const fs::path precious = folder_ / "precious";
    fs::create_directories(precious);
    std::ofstream(precious / "thesis.txt") << "years of work";
    EXPECT_THROW(write_case(precious, some_patient()), InputError);
    EXPECT_EQ(text_of(precious / "thesis.txt"), "years of work");
}

// A radiologist's letter beside the case, and its dial, which belongs to the mesh that is gone.
TEST_F(PatientCaseTest, KeepsWhatOthersPutIntoItsFolder) {
    PatientCase patient = some_patient();
    patient.dial_json = "{}";
    write_case(case_, patient);
    std::ofstream(case_ / "letter.txt") << "dear colleague";
    patient.dial_json.clear();
    write_case(case_, patient);
    EXPECT_EQ(text_of(case_ / "letter.txt"), "dear colleague");
    EXPECT_FALSE(fs::exists(case_ / case_file::dial));
    EXPECT_EQ(hash_of(read_case(case_)), hash_of(patient));
    for (const auto& entry : fs::directory_iterator(case_))
        EXPECT_EQ(is_of_a_case(entry.path().filename()), entry.path().filename() != "letter.txt")
            << entry.path();
}

TEST_F(PatientCaseTest, LeavesNothingWhereItCannotWrite) {
    std::ofstream(folder_ / "file") << "x";
    EXPECT_THROW(write_case(folder_ / "file" / "p.hep", some_patient()), InputError);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

// Between any two files, as a folder and as one file.
TEST_F(PatientCaseTest, IsAsItWasWhereWritingIsCancelled) {
    for (const fs::path& place : {case_, folder_ / "p.hepz"}) {
        PatientCase patient = some_patient();
        write_case(place, patient);
        const std::uint64_t before = hash_of(read_case(place));
        patient.mesh.vertices_mm[0].x() += 1e-3;
        int cancelled = 0;
        for (bool ended = false; !ended;) {
            Job job;
            job.begin_stage("Writing the case");
            job.observe([&, at = 0](JobEvent) mutable {
                if (at++ == cancelled) job.cancel();
            });
            try {
                write_case_in_job(place, patient, job);
                ended = true;
            } catch (const Cancelled&) {
                ++cancelled;
                ASSERT_EQ(hash_of(read_case(place)), before) << place << " " << cancelled;
            }
        }
        EXPECT_GE(cancelled, 10);
        EXPECT_EQ(hash_of(read_case(place)), hash_of(patient));
        EXPECT_NE(hash_of(patient), before);
        for (const auto& entry : fs::directory_iterator(folder_))
            EXPECT_TRUE(entry.path().stem() == "p") << entry.path();
    }
}

// The dial and the measurements may be missing; they are not taken for missing where they cannot be
// read.
TEST_F(PatientCaseTest, SaysWhichFileBesideItCannotBeRead) {
    write_case(case_, some_patient());
    fs::remove(case_ / case_file::header);
    EXPECT_NE(refusal(case_).find("holds no case.json"), std::string::npos);
    fs::create_directories(case_ / case_file::header);
    EXPECT_NE(refusal(case_).find("is a folder"), std::string::npos) << refusal(case_);
    fs::remove_all(case_);
    for (const char* name : {case_file::dial, case_file::measurements}) {
        write_case(case_, some_patient());
        fs::remove_all(case_ / name);
        EXPECT_EQ(refusal(case_), "");
        fs::create_directories(case_ / name);
        EXPECT_NE(refusal(case_).find("is a folder"), std::string::npos) << name;
        EXPECT_NE(refusal(case_).find((case_ / name).string()), std::string::npos) << name;
        fs::remove_all(case_);
    }
}

// A case that is moved while its dial is measured leaves no folder that holds the dial alone.
TEST_F(PatientCaseTest, ThatIsGoneGetsNoDial) {
    write_case(case_, some_patient());
    write_dial(case_, "{}");
    EXPECT_EQ(text_of(case_ / case_file::dial), "{}");
    const fs::path moved = folder_ / "moved.hep";
    fs::rename(case_, moved);
    EXPECT_THROW(write_dial(case_, R"({"front": 1})"), InputError);
    EXPECT_FALSE(fs::exists(case_));
    EXPECT_EQ(text_of(moved / case_file::dial), "{}");
    EXPECT_NO_THROW(write_case(case_, some_patient()));
}

TEST_F(PatientCaseTest, WhoseRebuildingsHaveNoNumbersIsRefused) {
    PatientCase patient = some_patient();
    patient.corrections.rebuilt = {{0, 2}};
    for (const char* key : {"after_edits", "strokes"})
        for (const nlohmann::json& wrong : {nlohmann::json(-1), nlohmann::json(1.5)}) {
            write_case(case_, patient);
            const fs::path file = case_ / case_file::corrections;
            auto corrections = nlohmann::json::parse(text_of(file));
            corrections.at("rebuilt").at(0).at(key) = wrong;
            std::ofstream(file) << corrections.dump();
            auto header = nlohmann::json::parse(text_of(case_ / case_file::header));
            header.at("sha256").at(case_file::corrections) = sha256_of_file(file);
            std::ofstream(case_ / case_file::header) << header.dump();
            EXPECT_NE(refusal(case_).find("must be a whole number"), std::string::npos)
                << key << refusal(case_);
        }
}

// Writing such parameters by recursion would overflow the stack.
TEST_F(PatientCaseTest, WhoseParametersNestWithoutEndIsRefused) {
    write_case(case_, some_patient());
    std::string header = text_of(case_ / case_file::header);
    const std::string two = "\"refinement_recursions\": 2";
    const std::size_t at = header.find(two);
    ASSERT_NE(at, std::string::npos);
    const std::string deep = std::string(200000, '[') + std::string(200000, ']');
    header.replace(at, two.size(), "\"refinement_recursions\": " + deep);
    std::ofstream(case_ / case_file::header) << header;
    EXPECT_NE(refusal(case_).find("nests lists and objects"), std::string::npos);
}

// Reading a process's memory from address 0 on fails.
TEST_F(PatientCaseTest, WhoseHeaderFailsToBeReadIsRefusedByName) {
    if (!fs::exists("/proc/self/mem")) GTEST_SKIP() << "no file whose reading fails";
    write_case(case_, some_patient());
    fs::remove(case_ / case_file::header);
    fs::create_symlink("/proc/self/mem", case_ / case_file::header);
    EXPECT_NE(refusal(case_).find("cannot be read"), std::string::npos) << refusal(case_);
    EXPECT_NE(refusal(case_).find((case_ / case_file::header).string()), std::string::npos);
}

}  // namespace
}  // namespace hepatica
