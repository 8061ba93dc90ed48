// SPDX-License-Identifier: GPL-3.0-or-later
// The cheapest way across gaps of known length and brightness.
#include "core/tree/extraction/gap_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hepatica {
namespace {

// A row of pieces along x: 0 from x = 0 to 9, 1 from 14, 2 behind it from 20.
struct Row {
    Row() {
        grid.dims = {30, 9, 9};
        search.grid = &grid;
        search.piece_of = [this](std::size_t offset) {
            const int x = grid.index_of(offset)[0];
            return x <= 9 ? 0 : x < 14 ? -1 : x < 19 ? 1 : x < 20 ? -1 : 2;
        };
        search.brightness = [this](const Vec3&) { return brightness; };
    }

    Grid grid;
    double brightness = 1.0;
    GapSearch search;
};

TEST(GapPaths, CrossesABrightGapStraightOn) {
    Row row;
    const auto paths = gap_paths(row.search, 0, {9, 4, 4});
    ASSERT_EQ(paths.size(), 1u);  // what lies behind a piece is that piece's business
    EXPECT_EQ(paths[0].piece, 1);
    EXPECT_NEAR(paths[0].gap_mm, 4.0, 1e-12);  // four voxels outside of all pieces
    EXPECT_NEAR(paths[0].cost_mm, 5.0, 1e-12);
    ASSERT_EQ(paths[0].points_mm.size(), 6u);
    EXPECT_EQ(paths[0].points_mm.front(), Vec3(9, 4, 4));
    EXPECT_EQ(paths[0].points_mm.back().x(), 14.0);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(paths[0].points_mm[i].x(), 9 + i);
    EXPECT_EQ(paths[0].brightness, std::vector<double>(6, 1.0));
}

// A millimetre costs 1/(0.1 + 0.9 b^2).
TEST(GapPaths, PaysForDarkness) {
    Row row;
    row.brightness = 0.5;
    const auto paths = gap_paths(row.search, 0, {9, 4, 4});
    ASSERT_EQ(paths.size(), 1u);
    EXPECT_NEAR(paths[0].cost_mm, 4.0 / (0.1 + 0.9 * 0.25) + 1.0, 1e-9);
    EXPECT_EQ(paths[0].brightness, (std::vector<double>{1, 0.5, 0.5, 0.5, 0.5, 1}));
    row.brightness = 0.0;  // four dark millimetres cost 40, and the step into the piece one more
    EXPECT_TRUE(gap_paths(row.search, 0, {9, 4, 4}).empty());
}

TEST(GapPaths, EndsAtTheLongestGap) {
    Row row;
    row.search.longest_gap_mm = 4.0;
    EXPECT_EQ(gap_paths(row.search, 0, {9, 4, 4}).size(), 1u);
    row.search.longest_gap_mm = 3.99;
    EXPECT_TRUE(gap_paths(row.search, 0, {9, 4, 4}).empty());
    // From 4 mm inside its own piece it still finds out, from further it does not.
    row.search.longest_gap_mm = 4.0;
    ASSERT_EQ(gap_paths(row.search, 0, {5, 4, 4}).size(), 1u);
    EXPECT_NEAR(gap_paths(row.search, 0, {5, 4, 4})[0].gap_mm, 4.0, 1e-12);
    EXPECT_TRUE(gap_paths(row.search, 0, {3, 4, 4}).empty());
}

TEST(GapPaths, MeasuresStepsByTheSpacing) {
    Row row;
    row.grid.spacing_mm = Vec3(2.0, 0.5, 0.5);
    const auto paths = gap_paths(row.search, 0, {9, 4, 4});
    ASSERT_EQ(paths.size(), 1u);
    EXPECT_NEAR(paths[0].gap_mm, 8.0, 1e-12);
    EXPECT_NEAR(paths[0].cost_mm, 10.0, 1e-12);
}

// A bright bow around a dark middle: the way is longer and cheaper.
TEST(GapPaths, TakesABrightDetourRatherThanADarkShortCut) {
    Row row;
    row.search.brightness = [](const Vec3& p) {
        const double bow = 4.0 + 2.0 * std::sin(M_PI * (p.x() - 9.0) / 5.0);
        return std::abs(p.y() - bow) < 0.8 && p.z() == 4.0 ? 1.0 : 0.1;
    };
    const auto paths = gap_paths(row.search, 0, {9, 4, 4});
    ASSERT_EQ(paths.size(), 1u);
    double highest = 0.0, length = 0.0;
    for (std::size_t i = 0; i < paths[0].points_mm.size(); ++i) {
        highest = std::max(highest, paths[0].points_mm[i].y());
        EXPECT_EQ(paths[0].brightness[i], 1.0) << i;
        if (i > 0) length += (paths[0].points_mm[i] - paths[0].points_mm[i - 1]).norm();
    }
    EXPECT_GE(highest, 6.0);
    EXPECT_NEAR(paths[0].cost_mm, length, 1e-9);
    EXPECT_LT(length, 9.0);
}

TEST(GapPaths, FindsEachPieceOnceTheNearestFirst) {
    Row row;
    row.search.piece_of = [&](std::size_t offset) {
        const auto [x, y, z] = row.grid.index_of(offset);
        if (x == 0) return 0;
        if (x >= 3 && y <= 2) return 1;
        if (x >= 5 && y >= 6) return 2;
        return -1;
    };
    const auto paths = gap_paths(row.search, 0, {0, 4, 4});
    ASSERT_EQ(paths.size(), 2u);
    EXPECT_EQ(paths[0].piece, 1);
    EXPECT_EQ(paths[1].piece, 2);
    EXPECT_LT(paths[0].cost_mm, paths[1].cost_mm);
    EXPECT_NEAR(paths[0].cost_mm, 1.0 + 2.0 * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(paths[1].cost_mm, 3.0 + 2.0 * std::sqrt(2.0), 1e-9);
}

}  // namespace
}  // namespace hepatica
