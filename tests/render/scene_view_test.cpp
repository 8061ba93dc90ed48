// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene_view.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>

#include <cmath>

#include "render/osmesa_context.h"
#include "render/picture.h"
#include "tests/render/fake_frame.h"
#include "tests/render/screenshot.h"

namespace hepatica {
namespace {

using testing::expect_matches_baseline;
using testing::fake_frame;

// A view of 320 x 240 pixels without any display.
class SceneViewPicture : public ::testing::Test {
  protected:
    SceneViewPicture() {
        const std::size_t vertices = fake_frame().positions_mm.size() / 3;
        view_.set_vertex_systems(std::vector(vertices, VascularSystem::portal));
    }
    Picture picture() {
        view_.render();
        return read_picture(context_.window());
    }

    OsmesaContext context_{320, 240};
    SceneView view_{context_.window()};
};

TEST_F(SceneViewPicture, of_nothing_is_an_empty_room) {
    view_.show(Frame{});
    expect_matches_baseline(picture(), "empty");
}

TEST_F(SceneViewPicture, of_a_tree_from_the_front) {
    view_.show(fake_frame());
    expect_matches_baseline(picture(), "tree_anterior");
}

TEST_F(SceneViewPicture, of_a_tree_from_the_left) {
    view_.show(fake_frame());
    view_.look_from(ViewDirection::left);
    expect_matches_baseline(picture(), "tree_left");
}

TEST_F(SceneViewPicture, of_a_running_drug_on_a_moving_vessel) {
    view_.show(fake_frame(0.0, 0.5));
    const Picture early = picture();
    view_.show(fake_frame(1.0, 2.0));
    expect_matches_baseline(picture(), "drug_on_bent_tree");
    EXPECT_NE(early.rgb, picture().rgb);
}

TEST_F(SceneViewPicture, of_a_pull) {
    Frame frame = fake_frame(0.1);
    frame.grab = GrabView{Vec3(0, -4, -15), Vec3(25, -4, -25), 1e3};
    view_.show(frame);
    expect_matches_baseline(picture(), "pull");
}

// A rod that presses the trunk, which is lit up where it is touched.
TEST_F(SceneViewPicture, of_a_tool_that_touches) {
    view_.show(testing::touched_frame());
    expect_matches_baseline(picture(), "tool");
}

TEST_F(SceneViewPicture, of_two_systems_a_highlight_and_the_liver) {
    const Frame frame = fake_frame();
    const std::size_t count = frame.positions_mm.size() / 3;
    std::vector<VascularSystem> systems(count, VascularSystem::portal);
    std::vector<std::uint8_t> highlight(count, 0);
    TriangleMesh liver = testing::sphere(Vec3(0, 0, 0), 62.0);
    for (std::size_t v = 0; v < count; ++v) {
        const float x = frame.positions_mm[3 * v];
        if (x > 8) systems[v] = VascularSystem::hepatic;
        if (x < -8) systems[v] = VascularSystem::artery;
        highlight[v] = x < -25;
    }
    view_.show(frame);
    view_.set_vertex_systems(systems);
    view_.set_highlight(highlight);
    view_.set_liver(liver);
    expect_matches_baseline(picture(), "systems_and_liver");
    view_.set_liver_visible(false);
    view_.set_highlight({});
    view_.set_annotations_visible(false);
    expect_matches_baseline(picture(), "systems_bare");
}

TEST_F(SceneViewPicture, of_vessels_and_liver_cut_open) {
    view_.show(fake_frame());
    view_.set_liver(testing::sphere(Vec3(0, 0, 0), 62.0));
    const Picture whole = picture();
    view_.set_clip(ClipPlane{Vec3(0, 0, 0), Vec3(-0.8, 0.6, 0.0)});
    expect_matches_baseline(picture(), "opened");
    view_.set_clip(std::nullopt);
    EXPECT_EQ(picture().rgb, whole.rgb);
}

// Else one could not tell a vessel that one looks into from one that one looks at.
TEST_F(SceneViewPicture, the_inside_of_a_vessel_is_darker_than_its_outside) {
    view_.set_annotations_visible(false);
    view_.show(fake_frame());
    const auto blue_in_the_trunk = [this] {
        return static_cast<int>(picture().rgb[3 * static_cast<std::size_t>(180 * 320 + 160) + 2]);
    };
    ASSERT_GE(view_.pick({160.5, 180.5}).triangle, 0);
    const int outside = blue_in_the_trunk();
    view_.set_clip(ClipPlane{Vec3(0, 0, 0), view_.axes().forward});  // through its axis
    const int inside = blue_in_the_trunk();
    view_.set_clip(ClipPlane{200.0 * view_.axes().forward, view_.axes().forward});
    const int nothing = blue_in_the_trunk();
    EXPECT_GT(inside, nothing + 20);
    EXPECT_LT(inside, 0.7 * outside);
}

// Where its surface faces the eye, too, in front of the room and of the trunk.
TEST_F(SceneViewPicture, the_liver_is_seen_and_hides_nothing) {
    view_.set_annotations_visible(false);
    view_.show(fake_frame());
    const auto red_at = [](const Picture& shown, int x, int y) {
        return static_cast<int>(shown.rgb[3 * static_cast<std::size_t>(y * 320 + x)]);
    };
    const Picture bare = picture();
    view_.set_liver(testing::sphere(Vec3(0, 0, 0), 62.0));
    const Picture within = picture();
    ASSERT_LT(view_.pick({120.5, 170.5}).triangle, 0);
    ASSERT_GE(view_.pick({160.5, 180.5}).triangle, 0);
    EXPECT_GE(red_at(within, 120, 170), red_at(bare, 120, 170) + 9);
    EXPECT_NEAR(red_at(within, 160, 180), red_at(bare, 160, 180), 20);
}

// A tumour as solid as it is, and the liver's wall, which hides nothing.
TEST_F(SceneViewPicture, of_obstacles) {
    view_.show(testing::frame_beside_obstacles());
    expect_matches_baseline(picture(), "obstacles");
}

TEST_F(SceneViewPicture, keeps_up_with_a_change_of_topology) {
    Frame frame = fake_frame();
    view_.show(frame);
    const Picture whole = picture();
    auto fewer = *frame.surface;
    fewer.resize(fewer.size() / 2);
    frame.surface = std::make_shared<const std::vector<std::array<int, 3>>>(fewer);
    ++frame.topology_version;
    view_.show(frame);
    EXPECT_NE(picture().rgb, whole.rgb);
    view_.show(fake_frame());
    EXPECT_EQ(picture().rgb, whole.rgb);
}

TEST_F(SceneViewPicture, names_its_renderer_as_software) {
    view_.render();
    EXPECT_TRUE(is_software_renderer(renderer_name(context_.window())));
    EXPECT_FALSE(is_software_renderer("NVIDIA H200/PCIe/SSE2"));
}

TEST_F(SceneViewPicture, pixel_and_point_are_inverse_to_each_other) {
    view_.show(fake_frame());
    view_.drag_orbit({10, 10}, {90, 40});
    view_.zoom_by(1.7);
    const Vec3 point(12.0, -7.0, 21.0);
    const Pixel pixel = view_.pixel_of(point);
    EXPECT_NEAR((view_.point_at_depth(pixel, point) - point).norm(), 0.0, 1e-9);
    const ViewRay ray = view_.ray_through(pixel);
    const Vec3 offset = point - ray.origin_mm;
    EXPECT_NEAR((offset - offset.dot(ray.direction) * ray.direction).norm(), 0.0, 1e-9);
}

TEST_F(SceneViewPicture, picks_the_point_it_draws) {
    view_.set_annotations_visible(false);
    view_.show(fake_frame());
    const Picture with_tree = picture();
    int hits = 0;
    for (int y = 8; y < 200; y += 7) {
        for (int x = 60; x < 260; x += 7) {
            const SurfacePick pick = view_.pick({x + 0.5, y + 0.5});
            const auto* rgb = &with_tree.rgb[3 * static_cast<std::size_t>(y * 320 + x)];
            // Vessels are far more blue than the room; edges may be half one, half the other.
            const bool drawn = rgb[2] > 90;
            if (drawn) {
                EXPECT_GE(pick.triangle, 0) << x << " " << y;
            }
            if (pick.triangle < 0) continue;
            ++hits;
            const Pixel back = view_.pixel_of(pick.position_mm);
            EXPECT_NEAR(back.x, x + 0.5, 1e-6);
            EXPECT_NEAR(back.y, y + 0.5, 1e-6);
        }
    }
    EXPECT_GT(hits, 20);
    EXPECT_LT(view_.pick({2, 2}).triangle, 0);
}

TEST_F(SceneViewPicture, pans_with_the_mouse_and_zooms_about_the_focus) {
    view_.show(fake_frame());
    const Vec3 focus(view_.camera().GetFocalPoint());
    view_.drag_pan({100, 100}, {130, 85});
    const Pixel moved = view_.pixel_of(focus);
    EXPECT_NEAR(moved.x, 160 + 30, 1e-6);
    EXPECT_NEAR(moved.y, 120 - 15, 1e-6);
    const double before = view_.camera().GetDistance();
    view_.zoom_by(2.0);
    EXPECT_NEAR(view_.camera().GetDistance(), 0.5 * before, 1e-9);
    for (int i = 0; i < 100; ++i) view_.zoom_by(2.0);
    EXPECT_GT(view_.camera().GetDistance(), 1.0);
}

// Its lines' colour is found where the point appears, and nowhere once it is taken away.
TEST_F(SceneViewPicture, of_the_place_where_slices_cross) {
    view_.show(fake_frame());
    view_.set_annotations_visible(false);
    const Vec3 place(30, -40, 20);
    const auto yellow_at = [&](const Picture& shown) {
        std::vector<Pixel> found;
        for (int y = 0; y < shown.height; ++y)
            for (int x = 0; x < shown.width; ++x) {
                const auto* rgb = &shown.rgb[3 * static_cast<std::size_t>(y * shown.width + x)];
                if (rgb[0] > 150 && rgb[0] > rgb[2] + 60) found.push_back({x + 0.5, y + 0.5});
            }
        return found;
    };
    EXPECT_TRUE(yellow_at(picture()).empty());
    EXPECT_TRUE(view_.set_crosshair(place));
    EXPECT_FALSE(view_.set_crosshair(place)) << "nothing is to be drawn again";
    const std::vector<Pixel> lines = yellow_at(picture());
    ASSERT_GT(lines.size(), 30u);
    const Pixel expected = view_.pixel_of(place);
    double x = 0.0, y = 0.0;
    for (const Pixel& pixel : lines) {
        x += pixel.x / static_cast<double>(lines.size());
        y += pixel.y / static_cast<double>(lines.size());
    }
    EXPECT_NEAR(x, expected.x, 2.0);
    EXPECT_NEAR(y, expected.y, 2.0);
    EXPECT_TRUE(view_.set_crosshair(std::nullopt));
    EXPECT_TRUE(yellow_at(picture()).empty());
}

// The window's view is halved when slices come beside it.
TEST_F(SceneViewPicture, keeps_the_tree_in_sight_when_it_gets_narrow_and_comes_back) {
    const Frame frame = fake_frame();
    view_.show(frame);
    view_.render();
    const auto all_in_sight = [&](int width, int height) {
        for (std::size_t i = 0; i < frame.positions_mm.size(); i += 3) {
            const Pixel at = view_.pixel_of(
                Vec3(frame.positions_mm[i], frame.positions_mm[i + 1], frame.positions_mm[i + 2]));
            if (at.x < 0 || at.x > width || at.y < 0 || at.y > height) return false;
        }
        return true;
    };
    ASSERT_TRUE(all_in_sight(320, 240));
    const double before = view_.camera().GetDistance();
    context_.window().SetSize(90, 240);
    view_.render();
    EXPECT_TRUE(all_in_sight(90, 240));
    context_.window().SetSize(320, 240);
    view_.render();
    EXPECT_NEAR(view_.camera().GetDistance(), before, 1e-9 * before);
}

TEST_F(SceneViewPicture, is_fitted_once_to_a_size_that_is_new) {
    view_.show(fake_frame());
    view_.render();
    context_.window().SetSize(90, 240);
    view_.show_whole();
    const double chosen = view_.camera().GetDistance();
    view_.render();
    EXPECT_EQ(view_.camera().GetDistance(), chosen);
}

// Two plays side by side stand still when the second brings its scale.
TEST_F(SceneViewPicture, is_drawn_anew_where_the_drugs_scale_alone_is_another) {
    const Frame frame = fake_frame(0.0, 0.5);
    EXPECT_TRUE(view_.show(frame));
    EXPECT_FALSE(view_.show(frame));
    view_.set_drug_scale(25.0);
    EXPECT_TRUE(view_.show(frame));
    EXPECT_FALSE(view_.show(frame));
}

TEST_F(SceneViewPicture, picks_no_gap_behind_the_eye) {
    view_.show(fake_frame());
    const ViewAxes axes = view_.axes();
    const Vec3 eye = view_.ray_through({160, 120}).origin_mm;
    const auto picked = [&](double away_mm) {
        const Vec3 middle = eye + away_mm * axes.forward;
        const Vec3 half = 5.0 * axes.right;
        view_.set_bridges({{{Vec3(middle - half), Vec3(middle + half)}, "50 %", false}});
        return view_.bridge_at({160, 120}, 4.0);
    };
    EXPECT_EQ(picked(40.0), 0);
    EXPECT_EQ(picked(-40.0), -1);
}

// Letters in the colours of tools would hardly be seen there.
TEST_F(SceneViewPicture, has_figures_on_dark_where_it_is_bright) {
    view_.set_annotations_visible(false);
    Frame frame = fake_frame();
    frame.tool.emplace();
    frame.tool->parts = {{Vec3(30, 0, -40), Vec3(30, 0, -40), 1.0}};
    frame.tool->tip_mm = Vec3(30, 0, -40);
    const auto dark_pixels = [&](bool says_how_far) {
        frame.tool->touched = says_how_far ? std::vector<int>{} : std::vector{0};
        view_.show(frame);
        const Picture shown = picture();
        int dark = 0;
        for (std::size_t i = 0; i < shown.rgb.size(); i += 3)
            dark += shown.rgb[i] < 90 && shown.rgb[i + 1] < 90 && shown.rgb[i + 2] < 90;
        return dark;
    };
    view_.set_look(light_look);
    EXPECT_GT(dark_pixels(true), dark_pixels(false) + 150);
}

}  // namespace
}  // namespace hepatica
