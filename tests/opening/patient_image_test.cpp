// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/opening/patient_image.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>

#include "core/base/error.h"
#include "core/image/volume_writer.h"
#include "core/opening/open_patient.h"
#include "core/patient/corrections.h"
#include "core/patient/image_digest.h"
#include "core/patient/liver_segments.h"
#include "core/patient/painted_tumours.h"
#include "core/reconstruction/built_in_patient.h"
#include "tests/patient/parted_patient.h"
#include "tests/tree/territories/textbook_portal.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class PatientImage : public ::testing::Test {
  protected:
    static PatientCase made_from(const Volume& ct) {
        PatientCase patient;
        patient.source.image_sha256 = digest_of(ct);
        patient.source.image_grid = ct.grid;
        return patient;
    }

    const fs::path folder_ = fs::path(std::getenv("TEST_TMPDIR"));
    Job job_;
};

TEST_F(PatientImage, IsFoundAmongTheSeriesOfAFolderByItsContent) {
    const Volume thin(Grid{{16, 16, 8}}, 40), thick(Grid{{16, 16, 4}}, 70);
    write_dicom_series(folder_ / "scan" / "thin", thin, {}, job_);
    write_dicom_series(folder_ / "scan" / "thick", thick, {}, job_);
    EXPECT_EQ(image_of(made_from(thin), folder_ / "scan", job_).voxels, thin.voxels);
    EXPECT_EQ(image_of(made_from(thick), folder_ / "scan", job_).voxels, thick.voxels);
}

// The best of a folder's series and others may lack slices; the patient's is another.
TEST_F(PatientImage, IsFoundBesideSeriesThatCannotBeRead) {
    const Volume thin(Grid{{16, 16, 8}}, 40), thick(Grid{{16, 16, 4}}, 70);
    const fs::path scan = folder_ / "broken scan";
    write_dicom_series(scan / "thin", thin, {}, job_);
    write_dicom_series(scan / "thick", thick, {}, job_);
    for (const int slices : {12, 6}) {
        const fs::path broken = scan / std::to_string(slices);
        write_dicom_series(
            broken, Volume(Grid{{16, 16, slices}}, static_cast<std::int16_t>(slices)), {}, job_);
        ASSERT_TRUE(fs::remove(broken / "slice_0003.dcm"));
    }
    EXPECT_EQ(image_of(made_from(thin), scan, job_).voxels, thin.voxels);
    EXPECT_EQ(image_of(made_from(thick), scan, job_).voxels, thick.voxels);
    // Without it, what is wrong with the best is said.
    try {
        image_of(made_from(Volume(Grid{{16, 16, 8}}, 41)), scan, job_);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("1 slice is missing"), std::string::npos) << error.problem();
    }
}

TEST_F(PatientImage, OfAnotherPatientIsRefused) {
    const Volume ct(Grid{{16, 16, 8}}, 40);
    write_nifti(folder_ / "ct.nii.gz", ct);
    Volume other = ct;
    other.voxels[77] += 1;
    EXPECT_EQ(image_of(made_from(ct), folder_ / "ct.nii.gz", job_).voxels, ct.voxels);
    try {
        image_of(made_from(other), folder_ / "ct.nii.gz", job_);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), (folder_ / "ct.nii.gz").string());
    }
    EXPECT_THROW(image_of(made_from(ct), {}, job_), InputError) << "nobody said where it lies";
}

TEST_F(PatientImage, ThatIsGoneIsNamedWithWhatToDo) {
    const Volume ct(Grid{{16, 16, 8}}, 40);
    for (const fs::path& place : {folder_ / "gone.nii.gz", folder_ / "gone.nii.gz" / ""}) {
        try {
            image_of(made_from(ct), place, job_);
            FAIL();
        } catch (const InputError& error) {
            EXPECT_EQ(error.problem(), "the CT “gone.nii.gz” is not there any more");
            EXPECT_EQ(error.place(), place.string());
            EXPECT_TRUE(error.remedy().starts_with("choose the folder or file where it lies now"));
        }
    }
}

TEST_F(PatientImage, OfTheBuiltInPatientIsMadeAnew) {
    const Volume ct = built_in_truth(job_).ct;
    EXPECT_EQ(image_of(made_from(ct), {}, job_).voxels, ct.voxels);
    Volume other = ct;
    other.voxels[0] += 1;
    EXPECT_THROW(image_of(made_from(other), {}, job_), InputError);
}

TEST_F(PatientImage, SystemsAreReadFromTheCaseWhereThePatientCameWithoutVoxels) {
    PatientCase patient = test::patient_with_bridges();
    patient.mask = Mask(Grid{{5, 4, 3}});
    patient.mask.voxels[7] = 2;
    write_case(folder_ / "p.hep", patient);
    const PatientCase opened = read_case_without_voxels(folder_ / "p.hep");
    EXPECT_EQ(system_voxels(opened, folder_ / "p.hep").voxels, patient.mask.voxels);
    EXPECT_EQ(system_voxels(patient, {}).voxels, patient.mask.voxels);
    EXPECT_TRUE(system_voxels(opened, {}).voxels.empty());
}

// A tree that has been corrected since takes the segments of the case with it.
TEST_F(PatientImage, SegmentsAreThoseOfThePresentTree) {
    PatientCase patient = test::patient_with_bridges();
    auto textbook =
        test::textbook_patient(test::PortalType::usual, true, test::liver_of_phantom(6.0));
    patient.tree = textbook.tree;
    patient.organs = textbook.liver;
    label_segments(patient, job_);
    ASSERT_FALSE(patient.couinaud.voxels.empty());
    const fs::path folder = folder_ / "segments.hep";
    write_case(folder, patient);
    PatientCase opened = read_case_without_voxels(folder);
    EXPECT_EQ(segment_voxels(opened, folder, false, job_).voxels, patient.couinaud.voxels);
    EXPECT_EQ(segment_voxels(patient, {}, false, job_).voxels, patient.couinaud.voxels);
    EXPECT_TRUE(segment_voxels(opened, {}, false, job_).voxels.empty()) << "nobody knows a liver";

    TreeEdit edit;
    edit.kind = TreeEditKind::delete_branch;
    edit.at_mm = Vec3(-22, 12, 4);  // the caudate branch
    patient.tree = opened.tree = with_edited_tree(opened, {edit}).tree;
    const Mask before = patient.couinaud;
    label_segments(patient, job_);
    ASSERT_NE(patient.couinaud.voxels, before.voxels);
    EXPECT_EQ(segment_voxels(opened, folder, true, job_).voxels, patient.couinaud.voxels);
    EXPECT_EQ(segment_voxels(opened, folder, false, job_).voxels, before.voxels);
}

// What is written of a patient who was read without his voxels has the strokes that are wanted, and
// not those that the case on disk had.
TEST_F(PatientImage, TumoursOfTheWholeCaseAreThoseOfTheStrokesThatAreWanted) {
    PatientCase patient = test::patient_with_bridges();
    patient.organs = Mask(Grid{{40, 40, 40}}, organ_label::liver);
    patient.mask = Mask(patient.organs.grid, 1);
    const TreeEdit first = tumour_edit({{Vec3(10, 10, 10)}, 4.0, false}, 1);
    const TreeEdit second = tumour_edit({{Vec3(25, 25, 25)}, 5.0, false}, 2);
    PatientCase on_disk = patient, wanted = patient;
    set_tumour_strokes(on_disk, {first});
    set_tumour_strokes(wanted, {first, second});
    const fs::path folder = folder_ / "strokes.hep";
    write_case(folder, on_disk);
    const PatientCase opened = read_case_without_voxels(folder);
    const PatientCase whole = whole_case(opened, folder, {first, second}, job_);
    EXPECT_EQ(whole.organs.voxels, wanted.organs.voxels);
    EXPECT_EQ(whole.corrections.edits, wanted.corrections.edits);
    EXPECT_EQ(whole_case(opened, folder, {}, job_).organs.voxels, patient.organs.voxels);
    EXPECT_EQ(whole_case(on_disk, {}, {first, second}, job_).organs.voxels, wanted.organs.voxels)
        << "of one with his voxels in memory, too";
    fs::rename(folder, folder_ / "moved.hep");
    EXPECT_EQ(whole_case(opened, folder, {first, second}, job_).organs.voxels, wanted.organs.voxels)
        << "although its case is not there any more";
    fs::rename(folder_ / "moved.hep", folder);
    const Mask canvas = canvas_voxels(opened, folder);
    EXPECT_TRUE(tumours_in(canvas).empty());
    EXPECT_EQ(canvas.voxels, tumour_canvas(patient).voxels);
}

}  // namespace
}  // namespace hepatica
