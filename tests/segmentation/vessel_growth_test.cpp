// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/vessel_growth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/base/error.h"
#include "core/segmentation/tissue_contrast.h"

namespace hepatica {
namespace {

Grid half_millimetres() {
    Grid grid;
    grid.dims = {30, 12, 6};
    grid.spacing_mm = Vec3::Constant(0.5);
    return grid;
}

// Voxels x0 to x1 of a row.
void draw(Mask& mask, int x0, int x1, int y, int z = 2) {
    for (int x = x0; x <= x1; ++x) mask.at(x, y, z) = 1;
}

std::size_t voxels_of(const Mask& mask) {
    return static_cast<std::size_t>(
        std::ranges::count_if(mask.voxels, [](auto v) { return v != 0; }));
}

TEST(Hysteresis, KeepsPiecesThatAreStrongSomewhereAndLargeEnough) {
    Mask weak(half_millimetres()), strong(half_millimetres());
    draw(weak, 0, 15, 1);   // 16 voxels are 2 mm3: just enough
    draw(weak, 0, 14, 4);   // one less
    draw(weak, 0, 20, 7);   // strong nowhere
    draw(weak, 18, 25, 2);  // touches the first by a corner only with the next row
    draw(weak, 16, 17, 2);
    for (const int y : {1, 4}) strong.at(3, y, 2) = 1;
    strong.at(29, 11, 5) = 1;  // strong, not weak
    const Mask kept = hysteresis(strong, weak, 2.0);
    Mask expected(half_millimetres());
    draw(expected, 0, 15, 1);
    draw(expected, 16, 25, 2);
    EXPECT_EQ(kept.voxels, expected.voxels);
    EXPECT_EQ(voxels_of(hysteresis(strong, weak, 2.5)), 26u);
    EXPECT_EQ(voxels_of(hysteresis(strong, weak, 0.0)), 26u + 15u);
}

TEST(PiecesWithin, KeepsThoseThatLieThereForAGivenShare) {
    Mask mask(half_millimetres()), where(half_millimetres());
    draw(mask, 0, 9, 1);   // 3 of 10 inside
    draw(mask, 0, 9, 4);   // 2 of 10
    draw(mask, 0, 9, 7);   // none
    draw(mask, 0, 2, 10);  // 1 of 3
    for (const int y : {1, 4, 10}) draw(where, y == 1 ? 0 : y == 4 ? 1 : 2, 2, y);
    draw(where, 15, 29, 7);  // of no piece
    Mask expected(half_millimetres());
    draw(expected, 0, 9, 1);
    draw(expected, 0, 2, 10);
    EXPECT_EQ(pieces_within(mask, where, 0.3).voxels, expected.voxels);
    EXPECT_EQ(voxels_of(pieces_within(mask, where, 0.0)), 33u);
    EXPECT_EQ(voxels_of(pieces_within(mask, where, 0.34)), 0u);
}

TEST(GrowWithin, ReachesSoFarThroughWhatIsWeak) {
    Mask weak(half_millimetres()), strong(half_millimetres());
    draw(weak, 0, 29, 5);
    strong.at(10, 5, 2) = 1;
    strong.at(20, 9, 2) = 1;  // not weak: grows nowhere
    for (const auto& [reach_mm, steps] : {std::pair{0.0, 0}, {1.5, 3}, {1.7, 3}, {1.8, 4}}) {
        Mask expected(half_millimetres());
        draw(expected, 10 - steps, 10 + steps, 5);
        EXPECT_EQ(grow_within(strong, weak, reach_mm).voxels, expected.voxels) << reach_mm;
    }
}

TEST(GrowWithin, CountsADiagonalStepAsOneAndJumpsNoGap) {
    Mask weak(half_millimetres()), strong(half_millimetres());
    for (int k = 0; k < 6; ++k) weak.at(10 + k, 3 + k, k) = 1;
    draw(weak, 2, 8, 3, 0);  // a voxel away
    strong.at(10, 3, 0) = 1;
    const Mask grown = grow_within(strong, weak, 2.0);
    for (int k = 0; k < 6; ++k) EXPECT_EQ(grown.at(10 + k, 3 + k, k), k <= 4) << k;
    EXPECT_EQ(grown.at(8, 3, 0), 0);
    // In all 26 directions, and not over the edge of the grid.
    const Mask all(half_millimetres(), 1);
    EXPECT_EQ(voxels_of(grow_within(strong, all, 0.5)), 9u * 2u);
    Mask inside(half_millimetres());
    inside.at(10, 6, 3) = 1;
    EXPECT_EQ(voxels_of(grow_within(inside, all, 0.5)), 27u);
    EXPECT_EQ(voxels_of(grow_within(inside, all, 1.0)), 125u);
}

// Surface parts A and B on one row; the skeleton also has branches that lead nowhere.
TEST(Rejoin, PutsBackWhatJoinsPartsAndLongBranches) {
    Mask surface(half_millimetres()), skeleton(half_millimetres());
    draw(surface, 0, 5, 2);
    draw(surface, 10, 15, 2);
    draw(skeleton, 0, 15, 2);   // joins both: 6 to 9 are missing
    draw(skeleton, 16, 19, 2);  // 4 voxels beyond the end: 2 mm
    draw(skeleton, 20, 24, 8);  // 5 voxels on their own: 2.5 mm
    draw(skeleton, 3, 6, 8);    // 4 voxels on their own
    Mask expected = surface;
    draw(expected, 6, 9, 2);
    draw(expected, 20, 24, 8);
    Mask joined = surface;
    rejoin(skeleton, 2.0, joined);
    EXPECT_EQ(joined.voxels, expected.voxels);
    draw(expected, 16, 19, 2);
    draw(expected, 3, 6, 8);
    rejoin(skeleton, 1.9, surface);
    EXPECT_EQ(surface.voxels, expected.voxels);
}

TEST(Rejoin, DoesNotCallOnePartTwo) {
    Mask surface(half_millimetres()), skeleton(half_millimetres());
    draw(surface, 0, 10, 2);
    draw(skeleton, 2, 2, 3);  // a loop of four voxels that begins and ends at the same part
    draw(skeleton, 3, 4, 4);
    draw(skeleton, 5, 5, 3);
    const Mask before = surface;
    rejoin(skeleton, 2.0, surface);
    EXPECT_EQ(surface.voxels, before.voxels);
}

// Looks at its job again and again, ends at whichever of its looks it is cancelled, and changes
// nothing by looking.
void expect_to_hear_a_cancel(const std::function<void(const Job&)>& work, int least_looks) {
    int looks = 0;
    Job whole;
    whole.observe([&](JobEvent) { ++looks; });
    work(whole);
    EXPECT_GE(looks, least_looks);
    for (const int last : {1, looks / 2, looks}) {
        int seen = 0;
        Job job;
        job.observe([&](JobEvent) {
            if (++seen == last) job.cancel();
        });
        EXPECT_THROW(work(job), Cancelled) << last << " of " << looks;
    }
}

TEST(VesselGrowth, HearsACancelAndIsTheSameWithAJob) {
    Grid grid = half_millimetres();
    grid.dims[2] = 400;
    Mask weak(grid), strong(grid);
    for (int z = 0; z < 400; ++z) draw(weak, z % 7, 20, z % 11, z);
    draw(strong, 9, 14, 5, 200);
    const Job job;
    EXPECT_EQ(hysteresis(strong, weak, 1.0, job).voxels, hysteresis(strong, weak, 1.0).voxels);
    EXPECT_EQ(pieces_within(weak, strong, 0.1, job).voxels,
              pieces_within(weak, strong, 0.1).voxels);
    Mask joined = strong, joined_with_job = strong;
    rejoin(weak, 1.0, joined);
    rejoin(weak, 1.0, joined_with_job, job);
    EXPECT_EQ(joined.voxels, joined_with_job.voxels);
    expect_to_hear_a_cancel([&](const Job& j) { hysteresis(strong, weak, 1.0, j); }, 400);
    expect_to_hear_a_cancel([&](const Job& j) { pieces_within(weak, strong, 0.1, j); }, 400);
    expect_to_hear_a_cancel(
        [&](const Job& j) {
            Mask surface = strong;
            rejoin(weak, 1.0, surface, j);
        },
        800);
    expect_to_hear_a_cancel([&](const Job& j) { robust_spread(FloatVolume(grid), weak, j); }, 2);
}

}  // namespace
}  // namespace hepatica
