// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/opening/open_patient.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/base/error.h"
#include "core/image/volume_writer.h"
#include "core/tree/files/tree_io.h"
#include "tests/patient/parted_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class Opening : public ::testing::Test {
  protected:
    OpenedPatient open(const fs::path& path) {
        OpenRequest request;
        request.reconstruct.ct = path;
        Job job;
        OpenedPatient opened = open_patient(request, job);
        EXPECT_EQ(static_cast<int>(job.stage_times().size()), opening_stage_count(request));
        return opened;
    }

    const fs::path folder_ = fs::path(std::getenv("TEST_TMPDIR"));
};

TEST_F(Opening, a_case_is_where_it_lies_and_nothing_of_it_is_lost_by_leaving) {
    const PatientCase patient = test::patient_with_bridges();
    write_case(folder_ / "p.hep", patient);
    write_case(folder_ / "p.hepz", patient);
    for (const fs::path& path : {folder_ / "p.hep", folder_ / "p.hep" / "", folder_ / "p.hepz"}) {
        const OpenedPatient opened = open(path);
        EXPECT_EQ(opened.title, path == folder_ / "p.hepz" ? "p.hepz" : "p.hep");
        EXPECT_EQ(opened.folder, path);
        EXPECT_EQ(hash_of(*opened.patient), hash_of(patient));
        EXPECT_FALSE(opened.worth_saving);
        EXPECT_TRUE(opened.image.empty());
    }
}

TEST_F(Opening, a_case_tells_what_its_reconstruction_warned_of) {
    PatientCase patient = test::patient_with_bridges();
    patient.warnings = {"thick slices", "a piece is left out"};
    patient.warnings_of_image = 1;
    write_case(folder_ / "warned.hep", patient);
    OpenRequest request;
    request.reconstruct.ct = folder_ / "warned.hep";
    for (const bool unsaved : {false, true}) {
        request.unsaved_copy = unsaved;
        Job job;
        const OpenedPatient opened = open_patient(request, job);
        ASSERT_GE(opened.warnings.size(), 2u) << unsaved;
        EXPECT_EQ(opened.warnings[0], "thick slices");
        EXPECT_EQ(opened.warnings[1], "a piece is left out");
        EXPECT_EQ(opened.warnings_of_image, std::vector<std::string>{"thick slices"});
    }
}

TEST_F(Opening, what_is_lost_of_unsaved_work_is_the_first_warning) {
    write_case(folder_ / "torn.hep", test::patient_with_bridges());
    OpenRequest request;
    request.reconstruct.ct = folder_ / "torn.hep";
    Job job;
    const std::size_t usual = open_patient(request, job).warnings.size();
    request.lost = "the last change is lost";
    const std::vector<std::string> warnings = open_patient(request, job).warnings;
    ASSERT_EQ(warnings.size(), usual + 1);
    EXPECT_EQ(warnings.front(), request.lost);
}

TEST_F(Opening, a_tree_gets_a_body) {
    write_tree_vtp(folder_ / "tree.vtp", test::forked_tree());
    const OpenedPatient opened = open(folder_ / "tree.vtp");
    EXPECT_EQ(opened.patient->tree.segments.size(), test::forked_tree().segments.size());
    EXPECT_FALSE(opened.patient->mesh.tetrahedra.empty());
    EXPECT_TRUE(opened.folder.empty());
    EXPECT_FALSE(opened.worth_saving);
}

TEST_F(Opening, what_is_not_there_is_named) {
    try {
        open(folder_ / "nothing.hep");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), (folder_ / "nothing.hep").string());
    }
}

// The system refuses to look at such a name, which says nothing of what is there.
TEST_F(Opening, a_place_that_cannot_be_looked_at_is_named) {
    OpenRequest request;
    request.reconstruct.ct = folder_ / (std::string(300, 'n') + ".nii");
    Job job;
    for (const bool only_looked_at : {true, false}) {
        try {
            if (only_looked_at)
                look_at(request, job);
            else
                open_patient(request, job);
            FAIL();
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), request.reconstruct.ct.string());
            EXPECT_TRUE(error.problem().starts_with("cannot be read (")) << error.problem();
        }
    }
}

// A folder of images may bear the name of any file.
TEST_F(Opening, a_folder_is_no_tree_whatever_its_name) {
    fs::create_directory(folder_ / "scan.swc");
    OpenRequest request;
    request.reconstruct.ct = folder_ / "scan.swc";
    EXPECT_EQ(opening_stage_count(request), stage_count(request.reconstruct));
}

std::vector<std::string> choice(const fs::path& path, int series = 0) {
    OpenRequest request;
    request.reconstruct.ct = path;
    request.reconstruct.series = series;
    Job job;
    std::vector<std::string> slices;
    for (const SeriesDescription& one : series_to_choose_from(request, job))
        slices.push_back(std::to_string(one.slices) + " " + one.why_not_chosen);
    return slices;
}

// A person is asked only where several series of a folder could be read and none is named yet.
TEST_F(Opening, offers_the_series_of_a_folder_that_holds_several) {
    Volume volume(Grid{{16, 16, 8}}, 40);
    Job job;
    write_dicom_series(folder_ / "scan" / "thin", volume, {}, job);
    EXPECT_TRUE(choice(folder_ / "scan").empty());
    volume = Volume(Grid{{16, 16, 4}}, 40);
    volume.grid.spacing_mm.z() = 2.0;
    write_dicom_series(folder_ / "scan" / "thick", volume, {}, job);
    EXPECT_EQ(choice(folder_ / "scan"), (std::vector<std::string>{"8 ", "4 it has more slices"}));
    EXPECT_TRUE(choice(folder_ / "scan", 1).empty());
    EXPECT_TRUE(choice(folder_ / "scan" / "thin").empty());
    fs::create_directory(folder_ / "empty");
    for (const char* name : {"empty", "nothing", "scan/thin/0001.dcm"})
        EXPECT_TRUE(choice(folder_ / name).empty()) << name;
    write_case(folder_ / "p.hep", test::patient_with_bridges());
    EXPECT_TRUE(choice(folder_ / "p.hep").empty());
}

TEST(OpenRequest, means_the_same_from_every_folder) {
    OpenRequest request;
    request.reconstruct.ct = "scans/../ct";
    request.reconstruct.liver_mask = "liver.nii";
    const OpenRequest absolute = with_absolute_paths(request);
    EXPECT_EQ(absolute.reconstruct.ct, fs::current_path() / "ct");
    EXPECT_EQ(absolute.reconstruct.liver_mask, fs::current_path() / "liver.nii");
    EXPECT_FALSE(absolute.reconstruct.vessel_mask);
    EXPECT_FALSE(absolute.reconstruct.model);
    EXPECT_TRUE(absolute.cache.folder.empty()) << "nothing is kept";
    EXPECT_TRUE(with_absolute_paths({true, {}}).reconstruct.ct.empty());
}

TEST(OpenRequest, all_of_its_paths_are_made_absolute) {
    OpenRequest request;
    request.reconstruct.ct = "ct";
    request.reconstruct.vessel_mask = "vessels.nii";
    request.reconstruct.tumour_masks = {"one.nii", "masks/./two.nii"};
    request.reconstruct.model = "lines.model";
    request.cache.folder = "cache";
    request.left_edits.emplace().file = "journals/left.edits";
    const OpenRequest absolute = with_absolute_paths(request);
    const fs::path here = fs::current_path();
    EXPECT_EQ(absolute.reconstruct.vessel_mask, here / "vessels.nii");
    EXPECT_EQ(absolute.reconstruct.tumour_masks,
              (std::vector<fs::path>{here / "one.nii", here / "masks" / "two.nii"}));
    EXPECT_EQ(absolute.reconstruct.model, here / "lines.model");
    EXPECT_EQ(absolute.cache.folder, here / "cache");
    EXPECT_EQ(absolute.left_edits.value().file, here / "journals" / "left.edits");
}

}  // namespace
}  // namespace hepatica
