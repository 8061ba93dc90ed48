// SPDX-License-Identifier: GPL-3.0-or-later
// In a small picture the legend gives way to the vessels, to the picture's edges and to the cube.
#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <vector>

#include "render/legend.h"
#include "render/orientation_marker.h"
#include "render/osmesa_context.h"
#include "render/picture.h"
#include "render/scene_view.h"
#include "tests/render/fake_frame.h"

namespace hepatica {
namespace {

// A legend in a picture whose vessels fill this box evenly.
class LegendOverVessels {
  public:
    LegendOverVessels(int width, int height, const PictureBox& vessels)
        : width_(width), height_(height), context_(width, height), legend_(*renderer_) {
        context_.window().AddRenderer(renderer_);
        for (double x = vessels.left; x <= vessels.right; x += 5.0)
            for (double y = vessels.bottom; y <= vessels.top; y += 5.0) at_.push_back({x, y, x, y});
    }
    ~LegendOverVessels() { context_.window().RemoveRenderer(renderer_); }
    LegendOverVessels(const LegendOverVessels&) = delete;
    LegendOverVessels& operator=(const LegendOverVessels&) = delete;

    PictureBox box_of(const LegendContent& content, double point, bool rests = true) {
        const Legend::Count count = [this](const std::vector<PictureBox>& boxes) {
            std::vector<int> within;
            for (const PictureBox& box : boxes) within.push_back(within_box(box));
            return within;
        };
        legend_.update(legend_rows(content), {width_, height_, point}, dark_look,
                       rests ? count : Legend::Count());
        return legend_.box();
    }
    bool leaves_out() const { return legend_.leaves_out(); }
    std::vector<std::string> texts() const {
        std::vector<std::string> texts;
        for (const LegendRow& row : legend_.rows()) {
            texts.push_back(row.text);
            for (const auto& [colour, name] : row.beside) texts.push_back(name);
        }
        return texts;
    }
    // The picture, in which the legend is on a ground of this look.
    Picture drawn(const LegendContent& content, const ViewLook& look) {
        renderer_->SetBackground(look.bottom[0], look.bottom[1], look.bottom[2]);
        legend_.update(legend_rows(content), {width_, height_, 1.0}, look, {});
        context_.window().Render();
        return read_picture(context_.window());
    }
    PictureBox box() const { return legend_.box(); }
    double share_hidden() const {
        return static_cast<double>(within_box(legend_.box())) / static_cast<double>(at_.size());
    }

  private:
    int within_box(const PictureBox& box) const {
        int count = 0;
        for (const PictureBox& at : at_)
            count += at.left >= box.left && at.left <= box.right && at.bottom >= box.bottom &&
                     at.bottom <= box.top;
        return count;
    }

    int width_, height_;
    OsmesaContext context_;
    vtkNew<vtkRenderer> renderer_;
    Legend legend_;
    std::vector<PictureBox> at_;
};

LegendContent drug_in_three_systems() {
    LegendContent content;
    content.systems = {VascularSystem::portal, VascularSystem::hepatic, VascularSystem::artery};
    content.injected = true;
    content.drug_time_s = 1.0;
    content.drug_end_s = 30.0;
    return content;
}

double height_of(const PictureBox& box) {
    return box.top - box.bottom;
}

// A second view beside slices, of a patient who is as wide as it.
TEST(SmallLegend, HasAsManyRowsAsHideHardlyAnyVessel) {
    LegendOverVessels legend(217, 340, {30, 120, 190, 230});
    const double drawn = height_of(legend.box_of(drug_in_three_systems(), 1.0));
    EXPECT_LE(legend.share_hidden(), 0.02);
    EXPECT_GT(drawn, 20.0) << "what there is room for";
    EXPECT_TRUE(legend.leaves_out());
    EXPECT_EQ(height_of(legend.box_of(drug_in_three_systems(), 1.0, false)), drawn)
        << "and no more while the picture moves";
}

TEST(SmallLegend, IsLeftOutWhereVesselsFillThePicture) {
    LegendOverVessels legend(160, 120, {0, 0, 160, 120});
    EXPECT_EQ(height_of(legend.box_of(drug_in_three_systems(), 0.75)), 0.0);
}

TEST(SmallLegend, OfAPictureThatIsNotSmallHasAllItsRows) {
    LegendOverVessels legend(640, 480, {0, 0, 640, 480});
    EXPECT_DOUBLE_EQ(height_of(legend.box_of(drug_in_three_systems(), 1.0)), 59.0 + 5.0 * 22.0);
    EXPECT_FALSE(legend.leaves_out());
}

LegendContent three_systems() {
    LegendContent content;
    content.systems = {VascularSystem::portal, VascularSystem::hepatic, VascularSystem::artery};
    return content;
}

// The view beside slices in a window of 1280 x 800: the patient leaves room at its edges alone.
TEST(SmallLegend, NamesColoursBesideEachOtherWhereTheyWouldHideVessels) {
    LegendOverVessels legend(490, 325, {60, 60, 460, 270});
    EXPECT_DOUBLE_EQ(height_of(legend.box_of(three_systems(), 1.0)), 22.0);
    EXPECT_EQ(legend.share_hidden(), 0.0);
    EXPECT_LE(legend.box().right, 490.0);
    EXPECT_FALSE(legend.leaves_out());
    EXPECT_DOUBLE_EQ(height_of(legend.box_of(three_systems(), 1.0, false)), 22.0)
        << "also while the picture moves";
    LegendContent more = three_systems();
    more.tumours = more.torn = true;
    LegendOverVessels lower(490, 325, {60, 60, 460, 255});
    EXPECT_DOUBLE_EQ(height_of(lower.box_of(more, 1.0)), 44.0) << "five are two lines";
}

// The same view in a window of 1280 x 800 with bars: the tree reaches its upper edge. What tells
// the vessels apart is never left out.
TEST(SmallLegend, OfNamesLeavesOutWhatWouldHideVesselsInANarrowPicture) {
    LegendContent content;
    content.systems = {VascularSystem::portal, VascularSystem::hepatic};
    content.gaps = true;
    LegendOverVessels legend(437, 280, {80, 60, 380, 280});
    const double drawn = height_of(legend.box_of(content, 0.93));
    EXPECT_LE(legend.share_hidden(), 0.12);
    EXPECT_TRUE(legend.leaves_out());
    EXPECT_EQ(legend.texts(),
              (std::vector<std::string>{"Portal vein", "Hepatic veins", "and 1 more"}));
    EXPECT_EQ(height_of(legend.box_of(content, 0.93, false)), drawn)
        << "and no more while the picture moves";
    LegendOverVessels aside(437, 280, {20, 60, 80, 280});
    aside.box_of(content, 0.93);
    EXPECT_FALSE(aside.leaves_out()) << "there is room";
}

TEST(SmallLegend, NamesColoursBelowEachOtherWhereThereIsRoom) {
    LegendOverVessels aside(490, 325, {60, 60, 300, 270}), wide(700, 325, {60, 60, 680, 270});
    for (LegendOverVessels* legend : {&aside, &wide})
        EXPECT_DOUBLE_EQ(height_of(legend->box_of(three_systems(), 1.0)), 66.0);
    EXPECT_EQ(aside.share_hidden(), 0.0);
}

// The swatch of each name is in its colour, and no name lies on another.
TEST(SmallLegend, DrawsEachOfTheColoursThatStandBesideEachOther) {
    LegendOverVessels legend(490, 325, {60, 60, 460, 270});
    legend.box_of(three_systems(), 1.0);
    const Picture drawn = legend.drawn(three_systems(), dark_look);
    const PictureBox box = legend.box();
    int before = static_cast<int>(box.left) - 1;
    for (const VascularSystem system : three_systems().systems) {
        const Colour colour = palette::vessel_system(system);
        int found = -1;
        for (int x = before + 1; x < static_cast<int>(box.right) && found < 0; ++x) {
            const int row = 325 - 1 - static_cast<int>(box.bottom + 22.0 - 16.0 + 6.0);
            const auto first =
                3 * (static_cast<std::size_t>(row) * 490 + static_cast<std::size_t>(x));
            bool same = true;
            for (std::size_t c = 0; c < 3; ++c)
                same &= std::abs(drawn.rgb[first + c] - 255.0 * colour[c]) < 3.0;
            if (same) found = x;
        }
        ASSERT_GE(found, 0) << "behind " << before;
        before = found;
    }
}

// In a row of its own: behind a name it would read as a name that is cut off.
TEST(SmallLegend, SaysHowManyRowsAreLeftOut) {
    using Texts = std::vector<std::string>;
    LegendContent one;
    one.systems = {VascularSystem::hepatic};
    LegendContent three = one;
    three.touched = three.gaps = true;  // their rows are minor ones
    LegendOverVessels legend(320, 110, {});
    legend.box_of(one, 1.0);
    EXPECT_FALSE(legend.leaves_out());
    EXPECT_EQ(legend.texts(), Texts{"Hepatic veins"});
    legend.box_of(three, 1.0);
    EXPECT_TRUE(legend.leaves_out());
    EXPECT_EQ(legend.texts(), (Texts{"Hepatic veins", "and 2 more"}));
    LegendOverVessels low(320, 80, {});
    low.box_of(three, 1.0);
    EXPECT_TRUE(low.leaves_out());
    EXPECT_EQ(low.texts(), Texts{"Hepatic veins"}) << "there is no room for a second row";
}

// The view beside slices at 2560 x 1600 with two pixels to a point, filled by the vessels.
TEST(SmallLegend, KeepsSystemsAndPlacesOfTheLessonWhateverTheyHide) {
    LegendContent content;
    content.systems = {VascularSystem::portal, VascularSystem::hepatic};
    content.tumours = content.gaps = content.places = content.torn = true;
    LegendOverVessels legend(880, 560, {0, 0, 880, 560});
    legend.box_of(content, 2.0);
    const std::vector<std::string> texts = legend.texts();
    for (const char* kept : {"Portal vein", "Hepatic veins", "A place of the lesson"})
        EXPECT_EQ(std::ranges::count(texts, kept), 1) << kept;
    LegendOverVessels thumbnail(150, 110, {0, 0, 150, 110});
    thumbnail.box_of(content, 1.0);
    EXPECT_TRUE(thumbnail.texts().empty());
}

// One name fewer in one line, and a line that says so, hides more.
TEST(SmallLegend, LeavesNothingOutWhereThatHidesNoLess) {
    LegendContent content = three_systems();
    content.systems.pop_back();
    content.tumours = true;
    LegendOverVessels legend(490, 325, {20, 20, 470, 325});
    legend.box_of(content, 1.0);
    EXPECT_FALSE(legend.leaves_out());
    EXPECT_EQ(legend.texts(), (std::vector<std::string>{"Tumour", "Portal vein", "Hepatic veins"}));
}

// White on a light ground has nothing that sets it off.
TEST(SmallLegend, RimsASwatchThatHardlyDiffersFromTheGround) {
    LegendOverVessels legend(640, 480, {});
    LegendContent content;
    content.injected = true;
    content.drug_end_s = 30.0;  // its last row is that of the white front
    const Picture picture = legend.drawn(content, light_look);
    const PictureBox box = legend.box();
    double most = 1.0;
    const int middle = 480 - static_cast<int>(box.bottom + 22.0 - 16.0 + 6.0);
    for (int x = static_cast<int>(box.left) - 1; x <= static_cast<int>(box.left) + 2; ++x) {
        const std::size_t at =
            3 * (static_cast<std::size_t>(middle) * 640 + static_cast<std::size_t>(x));
        const Colour seen{picture.rgb[at] / 255.0, picture.rgb[at + 1] / 255.0,
                          picture.rgb[at + 2] / 255.0};
        most = std::max(most, palette::contrast(seen, light_look.bottom));
    }
    EXPECT_GE(most, 3.0);
}

TEST(SmallLegend, IsNoHigherThanThePicture) {
    LegendOverVessels legend(320, 240, {});
    LegendContent content = drug_in_three_systems();
    content.tumours = content.target = content.gaps = content.torn = content.bleeds = true;
    content.warned = content.reached_before = true;
    content.segments = {2, 3, 4};
    const PictureBox box = legend.box_of(content, 0.8);
    EXPECT_GE(box.bottom, 0.0);
    EXPECT_LE(box.top, 240.0);
    EXPECT_GT(height_of(box), 120.0);
}

TEST(SmallLegend, LiesBesideTheOrientationCubeOrAboveIt) {
    OsmesaContext context(300, 420);
    SceneView view(context.window());
    Frame frame = testing::fake_frame(0.1);
    frame.drug.arrival_s =
        std::make_shared<const std::vector<float>>(frame.positions_mm.size() / 3, 1.0f);
    frame.drug.end_s = 100.0;
    frame.drug.time_s = 24.0;
    view.show(frame);
    view.zoom_by(0.05);  // so that vessels push it nowhere
    view.render();
    constexpr double room = 420.0 / 600.0;
    const double cube = OrientationMarker::right_edge({300, 420, room});
    const PictureBox box = view.legend_box();
    ASSERT_LT(box.top, 300.0) << "it is at the foot";
    EXPECT_TRUE(box.left >= cube || box.bottom >= cube) << box.left << " " << box.bottom;
}

// A quarter of a small window: what matters most is explained, and half of the picture stays free.
TEST(LegendPicture, LeavesOutWhatMattersLeastWhereThereIsNoRoom) {
    constexpr int width = 430, height = 330;
    OsmesaContext context{width, height};
    SceneView view(context.window());
    Frame frame = fake_frame();
    const std::size_t count = frame.positions_mm.size() / 3;
    std::vector<VascularSystem> systems(count, VascularSystem::portal);
    systems[0] = VascularSystem::hepatic;
    systems[1] = VascularSystem::artery;
    frame.drug.arrival_s = std::make_shared<const std::vector<float>>(count, 90.0f);
    frame.drug.end_s = 100.0;
    frame.drug.time_s = 1.0;
    view.show(frame);
    view.set_vertex_systems(systems);
    view.render();
    const double drawn = view.legend_box().top - view.legend_box().bottom;
    EXPECT_LE(drawn, 0.5 * height);
    EXPECT_GE(drawn, 59.0 + 3.0 * 22.0) << "the drug's scale and three systems";
}

// As two recordings beside each other leave it.
TEST(LegendPicture, InANarrowPictureNothingRunsTogetherAndNothingIsCut) {
    OsmesaContext context{300, 420};
    SceneView view(context.window());
    view.set_words([](const std::string& english) {
        return english == "Drug arrival (s)" ? std::string("Ankunft des Wirkstoffs (s), lang")
               : english.starts_with("now")  ? std::string("jetzt 24")
                                             : english;
    });
    view.set_caption("A recording with a long name, 26 Nov 2026, 03:40");
    Frame frame = fake_frame(0.1);
    frame.drug.arrival_s =
        std::make_shared<const std::vector<float>>(frame.positions_mm.size() / 3, 1.0f);
    frame.drug.end_s = 100.0;
    frame.drug.time_s = 24.0;
    view.show(frame);
    view.render();
    const PictureBox box = view.legend_box();
    EXPECT_GE(box.left, 0.0);
    EXPECT_LE(box.right, 300.0);
    EXPECT_LE(box.top, 420.0 - 22.0) << "the name stands above it";
    EXPECT_TRUE(view.shows_caption());
}

}  // namespace
}  // namespace hepatica
