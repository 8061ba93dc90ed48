// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/tumours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

TEST(Tumours, AreNumberedByTheirSizeAndMarkedOnAnyGrid) {
    const fs::path folder = fs::path(testing::TempDir()) / "hepatica tumours";
    fs::create_directories(folder);
    Grid grid;
    grid.dims = {24, 20, 16};
    Mask first(grid), second(grid);
    first.at(3, 3, 3) = 7;  // one voxel
    for (int x = 10; x < 14; ++x)
        for (int y = 10; y < 14; ++y)
            for (int z = 4; z < 12; ++z) second.at(x, y, z) = 1;
    write_nifti(folder / "first.nii.gz", first);
    write_nifti(folder / "second.nii.gz", second);
    Job job;
    std::vector<std::string> warnings;
    const Mask tumours =
        read_tumours({folder / "first.nii.gz", folder / "second.nii.gz"}, grid, warnings, job);
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(tumours.at(3, 3, 3), 2);
    EXPECT_EQ(tumours.at(12, 12, 8), 1);
    EXPECT_EQ(std::ranges::count(tumours.voxels, 1), 128);

    Grid fine = grid;  // half the edge, from the middle of the CT on
    fine.dims = {20, 20, 20};
    fine.spacing_mm = Vec3::Constant(0.5);
    fine.origin_mm = Vec3(8.25, 8.25, 4.25);
    Mask organs(fine, 1);
    add_tumours(tumours, organs);
    // Voxels whose middles lie in the tumour's, which fills 9.5 to 13.5 mm, and 3.5 to 11.5 mm.
    EXPECT_EQ(std::ranges::count(organs.voxels, 10), 8 * 8 * 15);
    EXPECT_EQ(std::ranges::count(organs.voxels, 11), 0);
    EXPECT_EQ(organs.at(0, 0, 0), 1);
    Grid other = grid;
    other.spacing_mm = Vec3::Constant(2.0);
    EXPECT_THROW(read_tumours({folder / "first.nii.gz"}, other, warnings, job), InputError);
    fs::remove_all(folder);
}

// A case keeps organs in a box about the liver: what a mask holds elsewhere would vanish silently.
TEST(Tumours, OutsideTheBoxAboutTheLiverAreToldOf) {
    Grid ct;
    ct.dims = {24, 20, 16};
    Mask tumours(ct);
    for (int x = 10; x < 14; ++x)
        for (int y = 10; y < 14; ++y)
            for (int z = 4; z < 12; ++z) tumours.at(x, y, z) = 1;
    tumours.at(3, 3, 3) = 2;
    Job job;
    std::vector<std::string> warnings;
    warn_of_tumours_outside(tumours, ct, warnings, job);
    EXPECT_TRUE(warnings.empty());
    Grid box = ct;  // of half the edge, and without tumour 2
    box.origin_mm = ct.to_mm(6, 6, 0);
    box.spacing_mm = Vec3::Constant(0.5);
    box.dims = {30, 28, 32};
    warn_of_tumours_outside(tumours, box, warnings, job);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_TRUE(warnings[0].starts_with(
        "Of the tumours numbered 2 from the masks 0.001 of 0.001 ml lie outside the box"))
        << warnings[0];
    box = ct;  // without two of the eight layers of tumour 1
    box.dims[2] = 10;
    warn_of_tumours_outside(tumours, box, warnings, job);
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_TRUE(warnings[1].starts_with(
        "Of the tumours numbered 1 from the masks 0.032 of 0.128 ml lie outside the box"))
        << warnings[1];
}

// Only the reading of the file asked, once for a row; a CT has a hundred million voxels.
TEST(Tumours, HearACancellationAfterTheirFileIsRead) {
    const fs::path folder = fs::path(testing::TempDir()) / "hepatica wide tumour";
    fs::create_directories(folder);
    Grid grid;
    grid.dims = {1024, 1024, 3};
    Mask mask(grid);
    mask.voxels.back() = 1;
    write_nifti(folder / "tumour.nii.gz", mask);
    std::vector<std::string> warnings;
    const auto checks_of = [&](const auto& work) {
        Job job;
        std::atomic<int> checks = 0;
        job.observe([&](JobEvent event) { checks += event == JobEvent::check; });
        work(job);
        return checks.load();
    };
    const int of_file = checks_of([&](Job& job) { read_mask(folder / "tumour.nii.gz", job); });
    const int of_all =
        checks_of([&](Job& job) { read_tumours({folder / "tumour.nii.gz"}, grid, warnings, job); });
    EXPECT_GE(of_all, of_file + 12);  // a million voxels between two, in four passes
    fs::remove_all(folder);
}

}  // namespace
}  // namespace hepatica
