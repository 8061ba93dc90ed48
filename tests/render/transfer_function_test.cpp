// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/transfer_function.h"

#include <gtest/gtest.h>

#include <array>

namespace hepatica {
namespace {

constexpr std::array looks{dark_look, light_look, high_contrast_look};
constexpr std::array both{VolumePreset::vessels_and_bones, VolumePreset::maximum_intensity};

VolumeLook look_of(VolumePreset preset, double density, const GreyWindow& window = {}) {
    return {preset, density, window};
}

double opacity_at(const std::vector<TransferPoint>& points, double hu) {
    if (hu <= points.front().hu) return points.front().opacity;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const TransferPoint &a = points[i - 1], &b = points[i];
        if (hu <= b.hu) return a.opacity + (b.opacity - a.opacity) * (hu - a.hu) / (b.hu - a.hu);
    }
    return points.back().opacity;
}

double lightness(const Colour& colour) {
    return 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];
}

TEST(TransferFunction, NeverFallsAndStaysWithinItsRange) {
    for (const VolumePreset preset : both)
        for (const double density : {-1.0, 0.0, 0.3, 0.5, 1.0, 7.0})
            for (const GreyWindow& window :
                 {GreyWindow{}, GreyWindow{400, 1800}, GreyWindow{-600, 1500}, GreyWindow{60, 1}}) {
                const auto points = transfer_function(look_of(preset, density, window), dark_look);
                ASSERT_GE(points.size(), 2U);
                for (std::size_t i = 0; i < points.size(); ++i) {
                    EXPECT_GE(points[i].opacity, 0.0);
                    EXPECT_LE(points[i].opacity, 1.0);
                    for (const double channel : points[i].colour) {
                        EXPECT_GE(channel, 0.0);
                        EXPECT_LE(channel, 1.0);
                    }
                    if (i == 0) continue;
                    EXPECT_GT(points[i].hu, points[i - 1].hu);
                    EXPECT_GE(points[i].opacity, points[i - 1].opacity);
                }
            }
}

TEST(TransferFunction, FollowsTheGreyWindow) {
    for (const VolumePreset preset : both) {
        const auto vessels = transfer_function(look_of(preset, 0.5), dark_look);
        EXPECT_EQ(opacity_at(vessels, -50.0), 0.0) << "black";
        EXPECT_EQ(opacity_at(vessels, 250.0), vessels.back().opacity) << "white";
        const auto bone = transfer_function(look_of(preset, 0.5, {400, 1800}), dark_look);
        EXPECT_EQ(opacity_at(bone, 0.0), 0.0) << "water is nearly black in a window for bone";
        EXPECT_LT(opacity_at(bone, 150.0), opacity_at(vessels, 150.0)) << "blood";
        EXPECT_LT(opacity_at(bone, 300.0), opacity_at(vessels, 300.0));
    }
}

TEST(TransferFunction, GetsDenserWithTheDensity) {
    for (const VolumePreset preset : both) {
        double last = -1.0;
        for (const double density : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const double opacity =
                opacity_at(transfer_function(look_of(preset, density), dark_look), 150.0);
            EXPECT_GT(opacity, last);
            last = opacity;
        }
    }
}

TEST(TransferFunction, HasTheColoursOfTissueWhateverTheWindow) {
    for (const GreyWindow& window : {GreyWindow{}, GreyWindow{400, 1800}, GreyWindow{500, 100}})
        for (const TransferPoint& point :
             transfer_function(look_of(VolumePreset::vessels_and_bones, 0.5, window), light_look)) {
            const auto& [red, green, blue] = point.colour;
            if (point.hu > 130.0 && point.hu < 180.0) {
                EXPECT_GT(red, 2.0 * green) << "blood at " << point.hu;
            }
            if (point.hu > 320.0) {
                EXPECT_GT(lightness(point.colour), 0.8) << "bone at " << point.hu;
                EXPECT_GT(green, blue) << "ivory at " << point.hu;
            }
        }
}

// A maximum intensity is drawn in the room's greys: dark on light in a light room.
TEST(TransferFunction, GoesFromTheRoomTowardsItsWriting) {
    for (const ViewLook& room : looks) {
        const auto points = transfer_function(look_of(VolumePreset::maximum_intensity, 0.5), room);
        EXPECT_EQ(points.front().colour, room.bottom);
        const bool rises = lightness(room.text) > lightness(room.bottom);
        for (std::size_t i = 1; i < points.size(); ++i)
            EXPECT_EQ(lightness(points[i].colour) > lightness(points[i - 1].colour), rises);
    }
}

TEST(GradientFunction, RisesToAll) {
    const auto points = gradient_function();
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_GT(points[i].hu_per_mm, points[i - 1].hu_per_mm);
        EXPECT_GT(points[i].share, points[i - 1].share);
    }
    EXPECT_GT(points.front().share, 0.0) << "an organ has an inside";
    EXPECT_EQ(points.back().share, 1.0);
}

}  // namespace
}  // namespace hepatica
