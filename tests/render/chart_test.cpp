// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "render/offscreen_picture.h"
#include "tests/render/fake_frame.h"
#include "tests/render/screenshot.h"

namespace hepatica {
namespace {

Chart two_laws() {
    Chart chart{
        "Loss of pressure along one vessel", "Reynolds number", "Pressure (Pa)", {}, true, true};
    for (const double exponent : {1.0, 1.75}) {
        Curve curve;
        curve.name = exponent == 1.0 ? "laminar" : "turbulent";
        for (double re = 1.0; re <= 1e5; re *= 1.5) {
            curve.x.push_back(re);
            curve.y.push_back(0.01 * std::pow(re, exponent));
        }
        chart.curves.push_back(curve);
    }
    return chart;
}

TEST(Chart, looks_as_it_did_on_plain_axes) {
    const Chart chart{"Delivered fraction",
                      "Time (s)",
                      "Share of the drug (%)",
                      {{"left lobe", {0, 1, 2, 3}, {0, 4, 22, 31}},
                       {"right lobe", {0, 1, 2, 3}, {0, 10, 41, 69}},
                       {"measured", {0.5, 1.5, 2.5}, {3, 20, 60}, true}}};
    testing::expect_matches_baseline(draw_chart(chart, 480, 320).picture, "chart_plain");
}

TEST(Chart, looks_as_it_did_on_logarithmic_axes) {
    const OffscreenPicture drawn = draw_chart(two_laws(), 480, 320);
    testing::expect_matches_baseline(drawn.picture, "chart_logarithmic");
}

TEST(Chart, leaves_out_what_cannot_be_drawn) {
    Chart chart = two_laws();
    const Picture clean = draw_chart(chart, 480, 320).picture;
    chart.curves[0].x.push_back(10.0);
    chart.curves[0].y.push_back(std::numeric_limits<double>::quiet_NaN());
    chart.curves[0].x.push_back(-1.0);
    chart.curves[0].y.push_back(3.0);
    EXPECT_EQ(draw_chart(chart, 480, 320).picture.rgb, clean.rgb);
    EXPECT_NO_THROW(draw_chart(Chart{}, 64, 64));
}

TEST(Chart, writes_csv_that_reads_back_to_the_last_bit) {
    Chart chart{"t", "x", "y", {{"a \"b\"", {0.1}, {1.0 / 3.0}}}};
    const std::string csv = to_csv(chart);
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "curve,\"x\",\"y\"");
    EXPECT_NE(csv.find("\"a \"\"b\"\"\","), std::string::npos);
    EXPECT_EQ(std::stod(csv.substr(csv.rfind(',') + 1)), 1.0 / 3.0);
}

// Bent and straight the tree fills another box; what stands still must not move in the picture.
TEST(OffscreenPicture, keeps_its_camera_over_a_moving_tree) {
    PictureOptions options;
    options.width = 240;
    options.height = 180;
    options.annotations = false;
    const auto foot_of = [](const Picture& picture) {
        const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
        const auto lowest = std::ranges::max(picture.rgb) / 2;
        std::vector<std::size_t> bright;  // of the lowest row that shows the tree
        for (std::size_t y = static_cast<std::size_t>(picture.height); y-- > 0 && bright.empty();)
            for (std::size_t x = 0; x < row; ++x)
                if (picture.rgb[y * row + x] > lowest) bright.push_back(y * row + x);
        return bright;
    };
    const Frame straight = testing::fake_frame(0.0), bent = testing::fake_frame(1.0);
    options.vertex_systems.assign(straight.positions_mm.size() / 3, VascularSystem::portal);
    EXPECT_NE(foot_of(draw_frame(straight, options).picture),
              foot_of(draw_frame(bent, options).picture));
    options.fitted_box_mm = {Vec3(-100, -100, -20), Vec3(100, 100, 150)};
    const Picture one = draw_frame(straight, options).picture;
    EXPECT_FALSE(foot_of(one).empty());
    EXPECT_EQ(foot_of(one), foot_of(draw_frame(bent, options).picture));
}

TEST(OffscreenPicture, is_drawn_as_asked) {
    PictureOptions options;
    options.width = 240;
    options.height = 180;
    const Frame frame = testing::fake_frame(0.2, 1.0);
    const OffscreenPicture front = draw_frame(frame, options);
    EXPECT_EQ(front.picture.width, 240);
    EXPECT_EQ(front.picture.height, 180);
    EXPECT_FALSE(front.renderer.empty());
    EXPECT_EQ(draw_frame(frame, options).picture.rgb, front.picture.rgb);
    options.view = ViewDirection::superior;
    EXPECT_NE(draw_frame(frame, options).picture.rgb, front.picture.rgb);
    options.width = 0;
    EXPECT_THROW(draw_frame(frame, options), UsageError);
}

}  // namespace
}  // namespace hepatica
