// SPDX-License-Identifier: GPL-3.0-or-later
// Small pictures of slices: proportions, greys, and which slice stands for a series.
#include "core/image/thumbnail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "tests/image/dicom_folder.h"

namespace hepatica {
namespace {

using namespace testing_support;
namespace fs = std::filesystem;

int grey_at(const Thumbnail& picture, int x, int y) {
    return picture.grey[static_cast<std::size_t>(y * picture.width + x)];
}

// 40 mm wide and 80 mm high.
TEST(Thumbnail, HasTheProportionsOfTheSliceInMillimetres) {
    const std::vector<double> hu(40 * 20, 40.0);
    const Thumbnail picture = thumbnail_of({hu, 40, 20, 1.0, 4.0}, soft_tissue, 96);
    EXPECT_EQ(picture.width, 48);
    EXPECT_EQ(picture.height, 96);
    EXPECT_EQ(picture.grey.size(), 48u * 96u);
    const Thumbnail lying = thumbnail_of({hu, 20, 40, 4.0, 1.0}, soft_tissue, 96);
    EXPECT_EQ(lying.width, 96);
    EXPECT_EQ(lying.height, 48);
    const Thumbnail thread = thumbnail_of({hu, 800, 1, 1.0, 1.0}, soft_tissue, 96);
    EXPECT_EQ(thread.width, 96);
    EXPECT_EQ(thread.height, 1) << "a line at least";
}

TEST(Thumbnail, ShowsSoftTissueBetweenBlackAndWhite) {
    const double padding = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> hu{-1000.0, -160.0, -60.0, 40.0, 140.0, 240.0, 1500.0, padding};
    const Thumbnail picture = thumbnail_of({hu, 8, 1}, soft_tissue, 8);
    const std::vector<std::uint8_t> expected{0, 0, 64, 128, 191, 255, 255, 0};
    EXPECT_EQ(picture.grey, expected);
}

// Every pixel is the mean of four, whatever pattern they make; the right half is brighter.
TEST(Thumbnail, MeansWhatLiesUnderEachPixel) {
    std::vector<double> hu;
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 16; ++column)
            hu.push_back((row + column) % 2 == 0 ? -160.0 : column < 8 ? 40.0 : 240.0);
    const Thumbnail picture = thumbnail_of({hu, 16, 8}, soft_tissue, 8);
    ASSERT_EQ(picture.width, 8);
    ASSERT_EQ(picture.height, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) EXPECT_EQ(grey_at(picture, x, y), x < 4 ? 64 : 128);
}

TEST(Thumbnail, EnlargesASmallSliceWithoutLosingAPixel) {
    const std::vector<double> hu{-160.0, 240.0, 240.0, -160.0};
    const Thumbnail picture = thumbnail_of({hu, 2, 2}, soft_tissue, 6);
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 6; ++x)
            EXPECT_EQ(grey_at(picture, x, y), (x < 3) == (y < 3) ? 0 : 255) << x << " " << y;
}

// Against the volume that was written, voxel by voxel.
TEST(Thumbnail, OfAFileShowsItsSlice) {
    Job job;
    Grid grid = small_grid();
    grid.spacing_mm = Vec3(2.0, 2.0, 1.5);
    Volume ct(grid);
    for (int z = 0; z < grid.dims[2]; ++z)
        for (int y = 0; y < grid.dims[1]; ++y)
            for (int x = 0; x < grid.dims[0]; ++x)
                ct.voxels[grid.offset(x, y, z)] =
                    static_cast<std::int16_t>(20 * x - 12 * y + 5 * z);
    const DicomFolder folder(ct);
    const int side = static_cast<int>(std::max(grid.dims[0], grid.dims[1]));
    const Thumbnail picture = thumbnail_of(folder.slice(4), side, job);
    ASSERT_EQ(picture.width, grid.dims[0]);
    ASSERT_EQ(picture.height, grid.dims[1]);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double hu = ct.at(x, y, 3);
            EXPECT_NEAR(grey_at(picture, x, y),
                        std::clamp(255.0 * (hu + 160.0) / 400.0, 0.0, 255.0), 0.5);
        }
}

TEST(Thumbnail, OfPixelsWithoutASizeIsDrawnAsIfTheyWereSquare) {
    Job job;
    const DicomFolder folder;
    const Grid& grid = folder.volume().grid;
    folder.edit(4, pixel_spacing, "");
    const Thumbnail picture = thumbnail_of(folder.slice(4), 90, job);
    const double wide = static_cast<double>(grid.dims[0]), high = static_cast<double>(grid.dims[1]);
    EXPECT_EQ(picture.width, std::lround(90.0 * wide / std::max(wide, high)));
    EXPECT_EQ(picture.height, std::lround(90.0 * high / std::max(wide, high)));
}

TEST(Thumbnail, IsRefusedWhereNothingCanBeDecoded) {
    Job job;
    const DicomFolder folder;
    fs::resize_file(folder.slice(1), fs::file_size(folder.slice(1)) - 7);
    EXPECT_NE(refusal([&] { thumbnail_of(folder.slice(1), 96, job); }), "");
    folder.edit(2, frames, "3");
    EXPECT_NE(refusal([&] { thumbnail_of(folder.slice(2), 96, job); }).find("frames"),
              std::string::npos);
    folder.edit(3, slope, "two");
    EXPECT_NE(refusal([&] { thumbnail_of(folder.slice(3), 96, job); }).find("slope"),
              std::string::npos);
    std::ofstream(folder.slice(4)) << "a letter";
    EXPECT_NE(refusal([&] { thumbnail_of(folder.slice(4), 96, job); }).find("no DICOM image"),
              std::string::npos);
    EXPECT_NE(refusal([&] { thumbnail_of(folder.path() / "gone", 96, job); }), "");
}

// Names of files say nothing about where slices lie.
TEST(Thumbnail, StandsForASeriesByItsMiddleSlice) {
    Job job;
    const DicomFolder folder;  // nine slices
    fs::rename(folder.slice(5), folder.path() / "zzz.dcm");
    fs::rename(folder.slice(9), folder.path() / "aaa.dcm");
    const std::vector<SeriesDescription> series = list_series(folder.path(), job);
    ASSERT_EQ(series.size(), 1u);
    EXPECT_EQ(series[0].middle_slice, folder.path() / "zzz.dcm");
}

}  // namespace
}  // namespace hepatica
