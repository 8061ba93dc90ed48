// SPDX-License-Identifier: GPL-3.0-or-later
// Marks cover the area that their shape has, where it is, and nothing beyond the picture.
#include "render/picture_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hepatica {
namespace {

constexpr Colour white{1.0, 1.0, 1.0};

Picture black(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width * height))};
}

// In pixels that are wholly covered.
double covered(const Picture& picture) {
    return std::accumulate(picture.rgb.begin(), picture.rgb.end(), 0.0) / (3.0 * 255.0);
}

TEST(PictureMarks, ALineHasTheAreaOfItsShape) {
    Picture picture = black(200, 160);
    const std::array<std::array<double, 2>, 2> ends{{{30.25, 40.5}, {150.75, 110.0}}};
    draw_line(picture, ends, 6.0, white);
    const double length = std::hypot(120.5, 69.5);
    EXPECT_NEAR(covered(picture), 6.0 * length + 9.0 * M_PI, 0.01 * 6.0 * length);
}

TEST(PictureMarks, ACircleIsARing) {
    Picture picture = black(200, 200);
    draw_circle(picture, {100.0, 90.0}, 50.0, 4.0, white);
    EXPECT_NEAR(covered(picture), 2.0 * M_PI * 50.0 * 4.0, 0.01 * 2.0 * M_PI * 50.0 * 4.0);
    const auto at = [&](int x, int y) { return picture.rgb[3 * (y * 200 + x)]; };
    EXPECT_EQ(at(100, 90), 0);
    EXPECT_EQ(at(149, 90), 255);
    EXPECT_EQ(at(100, 139), 255);
}

TEST(PictureMarks, TheColourIsLaidOverThePicture) {
    Picture picture = black(20, 20);
    std::ranges::fill(picture.rgb, std::uint8_t{100});
    const std::array<std::array<double, 2>, 2> ends{{{2.0, 10.0}, {18.0, 10.0}}};
    draw_line(picture, ends, 4.0, {1.0, 0.0, 0.2});
    const std::size_t middle = 3 * (10 * 20 + 10);
    EXPECT_EQ(picture.rgb[middle], 255);
    EXPECT_EQ(picture.rgb[middle + 1], 0);
    EXPECT_EQ(picture.rgb[middle + 2], 51);
    EXPECT_EQ(picture.rgb[0], 100);
}

TEST(PictureMarks, WhatLiesOutsideIsLeftOut) {
    Picture picture = black(10, 10);
    const std::array<std::array<double, 2>, 2> far{{{-500.0, 5.0}, {700.0, 5.0}}};
    draw_line(picture, far, 2.0, white);
    EXPECT_NEAR(covered(picture), 20.0, 0.5);
    draw_circle(picture, {-300.0, -300.0}, 20.0, 3.0, white);
    EXPECT_NEAR(covered(picture), 20.0, 0.5);
}

}  // namespace
}  // namespace hepatica
