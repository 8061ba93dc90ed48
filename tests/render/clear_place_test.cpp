// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/clear_place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace hepatica {
namespace {

TEST(ClearPlace, MeasuresFromTheRectangleToTheLine) {
    const PictureBox box{10, 20, 30, 25};
    EXPECT_EQ(distance_between(box, {{0, 22}, {4, 22}, 0.0}), 6.0) << "an end is nearest";
    EXPECT_NEAR(distance_between(box, {{0, 40}, {40, 0}, 0.0}), 0.0, 1e-12) << "it crosses";
    EXPECT_EQ(distance_between(box, {{12, 21}, {13, 22}, 0.0}), 0.0) << "it lies inside";
    EXPECT_NEAR(distance_between(box, {{30, 35}, {40, 25}, 0.0}), 5.0 * std::sqrt(2.0), 1e-12)
        << "a corner is nearest";
    EXPECT_EQ(distance_between(box, {{33, 29}, {33, 29}, 0.0}), 5.0) << "a point";
}

// Against the least of the distances of many points of both.
TEST(ClearPlace, AgreesWithPointsByTheDozen) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> anywhere(0.0, 100.0);
    for (int round = 0; round < 200; ++round) {
        const double left = anywhere(random), bottom = anywhere(random);
        const PictureBox box{left, bottom, left + 0.4 * anywhere(random),
                             bottom + 0.2 * anywhere(random)};
        const ThickStretch line{{anywhere(random), anywhere(random)},
                                {anywhere(random), anywhere(random)}};
        constexpr int pieces = 2000;
        double least = 1e9;
        for (int i = 0; i <= pieces; ++i) {
            const double share = static_cast<double>(i) / pieces;
            const double x = line.from[0] + share * (line.to[0] - line.from[0]);
            const double y = line.from[1] + share * (line.to[1] - line.from[1]);
            least = std::min(least, std::hypot(x - std::clamp(x, box.left, box.right),
                                               y - std::clamp(y, box.bottom, box.top)));
        }
        EXPECT_NEAR(distance_between(box, line), least, 0.08) << "round " << round;
    }
}

TEST(ClearPlace, LeavesAMarginToEachOfThem) {
    const PictureBox box{10, 20, 30, 25};
    const std::vector<ThickStretch> both{{{0, 100}, {50, 100}, 3.0}, {{0, 22}, {4, 22}, 4.0}};
    EXPECT_TRUE(is_clear_of(box, both, 2.0));
    EXPECT_FALSE(is_clear_of(box, both, 2.5));
    EXPECT_TRUE(is_clear_of(box, {}, 1e9));
}

TEST(ClearPlace, CoversARectangleToItsCorners) {
    const PictureBox box{10, 20, 30, 25};
    for (const double x : {box.left, box.right})
        for (const double y : {box.bottom, box.top})
            EXPECT_FALSE(is_clear_of({x, y, x, y}, std::vector{covering(box)}, 1e-9));
    EXPECT_TRUE(is_clear_of({10, 27, 30, 32}, std::vector{covering(box)}, 2.0)) << "and no more";
}

}  // namespace
}  // namespace hepatica
