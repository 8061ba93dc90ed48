// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/opening/patient_image.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/base/error.h"
#include "core/image/volume_writer.h"
#include "core/opening/open_patient.h"
#include "core/patient/image_digest.h"
#include "core/reconstruction/built_in_patient.h"
#include "tests/patient/parted_patient.h"

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

}  // namespace
}  // namespace hepatica
