// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of a tool: the mark of what it holds, and its figure, which covers no part of it.
#include "render/tool_actor.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <cmath>
#include <vector>

#include "render/osmesa_context.h"
#include "tests/render/fake_frame.h"
#include "tests/render/scene_pictures.h"

namespace hepatica {
namespace {

class ToolInThePicture : public ::testing::Test {
  protected:
    ToolInThePicture() {
        context_.window().AddRenderer(renderer_);
        vtkCamera& eye = *renderer_->GetActiveCamera();
        eye.SetPosition(0, 0, 100);
        eye.SetFocalPoint(0, 0, 0);
    }
    ~ToolInThePicture() override { context_.window().RemoveRenderer(renderer_); }

    // Jaws along x that hold something midway between them and pull it back, to the left.
    static ToolView forceps() {
        ToolView tool;
        tool.parts = {{Vec3(15, 3, 0), Vec3(-5, 3, 0), 1.5},
                      {Vec3(15, -3, 0), Vec3(-5, -3, 0), 1.5}};
        tool.tip_mm = Vec3(-5, 0, 0);
        tool.at_mm = Vec3(-3, 0, 0);
        tool.touched = {4, 5};
        tool.grip_un = 300e3;
        return tool;
    }
    PictureBox label(const ToolView& tool) {
        const PictureBox box = placed(tool);
        context_.window().Render();
        return box;
    }
    PictureBox placed(const ToolView& tool) {
        actor_.update(tool);
        actor_.set_scale(0.2, 1.0);
        const auto box = actor_.label_box();
        EXPECT_TRUE(box);
        return box.value_or(PictureBox{});
    }

    OsmesaContext context_{400, 300};
    vtkNew<vtkRenderer> renderer_;
    ToolActor actor_{*renderer_};
};

TEST_F(ToolInThePicture, HasItsFigureBesideIt) {
    for (const Vec3& force : {Vec3(0, 0, 0), Vec3(-40e3, 0, 0), Vec3(40e3, 0, 0), Vec3(0, 40e3, 0),
                              Vec3(0, -40e3, 0), Vec3(30e3, 30e3, 0), Vec3(0, 0, 40e3)}) {
        ToolView tool = forceps();
        tool.force_un = force;
        const PictureBox box = label(tool);
        const std::vector<ThickStretch> outlines = actor_.outlines();
        ASSERT_EQ(outlines.size(), force.isZero() ? 2u : 3u) << "both jaws and the arrow";
        EXPECT_TRUE(is_clear_of(box, outlines, 1.0)) << force.transpose();
        EXPECT_GT(box.right - box.left, 40.0) << "it says something";
    }
}

// The eye is 100 mm away, and half the height of the picture then shows 100 tan 15°.
TEST_F(ToolInThePicture, IsOutlinedWhereItIsDrawn) {
    label(forceps());
    const std::vector<ThickStretch> outlines = actor_.outlines();
    ASSERT_EQ(outlines.size(), 2u);
    const double per_mm = 150.0 / (100.0 * std::tan(M_PI / 12.0));
    EXPECT_NEAR(outlines[0].from[0], 200.0 + 15.0 * per_mm, 1e-6);
    EXPECT_NEAR(outlines[0].from[1], 150.0 + 3.0 * per_mm, 1e-6);
    EXPECT_NEAR(outlines[1].to[0], 200.0 - 5.0 * per_mm, 1e-6);
    EXPECT_NEAR(outlines[1].to[1], 150.0 - 3.0 * per_mm, 1e-6);
    EXPECT_NEAR(outlines[0].radius, 1.5 * per_mm, 1e-6);
    actor_.update(std::nullopt);
    EXPECT_TRUE(actor_.outlines().empty());
}

// It stays where it is though another place would be the first choice, be it on another side or
// nearer, as long as no more of its own is taken.
TEST_F(ToolInThePicture, KeepsItsFigureWhereItIsAsLongAsThatIsFree) {
    const auto pulled = [](double degrees) {
        ToolView tool = forceps();
        const double angle = degrees * M_PI / 180.0;
        tool.force_un = 40e3 * Vec3(std::cos(angle), std::sin(angle), 0);
        return tool;
    };
    const auto chosen = [&](const ToolView& tool) {
        actor_.update(std::nullopt);  // what comes after it was put away is placed anew
        return placed(tool);
    };
    const auto jumps = [](const PictureBox& a, const PictureBox& b) {
        return std::hypot(b.left - a.left, b.bottom - a.bottom) > 14.0;
    };
    label(forceps());  // the picture has a size from now on
    int choices_that_jump = 0;
    for (int degrees = 0; degrees < 360; ++degrees) {
        const ToolView one = pulled(degrees - 0.25), other = pulled(degrees + 0.25);
        if (!jumps(chosen(one), chosen(other))) continue;
        ++choices_that_jump;
        chosen(one);
        const PictureBox second = placed(other);
        EXPECT_FALSE(jumps(second, placed(one))) << degrees << ": to and fro";
    }
    EXPECT_GT(choices_that_jump, 0) << "the test's own premise";
}

class ToolInTheScene : public testing::ScenePictures {
  protected:
    // Whether the picture is turquoise at this place, be it through a faint jaw.
    bool is_marked(const Frame& frame, const Vec3& place_mm) {
        const Picture drawn = picture_of(frame);
        const Pixel at = view_.pixel_of(place_mm);
        const auto first =
            3 * (static_cast<std::size_t>(at.y) * width + static_cast<std::size_t>(at.x));
        const int red = drawn.rgb[first], green = drawn.rgb[first + 1], blue = drawn.rgb[first + 2];
        return green > red + 50 && green > blue;
    }
    // The vertices of the trunk below and above this place of its axis: what is touched has the
    // colour of the mark, and the place itself is to be seen.
    static std::vector<int> touched_around(const Frame& frame, const Vec3& place_mm) {
        std::vector<int> touched;
        for (std::size_t v = 0; 3 * v + 2 < frame.positions_mm.size(); ++v) {
            const float* at = &frame.positions_mm[3 * v];
            const double away_mm = (Vec3(at[0], at[1], at[2]) - place_mm).norm();
            if (away_mm > 8.0 && away_mm < 14.0) touched.push_back(static_cast<int>(v));
        }
        return touched;
    }
};

// Its metal is bright, and would be lost on a bright ground.
TEST_F(ToolInTheScene, it_stands_out_from_the_ground_in_each_look) {
    Frame frame = testing::fake_frame(0.0);
    frame.tool.emplace();
    const Vec3 from(-24, 0, -55), to(-24, 0, -35);
    frame.tool->parts = {{from, to, 3.0}};
    frame.tool->tip_mm = to;
    for (const ViewLook& look : {dark_look, light_look, high_contrast_look}) {
        view_.set_look(look);
        const Picture drawn = picture_of(frame);
        const Pixel at = view_.pixel_of(0.5 * (from + to));
        const auto first =
            3 * (static_cast<std::size_t>(at.y) * width + static_cast<std::size_t>(at.x));
        const Colour seen{drawn.rgb[first] / 255.0, drawn.rgb[first + 1] / 255.0,
                          drawn.rgb[first + 2] / 255.0};
        for (const Colour& ground : {look.top, look.bottom})
            EXPECT_GE(palette::contrast(seen, ground), 3.0) << look.text[0];
    }
}

// As it leaves a vessel, its force has not faded yet, and its distance is shown already.
TEST_F(ToolInTheScene, its_force_and_its_distance_do_not_lie_on_each_other) {
    Frame frame = testing::fake_frame(0.0);
    for (const Vec3& shaft : {Vec3(20, 0, 0), Vec3(-20, 0, 0), Vec3(0, 0, 20), Vec3(0, 0, -20)})
        for (const double away_mm : {-24.0, -16.0, 12.0, 16.0, 24.0}) {
            const Vec3 tip(away_mm, 0, -40);
            frame.tool.emplace();
            frame.tool->parts = {{tip + shaft, tip, 2.0}};
            frame.tool->tip_mm = frame.tool->at_mm = tip;
            frame.tool->felt_un = 7100.0;
            picture_of(frame);
            const std::vector<PictureBox> labels = view_.tool_labels();
            ASSERT_EQ(labels.size(), 2u) << away_mm;
            EXPECT_FALSE(overlap(labels[0], labels[1])) << shaft.transpose() << ", " << away_mm;
        }
}

// The jaws lie before and behind the trunk, so that what they touch is hidden.
TEST_F(ToolInTheScene, what_jaws_hold_is_marked_through_them_and_the_vessel) {
    Frame frame = testing::fake_frame(0.0);
    const Vec3 held(0, 0, -40);
    frame.tool.emplace();
    frame.tool->parts = {{Vec3(30, -12, -40), Vec3(-8, -12, -40), 5.0},
                         {Vec3(30, 12, -40), Vec3(-8, 12, -40), 5.0}};
    frame.tool->tip_mm = Vec3(-8, 0, -40);
    frame.tool->at_mm = held;
    frame.tool->touched = touched_around(frame, held);
    EXPECT_FALSE(is_marked(frame, held));
    frame.tool->grip_un = 20.0;
    EXPECT_FALSE(is_marked(frame, held)) << "too little to count as a force";
    frame.tool->grip_un = 300e3;
    EXPECT_TRUE(is_marked(frame, held));
    frame.tool->touched.clear();
    EXPECT_FALSE(is_marked(frame, held)) << "jaws on a tumour hold no vessel";
    frame.tool->touched = touched_around(frame, held);
    EXPECT_TRUE(is_marked(frame, held));
    frame.tool.reset();
    EXPECT_FALSE(is_marked(frame, held)) << "it is put away";
}

// A tumour that the jaws lean on draws the mean of their contacts to its side.
TEST_F(ToolInTheScene, what_jaws_hold_is_marked_on_the_vessel_also_where_they_lean_on_a_tumour) {
    Frame frame = testing::fake_frame(0.0);
    const Vec3 held(0, 0, -40), beside(-20, 0, -40);
    frame.tool.emplace();
    frame.tool->parts = {{Vec3(30, -12, -40), Vec3(-8, -12, -40), 5.0},
                         {Vec3(30, 12, -40), Vec3(-8, 12, -40), 5.0}};
    frame.tool->tip_mm = Vec3(-8, 0, -40);
    frame.tool->at_mm = beside;
    frame.tool->touched = touched_around(frame, held);
    frame.tool->grip_un = 300e3;
    EXPECT_FALSE(is_marked(frame, beside));
    EXPECT_TRUE(is_marked(frame, held - Vec3(5.4, 0, 0))) << "on the side of the trunk";
}

}  // namespace
}  // namespace hepatica
