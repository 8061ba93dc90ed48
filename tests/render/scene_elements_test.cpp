// SPDX-License-Identifier: GPL-3.0-or-later
// That the comparison of pictures sees: each element of a picture is taken away, and the picture
// must no longer look like the one that has it.
#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/deform/body/obstacles.h"
#include "core/flow/fluid.h"
#include "render/crosshair_actor.h"
#include "render/depth_stem.h"
#include "render/grab_actor.h"
#include "render/osmesa_context.h"
#include "render/scene_view.h"
#include "render/tool_actor.h"
#include "tests/render/fake_frame.h"
#include "tests/render/scene_pictures.h"
#include "tests/render/screenshot.h"

namespace hepatica {
namespace {

using testing::fake_frame;
using testing::look_alike;
using testing::worst_tile_difference;

constexpr int width = 320, height = 240;

struct Box {
    const char* element;
    int left, top, right, bottom;
};

class SceneElements : public testing::ScenePictures {
  protected:
    // Of the legend of a drug as it was drawn last, by its points from the top: five lines of 22
    // and a bar of 10 with a gap of 5.
    Box of_legend(const char* element, double from_pt, double to_pt) const {
        const PictureBox legend = view_.legend_box();
        const double point = (legend.top - legend.bottom) / 125.0;
        const double top = height - legend.top;
        return {element, static_cast<int>(legend.left), static_cast<int>(top + from_pt * point),
                static_cast<int>(legend.right), static_cast<int>(top + to_pt * point)};
    }
};

// The picture with one box of it as it is in another picture.
Picture with_box_of(const Picture& other, const Box& box, Picture picture) {
    for (int y = box.top; y < box.bottom; ++y) {
        const std::size_t row = 3 * static_cast<std::size_t>(y * picture.width);
        std::copy(other.rgb.begin() + row + 3 * box.left, other.rgb.begin() + row + 3 * box.right,
                  picture.rgb.begin() + row + 3 * box.left);
    }
    return picture;
}

Frame pulled_frame() {
    Frame frame = fake_frame(0.1);
    frame.grab = GrabView{Vec3(0, -4, -15), Vec3(25, -4, -25), 1e3};
    return frame;
}

TEST_F(SceneElements, the_pulls_line_and_its_bead_are_each_seen) {
    const Picture pulled = picture_of(pulled_frame());
    const Picture free = picture_of(fake_frame(0.1));
    EXPECT_FALSE(look_alike(free, pulled));
    for (const Box& box : {Box{"line", 150, 130, 189, 160}, Box{"bead", 190, 150, 205, 170}})
        EXPECT_GT(worst_tile_difference(with_box_of(free, box, pulled), pulled), 8.0)
            << box.element;
}

TEST_F(SceneElements, a_tool_its_arrow_its_number_and_what_it_touches_are_each_seen) {
    const Frame touched = testing::touched_frame();
    const Picture whole = picture_of(touched);
    Frame less = touched;
    less.tool->force_un.setZero();
    const Picture without_force = picture_of(less);
    EXPECT_FALSE(look_alike(without_force, whole));
    for (const Box& box : {Box{"arrow", 185, 150, 230, 175}, Box{"number", 231, 133, 300, 155}})
        EXPECT_FALSE(look_alike(with_box_of(without_force, box, whole), whole)) << box.element;
    less.tool->grip_un = 21e3;
    EXPECT_FALSE(look_alike(picture_of(less), without_force)) << "grip";
    less.tool->grip_un = 0.0;
    less.tool->touched.clear();
    const Picture untouched = picture_of(less);
    EXPECT_FALSE(look_alike(untouched, without_force));
    less.tool.reset();
    EXPECT_FALSE(look_alike(picture_of(less), untouched));
    EXPECT_FALSE(view_.show(less)) << "nothing is new";
    EXPECT_TRUE(view_.show(touched));
    EXPECT_EQ(picture().rgb, whole.rgb);
}

// A tool behind the trunk, seen from the front.
TEST_F(SceneElements, what_a_vessel_hides_of_a_tool_shines_through) {
    Frame hidden = fake_frame(0.0);
    const Picture without = picture_of(hidden);
    hidden.tool.emplace();
    hidden.tool->parts = {{Vec3(0, 40, -45), Vec3(0, 40, -30), 4.0}};
    hidden.tool->tip_mm = Vec3(0, 40, -30);
    hidden.tool->touched = {0};  // no line to the nearest vessel then
    Frame lit = fake_frame(0.0);
    lit.tool = hidden.tool;
    lit.tool->parts.clear();
    const Picture touched_alone = picture_of(lit);
    const Picture through = picture_of(hidden);
    EXPECT_FALSE(look_alike(through, touched_alone));
    int largest = 0;
    for (std::size_t i = 0; i < through.rgb.size(); ++i)
        largest = std::max(largest, through.rgb[i] - touched_alone.rgb[i]);
    EXPECT_GT(largest, 75) << "its outline is clear; a body that is merely faint adds 60";
    EXPECT_TRUE(view_.show(fake_frame(0.0)));
    EXPECT_TRUE(look_alike(picture_of(fake_frame(0.0)), without));
}

TEST_F(SceneElements, how_far_a_tool_is_from_the_vessels_is_seen) {
    Frame near = fake_frame(0.0);
    near.tool.emplace();
    near.tool->parts = {{Vec3(20, 0, -40), Vec3(20, 0, -40), 3.0}};
    near.tool->tip_mm = Vec3(20, 0, -40);
    const Picture apart = picture_of(near);
    Frame far = near;
    far.tool->tip_mm = Vec3(20, 500, -40);  // as if it were nowhere near
    EXPECT_FALSE(look_alike(picture_of(far), apart));
}

TEST_F(SceneElements, a_pulls_force_and_the_blood_of_a_torn_vessel_are_seen) {
    Frame frame = fake_frame(0.0);
    frame.grab = GrabView{Vec3(0, 0, -40), Vec3(20, 0, -40), 0.0, false};
    const Picture without_force = picture_of(frame);
    frame.grab->force_un = 12e3;
    EXPECT_FALSE(look_alike(picture_of(frame), without_force));
    frame.grab.reset();
    frame.tear.emplace();
    const Picture whole = picture_of(frame);
    frame.tear->leaks = {{Vec3(0, 0, -40), 1.0}};
    EXPECT_TRUE(look_alike(picture_of(frame), whole)) << "nothing was lost yet";
    frame.tear->leaked_g = 40.0;
    EXPECT_FALSE(look_alike(picture_of(frame), whole));
    frame.tear->leaks.clear();
    EXPECT_TRUE(look_alike(picture_of(frame), whole));
}

TEST(LinesInThePicture, AreAsWideInPointsOnADenseScreen) {
    GrabActor pull;
    CrosshairActor crosshair;
    vtkNew<vtkRenderer> renderer;
    DepthStem stem(*renderer);
    auto* line = vtkActor::SafeDownCast(renderer->GetActors()->GetItemAsObject(0));
    ASSERT_NE(line, nullptr);
    for (const double ratio : {1.0, 2.0}) {
        const auto wide = [&](double points) { return static_cast<float>(points * ratio); };
        pull.set_scale(0.1, ratio);
        crosshair.set_pixel_ratio(ratio);
        stem.place(ratio, Vec3::UnitY());
        EXPECT_FLOAT_EQ(pull.line()->GetProperty()->GetLineWidth(), wide(2.0));
        EXPECT_FLOAT_EQ(crosshair.actor()->GetProperty()->GetLineWidth(), wide(1.5));
        EXPECT_FLOAT_EQ(line->GetProperty()->GetLineWidth(), wide(1.5));
    }
}

TEST(ForceText, IsInMillinewtonsAndEmptyWhereThereIsNone) {
    EXPECT_EQ(force_text(0.0), "");
    EXPECT_EQ(force_text(49.0), "");
    EXPECT_EQ(force_text(50.0), "0.1 mN");
    EXPECT_EQ(force_text(1234.0), "1.2 mN");
    EXPECT_EQ(force_text(9949.0), "9.9 mN");
    EXPECT_EQ(force_text(9960.0), "10 mN");
    EXPECT_EQ(force_text(123456.0), "123 mN");
    EXPECT_EQ(force_text(1151300.0), "1150 mN") << "as in the lesson's panel";
    EXPECT_EQ(force_text(NAN), "");
}

TEST_F(SceneElements, the_drug_and_the_place_of_its_front_are_seen) {
    const Picture now = picture_of(fake_frame(1.0, 2.0));
    view_.set_annotations_visible(false);
    const Picture bare = picture();
    EXPECT_FALSE(look_alike(picture_of(fake_frame(1.0, 2.2)), bare));
    EXPECT_FALSE(look_alike(picture_of(fake_frame(1.0)), bare));
    EXPECT_FALSE(look_alike(bare, now));
}

TEST_F(SceneElements, each_annotation_is_seen) {
    view_.set_caption("Patient");
    const Picture full = picture_of(fake_frame(1.0, 0.5));
    EXPECT_NEAR(view_.legend_box().top - view_.legend_box().bottom, 0.8 * 125.0, 1e-9);
    const std::vector<Box> elements{
        of_legend("legend's title", 0, 22),       of_legend("legend's colours", 22, 32),
        of_legend("legend's ticks", 37, 59),      of_legend("legend's axis", 59, 81),
        of_legend("legend's front", 81, 103),     of_legend("legend's system", 103, 125),
        Box{"scale's label", 140, 214, 180, 223}, Box{"scale's bar", 118, 223, 189, 232},
        Box{"orientation", 10, 190, 50, 230},     Box{"caption", 5, 5, 80, 25}};
    view_.set_annotations_visible(false);
    const Picture bare = picture();
    for (const Box& box : elements) {
        const Picture without = with_box_of(bare, box, full);
        EXPECT_FALSE(look_alike(without, full))
            << box.element << ": " << worst_tile_difference(without, full);
    }
}

TEST_F(SceneElements, the_mark_of_now_on_the_legend_is_seen) {
    const Picture later = picture_of(fake_frame(1.0, 2.0));
    const Picture now = picture_of(fake_frame(1.0, 0.5));
    Box mark = of_legend("mark", 22, 32);
    const double at = mark.left + (mark.right - mark.left) * std::sqrt(0.5 / 3.2);
    mark.left = static_cast<int>(at) - 4;
    mark.right = static_cast<int>(at) + 4;
    EXPECT_GT(worst_tile_difference(with_box_of(later, mark, now), now),
              testing::unnoticed_difference);
    // Across the colours, not behind them.
    const std::size_t middle =
        3 * static_cast<std::size_t>((mark.top + mark.bottom) / 2 * width + static_cast<int>(at));
    EXPECT_GT(now.rgb[middle + 2], 180);
}

TEST_F(SceneElements, a_highlight_the_liver_and_a_gap_are_seen) {
    const Frame frame = fake_frame();
    const Picture plain = picture_of(frame);
    std::vector<std::uint8_t> tip(frame.positions_mm.size() / 3, 0);
    for (std::size_t v = 0; v < tip.size(); ++v) tip[v] = frame.positions_mm[3 * v] < -25;
    view_.set_highlight(tip);
    EXPECT_FALSE(look_alike(picture(), plain));
    view_.set_highlight({});
    EXPECT_EQ(picture().rgb, plain.rgb);
    view_.set_liver(testing::sphere(Vec3(0, 0, 0), 62.0));
    EXPECT_FALSE(look_alike(picture(), plain));
    view_.set_liver_visible(false);
    EXPECT_EQ(picture().rgb, plain.rgb);
    view_.set_bridges({{{Vec3(-20, 0, -20), Vec3(-20, 0, -10)}, "22 %", false}});
    EXPECT_FALSE(look_alike(picture(), plain));
}

// Of one colour that nothing else has, also where it runs behind vessels or towards the eye.
TEST_F(SceneElements, the_line_of_a_chosen_branch_is_seen_through_the_vessels) {
    const auto pixels = [](const Picture& seen) {
        const Colour colour = palette::chosen_branch();
        int count = 0;
        for (std::size_t at = 0; at + 2 < seen.rgb.size(); at += 3) {
            bool same = true;
            for (std::size_t c = 0; c < 3; ++c)
                same &= std::abs(seen.rgb[at + c] - 255.0 * colour[c]) < 3.0;
            count += same;
        }
        return count;
    };
    view_.set_annotations_visible(false);  // whose legend has the colour, too
    const Picture plain = picture_of(fake_frame());
    ASSERT_EQ(pixels(plain), 0);
    view_.set_chosen_branch({Vec3(0, 60, -20), Vec3(0, 60, 20)});
    EXPECT_GT(pixels(picture()), 40) << "it lies behind the vessels for who looks from the front";
    EXPECT_TRUE(view_.legend().branch_line);
    view_.set_chosen_branch({Vec3(0, -1, 0), Vec3(0, 1, 0)});
    EXPECT_GE(pixels(picture()), 9) << "seen along it";
    EXPECT_FALSE(view_.set_chosen_branch({Vec3(0, -1, 0), Vec3(0, 1, 0)}));
    view_.set_chosen_branch({});
    EXPECT_EQ(picture().rgb, plain.rgb);
    EXPECT_FALSE(view_.legend().branch_line);
}

TEST_F(SceneElements, vessels_are_brighter_where_the_look_wants_that) {
    ViewLook dim = high_contrast_look;
    dim.bright_vessels = false;
    view_.set_look(dim);
    const Frame frame = fake_frame();
    view_.set_vertex_systems(std::vector(frame.positions_mm.size() / 3, VascularSystem::portal));
    const Picture before = picture_of(frame);
    view_.set_look(high_contrast_look);
    const Picture after = picture();
    const auto light = [](const Picture& picture) {
        return std::accumulate(picture.rgb.begin(), picture.rgb.end(), 0.0);
    };
    EXPECT_GT(light(after), 1.01 * light(before));
}

// Each is seen, once: the organs that a case shows give way to obstacles or take their place.
TEST_F(SceneElements, a_tumour_and_a_wall_in_the_way_are_each_seen) {
    const Frame both = testing::frame_beside_obstacles();
    Frame frame = both;
    const auto with = [&](std::vector<Obstacle> some) {
        frame.obstacles = std::make_shared<const Obstacles>(Obstacles{std::move(some)});
        return picture_of(frame);
    };
    const Picture all = picture_of(both);
    const Picture tumour = with({both.obstacles->all[0]}), wall = with({both.obstacles->all[1]});
    frame.obstacles.reset();
    EXPECT_TRUE(view_.show(frame));
    EXPECT_FALSE(view_.show(frame)) << "as it was";
    const Picture none = picture();
    for (const Picture* one : {&tumour, &wall}) {
        EXPECT_FALSE(look_alike(*one, all));
        EXPECT_FALSE(look_alike(*one, none));
    }
    const TriangleMesh liver = both.obstacles->all[1].surface;
    view_.set_tumours(both.obstacles->all[0].surface);
    view_.set_liver(liver);
    EXPECT_FALSE(look_alike(picture_of(both), picture_of(frame))) << "the tumour is solid";
    EXPECT_EQ(picture_of(both).rgb, all.rgb) << "neither is seen twice";
    view_.set_liver_visible(false);
    EXPECT_EQ(picture_of(both).rgb, all.rgb) << "the wall is there without the organ";
    EXPECT_FALSE(look_alike(picture_of(frame), none)) << "the case's tumours are there again";
    view_.set_tumours({});
    EXPECT_EQ(picture_of(frame).rgb, none.rgb);
}

// It is no obstacle before the case is opened again.
TEST_F(SceneElements, a_tumour_that_was_painted_since_is_seen_beside_those_in_the_way) {
    const Frame frame = testing::frame_beside_obstacles();
    const TriangleMesh known = frame.obstacles->all[0].surface;
    TriangleMesh painted = testing::sphere(Vec3(-30, -20, -30), 9.0);
    const auto first = static_cast<int>(painted.vertices_mm.size());
    painted.vertices_mm.insert(painted.vertices_mm.end(), known.vertices_mm.begin(),
                               known.vertices_mm.end());
    for (const auto& [a, b, c] : known.triangles)
        painted.triangles.push_back({first + a, first + b, first + c});
    view_.set_tumours(known);
    const Picture before = picture_of(frame);
    view_.set_tumours(painted);
    EXPECT_FALSE(look_alike(picture(), before));
    // Also where the obstacles come later.
    const Picture both = picture();
    view_.show(fake_frame(0.3));
    EXPECT_EQ(picture_of(frame).rgb, both.rgb);
    view_.set_tumours(known);
    EXPECT_EQ(picture().rgb, before.rgb) << "none is drawn twice";
}

// Cut open, both are.
TEST_F(SceneElements, obstacles_are_cut_open_with_the_vessels) {
    view_.set_annotations_visible(false);
    const Picture whole = picture_of(testing::frame_beside_obstacles());
    view_.set_clip(ClipPlane{Vec3(200, 0, 0), Vec3(1, 0, 0)});
    const Picture nothing = picture();
    view_.show(fake_frame(0.3));
    EXPECT_EQ(picture().rgb, nothing.rgb);
    view_.show(testing::frame_beside_obstacles());
    view_.set_clip(std::nullopt);
    EXPECT_EQ(picture().rgb, whole.rgb);
}

TEST(Screenshot, another_drivers_smoothing_of_edges_is_not_seen) {
    OsmesaContext context(width, height);
    SceneView view(context.window());
    view.show(fake_frame(0.2, 1.0));
    view.set_annotations_visible(false);
    view.render();
    const Picture sharp = read_picture(context.window());
    Picture softer = sharp, shifted = sharp;
    for (std::size_t i = 0; i + 3 < sharp.rgb.size(); ++i) {
        softer.rgb[i] = static_cast<std::uint8_t>((sharp.rgb[i] + sharp.rgb[i + 3]) / 2);
        shifted.rgb[i] = sharp.rgb[i + 3];
    }
    EXPECT_NE(softer.rgb, sharp.rgb);
    EXPECT_TRUE(look_alike(softer, sharp)) << worst_tile_difference(softer, sharp);
    EXPECT_TRUE(look_alike(shifted, sharp)) << worst_tile_difference(shifted, sharp);
    for (std::size_t i = 0; i + 12 < sharp.rgb.size(); ++i) shifted.rgb[i] = sharp.rgb[i + 12];
    EXPECT_FALSE(look_alike(shifted, sharp)) << "four pixels away";
    EXPECT_FALSE(look_alike(Picture{1, 1, {0, 0, 0}}, sharp));
}

// Wherever the arrow ends, also beyond an edge.
TEST(ForceLabel, StaysWithinThePicture) {
    OsmesaContext context(200, 150);
    vtkNew<vtkRenderer> renderer;
    context.window().AddRenderer(renderer);
    vtkCamera& eye = *renderer->GetActiveCamera();
    eye.SetPosition(0, 0, 100);
    eye.SetFocalPoint(0, 0, 0);
    ToolActor actor(*renderer);
    for (const Vec3& at : {Vec3(40, 0, 0), Vec3(-60, 0, 0), Vec3(0, 40, 0), Vec3(0, -40, 0),
                           Vec3(30, 26, 0), Vec3(0, 0, 0)}) {
        ToolView tool;
        tool.parts = {{at, at + Vec3(0, 0, 5), 1.0}};
        tool.at_mm = tool.tip_mm = at;
        tool.force_un = Vec3(5e3, 0, 0);
        actor.update(tool);
        actor.set_scale(0.4, 1.0);
        context.window().Render();
        const auto label = actor.label_box();
        ASSERT_TRUE(label);
        EXPECT_GE(label->left, 0.0);
        EXPECT_GE(label->bottom, 0.0);
        EXPECT_LE(label->right, 200.0);
        EXPECT_LE(label->top, 150.0);
        EXPECT_GT(label->right - label->left, 20.0) << "it says something";
        tool.at_mm = tool.tip_mm = Vec3(at.x(), at.y(), 150.0);
        actor.update(tool);
        actor.set_scale(0.4, 1.0);
        EXPECT_FALSE(actor.label_box()) << "behind the eye";
    }
    context.window().RemoveRenderer(renderer);
}

// A hairline would not be seen on a whole patient.
TEST_F(SceneElements, a_cut_line_is_some_pixels_wide_and_has_a_dark_rim) {
    Frame frame = fake_frame(0.1);
    const Picture plain = picture_of(frame);
    const auto place = [&](int vertex) {
        const float* at = &frame.positions_mm[3 * static_cast<std::size_t>(vertex)];
        return Vec3(at[0], at[1], at[2]);
    };
    std::array<int, 2> front{};
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : *frame.surface)
        if (const double away = place(a).y() + place(b).y(); away < nearest) {
            nearest = away;
            front = {std::min(a, b), std::max(a, b)};
        }
    frame.tear.emplace();
    frame.tear->weak_edges = std::make_shared<const std::vector<std::array<int, 2>>>(1, front);
    EXPECT_TRUE(view_.show(frame));
    const Picture cut = picture();
    int red = 0, dark = 0;
    for (std::size_t i = 0; i < cut.rgb.size(); i += 3) {
        const std::uint8_t* now = &cut.rgb[i];
        if (std::equal(now, now + 3, &plain.rgb[i])) continue;
        red += now[0] > 200 && now[1] < 110 && now[2] < 90;
        dark += now[0] < 60 && now[1] < 60 && now[2] < 60;
    }
    const Pixel from = view_.pixel_of(place(front[0])), to = view_.pixel_of(place(front[1]));
    const double dash = 0.64 * std::hypot(to.x - from.x, to.y - from.y);
    EXPECT_GT(red, 2.0 * dash);
    EXPECT_GT(dark, dash);
}

TEST_F(SceneElements, a_cut_line_that_has_not_torn_is_seen) {
    Frame frame = fake_frame(0.1);
    const Picture plain = picture_of(frame);
    frame.tear.emplace();
    std::vector<std::array<int, 2>> edges;
    for (const auto& [a, b, c] : *frame.surface) edges.push_back({std::min(a, b), std::max(a, b)});
    frame.tear->weak_edges =
        std::make_shared<const std::vector<std::array<int, 2>>>(std::move(edges));
    EXPECT_TRUE(view_.show(frame));
    EXPECT_FALSE(view_.show(frame)) << "nothing new";
    EXPECT_FALSE(look_alike(picture(), plain));
    frame.tear->weak_edges = nullptr;
    EXPECT_TRUE(view_.show(frame));
    EXPECT_TRUE(look_alike(picture(), plain));
}

}  // namespace
}  // namespace hepatica
