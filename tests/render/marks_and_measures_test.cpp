// SPDX-License-Identifier: GPL-3.0-or-later
// That the marks of a lesson, the distance to them and what was measured are seen in a picture.
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "render/measure_marks.h"
#include "render/palette.h"
#include "tests/render/fake_frame.h"
#include "tests/render/scene_pictures.h"
#include "tests/render/screenshot.h"

namespace hepatica {
namespace {

using testing::fake_frame;
using testing::look_alike;

class MarksAndMeasures : public testing::ScenePictures {};

TEST_F(MarksAndMeasures, a_mark_its_number_and_that_it_is_reached_are_each_seen) {
    view_.show(fake_frame());
    const Vec3 beside(-30, 0, -30);
    const Picture without = picture();
    view_.set_marks({{beside, "", false}});
    const Picture ball = picture();
    EXPECT_FALSE(look_alike(ball, without));
    view_.set_marks({{beside, "1", false}});
    const Picture numbered = picture();
    EXPECT_FALSE(look_alike(numbered, ball));
    EXPECT_TRUE(view_.set_marks({{beside, "1", true}}));
    EXPECT_FALSE(look_alike(picture(), numbered));
    EXPECT_FALSE(view_.set_marks({{beside, "1", true}})) << "as it was";
    view_.set_marks({});
    EXPECT_TRUE(look_alike(picture(), without));
}

// Which of two things in the layer over the picture is in front depends on the driver, so that a
// rim behind the line would hide it on some.
TEST_F(MarksAndMeasures, a_stroke_and_its_rim_are_both_seen) {
    view_.show(fake_frame());
    const Picture without = picture();
    view_.set_stroke(std::array{Vec3(-30, 0, -20), Vec3(30, 0, 20)});
    const Picture stroke = picture();
    const auto pixels_of = [&](const Colour& colour) {
        int count = 0;
        for (std::size_t p = 0; p < stroke.rgb.size(); p += 3) {
            bool like = false;
            for (std::size_t c = 0; c < 3; ++c)
                like = like || stroke.rgb[p + c] != without.rgb[p + c];
            for (std::size_t c = 0; c < 3; ++c)
                like = like && std::abs(stroke.rgb[p + c] - 255.0 * colour[c]) < 30.0;
            count += like ? 1 : 0;
        }
        return count;
    };
    const int line = pixels_of(palette::grab_line), rim = pixels_of(palette::rim);
    EXPECT_GT(line, 100);
    EXPECT_GT(rim, 100);
    EXPECT_LT(std::abs(line - rim), line / 2) << "as wide as its rim on both sides together";
    view_.set_stroke(std::nullopt);
    EXPECT_EQ(picture().rgb, without.rgb);
}

// Behind the vessels, or in a pool of blood.
TEST_F(MarksAndMeasures, the_number_of_a_mark_is_seen_through_vessels_and_blood) {
    Frame frame = fake_frame();
    const auto its_number_is_seen = [&](const Vec3& place) {
        view_.show(frame);
        view_.set_marks({{place, "8", false}});
        const Picture other = picture();
        view_.set_marks({{place, "1", false}});
        EXPECT_TRUE(picture().rgb != other.rgb);
    };
    const std::size_t vertices = frame.positions_mm.size() / 3;
    Vec3 middle = Vec3::Zero();
    for (std::size_t i = 0; i < frame.positions_mm.size(); ++i)
        middle[static_cast<int>(i % 3)] += frame.positions_mm[i] / static_cast<double>(vertices);
    const Vec3 forward(view_.camera().GetDirectionOfProjection());
    its_number_is_seen(middle + 15.0 * forward);
    frame.tear.emplace();
    frame.tear->leaked_g = 400.0;
    frame.tear->leaks = {{.at_mm = middle, .share = 1.0}};
    its_number_is_seen(middle);
}

// As that of the only place of a lesson, and those in the lesson editor.
TEST_F(MarksAndMeasures, a_mark_without_a_number_is_seen_through_vessels_and_blood) {
    Frame frame = fake_frame();
    const Vec3 trunk(0, 0, -40);
    view_.show(frame);
    const Vec3 behind = trunk + 15.0 * view_.axes().forward;
    const auto colour_there = [&](const Picture& seen, const Vec3& place) {
        const Pixel at = view_.pixel_of(place);
        const std::size_t pixel =
            3 * static_cast<std::size_t>(static_cast<int>(at.y) * width + static_cast<int>(at.x));
        return std::array<int, 3>{seen.rgb[pixel], seen.rgb[pixel + 1], seen.rgb[pixel + 2]};
    };
    const auto is_seen_at = [&](const Vec3& place) {
        view_.set_marks({});
        const auto without = colour_there(picture(), place);
        view_.set_marks({{place, "", false}});
        const auto with = colour_there(picture(), place);
        int difference = 0;
        for (std::size_t c = 0; c < 3; ++c) difference += std::abs(with[c] - without[c]);
        EXPECT_GT(difference, 20) << place.transpose();
    };
    ASSERT_GE(view_.pick(view_.pixel_of(behind)).triangle, 0) << "the trunk is before it";
    is_seen_at(behind);
    frame.tear.emplace();
    frame.tear->leaked_g = 400.0;
    frame.tear->leaks = {{.at_mm = trunk, .share = 1.0}};
    view_.show(frame);
    is_seen_at(trunk);
}

// As large before the vessels as at its place, where nothing hides it.
TEST_F(MarksAndMeasures, a_mark_without_a_number_is_as_large_as_one_with_a_number) {
    view_.show(fake_frame());
    const Vec3 beside(-30, 0, -30);
    view_.set_marks({});
    const Picture without = picture();
    const auto pixels_of = [&](const char* number) {
        view_.set_marks({{beside, number, false}});
        const Picture with = picture();
        // Below the middle, where no number stands.
        const Pixel middle = view_.pixel_of(beside);
        const int row = static_cast<int>(middle.y) + 4, column = static_cast<int>(middle.x);
        int changed = 0;
        for (int x = column - 30; x < column + 30; ++x) {
            const auto pixel = 3 * static_cast<std::ptrdiff_t>(row * width + x);
            changed += !std::equal(with.rgb.begin() + pixel, with.rgb.begin() + pixel + 3,
                                   without.rgb.begin() + pixel);
        }
        return changed;
    };
    const int numbered = pixels_of("1");
    EXPECT_GT(numbered, 10);
    EXPECT_NEAR(pixels_of(""), numbered, 2);
}

// As the lesson measures it: from the tip to the mark.
TEST_F(MarksAndMeasures, a_line_says_how_far_the_tool_is_from_the_mark_and_whether_deeper) {
    std::string last;
    view_.set_words([&](const std::string& english) {
        for (const char* part : {"mm", "mark", "from you", "towards you"})
            if (english.ends_with(part) || english.find("mark") != std::string::npos)
                last = english;
        return english;
    });
    Frame frame = fake_frame();
    view_.show(frame);
    const Vec3 tip(40, 0, 20);
    frame.tool.emplace();
    frame.tool->parts = {{tip, tip - Vec3(0, 0, 20), 2.0}};
    frame.tool->tip_mm = frame.tool->at_mm = frame.tool->centre_mm = tip;
    const auto said = [&](const std::vector<MarkView>& marks) {
        last.clear();
        view_.set_marks(marks);
        view_.show(frame);
        return last;
    };
    const ViewAxes axes = view_.axes();
    EXPECT_EQ(said({{tip + 12.0 * axes.right, "", false}}), "12.0 mm to the mark");
    EXPECT_EQ(said({{tip + 12.0 * axes.forward, "", false}}),
              "12.0 mm to the mark, move away from you");
    EXPECT_EQ(said({{tip - 12.0 * axes.forward, "", false}}),
              "12.0 mm to the mark, move towards you");
    EXPECT_EQ(said({{tip + 90.0 * axes.right, "", false}, {tip + 7.0 * axes.up, "", false}}),
              "7.0 mm to the mark");
    EXPECT_EQ(said({{tip + 12.4 * axes.right, "", false}}), "12.4 mm to the mark")
        << "12 mm would look like a bound that is reached";
    // The step asks for the first, though the second is nearer.
    const MarkView asked{tip + 33.5 * axes.right, "1", false, true, true};
    EXPECT_EQ(said({asked, {tip + 16.0 * axes.right, "2", false}}), "33.5 mm to mark 1");
    const std::string vessel = said({{tip + 12.0 * axes.right, "", true}});
    EXPECT_NE(vessel.find(" mm"), std::string::npos) << "of a vessel";
    EXPECT_EQ(vessel.find("mark"), std::string::npos) << "it is done with: " << vessel;
    const Picture near_vessel = picture();
    said({{tip + 12.0 * axes.forward + 5.0 * axes.up, "", false}});
    EXPECT_FALSE(look_alike(picture(), near_vessel));
}

TEST_F(MarksAndMeasures, a_number_beside_the_vessels_says_whether_they_lie_before_or_behind) {
    std::string last;
    view_.set_words([&](const std::string& english) {
        if (english.find(" mm, move") != std::string::npos) last = english;
        return english;
    });
    Frame frame = fake_frame();
    view_.show(frame);
    const Vec3 forward = view_.axes().forward;
    Vec3 nearest = frame.place_mm(0), farthest = nearest;  // to the user
    for (int v = 0; 3 * static_cast<std::size_t>(v) < frame.positions_mm.size(); ++v) {
        const Vec3 place = frame.place_mm(v);
        if (place.dot(forward) < nearest.dot(forward)) nearest = place;
        if (place.dot(forward) > farthest.dot(forward)) farthest = place;
    }
    const auto said_at = [&](const Vec3& tip) {
        last.clear();
        frame.tool.emplace();
        frame.tool->parts = {{tip, tip, 2.0}};
        frame.tool->tip_mm = frame.tool->at_mm = frame.tool->centre_mm = tip;
        view_.show(frame);
        return last;
    };
    EXPECT_EQ(said_at(nearest - 12.0 * forward), "10 mm, move away from you");
    EXPECT_EQ(said_at(farthest + 12.0 * forward), "10 mm, move towards you");
}

// Jaws touch other vessels on their way to the one that they are to hold; of them the middle
// counts.
TEST_F(MarksAndMeasures, jaws_are_led_by_their_middle_until_they_close_and_say_where_they_closed) {
    std::string last;
    view_.set_words([&](const std::string& english) {
        if (english.find("mark") != std::string::npos) last = english;
        return english;
    });
    Frame frame = fake_frame();
    const ViewAxes axes = view_.axes();
    const Vec3 middle(40, 0, 20);
    ToolView& forceps = frame.tool.emplace();
    forceps.opening_mm = 12.0;
    forceps.centre_mm = middle - 7.5 * axes.forward;
    forceps.tip_mm = forceps.at_mm = middle + 7.5 * axes.forward;
    for (const double side : {-8.0, 8.0}) {
        const Vec3 end = forceps.tip_mm + side * axes.up;
        forceps.parts.push_back({end - 30.0 * axes.forward, end, 2.0});
    }
    ASSERT_LT((forceps.working_mm() - middle).norm(), 1e-9);
    const auto said = [&](const std::vector<MarkView>& marks) {
        last.clear();
        view_.set_marks(marks);
        view_.show(frame);
        return last;
    };
    const std::vector<MarkView> deeper{{middle + 13.0 * axes.forward, "", false}};
    EXPECT_EQ(said(deeper), "13.0 mm to the mark, move away from you");
    forceps.touched = {1, 2, 3};
    said({});
    EXPECT_EQ(said(deeper), "13.0 mm to the mark, move away from you");
    EXPECT_EQ(said({{middle + 6.5 * axes.right, "", false}}), "6.5 mm to the mark");
    EXPECT_EQ(said({{middle + 5.5 * axes.right, "", false}}), "the mark is between the jaws");
    EXPECT_EQ(said({{middle, "2", false}}), "mark 2 is between the jaws");
    forceps.closing = true;
    forceps.opening_mm = 3.0;
    view_.show(frame);
    EXPECT_EQ(said({{middle + 5.5 * axes.right, "", false}}), "") << "it is held";
    EXPECT_EQ(said({{middle + 6.5 * axes.right, "", false}}),
              "closed 6.5 mm beside the mark: open with C");
    EXPECT_EQ(said(deeper), "closed 13.0 mm beside the mark: open with C and move away from you");
    forceps.grip_un = 5e3;
    EXPECT_EQ(said({{middle - 9.0 * axes.forward, "2", false}}),
              "closed 9.0 mm beside mark 2: open with C and move towards you")
        << "whatever else they hold";
    // A probe that touches something has arrived.
    forceps.closing = false;
    forceps.grip_un = 0.0;
    forceps.parts.pop_back();
    view_.show(frame);
    EXPECT_EQ(said(deeper), "");
}

// While nothing moves but the marks and the view.
TEST_F(MarksAndMeasures, the_way_to_a_mark_is_said_anew_for_other_marks_and_where_one_looks_from) {
    std::string last;
    view_.set_words([&](const std::string& english) {
        if (english.find("mark") != std::string::npos) last = english;
        return english;
    });
    Frame frame = fake_frame();
    const Vec3 tip(40, 0, 20);
    frame.tool.emplace();
    frame.tool->parts = {{tip, tip - Vec3(0, 0, 20), 2.0}};
    frame.tool->tip_mm = frame.tool->at_mm = frame.tool->centre_mm = tip;
    view_.show(frame);
    view_.set_marks({{tip + 12.0 * view_.axes().forward, "", false}});
    EXPECT_EQ(last, "12.0 mm to the mark, move away from you");
    picture();
    view_.look_from(ViewDirection::posterior);
    picture();
    EXPECT_EQ(last, "12.0 mm to the mark, move towards you");
}

TEST_F(MarksAndMeasures, what_was_measured_and_its_value_are_seen) {
    const Picture plain = picture_of(fake_frame());
    const MeasureView measure{{Vec3(-20, -30, -50), Vec3(20, -30, -50)}, "40.0 mm"};
    MeasureView without_value = measure;
    without_value.text.clear();
    EXPECT_TRUE(view_.set_measures({measure}));
    EXPECT_FALSE(view_.set_measures({measure})) << "nothing is new";
    const Picture whole = picture();
    EXPECT_TRUE(view_.set_measures({without_value}));
    const Picture line = picture();
    EXPECT_FALSE(look_alike(line, whole));
    EXPECT_FALSE(look_alike(line, plain));
    // From end to end.
    for (const Vec3& end : without_value.points_mm) {
        const Pixel at = view_.pixel_of(end);
        const std::size_t pixel =
            3 * static_cast<std::size_t>(static_cast<int>(at.y) * width + static_cast<int>(at.x));
        EXPECT_GT(line.rgb[pixel], 240);
        EXPECT_LT(line.rgb[pixel + 2], 100);
    }
    EXPECT_TRUE(view_.set_measures({}));
    EXPECT_EQ(picture().rgb, plain.rgb);
}

// On a dense screen letters are large, and a vessel may end at any edge.
TEST_F(MarksAndMeasures, the_value_of_a_measure_stays_within_the_picture) {
    vtkNew<vtkRenderer> renderer;
    OsmesaContext context(200, 150);
    context.window().AddRenderer(renderer);
    MeasureMarks marks(*renderer);
    for (const std::array<double, 2>& end :
         {std::array{195.0, 75.0}, {2.0, 2.0}, {100.0, 148.0}, {199.0, 149.0}}) {
        marks.show({{{Vec3(0, 0, 0), Vec3(1, 0, 0)}, std::to_string(end[0]).substr(0, 3) + " mm"}});
        marks.update(
            [&](const Vec3& position) {
                return std::optional(position.x() > 0.0 ? end : std::array{100.0, 75.0});
            },
            2.0);
        context.window().Render();
        vtkTextActor* text = nullptr;
        vtkPropCollection& props = *renderer->GetViewProps();
        for (int i = 0; i < props.GetNumberOfItems(); ++i)
            if (auto* one = vtkTextActor::SafeDownCast(props.GetItemAsObject(i))) text = one;
        ASSERT_NE(text, nullptr);
        std::array<double, 2> size{};
        text->GetSize(renderer, size.data());
        EXPECT_GT(size[0], 40.0) << "it says something";
        for (int axis = 0; axis < 2; ++axis) {
            // A window's frame is four pixels wide there.
            EXPECT_GE(text->GetPosition()[axis], 6.0);
            EXPECT_LE(text->GetPosition()[axis] + size[axis], axis == 0 ? 194.0 : 144.0);
        }
    }
    context.window().RemoveRenderer(renderer);
}

// Letters shrink, and what has no room is left out.
TEST_F(MarksAndMeasures, values_of_measures_lie_on_no_other_and_within_a_small_picture) {
    vtkNew<vtkRenderer> renderer;
    OsmesaContext context(150, 100);
    context.window().AddRenderer(renderer);
    MeasureMarks marks(*renderer);
    const auto labels_at = [&](const std::array<double, 2>& end, const std::string& text,
                               std::size_t count) {
        std::vector<MeasureView> measures;
        for (std::size_t m = 0; m < count; ++m)
            measures.push_back({{Vec3(0, 0, 0), Vec3(1, 0, 0)}, text});
        marks.show(measures);
        marks.update([&](const Vec3&) { return std::optional(end); }, 1.0, 10.0, 20.0);
        for (const PictureBox& label : marks.labels()) {
            EXPECT_GE(label.left, 4.0);
            EXPECT_LE(label.right, 146.0);
            EXPECT_GE(label.bottom, 24.0) << "something covers the picture's foot";
            EXPECT_LE(label.top, 86.0) << "and its head";
            for (const PictureBox& other : marks.labels())
                EXPECT_TRUE(&other == &label || !overlap(label, other));
        }
        return marks.labels().size();
    };
    EXPECT_EQ(labels_at({140.0, 60.0}, "4.0 mm", 2), 2u);
    EXPECT_EQ(labels_at({140.0, 60.0}, "4.0 mm", 4), 4u) << "in two columns";
    EXPECT_EQ(labels_at({140.0, 60.0}, "\u2300 8.0 mm, stenosis", 1), 1u) << "in small letters";
    const std::size_t shown = labels_at({140.0, 60.0}, "4.0 mm", 40);
    EXPECT_GE(shown, 4u);
    EXPECT_LT(shown, 40u);
    context.window().RemoveRenderer(renderer);
}

// Brown on violet is hardly seen.
TEST_F(MarksAndMeasures, a_line_of_a_measure_has_rims_in_the_colour_of_the_ground) {
    vtkNew<vtkRenderer> renderer;
    OsmesaContext context(200, 100);
    context.window().AddRenderer(renderer);
    const Colour vessel = palette::vessel_system(VascularSystem::portal);
    renderer->SetBackground(vessel[0], vessel[1], vessel[2]);
    MeasureMarks marks(*renderer);
    marks.set_colours(light_look.measure, light_look.bottom);
    marks.show({{{Vec3(0, 0, 0), Vec3(1, 0, 0)}, ""}});
    marks.update(
        [](const Vec3& position) {
            return std::optional(std::array{position.x() > 0.0 ? 180.0 : 20.0, 50.0});
        },
        4.0);
    context.window().Render();
    const Picture drawn = read_picture(context.window());
    const auto is_at = [&](int above, const Colour& colour) {
        const auto at = static_cast<std::size_t>(3 * ((50 - above) * 200 + 100));
        bool same = true;
        for (std::size_t c = 0; c < 3; ++c)
            same &= std::abs(drawn.rgb[at + c] - 255.0 * colour[c]) < 3.0;
        return same;
    };
    EXPECT_TRUE(is_at(0, light_look.measure));
    for (const int side : {-6, 6}) EXPECT_TRUE(is_at(side, light_look.bottom)) << side;
    for (const int side : {-11, 11}) EXPECT_TRUE(is_at(side, vessel)) << side;
    EXPECT_GE(palette::contrast(light_look.measure, light_look.bottom), 4.5);
    context.window().RemoveRenderer(renderer);
}

TEST_F(MarksAndMeasures, values_of_measures_lie_beside_the_legend) {
    vtkNew<vtkRenderer> renderer;
    OsmesaContext context(300, 200);
    context.window().AddRenderer(renderer);
    MeasureMarks marks(*renderer);
    marks.show({{{Vec3(0, 0, 0), Vec3(1, 0, 0)}, "4.0 mm"}});
    const PictureBox legend{150.0, 20.0, 290.0, 80.0};
    const auto label_beside = [&](const PictureBox& box) {
        marks.update(
            [&](const Vec3&) {
                return std::optional(std::array{160.0, 40.0});
            },
            1.0, 0.0, 0.0, box);
        return marks.labels().at(0);
    };
    EXPECT_TRUE(overlap(label_beside({}), legend)) << "where it belongs";
    EXPECT_FALSE(overlap(label_beside(legend), legend));
    context.window().RemoveRenderer(renderer);
}

TEST_F(MarksAndMeasures, every_measure_is_seen_but_what_lies_behind_the_eye) {
    const Picture plain = picture_of(fake_frame());
    const MeasureView low{{Vec3(-20, -30, -50), Vec3(20, -30, -50)}, ""};
    const MeasureView high{{Vec3(-20, -30, 10), Vec3(20, -30, 10)}, ""};
    view_.set_measures({low, high});
    const Picture both = picture();
    for (const MeasureView& measure : {low, high}) {
        const Pixel at = view_.pixel_of(measure.points_mm[0]);
        const std::size_t pixel =
            3 * static_cast<std::size_t>(static_cast<int>(at.y) * width + static_cast<int>(at.x));
        EXPECT_GT(both.rgb[pixel], 240);
        EXPECT_LT(both.rgb[pixel + 2], 100);
    }
    const ViewAxes axes = view_.axes();
    const Vec3 eye = view_.ray_through({0.5 * width, 0.5 * height}).origin_mm;
    const Vec3 behind = eye - 40.0 * axes.forward;
    for (const Vec3& other : {Vec3(behind + 10.0 * axes.right), Vec3(20, -30, 10), eye}) {
        view_.set_measures({{{behind, other}, "10.0 mm"}});
        EXPECT_EQ(picture().rgb, plain.rgb) << other.transpose();
    }
}

}  // namespace
}  // namespace hepatica
