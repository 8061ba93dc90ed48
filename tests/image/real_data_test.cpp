// SPDX-License-Identifier: GPL-3.0-or-later
// Public patients, where their data are there (they are not part of the project): facts that their
// publishers state, not ours.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/image/morphology.h"
#include "core/image/volume_reader.h"
#include "tests/image/image_fixtures.h"

namespace hepatica {
namespace {

using namespace testing_support;

double mean_hu(const Volume& ct, const Mask& mask, const Index3& shift) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        if (mask.voxels[i] == 0) continue;
        const Index3 at = ct.grid.index_of(i);
        const Index3 to{at[0] + shift[0], at[1] + shift[1], at[2] + shift[2]};
        if (!ct.grid.contains(to[0], to[1], to[2])) continue;
        sum += ct.at(to[0], to[1], to[2]);
        count += 1.0;
    }
    return sum / count;
}

TEST(RealData, ReadsThePortalVenousCtOfIrcad) {
    const auto root = real_data("ircadb01_case01");
    if (!root) GTEST_SKIP() << "ircadb01_case01 is not there (see HEPATICA_TEST_DATA)";
    Job job;
    ReadRemarks remarks;
    const Volume ct = read_volume(*root / "PATIENT_DICOM", job, &remarks);
    EXPECT_TRUE(remarks.empty());
    EXPECT_EQ(ct.grid.dims, (Index3{512, 512, 129}));
    EXPECT_TRUE(ct.grid.spacing_mm.isApprox(Vec3(0.57, 0.57, 1.6), 1e-6));
    EXPECT_EQ(*std::ranges::min_element(ct.voxels), -1024);
    EXPECT_EQ(*std::ranges::max_element(ct.voxels), 1023);
    EXPECT_NO_THROW(require_plausible_ct(ct, "ircad", job));

    // The expert's masks lie on it voxel by voxel: the portal vein is brightest where its mask is,
    // and a voxel further in any direction it is darker. Parenchyma 114 HU, portal vein 186.
    const Mask liver = read_mask(*root / "masks" / "liver.nii.gz", job);
    const Mask portal = read_mask(*root / "masks" / "portalvein.nii.gz", job);
    ASSERT_TRUE(same_grid(liver.grid, ct.grid));
    const double in_place = mean_hu(ct, portal, {0, 0, 0});
    for (const Index3 shift : {Index3{1, 0, 0}, Index3{-1, 0, 0}, Index3{0, 1, 0}, Index3{0, -1, 0},
                               Index3{0, 0, 1}, Index3{0, 0, -1}})
        EXPECT_LT(mean_hu(ct, portal, shift), in_place);
    EXPECT_NEAR(mean_hu(ct, erode(portal, 1.2, job), {0, 0, 0}), 186.0, 6.0);
    EXPECT_NEAR(mean_hu(ct, erode(liver, 1.2, job), {0, 0, 0}), 114.0, 3.0);
}

TEST(RealData, ReadsJpeg2000WithoutIdentifiers) {
    const auto root = real_data("totalseg_dicom");
    if (!root) GTEST_SKIP() << "totalseg_dicom is not there (see HEPATICA_TEST_DATA)";
    Job job;
    const Volume ct = read_volume(*root / "dicom", job);
    EXPECT_EQ(ct.grid.dims, (Index3{512, 512, 20}));
    EXPECT_TRUE(ct.grid.spacing_mm.isApprox(Vec3(0.9765625, 0.9765625, 2.0), 1e-6));
    const LabelMap labels = read_label_map(*root / "example_seg_dicom.nii.gz", job);
    ASSERT_TRUE(same_grid(labels.grid, ct.grid));
    const std::vector<int> liver_label{5};
    const Mask liver = read_mask(*root / "example_seg_dicom.nii.gz", job, liver_label);
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < liver.voxels.size(); ++i)
        if (liver.voxels[i] != 0) {
            EXPECT_EQ(labels.voxels[i], 5);
            sum += ct.voxels[i];
            count += 1.0;
        }
    EXPECT_GT(count, 1000.0);
    EXPECT_GT(sum / count, 60.0);  // contrast-enhanced parenchyma
    EXPECT_LT(sum / count, 160.0);
}

TEST(RealData, ReadsThePhantomOfVascusynth) {
    const auto root = real_data("vascusynth");
    if (!root) GTEST_SKIP() << "vascusynth is not there (see HEPATICA_TEST_DATA)";
    Job job;
    const Volume ct = read_volume(*root / "phantom_ct_hu.nii.gz", job);
    EXPECT_EQ(ct.grid.dims, (Index3{167, 135, 131}));
    EXPECT_TRUE(ct.grid.spacing_mm.isApprox(Vec3(1.2, 1.2, 1.2), 1e-6));
    EXPECT_TRUE(same_grid(ct.grid, read_mask(*root / "mask_portal.nii.gz", job).grid));
}

}  // namespace
}  // namespace hepatica
