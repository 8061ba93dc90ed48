// SPDX-License-Identifier: GPL-3.0-or-later
// Caption and scale in small pictures: letters of at least 9 points of print, or none.
#include "render/annotations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "render/osmesa_context.h"
#include "render/scene_view.h"
#include "tests/render/fake_frame.h"
#include "tests/render/screenshot.h"

namespace hepatica {
namespace {

// Of DejaVu Sans, in parts of its size, less what smoothing takes.
constexpr double height_of_capitals = 0.66;

// Rows from the first to the last in which two pictures differ; only from row `top` on.
int height_of_difference(const Picture& a, const Picture& b, int top = 0) {
    int first = a.height, last = -1;
    for (int y = top; y < a.height; ++y) {
        const auto row = 3 * static_cast<std::ptrdiff_t>(y) * a.width;
        if (std::equal(a.rgb.begin() + row, a.rgb.begin() + row + 3 * a.width, b.rgb.begin() + row))
            continue;
        first = std::min(first, y);
        last = y;
    }
    return std::max(0, last - first + 1);
}

Picture picture_of(int width, int height, const std::string& caption, bool annotated = true) {
    OsmesaContext context(width, height);
    SceneView view(context.window());
    view.set_caption(caption);
    view.set_annotations_visible(annotated);
    view.show(testing::fake_frame());
    view.render();
    return read_picture(context.window());
}

TEST(Annotations, NameThePatientInLettersThatCanBeRead) {
    for (const int height : {120, 240, 325, 700}) {
        const Picture without = picture_of(447, height, "");
        EXPECT_GE(height_of_difference(picture_of(447, height, "HEP"), without),
                  height_of_capitals * annotation_letters_pt)
            << height;
        const std::string long_name(200, 'H');
        EXPECT_GE(height_of_difference(picture_of(447, height, long_name), without),
                  height_of_capitals * annotation_letters_pt)
            << "one that is too long is cut, not left out: " << height;
    }
}

// The bar and its length above it, in the middle of the foot: both or none.
TEST(Annotations, GiveTheScaleInLettersThatCanBeReadOrNone) {
    constexpr int beside_the_cube = 57;
    const auto height_of_scale = [](int width, int height) {
        const auto foot = [&](bool annotated) {
            Picture picture = picture_of(width, height, "", annotated);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    if (x < beside_the_cube || std::abs(x - width / 2) > 20)
                        for (int c = 0; c < 3; ++c)
                            picture.rgb[static_cast<std::size_t>(3 * (y * width + x) + c)] = 0;
            return picture;
        };
        return height_of_difference(foot(true), foot(false), height - 40);
    };
    constexpr double bar = 6.0 * 0.6;
    for (const int height : {120, 240, 325})
        EXPECT_GE(height_of_scale(447, height), bar + height_of_capitals * annotation_letters_pt)
            << height;
    EXPECT_EQ(height_of_scale(130, 325), 0) << "the cube takes the room";
}

// The longer words would end just where the legend begins in one of these pictures.
TEST(Annotations, LeaveAGapBetweenTheScaleAndTheLegend) {
    int beside = 0;
    for (int width = 860; width < 1000; width += 4) {
        OsmesaContext context(width, 650);
        SceneView view(context.window());
        view.show(testing::fake_frame());
        BridgeView gap;
        gap.path_mm = {Vec3(0, 0, 0), Vec3(10, 0, 0)};
        view.set_bridges({gap});  // whose row is a long one
        view.render();
        const PictureBox legend = view.legend_box();
        if (legend.bottom > 30.0 || legend.left < 0.5 * width) continue;  // it is not beside it
        ++beside;
        view.set_annotations_visible(false);
        view.render();
        const Picture without = read_picture(context.window());
        view.set_annotations_visible(true);
        view.render();
        const Picture with = read_picture(context.window());
        // Between the scale and the legend, in the rows of the scale's words.
        for (int y = 650 - 45; y < 650 - 28; ++y)
            for (int x = static_cast<int>(legend.left) - 8; x < static_cast<int>(legend.left) - 1;
                 ++x)
                for (int c = 0; c < 3; ++c) {
                    const auto at = static_cast<std::size_t>(3 * (y * width + x) + c);
                    ASSERT_EQ(with.rgb[at], without.rgb[at]) << "width " << width;
                }
    }
    EXPECT_GT(beside, 20) << "as the window shows a tree";
}

// At the nearest zoom in a tall picture.
TEST(Annotations, GiveAShortScaleWithTheDecimalsThatItNeeds) {
    OsmesaContext context(1000, 2400);
    SceneView view(context.window());
    std::vector<std::string> lengths;
    view.set_words([&](const std::string& english) {
        if (english.find(" mm") != std::string::npos) lengths.push_back(english);
        return english;
    });
    view.show(testing::fake_frame());
    view.zoom_by(1e6);
    view.render();
    ASSERT_FALSE(lengths.empty());
    EXPECT_TRUE(lengths.front().starts_with("0.02 mm")) << lengths.front();
}

}  // namespace
}  // namespace hepatica
