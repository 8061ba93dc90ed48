// SPDX-License-Identifier: GPL-3.0-or-later
// ITK reads what this program writes, and this program reads what ITK writes, with every voxel at
// the same physical point.
#include <gtest/gtest.h>
#include <itkGDCMImageIO.h>
#include <itkGDCMSeriesFileNames.h>
#include <itkImage.h>
#include <itkImageFileReader.h>
#include <itkImageFileWriter.h>
#include <itkImageSeriesReader.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/image/image_fixtures.h"

namespace hepatica {
namespace {

using namespace testing_support;
using ItkVolume = itk::Image<short, 3>;

itk::ImageIOBase::Pointer io_for(const std::string& name) {
    if (name.ends_with(".nii") || name.ends_with(".nii.gz"))
        return itk::NiftiImageIO::New().GetPointer();
    if (name.ends_with(".nrrd") || name.ends_with(".nhdr"))
        return itk::NrrdImageIO::New().GetPointer();
    return itk::MetaImageIO::New().GetPointer();
}

ItkVolume::Pointer itk_copy(const Volume& volume) {
    const auto image = ItkVolume::New();
    ItkVolume::SizeType size;
    ItkVolume::SpacingType spacing;
    ItkVolume::PointType origin;
    ItkVolume::DirectionType direction;
    for (unsigned a = 0; a < 3; ++a) {
        size[a] = volume.grid.dims[a];
        spacing[a] = volume.grid.spacing_mm[a];
        origin[a] = volume.grid.origin_mm[a];
        for (unsigned b = 0; b < 3; ++b) direction[a][b] = volume.grid.direction(a, b);
    }
    image->SetRegions(size);
    image->SetSpacing(spacing);
    image->SetOrigin(origin);
    image->SetDirection(direction);
    image->Allocate();
    std::ranges::copy(volume.voxels, image->GetBufferPointer());
    return image;
}

// Every 7th voxel of ITK's image lies at the same point, with the same value, in ours.
void expect_same_world(const ItkVolume* theirs, const Volume& ours) {
    std::size_t compared = 0;
    const auto size = theirs->GetLargestPossibleRegion().GetSize();
    for (long z = 0; z < static_cast<long>(size[2]); ++z)
        for (long y = 0; y < static_cast<long>(size[1]); ++y)
            for (long x = (y + z) % 7; x < static_cast<long>(size[0]); x += 7) {
                const ItkVolume::IndexType index{{x, y, z}};
                ItkVolume::PointType point;
                theirs->TransformIndexToPhysicalPoint(index, point);
                const Vec3 at = ours.grid.to_index(Vec3(point[0], point[1], point[2]));
                const Vec3 whole = at.array().round();
                ASSERT_LT((at - whole).norm(), 0.01);
                ASSERT_TRUE(ours.grid.contains(static_cast<int>(whole[0]),
                                               static_cast<int>(whole[1]),
                                               static_cast<int>(whole[2])));
                ASSERT_EQ(theirs->GetPixel(index),
                          ours.at(static_cast<int>(whole[0]), static_cast<int>(whole[1]),
                                  static_cast<int>(whole[2])));
                ++compared;
            }
    EXPECT_GT(compared, 100u);
    EXPECT_EQ(size[0] * size[1] * size[2], ours.voxels.size());
}

ItkVolume::Pointer itk_read(const std::filesystem::path& file) {
    const auto reader = itk::ImageFileReader<ItkVolume>::New();
    reader->SetFileName(file.string());
    reader->SetImageIO(io_for(file.filename().string()));
    reader->Update();
    return reader->GetOutput();
}

Grid sagittal_grid() {
    Grid grid = turned_grid();
    Mat3 swap;
    swap << 0, 0, -1, 1, 0, 0, 0, -1, 0;
    grid.direction = grid.direction * swap;
    return grid;
}

Grid mirrored_grid() {
    Grid grid = turned_grid();
    grid.direction.col(1) *= -1.0;
    return grid;
}

TEST(Itk, ReadsOurNiftiInTheSamePlace) {
    const TemporaryFolder folder;
    for (const Grid& grid : {small_grid(), turned_grid(), sagittal_grid(), mirrored_grid()}) {
        const Volume volume = patterned_volume(grid);
        for (const char* name : {"ct.nii", "ct.nii.gz"}) {
            write_nifti(folder / name, volume);
            expect_same_world(itk_read(folder / name), volume);
        }
    }
}

TEST(Itk, ReadsOurSegmentationInTheSamePlace) {
    const TemporaryFolder folder;
    Volume volume = patterned_volume(sagittal_grid());
    LabelMap labels(volume.grid);
    for (std::size_t i = 0; i < labels.voxels.size(); ++i) {
        labels.voxels[i] = static_cast<std::uint16_t>(i % 3000);
        volume.voxels[i] = static_cast<std::int16_t>(i % 3000);
    }
    write_segmentation(folder / "s.seg.nrrd", labels, {});
    expect_same_world(itk_read(folder / "s.seg.nrrd"), volume);
}

TEST(Itk, ReadsOurDicomSeriesInTheSamePlace) {
    const TemporaryFolder folder;
    Job job;
    for (const Grid& grid : {small_grid(), turned_grid(), sagittal_grid(), mirrored_grid()}) {
        const Volume volume = patterned_volume(grid);
        write_dicom_series(folder / "ct", volume, {}, job);
        const auto names = itk::GDCMSeriesFileNames::New();
        names->SetDirectory((folder / "ct").string());
        ASSERT_EQ(names->GetSeriesUIDs().size(), 1u);
        const auto reader = itk::ImageSeriesReader<ItkVolume>::New();
        reader->SetImageIO(itk::GDCMImageIO::New());
        reader->SetFileNames(names->GetInputFileNames());
        reader->Update();
        expect_same_world(reader->GetOutput(), volume);
        expect_same_world(reader->GetOutput(), read_volume(folder / "ct", job));
    }
}

TEST(Itk, WritesFilesThatWeReadInTheSamePlace) {
    const TemporaryFolder folder;
    Job job;
    for (const Grid& grid : {small_grid(), turned_grid(), sagittal_grid(), mirrored_grid()})
        for (const std::string name : {"a.nii", "a.nii.gz", "a.mha", "a.mhd", "a.nrrd", "a.nhdr"})
            for (const bool compressed : {false, true}) {
                const auto image = itk_copy(patterned_volume(grid));
                const auto writer = itk::ImageFileWriter<ItkVolume>::New();
                writer->SetInput(image);
                writer->SetFileName((folder / name).string());
                writer->SetImageIO(io_for(name));
                writer->SetUseCompression(compressed);
                writer->Update();
                SCOPED_TRACE(name);
                expect_same_world(image, read_volume(folder / name, job));
            }
}

}  // namespace
}  // namespace hepatica
