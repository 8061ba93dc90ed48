// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/voxel_loop.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

#include "core/base/error.h"
#include "core/image/morphology.h"

namespace hepatica {
namespace {

constexpr std::size_t several_blocks = 3 * voxels_between_looks + 17;

// 5.2 million voxels in 200 slices of 64 rows.
Mask speckled() {
    Grid grid;
    grid.dims = {408, 64, 200};
    Mask mask(grid);
    std::mt19937 random(3);
    for (std::uint8_t& voxel : mask.voxels) voxel = random() % 5 == 0;
    return mask;
}

// How often `work` looks at its job. Cancelled at any of some of these looks it ends with Cancelled
// and, but for threads beside it, does not look again.
int looks_of(const std::function<void(Job&)>& work) {
    Job whole;
    std::atomic<int> looks{0};
    whole.observe([&](JobEvent event) { looks += event == JobEvent::check; });
    work(whole);
    const int all = looks;
    for (const int last : {1, all / 3, 2 * all / 3, all}) {
        if (last < 1) continue;
        Job job;
        looks = 0;
        job.observe([&](JobEvent event) {
            if (event == JobEvent::check && ++looks == last) job.cancel();
        });
        EXPECT_THROW(work(job), Cancelled) << last << " of " << all;
        EXPECT_LE(looks, last + 16) << last << " of " << all;
    }
    return all;
}

TEST(VoxelLoop, VisitsEveryVoxelOnce) {
    Job job;
    std::vector<int> visits(several_blocks), order;
    for_each_voxel(visits.size(), job, [&](std::size_t i) { ++visits[i]; });
    EXPECT_EQ(visits, std::vector<int>(several_blocks, 1));
    for_each_voxel_in_order(several_blocks, job,
                            [&](std::size_t i) { order.push_back(static_cast<int>(i)); });
    std::vector<int> expected(several_blocks);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(order, expected);
    for_each_voxel(0, job, [](std::size_t) { ADD_FAILURE(); });
    for_each_voxel_in_order(0, job, [](std::size_t) { ADD_FAILURE(); });
}

TEST(VoxelLoop, HearsACancelInEveryBlock) {
    EXPECT_EQ(looks_of([](Job& job) { for_each_voxel(several_blocks, job, [](std::size_t) {}); }),
              4);
    EXPECT_EQ(looks_of([](Job& job) {
                  for_each_voxel_in_order(several_blocks, job, [](std::size_t) {});
              }),
              4);
}

TEST(VoxelLoop, FillsAndCopiesAsAnImageDoes) {
    Job job;
    const Mask mask = speckled();
    EXPECT_EQ(copied_image(mask, job).voxels, mask.voxels);
    EXPECT_TRUE(same_grid(copied_image(mask, job).grid, mask.grid));
    EXPECT_EQ(filled_image(mask.grid, 2.5f, job).voxels, FloatVolume(mask.grid, 2.5f).voxels);
    EXPECT_TRUE(filled_image(Grid(), 1.0f, job).voxels.empty());
    EXPECT_GE(looks_of([&](Job& j) { filled_image(mask.grid, 2.5f, j); }), 5);
    EXPECT_GE(looks_of([&](Job& j) { copied_image(mask, j); }), 10);
}

// In each of their passes over the rows, of which the one that joins them looks 200 times.
TEST(VoxelLoop, ComponentsAndHolesHearACancel) {
    const Mask mask = speckled();
    EXPECT_GE(looks_of([&](Job& j) { connected_components(mask, Connectivity::all26, j); }), 225);
    EXPECT_GE(looks_of([&](Job& j) { fill_holes(mask, j); }), 230);
    Job job;
    EXPECT_EQ(connected_components(mask, Connectivity::all26, job).labels.voxels,
              connected_components(mask, Connectivity::all26).labels.voxels);
    EXPECT_EQ(fill_holes(mask, job).voxels, fill_holes(mask).voxels);
}

TEST(VoxelLoop, ShapesHearACancel) {
    Mask mask = speckled();
    mask.grid.dims = {102, 64, 200};
    mask.voxels.resize(mask.grid.count());
    EXPECT_GE(looks_of([&](Job& j) { close(mask, 3.0, j); }), 400);
    EXPECT_GE(looks_of([&](Job& j) { erode(mask, 3.0, j); }), 200);
    EXPECT_GE(looks_of([&](Job& j) { close_in(mask, 3.0, {{9, 9, 9}, {40, 40, 40}}, j); }), 40);
}

}  // namespace
}  // namespace hepatica
