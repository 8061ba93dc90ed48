// SPDX-License-Identifier: GPL-3.0-or-later
// The rim that sets off the nearer of two vessels: around it, on what lies behind, and nowhere
// else.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "render/osmesa_context.h"
#include "render/picture.h"
#include "render/scene_view.h"
#include "tests/render/fake_frame.h"

namespace hepatica {
namespace {

constexpr int picture_px = 400;
constexpr double near_mm = 10.0, far_mm = 40.0;  // radii

// A small ball in front of a large one.
Frame two_balls() {
    Frame frame;
    std::vector<std::array<int, 3>> triangles;
    for (const TriangleMesh& ball :
         {testing::sphere(Vec3(0, -60, 0), near_mm), testing::sphere(Vec3(0, 0, 0), far_mm)}) {
        const int first = static_cast<int>(frame.positions_mm.size() / 3);
        for (const Vec3& vertex : ball.vertices_mm)
            for (const double x : vertex) frame.positions_mm.push_back(static_cast<float>(x));
        for (const auto& [a, b, c] : ball.triangles)
            triangles.push_back({first + a, first + b, first + c});
    }
    frame.surface = std::make_shared<const std::vector<std::array<int, 3>>>(triangles);
    frame.topology_version = 1;
    return frame;
}

class Halo : public ::testing::Test {
  protected:
    Halo() {
        view_.set_annotations_visible(false);
        view_.show(Frame{});
        view_.render();
        room_ = read_picture(context_.window());
        view_.show(two_balls());
    }
    Picture picture(bool halos) {
        view_.set_halos_visible(halos);
        view_.render();
        return read_picture(context_.window());
    }
    // How many pixels of the rim's middle, all around the small ball, have the room's colour.
    int rim_of(const Picture& picture) const {
        const Pixel centre = view_.pixel_of(Vec3(0, -60, 0));
        const Pixel edge = view_.pixel_of(Vec3(near_mm, -60, 0));
        const double radius = std::hypot(edge.x - centre.x, edge.y - centre.y) + 1.5;
        int count = 0;
        for (int degree = 0; degree < 360; ++degree) {
            const double turn = degree * 3.14159265358979 / 180.0;
            const int x = static_cast<int>(centre.x + radius * std::cos(turn));
            const int y = static_cast<int>(centre.y + radius * std::sin(turn));
            const std::size_t at = 3 * static_cast<std::size_t>(y * picture_px + x);
            bool same = true;
            for (std::size_t c = 0; c < 3; ++c)
                same &= std::abs(picture.rgb[at + c] - room_.rgb[at + c]) <= 6;
            count += same;
        }
        return count;
    }

    OsmesaContext context_{picture_px, picture_px};
    SceneView view_{context_.window()};
    Picture room_;
};

TEST_F(Halo, SetsOffWhatIsNearerAndChangesNothingBesideTheVessels) {
    const Picture without = picture(false);
    EXPECT_EQ(rim_of(without), 0);
    const Picture with = picture(true);
    EXPECT_GT(rim_of(with), 270);
    // Beyond the large ball there is the room, whose colour the rim has.
    const Pixel centre = view_.pixel_of(Vec3(0, 0, 0));
    const Pixel edge = view_.pixel_of(Vec3(far_mm, 0, 0));
    const double radius = std::hypot(edge.x - centre.x, edge.y - centre.y);
    int changed_outside = 0;
    for (int y = 0; y < picture_px; ++y)
        for (int x = 0; x < picture_px; ++x) {
            if (std::hypot(x - centre.x, y - centre.y) < 1.1 * radius) continue;
            const std::size_t at = 3 * static_cast<std::size_t>(y * picture_px + x);
            for (std::size_t c = 0; c < 3; ++c)
                changed_outside += std::abs(with.rgb[at + c] - without.rgb[at + c]) > 1;
        }
    EXPECT_EQ(changed_outside, 0);
}

TEST_F(Halo, HasTheLooksColours) {
    view_.set_look(light_look);
    view_.show(Frame{});
    view_.render();
    room_ = read_picture(context_.window());
    view_.show(two_balls());
    EXPECT_GT(rim_of(picture(true)), 270);
}

TEST_F(Halo, IsLeftOutOfPicturesThatMustBeQuick) {
    EXPECT_GT(rim_of(picture(true)), 270);
    view_.set_smoothing(Smoothing::none);
    EXPECT_EQ(rim_of(picture(true)), 0);
    view_.set_smoothing(Smoothing::cheap);
    EXPECT_GT(rim_of(picture(true)), 200);
}

// What the plane takes away has no rim either.
TEST_F(Halo, IsCutOpenWithTheVessels) {
    view_.set_clip(ClipPlane{Vec3(0, -45, 0), Vec3(0, 1, 0)});  // between the two
    const Picture with = picture(true), without = picture(false);
    int changed = 0;
    for (std::size_t i = 0; i < with.rgb.size(); ++i)
        changed += std::abs(with.rgb[i] - without.rgb[i]) > 1;
    EXPECT_EQ(changed, 0);
}

}  // namespace
}  // namespace hepatica
