// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of the liver's segments are told apart, and from those of systems and tumours, by
// normal and by colour-blind eyes.
#include "render/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {
namespace {

Vec3 linear(const Colour& colour) {
    Vec3 light;
    for (int c = 0; c < 3; ++c)
        light[c] = colour[static_cast<std::size_t>(c)] <= 0.04045
                       ? colour[static_cast<std::size_t>(c)] / 12.92
                       : std::pow((colour[static_cast<std::size_t>(c)] + 0.055) / 1.055, 2.4);
    return light;
}

// Ottosson 2020: distances in it are alike to the eye; 0.02 is just noticed side by side.
Vec3 oklab(const Vec3& light) {
    Mat3 cones, opponents;
    cones << 0.4122214708, 0.5363325363, 0.0514459929, 0.2119034982, 0.6806995451, 0.1073969566,
        0.0883024619, 0.2817188376, 0.6299787005;
    opponents << 0.2104542553, 0.7936177850, -0.0040720468, 1.9779984951, -2.4285922050,
        0.4505937099, 0.0259040371, 0.7827717662, -0.8086757660;
    return opponents * (cones * light).unaryExpr([](double cone) { return std::cbrt(cone); });
}

// What eyes that lack one kind of cones see (Machado et al. 2009, severity 1).
struct Sight {
    const char* name;
    Mat3 seen;
    double least_distance;
};

std::vector<Sight> sights() {
    Mat3 protan, deutan, tritan;
    protan << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
        1.051998;
    deutan << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
        0.968881;
    tritan << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
        0.303900;
    return {{"normal", Mat3::Identity(), 0.14},
            {"without red cones", protan, 0.10},
            {"without green cones", deutan, 0.10},
            {"without blue cones, which is rare", tritan, 0.05}};
}

double distance(const Colour& a, const Colour& b, const Sight& sight) {
    const auto seen = [&sight](const Colour& colour) {
        return oklab((sight.seen * linear(colour)).cwiseMax(0.0).cwiseMin(1.0));
    };
    return (seen(a) - seen(b)).norm();
}

// For eyes that need more contrast; none is dim, and no two are alike.
TEST(Palette, OfBrightSystemsHasContrastToBlackAndTellsThemApart) {
    for (const VascularSystem system : vascular_systems) {
        const Colour bright = palette::vessel_system(system, true);
        const double luminance = Vec3(0.2126, 0.7152, 0.0722).dot(linear(bright));  // WCAG 2.1
        EXPECT_GE((luminance + 0.05) / 0.05, 7.0) << title_of(system);
        for (const VascularSystem other : vascular_systems) {
            if (system == other) continue;
            for (const Sight& sight : sights())
                EXPECT_GE(distance(bright, palette::vessel_system(other, true), sight), 0.06)
                    << title_of(system) << ", " << title_of(other) << ", " << sight.name;
        }
    }
}

// The usual colours are quieter, and told apart by all eyes as well; the two systems of veins,
// which every patient has, more clearly.
TEST(Palette, OfSystemsTellsThemApart) {
    const auto least_of = [](VascularSystem one, VascularSystem other) {
        const auto vein = [](VascularSystem system) {
            return system == VascularSystem::portal || system == VascularSystem::hepatic;
        };
        return vein(one) && vein(other) ? 0.09 : 0.065;
    };
    for (const VascularSystem one : vascular_systems)
        for (const VascularSystem other : vascular_systems) {
            if (one == other) continue;
            for (const Sight& sight : sights())
                EXPECT_GE(
                    distance(palette::vessel_system(one), palette::vessel_system(other), sight),
                    least_of(one, other))
                    << title_of(one) << ", " << title_of(other) << ", " << sight.name;
        }
}

// What else is shown while a drug is to be brought to its target.
std::vector<Colour> colours_beside_a_target(bool bright) {
    std::vector<Colour> colours{{1.0, 1.0, 1.0},  // the drug's front
                                palette::touch,  palette::torn_circle, palette::reached,
                                palette::tumour, palette::torn,        palette::bleeding,
                                palette::bridge, palette::weak_line()};
    for (const VascularSystem system : vascular_systems)
        colours.push_back(palette::vessel_system(system, bright));
    for (int i = 0; i <= 20; ++i) colours.push_back(palette::drug(i / 20.0));
    for (const double load : {0.7, 0.8, 0.9, 1.0})
        colours.push_back(palette::warning(palette::vessel_system(VascularSystem::portal), load));
    return colours;
}

TEST(Palette, TellsTargetHighlightAndWhatWasReachedBeforeFromEachOtherAndFromAllElse) {
    for (const bool bright : {false, true})
        for (const Sight& sight : sights()) {
            SCOPED_TRACE(std::string(sight.name) + (bright ? ", bright" : ""));
            const std::vector<Colour> own{palette::drug_target(bright), palette::highlight(bright),
                                          palette::reached_before(bright),
                                          palette::lit_drug_target(bright)};
            for (std::size_t i = 0; i < own.size(); ++i) {
                // The last, where both lie over each other, is near one of them while it is shown.
                const double least = (i < 3 ? 0.7 : 0.5) * sight.least_distance;
                for (const Colour& other : colours_beside_a_target(bright))
                    EXPECT_GE(distance(own[i], other, sight), least) << i;
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_GE(distance(own[i], own[j], sight), least) << i << ", " << j;
            }
        }
}

// Lightness alone orders the stretches, for all eyes, and warnings and what is touched stand out
// from all of them; at rest they have contrast to a black background.
TEST(Palette, OfTheStretchGrowsLighterAndLeavesWarningsApart) {
    constexpr int steps = 20;
    const auto factor = [](int i) {
        return std::pow(palette::largest_stretch, static_cast<double>(i) / steps);
    };
    for (const bool bright : {false, true})
        for (const Sight& sight : sights()) {
            SCOPED_TRACE(std::string(sight.name) + (bright ? ", bright" : ""));
            const auto lightness = [&](int i) {
                const Vec3 light = linear(palette::stretch(factor(i), bright));
                return oklab((sight.seen * light).cwiseMax(0.0).cwiseMin(1.0)).x();
            };
            for (int i = 0; i < steps; ++i)
                EXPECT_GT(lightness(i + 1), lightness(i) + (bright ? 0.003 : 0.005)) << i;
            for (int i = 0; i <= steps; ++i) {
                const Colour stretched = palette::stretch(factor(i), bright);
                std::vector<Colour> others{palette::warning(stretched, 0.7),
                                           palette::warning(stretched, 1.0), palette::torn};
                if (!bright) others.push_back(palette::touch);
                for (const Colour& other : others)
                    EXPECT_GE(distance(stretched, other, sight), 0.5 * sight.least_distance) << i;
            }
        }
    EXPECT_GE(palette::contrast(palette::stretch(1.0), palette::background_top), 3.0);
    EXPECT_GE(palette::contrast(palette::stretch(1.0, true), {0, 0, 0}), 7.0);
    EXPECT_EQ(palette::stretch(0.5), palette::stretch(1.0));
    EXPECT_EQ(palette::stretch(3.0), palette::stretch(palette::largest_stretch));
}

// Both are there after a cut, side by side in the view and in its legend.
TEST(Palette, TellsTornRimsFromBloodFromVesselsAndFromTheBackground) {
    std::vector<Colour> others{palette::bleeding, palette::background_top,
                               palette::background_bottom};
    for (const VascularSystem system : vascular_systems)
        for (const bool bright : {false, true})
            others.push_back(palette::vessel_system(system, bright));
    for (const Sight& sight : sights())
        for (const Colour& other : others)
            EXPECT_GE(distance(palette::torn, other, sight), 0.9 * sight.least_distance)
                << sight.name;
    // What lies within that rim.
    others = {palette::torn, palette::bleeding, palette::tool, palette::touch};
    for (const VascularSystem system : vascular_systems)
        others.push_back(palette::vessel_system(system));
    for (const Sight& sight : sights())
        for (const Colour& other : others)
            EXPECT_GE(distance(palette::torn_inside, other, sight), 0.7 * sight.least_distance)
                << sight.name;
}

TEST(Palette, TellsSegmentsFromEachOtherFromSystemsAndFromTumours) {
    std::vector<Colour> others{palette::tumour};
    for (const VascularSystem system : vascular_systems)
        others.push_back(palette::vessel_system(system));
    for (const Sight& sight : sights())
        for (int segment = 1; segment <= 8; ++segment) {
            SCOPED_TRACE(std::string(sight.name) + ", segment " + std::to_string(segment));
            const Colour colour = palette::liver_segment(segment);
            for (const Colour& other : others)
                EXPECT_GE(distance(colour, other, sight), sight.least_distance);
            for (int before = 1; before < segment; ++before)
                EXPECT_GE(distance(colour, palette::liver_segment(before), sight),
                          sight.least_distance)
                    << before;
        }
}

// A tint over the grey of a CT must be one.
TEST(Palette, HasNoGreySegment) {
    for (int segment = 1; segment <= 8; ++segment) {
        const Vec3 seen = oklab(linear(palette::liver_segment(segment)));
        EXPECT_GT(std::hypot(seen.y(), seen.z()), 0.05) << segment;
    }
}

}  // namespace
}  // namespace hepatica
