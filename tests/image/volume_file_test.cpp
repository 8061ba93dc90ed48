// SPDX-License-Identifier: GPL-3.0-or-later
// NIfTI, MetaImage and NRRD: what is written comes back.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "core/base/parallel.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/image/image_fixtures.h"
#include "tests/image/nifti_bytes.h"

namespace hepatica {
namespace {

using namespace testing_support;

TEST(Nifti, SaysThatNothingIsSaidOfHowThePatientLies) {
    const TemporaryFolder folder;
    NiftiFile file(folder);
    const auto remarks = [&] {
        file.write();
        ReadRemarks heard;
        Job job;
        read_volume(file.path(), job, &heard);
        return heard;
    };
    EXPECT_TRUE(remarks().empty());
    file.set<std::int16_t>(252, 0).set<std::int16_t>(254, 0);  // qform_code and sform_code
    ASSERT_EQ(remarks().size(), 1u);
    EXPECT_NE(remarks()[0].find("does not say how the patient lies"), std::string::npos);
}

TEST(Nifti, ComesBackAsItWasWritten) {
    const TemporaryFolder folder;
    Job job;
    for (const Grid& grid : {small_grid(), turned_grid()})
        for (const char* name : {"ct.nii", "ct.nii.gz", "CT.NII.GZ"}) {
            const Volume volume = patterned_volume(grid);
            write_nifti(folder / name, volume);
            const Volume read = read_volume(folder / name, job);
            EXPECT_TRUE(same_grid(read.grid, grid)) << name;
            EXPECT_EQ(read.voxels, volume.voxels) << name;
        }
}

// Programs may read either form of the position: the rotation alone says the same as the map, of
// grids that are turned by any angle, mirrored or not.
TEST(Nifti, ItsRotationSaysWhatItsMapSays) {
    const TemporaryFolder folder;
    Job job;
    for (const double angle : {0.0, 1.0, 2.5, 4.0, 6.0})
        for (const double mirrored : {1.0, -1.0}) {
            Grid grid = small_grid();
            grid.direction =
                Eigen::AngleAxisd(angle, Vec3(3.0, -1.0, 2.0).normalized()).toRotationMatrix();
            grid.direction.col(2) *= mirrored;
            write_nifti(folder / "turned.nii", patterned_volume(grid));
            const Volume by_map = read_volume(folder / "turned.nii", job);
            std::string bytes = bytes_of_file(folder / "turned.nii");
            const std::int16_t no_map = 0;
            std::memcpy(bytes.data() + 254, &no_map, sizeof no_map);
            write_bytes(folder / "turned.nii", bytes);
            const Volume by_rotation = read_volume(folder / "turned.nii", job);
            const Grid &one = by_map.grid, &other = by_rotation.grid;
            EXPECT_NEAR((other.direction - one.direction).norm(), 0.0, 1e-5) << angle;
            EXPECT_NEAR((other.origin_mm - one.origin_mm).norm(), 0.0, 1e-4) << angle;
            EXPECT_EQ(by_rotation.voxels, by_map.voxels) << angle;
        }
}

TEST(Nifti, KeepsMasksLabelsAndFloats) {
    const TemporaryFolder folder;
    Job job;
    const Grid grid = small_grid();
    Mask mask(grid);
    LabelMap labels(grid);
    FloatVolume field(grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        mask.voxels[i] = i % 7 == 0 ? 1 : 0;
        labels.voxels[i] = static_cast<std::uint16_t>(i % 5 * 16000);
        field.voxels[i] = static_cast<float>(i) * 0.75f - 100.0f;
    }
    write_nifti(folder / "mask.nii.gz", mask);
    write_nifti(folder / "labels.nii.gz", labels);
    write_nifti(folder / "field.nii.gz", field);
    EXPECT_EQ(read_mask(folder / "mask.nii.gz", job).voxels, mask.voxels);
    EXPECT_EQ(read_label_map(folder / "labels.nii.gz", job).voxels, labels.voxels);
    const std::vector<int> wanted{16000, 64000};
    const Mask some = read_mask(folder / "labels.nii.gz", job, wanted);
    for (std::size_t i = 0; i < some.voxels.size(); ++i)
        EXPECT_EQ(some.voxels[i] != 0, i % 5 == 1 || i % 5 == 4);
    const Volume rounded = read_volume(folder / "field.nii.gz", job);
    EXPECT_EQ(rounded.voxels[8], -94);
}

TEST(Nifti, WritesTheSameBytesForAnyNumberOfThreads) {
    const TemporaryFolder folder;
    Grid grid = small_grid();
    grid.dims = {200, 150, 60};  // several blocks of the compressor
    const Volume volume = patterned_volume(grid);
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        write_nifti(folder / (std::to_string(threads) + ".nii.gz"), volume);
    }
    const std::string one = bytes_of_file(folder / "1.nii.gz");
    EXPECT_EQ(one, bytes_of_file(folder / "2.nii.gz"));
    EXPECT_EQ(one, bytes_of_file(folder / "4.nii.gz"));
    Job job;
    EXPECT_EQ(read_volume(folder / "2.nii.gz", job).voxels, volume.voxels);
}

// Flipped and swapped on disk, one image inside: the axes run to the left, back and head again.
TEST(Nifti, TurnsAnyWholeAxisOrderBackToPatientAxes) {
    const TemporaryFolder folder;
    Job job;
    const Volume volume = patterned_volume(small_grid());
    Grid shuffled;  // file axes: head to foot, right to left flipped, front to back
    shuffled.dims = {9, 13, 11};
    shuffled.spacing_mm = {1.5, 0.75, 0.8};
    shuffled.direction << 0, -1, 0, 0, 0, 1, -1, 0, 0;
    shuffled.origin_mm = small_grid().to_mm(12, 0, 8);
    Volume on_disk(shuffled);
    for (int z = 0; z < 9; ++z)
        for (int y = 0; y < 11; ++y)
            for (int x = 0; x < 13; ++x) on_disk.at(8 - z, 12 - x, y) = volume.at(x, y, z);
    write_nifti(folder / "shuffled.nii.gz", on_disk);
    const Volume read = read_volume(folder / "shuffled.nii.gz", job);
    EXPECT_TRUE(same_grid(read.grid, volume.grid));
    EXPECT_EQ(read.voxels, volume.voxels);
}

TEST(Nifti, FallsBackFromAffineToQuaternion) {
    const TemporaryFolder folder;
    Job job;
    const Volume volume = patterned_volume(turned_grid());
    write_nifti(folder / "q.nii", volume);
    std::string bytes = bytes_of_file(folder / "q.nii");
    const std::int16_t none = 0;
    std::memcpy(bytes.data() + 254, &none, 2);  // sform_code
    write_bytes(folder / "q.nii", bytes);
    const Volume read = read_volume(folder / "q.nii", job);
    EXPECT_TRUE(same_grid(read.grid, volume.grid));
    EXPECT_EQ(read.voxels, volume.voxels);
}

TEST(Nifti, WithoutOrientationHasItsSpacingAlongTheAxesOfItsTools) {
    const TemporaryFolder folder;
    Job job;
    write_nifti(folder / "s.nii", patterned_volume(small_grid()));
    std::string bytes = bytes_of_file(folder / "s.nii");
    std::memset(bytes.data() + 228, 'x', 24);  // a name beside them, as long as may be
    std::memset(bytes.data() + 252, 0, 4);     // qform_code and sform_code
    write_bytes(folder / "s.nii", bytes);
    const Grid read = read_volume(folder / "s.nii", job).grid;
    EXPECT_EQ(read.dims, small_grid().dims);
    EXPECT_NEAR((read.spacing_mm - small_grid().spacing_mm).norm(), 0.0, 1e-6);
    EXPECT_LT(read.origin_mm.norm(), 30.0) << "a corner of the image, and not where it was";
    EXPECT_GT(small_grid().origin_mm.norm(), 400.0);
    EXPECT_NE(read.spacing_mm.x(), read.spacing_mm.y());
    EXPECT_NE(read.spacing_mm.y(), read.spacing_mm.z());
}

TEST(Nifti, AppliesSlopeAndClampsToSixteenBits) {
    const TemporaryFolder folder;
    NiftiFile file(folder);
    file.set(112, 100.0f).set(116, 7.0f);
    EXPECT_EQ(file.refusal_of_volume(), "");
    Job job;
    ReadRemarks remarks;
    const Volume read = read_volume(file.path(), job, &remarks);
    EXPECT_EQ(read.voxels[0], -32768);    // -1024 * 100 + 7
    EXPECT_EQ(read.at(4, 0, 2), -21993);  // (4 + 800 - 1024) * 100 + 7
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_NE(remarks[0].find("clamped"), std::string::npos);
}

TEST(Nifti, FillsScatteredVoxelsThatAreNoNumbersAndMakesAirOfPadding) {
    const TemporaryFolder folder;
    FloatVolume field(small_grid(), 50.0f);
    field.voxels[3] = std::numeric_limits<float>::quiet_NaN();
    field.voxels[4] = std::numeric_limits<float>::infinity();
    write_nifti(folder / "nan.nii.gz", field);
    Job job;
    ReadRemarks remarks;
    const Volume read = read_volume(folder / "nan.nii.gz", job, &remarks);
    for (const std::int16_t value : read.voxels) EXPECT_EQ(value, 50);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_NE(remarks[0].find("2 of"), std::string::npos) << remarks[0];

    field.voxels.assign(field.voxels.size(), std::numeric_limits<float>::quiet_NaN());
    field.voxels.back() = 50.0f;
    write_nifti(folder / "padding.nii.gz", field);
    const Volume padded = read_volume(folder / "padding.nii.gz", job, &remarks);
    EXPECT_EQ(padded.voxels.front(), -1024);
    EXPECT_EQ(padded.voxels.back(), 50);
}

TEST(Segmentation, ComesBackAndCarriesSlicersNames) {
    const TemporaryFolder folder;
    Job job;
    LabelMap labels(turned_grid());
    for (std::size_t i = 0; i < labels.voxels.size(); ++i)
        labels.voxels[i] = static_cast<std::uint16_t>(i % 3);
    const std::vector<SegmentDescription> segments{{1, "portal vein", {0, 0, 1}},
                                                   {2, "hepatic veins"}};
    write_segmentation(folder / "vessels.seg.nrrd", labels, segments);
    const LabelMap read = read_label_map(folder / "vessels.seg.nrrd", job);
    EXPECT_TRUE(same_grid(read.grid, labels.grid));
    EXPECT_EQ(read.voxels, labels.voxels);
    const std::string header = bytes_of_file(folder / "vessels.seg.nrrd").substr(0, 2000);
    EXPECT_NE(header.find("Segment0_Name:=portal vein\n"), std::string::npos);
    EXPECT_NE(header.find("Segment1_LabelValue:=2\n"), std::string::npos);
    EXPECT_NE(header.find("Segment0_Color:=0 0 1\n"), std::string::npos);
}

TEST(Segmentation, WithOverlappingLayersIsRefused) {
    const TemporaryFolder folder;
    Job job;
    write_bytes(folder / "layers.seg.nrrd",
                "NRRD0004\ntype: uchar\ndimension: 4\nspace: left-posterior-superior\n"
                "sizes: 2 4 4 4\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n"
                "kinds: list domain domain domain\nencoding: raw\nspace origin: (0,0,0)\n\n" +
                    std::string(128, '\1'));
    EXPECT_NE(refusal([&] { read_mask(folder / "layers.seg.nrrd", job); }).find("overlap"),
              std::string::npos);
}

TEST(LabelMap, RefusesAnImage) {
    const TemporaryFolder folder;
    Job job;
    write_nifti(folder / "ct.nii.gz", patterned_volume(small_grid()));
    EXPECT_NE(refusal([&] { read_label_map(folder / "ct.nii.gz", job); }).find("no label"),
              std::string::npos);
}

TEST(MaskFile, RefusesOneThatMarksNothing) {
    const TemporaryFolder folder;
    Job job;
    write_nifti(folder / "mask.nii.gz", Mask(small_grid()));
    EXPECT_NE(refusal([&] { read_mask(folder / "mask.nii.gz", job); }).find("no voxel"),
              std::string::npos);
}

TEST(RequireSameGrid, NamesSizesOrPlace) {
    const Grid grid = small_grid();
    EXPECT_NO_THROW(require_same_grid(grid, grid, "m.nii"));
    Grid shifted = grid;
    shifted.origin_mm[0] += 0.1;
    EXPECT_NE(
        refusal([&] { require_same_grid(shifted, grid, "m.nii"); }).find("the mask lies elsewhere"),
        std::string::npos);
    Grid larger = grid;
    larger.dims[2] += 1;
    const std::string sizes = refusal([&] { require_same_grid(larger, grid, "m.nii"); });
    EXPECT_NE(sizes.find("the mask has "), std::string::npos) << "the window begins with it";
    EXPECT_NE(sizes.find("13 x 11 x 10"), std::string::npos);
}

TEST(RequirePlausibleCt, RefusesWhatShowsNoPatient) {
    Grid grid = small_grid();
    const auto says = [&](const Volume& volume) {
        return refusal([&] { require_plausible_ct(volume, "ct", Job()); });
    };
    EXPECT_NE(says(Volume(grid)).find("value 0 in every voxel"), std::string::npos);
    EXPECT_NE(says(Volume(grid, -1024)).find("every voxel"), std::string::npos);
    Volume air(grid, -1000);
    air.voxels[5] = 2000;
    EXPECT_NE(says(air).find("soft tissue"), std::string::npos);
    Grid one_slice = grid;
    one_slice.dims[2] = 1;
    const Volume thin(one_slice, 40);
    EXPECT_NE(says(thin).find("only 1"), std::string::npos);
    EXPECT_EQ(says(patterned_volume(grid)), "");
}

TEST(Writer, RefusesWhatItCannotWriteAndLeavesNothing) {
    const TemporaryFolder folder;
    const Volume volume = patterned_volume(small_grid());
    EXPECT_NE(refusal([&] { write_nifti(folder / "ct.png", volume); }).find(".nii"),
              std::string::npos);
    for (const char* name : {"ct.png", "ct.nrrd", "seg.nrrd"})
        EXPECT_NE(refusal([&] { write_segmentation(folder / name, LabelMap(small_grid()), {}); }),
                  "")
            << name;
    write_bytes(folder / "file", "not a folder");
    EXPECT_NE(refusal([&] { write_nifti(folder / "file" / "ct.nii", volume); }), "");
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path()))
        ++count;
    EXPECT_EQ(count, 1u);
}

TEST(Reading, StopsWhenCancelledAndReportsProgress) {
    const TemporaryFolder folder;
    Grid grid = small_grid();
    grid.dims = {256, 256, 40};
    write_nifti(folder / "ct.nii.gz", patterned_volume(grid));
    Job job;
    read_volume(folder / "ct.nii.gz", job);
    EXPECT_GT(job.progress().fraction, 0.8);
    EXPECT_EQ(job.progress().stage_number, 1);
    Job cancelled;
    cancelled.cancel();
    EXPECT_THROW(read_volume(folder / "ct.nii.gz", cancelled), Cancelled);
}

}  // namespace
}  // namespace hepatica
