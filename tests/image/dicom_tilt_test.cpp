// SPDX-License-Identifier: GPL-3.0-or-later
// Series taken with a tilted gantry: the slices are stacked aslant. What stands at a known place in
// millimetres is at that place in the image that is read.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/image/dicom_folder.h"

namespace hepatica {
namespace {

using namespace testing_support;

const gdcm::Tag gantry_tilt(0x0018, 0x1120);
const gdcm::Tag slice_thickness(0x0018, 0x0050);

const Vec3 sphere_centre_mm(4.2, -13.7, 61.3);
constexpr double sphere_radius_mm = 9.0;
constexpr double slice_step_mm = 2.0;

// Smooth enough that linear interpolation hardly errs, and of another value in every voxel.
double blob_hu(const Vec3& at_mm) {
    return 1000.0 * std::exp(-(at_mm - sphere_centre_mm).squaredNorm() / (2.0 * 64.0));
}

double sphere_hu(const Vec3& at_mm) {
    return (at_mm - sphere_centre_mm).norm() < sphere_radius_mm ? 255.0 : 0.0;
}

std::string three_numbers(const Vec3& p) {
    char text[96];
    std::snprintf(text, sizeof text, "%.9g\\%.9g\\%.9g", p.x(), p.y(), p.z());
    return text;
}

// Planes turned about the patient's left-right axis (or, where `about_y`, the back-front axis),
// while the table moves straight along the body.
struct TiltedScan {
    explicit TiltedScan(double degrees, bool about_y = false) {
        const double angle = degrees * std::numbers::pi / 180.0;
        grid.dims = {48, 44, 30};
        grid.spacing_mm = {0.8, 0.9, slice_step_mm * std::cos(angle)};
        grid.direction =
            Eigen::AngleAxisd(angle, about_y ? Vec3::UnitY() : Vec3::UnitX()).toRotationMatrix();
        grid.origin_mm = sphere_centre_mm -
                         grid.direction * Vec3(48 * 0.4 + 1.3, 44 * 0.45 - 0.7, 0.0) -
                         Vec3(0.0, 0.0, 15.0 * slice_step_mm);
    }
    Vec3 corner_mm(int z) const { return grid.origin_mm + Vec3(0.0, 0.0, z * slice_step_mm); }
    Vec3 to_mm(int x, int y, int z) const {
        return corner_mm(z) +
               grid.direction * Vec3(x * grid.spacing_mm[0], y * grid.spacing_mm[1], 0.0);
    }
    template <class Function>
    Volume sampled(const Function& hu) const {
        Volume volume(grid);
        for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
            const Index3 at = grid.index_of(i);
            volume.voxels[i] =
                static_cast<std::int16_t>(std::lround(hu(to_mm(at[0], at[1], at[2]))));
        }
        return volume;
    }
    void set_positions(const DicomFolder& folder) const {
        for (int z = 0; z < grid.dims[2]; ++z)
            folder.edit(z + 1, position, three_numbers(corner_mm(z)));
    }

    Grid grid;  // its origin and axes are those of the first slice
};

Vec3 centroid_mm(const Volume& volume) {
    Vec3 sum = Vec3::Zero();
    double weight = 0.0;
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        if (volume.voxels[i] <= 20) continue;
        const Index3 at = volume.grid.index_of(i);
        sum += volume.voxels[i] * volume.grid.to_mm(at[0], at[1], at[2]);
        weight += volume.voxels[i];
    }
    return sum / weight;
}

TEST(TiltedGantry, EveryVoxelShowsWhatLiesAtItsPlace) {
    for (const bool about_y : {false, true})
        for (const double degrees : {-24.0, 7.0, 30.0}) {
            const TiltedScan scan(degrees, about_y);
            const DicomFolder folder(scan.sampled(blob_hu));
            scan.set_positions(folder);
            const Volume read = folder.read();
            std::size_t seen = 0;
            for (std::size_t i = 0; i < read.voxels.size(); ++i) {
                if (read.voxels[i] == -1024) continue;
                const Index3 at = read.grid.index_of(i);
                ASSERT_NEAR(read.voxels[i], blob_hu(read.grid.to_mm(at[0], at[1], at[2])), 4.0)
                    << degrees << " degrees at " << at[0] << ", " << at[1] << ", " << at[2];
                ++seen;
            }
            // All that was scanned but a seam of a pixel is there, and nothing else.
            EXPECT_LE(seen, folder.volume().voxels.size());
            EXPECT_GE(seen, folder.volume().voxels.size() * 9 / 10);
            EXPECT_LT((centroid_mm(read) - sphere_centre_mm).norm(), 0.4) << degrees;
            EXPECT_TRUE((read.grid.direction.transpose() * read.grid.direction).isIdentity(1e-9));
        }
}

TEST(TiltedGantry, IsToldToTheUserWithItsAngle) {
    const TiltedScan scan(-12.5);
    const DicomFolder folder(scan.sampled(blob_hu));
    scan.set_positions(folder);
    folder.edit_all(gantry_tilt, "-12.5");
    ReadRemarks remarks;
    folder.read(&remarks);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_TRUE(mentions(remarks, "stacked aslant by 12.5 degrees")) << remarks[0];
}

// Interpolated, a mask would grow by the pixels that it only touches.
TEST(TiltedGantry, AMaskKeepsEveryPixelItHas) {
    const TiltedScan scan(17.0);
    const DicomFolder folder(scan.sampled(sphere_hu));
    scan.set_positions(folder);
    Job job;
    const Mask mask = read_mask(folder.path(), job);
    const auto drawn = std::ranges::count(folder.volume().voxels, 255);
    EXPECT_GT(drawn, 1000);
    EXPECT_EQ(std::ranges::count(mask.voxels, 1), drawn);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const Index3 at = mask.grid.index_of(i);
        const double off_mm =
            (mask.grid.to_mm(at[0], at[1], at[2]) - sphere_centre_mm).norm() - sphere_radius_mm;
        if (std::abs(off_mm) > 0.7) {
            ASSERT_EQ(mask.voxels[i], off_mm < 0.0 ? 1 : 0);
        }
    }
}

// An image and the mask that was drawn on it lie on one grid.
TEST(TiltedGantry, AMaskFitsItsImage) {
    const TiltedScan scan(17.0);
    const DicomFolder image(scan.sampled(blob_hu));
    const DicomFolder mask(scan.sampled(sphere_hu));
    scan.set_positions(image);
    scan.set_positions(mask);
    Job job;
    EXPECT_TRUE(same_grid(image.read().grid, read_mask(mask.path(), job).grid));
}

TEST(TiltedGantry, PaddingOfTheScanIsNotMixedIntoItsValues) {
    const TiltedScan scan(20.0);
    Volume volume = scan.sampled([](const Vec3&) { return 50.0; });
    for (int z = 0; z < 30; ++z)
        for (int x = 0; x < 10; ++x)
            for (int y = 0; y < 44; ++y) volume.at(x, y, z) = -2000;
    const DicomFolder folder(volume);
    scan.set_positions(folder);
    folder.edit_all(gdcm::Tag(0x0028, 0x0120), std::string("\x30\xf8", 2));  // -2000
    ReadRemarks remarks;
    const Volume read = folder.read(&remarks);
    for (const std::int16_t value : read.voxels)
        ASSERT_TRUE(value == 50 || value == -1024) << value;
    EXPECT_TRUE(mentions(remarks, "13200 of"));  // 10 x 44 x 30
    // Of the other 38 columns a row at most is lost, and no column beside the padding.
    EXPECT_GE(std::ranges::count(read.voxels, 50), 38 * 43 * 30);
}

TEST(TiltedGantry, BeyondAnyGantryIsRefusedByItsAngle) {
    const TiltedScan scan(60.0);
    const DicomFolder folder(scan.sampled(blob_hu));
    scan.set_positions(folder);
    const std::string message = folder.refusal_of_folder();
    EXPECT_NE(message.find("aslant by 60 degrees"), std::string::npos) << message;
}

TEST(TiltedGantry, WithASliceMissingOrShiftedIsRefusedAllTheSame) {
    const TiltedScan scan(15.0);
    const DicomFolder missing(scan.sampled(blob_hu));
    scan.set_positions(missing);
    std::filesystem::remove(missing.slice(11));
    EXPECT_NE(missing.refusal_of_folder().find("1 slice is missing between “slice_0010.dcm”"),
              std::string::npos);
    const DicomFolder shifted(scan.sampled(blob_hu));
    scan.set_positions(shifted);
    shifted.edit(7, position, three_numbers(scan.corner_mm(6) + Vec3(0.0, 1.0, 0.0)));
    const std::string message = shifted.refusal_of_folder();
    EXPECT_NE(message.find("slice_0007.dcm: is shifted sideways"), std::string::npos) << message;
}

// The standard wants positions and orientations to be believed, not the tilt.
TEST(TiltedGantry, ThatIsOnlyStatedChangesNothingAndIsSaid) {
    const DicomFolder folder;
    folder.edit_all(gantry_tilt, "15");
    ReadRemarks remarks;
    const Volume read = folder.read(&remarks);
    EXPECT_EQ(read.voxels, folder.volume().voxels);
    EXPECT_TRUE(same_grid(read.grid, folder.volume().grid));
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_TRUE(mentions(remarks, "gantry tilt of 15 degrees (0018,1120)")) << remarks[0];
}

// Slices thicker than their distance show some of the body twice: their centres count.
TEST(OverlappingSlices, AreReadByTheirPositions) {
    const DicomFolder folder;
    folder.edit_all(slice_thickness, "3");  // 1.5 mm apart
    ReadRemarks remarks;
    const Volume read = folder.read(&remarks);
    EXPECT_EQ(read.voxels, folder.volume().voxels);
    EXPECT_TRUE(same_grid(read.grid, folder.volume().grid));
    EXPECT_TRUE(remarks.empty());
}

}  // namespace
}  // namespace hepatica
