// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/liver_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "core/base/error.h"
#include "core/image/filters.h"

namespace hepatica {
namespace {

// Linear in space and whole at every voxel: resampling and smoothing leave it as it is.
double hu_at(const Vec3& p) {
    return 5.0 * p.x() - 3.0 * p.y() + 2.0 * p.z() + 40.0;
}

Volume linear_ct() {
    Grid grid;
    grid.dims = {70, 64, 40};
    grid.spacing_mm = Vec3(1.0, 1.0, 2.0);
    grid.origin_mm = Vec3(-30, 12, -100);
    Volume ct(grid);
    for (std::size_t i = 0; i < ct.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        ct.voxels[i] = static_cast<std::int16_t>(std::lround(hu_at(grid.to_mm(x, y, z))));
    }
    return ct;
}

// On voxels of 2 mm of its own, shifted against those of the CT.
Mask box(const Vec3& low_mm, const Vec3& high_mm) {
    Grid grid;
    grid.dims = {60, 60, 60};
    grid.spacing_mm = Vec3::Constant(2.0);
    grid.origin_mm = Vec3(-50.5, -9.5, -120.5);
    Mask mask(grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p = grid.to_mm(x, y, z);
        mask.voxels[i] =
            ((p - low_mm).array() >= 0.0).all() && ((high_mm - p).array() >= 0.0).all();
    }
    return mask;
}

const Vec3 low_mm(-6.5, 34.5, -72.5), high_mm(13.5, 54.5, -52.5);  // centres of voxels

TEST(LiverFrame, IsTheCtOnCubesAroundTheLiver) {
    const Volume ct = linear_ct();
    Job job;
    for (const double spacing : {0.8, 1.4}) {
        const LiverFrame frame = make_liver_frame(ct, box(low_mm, high_mm), spacing, job);
        const Grid& grid = frame.intensity.grid;
        EXPECT_TRUE(same_grid(grid, frame.liver.grid));
        EXPECT_LT((grid.spacing_mm - Vec3::Constant(spacing)).norm(), 1e-12);
        const Vec3 first = grid.to_mm(0, 0, 0),
                   last = grid.to_mm(grid.dims[0] - 1, grid.dims[1] - 1, grid.dims[2] - 1);
        for (int a = 0; a < 3; ++a) {
            // The liver with 6 mm around it, in whole voxels of the CT.
            EXPECT_LE(first[a], low_mm[a] - 6.0 + spacing) << a;
            EXPECT_GE(first[a], low_mm[a] - 6.0 - ct.grid.spacing_mm[a] - spacing) << a;
            EXPECT_GE(last[a], high_mm[a] + 6.0 - spacing) << a;
            EXPECT_LE(last[a], high_mm[a] + 6.0 + ct.grid.spacing_mm[a] + spacing) << a;
        }
        for (std::size_t i = 0; i < grid.count(); ++i) {
            const auto [x, y, z] = grid.index_of(i);
            const Vec3 p = grid.to_mm(x, y, z);
            // Smoothing repeats the border of the part that it sees.
            if (((p - first).array() < 4.5).any() || ((last - p).array() < 4.5).any()) continue;
            ASSERT_NEAR(frame.intensity.voxels[i], hu_at(p), 0.01) << p.transpose();
        }
    }
}

TEST(LiverFrame, HoldsTheLiverAndClosesWhatWasCutOutOfIt) {
    Mask liver = box(low_mm, high_mm);
    const Mask whole = liver;
    for (std::size_t i = 0; i < liver.voxels.size(); ++i) {  // a channel of 6 mm through it
        const auto [x, y, z] = liver.grid.index_of(i);
        const Vec3 p = liver.grid.to_mm(x, y, z);
        if (std::abs(p.x() - 3.5) < 2.5 && std::abs(p.y() - 44.5) < 2.5) liver.voxels[i] = 0;
    }
    Job job;
    const LiverFrame frame = make_liver_frame(linear_ct(), liver, 1.0, job);
    const Grid& grid = frame.liver.grid;
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p = grid.to_mm(x, y, z);
        const double inside = std::min((p - low_mm).minCoeff(), (high_mm - p).minCoeff());
        if (inside >= 5.0) {
            ASSERT_EQ(frame.liver.voxels[i], 1) << p.transpose();
        }
    }
}

// It is closed by more than the margin: a closing that grew towards the frame's border would add
// the whole margin to the liver.
TEST(LiverFrame, DoesNotGrowTheLiverTowardsItsBorder) {
    Job job;
    const LiverFrame frame = make_liver_frame(linear_ct(), box(low_mm, high_mm), 1.0, job);
    const Grid& grid = frame.liver.grid;
    std::size_t inside_voxels = 0;
    for (std::size_t i = 0; i < grid.count(); ++i) {
        if (frame.liver.voxels[i] == 0) continue;
        ++inside_voxels;
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p = grid.to_mm(x, y, z);
        const double outside = std::max((low_mm - p).maxCoeff(), (p - high_mm).maxCoeff());
        // Half a voxel of the mask's and one of the frame's.
        ASSERT_LE(outside, 2.0) << p.transpose();
    }
    EXPECT_NEAR(static_cast<double>(inside_voxels), 22.0 * 22.0 * 22.0, 0.1 * 22.0 * 22.0 * 22.0);
}

// As many programs save a mask: its grid is the liver's box, and liver lies at each border.
TEST(LiverFrame, OfAMaskCutToTheLiverIsTheSameAsOfTheWholeMask) {
    const Volume ct = linear_ct();
    const Mask whole = box(low_mm, high_mm);
    const Mask cut = crop(whole, bounding_box(whole));
    ASSERT_EQ(std::count(cut.voxels.begin(), cut.voxels.end(), 0), 0);
    Job job;
    const LiverFrame of_whole = make_liver_frame(ct, whole, 0.8, job);
    const LiverFrame of_cut = make_liver_frame(ct, cut, 0.8, job);
    ASSERT_TRUE(same_grid(of_cut.liver.grid, of_whole.liver.grid));
    EXPECT_EQ(of_cut.intensity.voxels, of_whole.intensity.voxels);
    std::size_t other = 0;
    for (std::size_t i = 0; i < of_cut.liver.voxels.size(); ++i)
        other += of_cut.liver.voxels[i] != of_whole.liver.voxels[i];
    // At edges and corners the whole mask is interpolated with the background around it.
    EXPECT_LT(other, of_cut.liver.voxels.size() / 50);
}

TEST(LiverFrame, EndsWhereTheCtEnds) {
    const Volume ct = linear_ct();
    Job job;
    const LiverFrame frame =
        make_liver_frame(ct, box(Vec3(-50, -20, -130), Vec3(100, 150, 100)), 1.0, job);
    const Grid& grid = frame.intensity.grid;
    EXPECT_LT((grid.to_mm(0, 0, 0) - ct.grid.origin_mm).norm(), 1.5);
    EXPECT_LT((grid.to_mm(grid.dims[0] - 1, grid.dims[1] - 1, grid.dims[2] - 1) -
               ct.grid.to_mm(69, 59, 39))
                  .cwiseAbs()
                  .x(),
              1.5);
}

double available_bytes() {
    std::ifstream info("/proc/meminfo");
    std::string name, unit;
    double kilobytes = 0.0;
    while (info >> name >> kilobytes >> unit)
        if (name == "MemAvailable:") return 1024.0 * kilobytes;
    return 0.0;
}

// A mask of the whole body in place of the liver: one image on cubes takes less than half of the
// memory, all of them together more than twice. Linux ends a program for that without a word.
TEST(LiverFrame, IsRefusedWhereTheStepsAfterItWouldNotFitIntoMemory) {
    const double available = available_bytes();
    if (available == 0.0) GTEST_SKIP() << "the free memory is not known";
    constexpr double cube_mm = 0.3, voxel_mm = 10.0;
    const double edge_mm = cube_mm * std::cbrt(0.4 * available / sizeof(float));
    Grid grid;
    grid.dims.fill(static_cast<int>(edge_mm / voxel_mm));
    grid.spacing_mm = Vec3::Constant(voxel_mm);
    Job job;
    try {
        make_liver_frame(Volume(grid, 100), Mask(grid, 1), cube_mm, job);
        FAIL() << "it was made";
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("of memory"), std::string::npos) << error.what();
        EXPECT_EQ(error.place(), "liver mask");
    }
}

TEST(LiverFrame, RefusesSpacingsAndMasksThatCannotBe) {
    const Volume ct = linear_ct();
    const Mask liver = box(low_mm, high_mm);
    Job job;
    for (const double wrong : {0.29, 1.51, std::nan("")})
        EXPECT_THROW(make_liver_frame(ct, liver, wrong, job), InputError) << wrong;
    EXPECT_NO_THROW(make_liver_frame(ct, liver, 1.5, job));
    EXPECT_THROW(make_liver_frame(ct, Mask(liver.grid), 1.0, job), InputError);
    Mask elsewhere = liver;
    elsewhere.grid.origin_mm.x() += 500.0;
    EXPECT_THROW(make_liver_frame(ct, elsewhere, 1.0, job), InputError);
}

}  // namespace
}  // namespace hepatica
