// SPDX-License-Identifier: GPL-3.0-or-later
// The legend says what is shown and nothing else, in letters that can be read, beside the vessels.
#include "render/legend.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "render/osmesa_context.h"
#include "render/scene_view.h"
#include "tests/render/fake_frame.h"

namespace hepatica {
namespace {

using testing::fake_frame;

std::vector<std::string> texts_of(const LegendContent& content) {
    std::vector<std::string> texts;
    for (const LegendRow& row : legend_rows(content)) texts.push_back(row.text);
    return texts;
}

LegendContent content_of(const Frame& frame, bool warnings = false) {
    LegendContent content;
    set_frame_shown(content, frame, warnings);
    return content;
}

TEST(LegendRows, NameTheSystemsThatThePatientHas) {
    LegendContent content;
    set_colours_shown(content, {}, {});
    EXPECT_EQ(texts_of(content), std::vector<std::string>{"Unknown system"});
    set_colours_shown(
        content, {VascularSystem::hepatic, VascularSystem::portal, VascularSystem::hepatic}, {});
    EXPECT_EQ(texts_of(content), (std::vector<std::string>{"Portal vein", "Hepatic veins"}));
    const std::vector<LegendRow> rows = legend_rows(content);
    EXPECT_EQ(rows[0].colours, std::vector{palette::vessel_system(VascularSystem::portal)});
    EXPECT_EQ(rows[1].colours, std::vector{palette::vessel_system(VascularSystem::hepatic)});
    content.bright = true;
    EXPECT_EQ(legend_rows(content)[0].colours,
              std::vector{palette::vessel_system(VascularSystem::portal, true)});
    content.bright = false;
    set_colours_shown(content, {VascularSystem::artery}, {});
    EXPECT_EQ(texts_of(content), std::vector<std::string>{"Artery"});
}

TEST(LegendRows, NameTumoursWhereThereAreAny) {
    LegendContent content;
    set_colours_shown(content, {VascularSystem::portal}, {});
    content.tumours = true;
    EXPECT_EQ(texts_of(content), (std::vector<std::string>{"Tumour", "Portal vein"}));
    EXPECT_EQ(legend_rows(content)[0].colours, std::vector{palette::tumour});
    content.injected = true;
    content.drug_end_s = 1.0;
    EXPECT_EQ(texts_of(content)[0], "Tumour") << "also while a drug is shown";
}

TEST(LegendRows, NameTheBloodWhileItRuns) {
    Frame frame;
    frame.tear.emplace();
    EXPECT_EQ(texts_of(content_of(frame)), std::vector<std::string>{});
    frame.tear->leaks = {{Vec3::Zero(), 1.0}};
    EXPECT_EQ(texts_of(content_of(frame)), std::vector<std::string>{}) << "nothing was lost yet";
    frame.tear->leaked_g = 0.5;
    EXPECT_EQ(texts_of(content_of(frame)), std::vector<std::string>{"Blood (1/10 of the volume)"});
}

// A vessel in the colour of its segment is not in that of its system.
TEST(LegendRows, NumberTheLiversSegmentsInTheirColours) {
    LegendContent content;
    set_colours_shown(content,
                      {VascularSystem::portal, VascularSystem::portal, VascularSystem::artery},
                      {7, 2, 0});
    EXPECT_EQ(texts_of(content), (std::vector<std::string>{"Liver segment", "Artery"}));
    const LegendRow bar = legend_rows(content)[0];
    EXPECT_EQ(bar.colours, (std::vector{palette::liver_segment(2), palette::liver_segment(7)}));
    ASSERT_EQ(bar.ticks.size(), 2u);
    EXPECT_EQ(bar.ticks[0], std::pair(0.25, std::string("II")));
    EXPECT_EQ(bar.ticks[1], std::pair(0.75, std::string("VII")));
    set_colours_shown(content, {VascularSystem::portal}, {7});
    EXPECT_EQ(texts_of(content), std::vector<std::string>{"Liver segment VII"});
}

// Colour, axis and mark go with the square root of the arrival time, and the axis says so.
TEST(LegendRows, ShowTheDrugAboveTheSystems) {
    LegendContent content = content_of(fake_frame(0.0, 0.8));  // of 3.2 s
    content.systems = {VascularSystem::portal};
    EXPECT_EQ(texts_of(content),
              (std::vector<std::string>{"Drug arrival (s)", "axis: square root of time",
                                        "The drug's front", "Portal vein"}));
    const LegendRow ramp = legend_rows(content)[0];
    EXPECT_EQ(ramp.at_right, "now 0.8");
    EXPECT_DOUBLE_EQ(ramp.marker.value(), 0.5);
    for (const auto& [place, label] : ramp.ticks)
        EXPECT_NEAR(std::stod(label), 3.2 * place * place, 0.05) << label;
    EXPECT_EQ(ramp.ticks.size(), 5u);
    EXPECT_EQ(ramp.colours.front(), palette::drug(0.5 / 48));
    EXPECT_TRUE(std::ranges::is_sorted(ramp.colours, {}, [](const Colour& colour) {
        return 0.21 * colour[0] + 0.72 * colour[1] + 0.07 * colour[2];
    })) << "a perceptual ramp";
}

// What the drug has not reached keeps its colour in the picture, and its entry.
TEST(LegendRows, NameASystemUntilTheDrugCoversAllOfIt) {
    constexpr auto portal = VascularSystem::portal, hepatic = VascularSystem::hepatic;
    constexpr float never = std::numeric_limits<float>::infinity();
    DrugView drug;
    drug.arrival_s = std::make_shared<const std::vector<float>>(std::vector{1.0f, 2.0f, never});
    LegendContent content;
    const auto systems_at = [&](double time_s) {
        drug.time_s = time_s;
        set_colours_shown(content, {portal, portal, hepatic}, {}, drug);
        return content.systems;
    };
    EXPECT_EQ(systems_at(0.5), (std::vector{portal, hepatic}));
    EXPECT_EQ(systems_at(1.5), (std::vector{portal, hepatic})) << "half of it";
    EXPECT_EQ(systems_at(2.0), std::vector{hepatic});
    set_colours_shown(content, {portal, portal, hepatic}, {2, 7, 0}, drug);
    EXPECT_TRUE(content.segments.empty());
    drug.time_s = 1.5;
    set_colours_shown(content, {portal, portal, hepatic}, {2, 7, 0}, drug);
    EXPECT_EQ(content.segments, std::vector{7});
    EXPECT_EQ(content.systems, std::vector{hepatic});
    set_colours_shown(content, {}, {}, drug);
    EXPECT_EQ(content.systems, std::vector{VascularSystem::unknown});
    drug.arrival_s = std::make_shared<const std::vector<float>>(3, 1.0f);
    set_colours_shown(content, {}, {}, drug);
    EXPECT_TRUE(content.systems.empty());
}

// Each is named while its colour is seen, and no longer.
TEST(LegendRows, NameTargetAndHighlightWhereTheyAreSeen) {
    LegendContent content;
    const auto texts = [&](const std::vector<std::uint8_t>& target,
                           const std::vector<std::uint8_t>& highlight, const DrugView& drug = {}) {
        set_highlights_shown(content, target, highlight, drug);
        return texts_of(content);
    };
    using Texts = std::vector<std::string>;
    EXPECT_EQ(texts({}, {}), Texts{});
    EXPECT_EQ(texts({0, 0}, {0, 0, 0}), Texts{});
    EXPECT_EQ(texts({0, 1}, {}), Texts{"Target of the drug"});
    EXPECT_EQ(legend_rows(content)[0].colours, std::vector{palette::drug_target()});
    EXPECT_EQ(texts({}, {0, 0, 1}), Texts{"Downstream of the pointer"});
    EXPECT_EQ(legend_rows(content)[0].colours, std::vector{palette::highlight()});
    EXPECT_EQ(texts({0, 1}, {0, 1}), Texts{"Target, downstream of the pointer"});
    EXPECT_EQ(legend_rows(content)[0].colours, std::vector{palette::lit_drug_target()});
    EXPECT_EQ(texts({1, 1}, {0, 1, 1}),
              (Texts{"Target of the drug", "Target, downstream of the pointer",
                     "Downstream of the pointer"}));
    content.bright = true;
    EXPECT_EQ(legend_rows(content)[0].colours, std::vector{palette::drug_target(true)});
    content.lit_branch = true;
    EXPECT_EQ(texts({1, 1}, {0, 1, 1}),
              (Texts{"Target of the drug", "Target, in the chosen branch", "The chosen branch"}));
    DrugView drug;
    drug.arrival_s = std::make_shared<const std::vector<float>>(std::vector{1.0f, 2.0f, 3.0f});
    drug.time_s = 2.0;
    EXPECT_EQ(texts({1, 1}, {0, 1, 1}, drug), Texts{"The chosen branch"}) << "the drug covers it";
}

TEST(LegendRows, NameWhatAnInjectionBeforeHasReachedUntilThePresentOneCoversIt) {
    DrugView drug;
    drug.arrival_s = std::make_shared<const std::vector<float>>(std::vector{1.0f, 2.0f, 3.0f});
    drug.time_s = 0.5;
    LegendContent content;
    const auto texts = [&] {
        set_colours_shown(content, std::vector(3, VascularSystem::portal), {}, drug);
        set_highlights_shown(content, {0, 1, 0}, {}, drug);
        return texts_of(content);
    };
    using Texts = std::vector<std::string>;
    EXPECT_EQ(texts(), (Texts{"Target of the drug", "Portal vein"}));
    drug.reached_before =
        std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{1, 1, 0});
    EXPECT_EQ(texts(), (Texts{"Reached by an earlier injection", "Portal vein"}));
    EXPECT_EQ(legend_rows(content)[0].colours, std::vector{palette::reached_before()});
    drug.time_s = 2.0;
    EXPECT_EQ(texts(), Texts{"Portal vein"});
    drug = {};
    EXPECT_EQ(texts(), (Texts{"Target of the drug", "Portal vein"}));
}

TEST(LegendRows, SayWhatGreenAndRedMeanWhereTheyAreShown) {
    EXPECT_FALSE(content_of(fake_frame()).touched);
    EXPECT_TRUE(content_of(testing::touched_frame()).touched);
    Frame pulled = fake_frame();
    pulled.grab = GrabView{};
    EXPECT_TRUE(content_of(pulled).touched);
    Frame near_tearing = fake_frame();
    near_tearing.tear = TearView{};
    EXPECT_FALSE(content_of(near_tearing, true).warned);
    near_tearing.tear->loads = std::make_shared<const std::vector<float>>(9, 0.8f);
    EXPECT_TRUE(content_of(near_tearing, true).warned);
    EXPECT_FALSE(content_of(near_tearing, false).warned) << "no colour shows it";
    EXPECT_FALSE(content_of(near_tearing, true).torn) << "nothing has given way yet";
    Frame lined = near_tearing;
    lined.tear->weak_edges = std::make_shared<const std::vector<std::array<int, 2>>>();
    EXPECT_FALSE(content_of(near_tearing, false).lined);
    ASSERT_TRUE(content_of(lined, false).lined);
    const LegendContent with_line = content_of(lined, false);
    EXPECT_EQ(texts_of(with_line)[0], "Cut line, not torn yet");
    EXPECT_EQ(legend_rows(with_line)[0].colours, std::vector{palette::weak_line()});
    near_tearing.tear->joints_broken = 3;
    LegendContent content = content_of(near_tearing, true);
    content.systems = {VascularSystem::portal};
    EXPECT_EQ(texts_of(content),
              (std::vector<std::string>{"Cut or torn", "Inside of what is torn",
                                        "Load (% of what tears)", "Portal vein"}));
    EXPECT_EQ(legend_rows(content)[0].colours, std::vector{palette::torn});
    content.touched = content.gaps = content.places = true;
    EXPECT_EQ(
        texts_of(content),
        (std::vector<std::string>{
            "Touch and force", "A place of the lesson", "What may be a vessel, and how sure",
            "Cut or torn", "Inside of what is torn", "Load (% of what tears)", "Portal vein"}));
    EXPECT_EQ(legend_rows(content)[0].colours, std::vector{palette::touch});
    EXPECT_EQ(legend_rows(content)[1].colours, std::vector{palette::torn_circle});
    EXPECT_EQ(legend_rows(content)[2].colours, std::vector{palette::bridge});
    content.places = false;
    content.places_reached = true;
    EXPECT_EQ(texts_of(content)[1], "A place that is reached");
    EXPECT_EQ(legend_rows(content)[1].colours, std::vector{palette::reached});
}

// A short branch between wide ones has no vertex of its own.
TEST(LegendRows, NameTheChosenBranchWhereItsLineAloneIsSeen) {
    LegendContent content;
    content.branch_line = true;
    EXPECT_EQ(texts_of(content), std::vector<std::string>{"The chosen branch"});
    EXPECT_EQ(legend_rows(content)[0].colours, std::vector{palette::chosen_branch()});
    EXPECT_FALSE(legend_rows(content)[0].passing);
    content.lit = true;  // the pointer is on a vessel meanwhile
    EXPECT_EQ(texts_of(content),
              (std::vector<std::string>{"Downstream of the pointer", "The chosen branch"}));
    EXPECT_TRUE(legend_rows(content)[0].passing);
    content.lit_branch = true;
    EXPECT_EQ(texts_of(content), std::vector<std::string>{"The chosen branch"});
}

// Each label of the bar of loads stands below the colour that a vessel of that load has.
TEST(LegendRows, LabelTheLoadsByTheColoursOfTheVessels) {
    LegendContent content;
    content.warned = true;
    const LegendRow bar = legend_rows(content)[0];
    ASSERT_EQ(bar.ticks.size(), 3u);
    for (const auto& [place, label] : bar.ticks) {
        const Colour on_vessel = palette::warning(palette::vessel_system(VascularSystem::unknown),
                                                  std::stod(label) / 100.0);
        const auto last = static_cast<double>(bar.colours.size() - 1);
        const Colour& in_bar = bar.colours[static_cast<std::size_t>(std::lround(place * last))];
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(in_bar[c], on_vessel[c], 0.05) << label;
    }
    EXPECT_NE(bar.colours.front(), bar.colours.back());
}

// Systems and segments have other colours then; the ramp follows the logarithm.
TEST(LegendRows, LabelTheStretchInsteadOfTheSystems) {
    LegendContent content;
    set_colours_shown(content, {VascularSystem::portal}, {});
    content.segments = {5};
    content.stretched = true;
    const std::vector<LegendRow> rows = legend_rows(content);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].text, "Stretch (length / length at rest)");
    ASSERT_EQ(rows[0].ticks.size(), 4u);
    for (const auto& [place, number] : rows[0].ticks)
        EXPECT_NEAR(place, std::log(std::stod(number)) / std::log(1.6), 1e-9) << number;
    EXPECT_EQ(rows[0].colours.front(),
              palette::stretch(std::pow(1.6, 0.5 / static_cast<double>(rows[0].colours.size()))));
}

TEST(LegendPlace, HasARowMoreForGapsAndForPlaces) {
    OsmesaContext context(800, 600);
    SceneView view(context.window());
    view.show(fake_frame());
    const auto height = [&] {
        view.render();
        return view.legend_box().top - view.legend_box().bottom;
    };
    const double alone = height();
    view.set_bridges({{{Vec3(-20, 0, -20), Vec3(-20, 0, -10)}, "22 %", false}});
    const double with_gaps = height();
    EXPECT_GT(with_gaps, alone);
    view.set_marks({{Vec3(0, 0, 0), "1", false}});
    const double with_place = height();
    EXPECT_GT(with_place, with_gaps);
    view.set_marks({{Vec3(0, 0, 0), "1", true}});
    EXPECT_EQ(height(), with_place) << "the row of reached ones stands for it";
    view.set_marks({{Vec3(0, 0, 0), "1", true}, {Vec3(0, 0, 9), "2", false}});
    EXPECT_GT(height(), with_place);
    view.set_marks({});
    view.set_bridges({});
    EXPECT_EQ(height(), alone);
}

TEST(LegendPlace, IsTheFirstThatIsFreeOrTheFreest) {
    EXPECT_EQ(least_covered({0, 0, 0}), 0u);
    EXPECT_EQ(least_covered({3, 0, 0}), 1u);
    EXPECT_EQ(least_covered({3, 4, 0}), 2u);
    EXPECT_EQ(least_covered({3, 2, 5}), 1u);
}

// Of the vessels in the picture, counted here by the view's own mapping of points to pixels.
int vertices_under_the_legend(const SceneView& view, const Frame& frame, int height) {
    const PictureBox box = view.legend_box();
    int count = 0;
    for (std::size_t v = 0; v < frame.positions_mm.size(); v += 3) {
        const float* at = &frame.positions_mm[v];
        const Pixel pixel = view.pixel_of(Vec3(at[0], at[1], at[2]));
        const double y = height - pixel.y;
        count += pixel.x > box.left && pixel.x < box.right && y > box.bottom && y < box.top;
    }
    return count;
}

TEST(LegendPlace, IsBesideTheVesselsHoweverTheyLie) {
    constexpr int width = 800, height = 600;
    OsmesaContext context(width, height);
    SceneView view(context.window());
    const Frame frame = fake_frame();
    view.show(frame);
    view.render();
    const PictureBox at_first = view.legend_box();
    EXPECT_GT(at_first.right - at_first.left, 60.0);
    EXPECT_GT(at_first.left, 0.5 * width);
    EXPECT_LT(at_first.top, 0.5 * height);
    EXPECT_EQ(vertices_under_the_legend(view, frame, height), 0);
    // The tree is led under it: it goes out of the way.
    view.drag_pan({400, 300}, {700, 560});
    view.render();
    EXPECT_NE(view.legend_box().bottom, at_first.bottom);
    EXPECT_EQ(vertices_under_the_legend(view, frame, height), 0);
    // While the picture moves it stays.
    const PictureBox aside = view.legend_box();
    view.set_smoothing(Smoothing::none);
    view.drag_pan({700, 560}, {400, 300});
    view.render();
    EXPECT_EQ(view.legend_box().bottom, aside.bottom);
    view.set_smoothing(Smoothing::best);
    view.render();
    EXPECT_EQ(view.legend_box().bottom, at_first.bottom);
}

// With a graphics card pictures of what moves are as fine as others.
TEST(LegendPlace, StaysWhileThePictureMovesHoweverFineItIs) {
    OsmesaContext context(800, 600);
    SceneView view(context.window());
    view.show(fake_frame());
    view.render();
    const PictureBox at_first = view.legend_box();
    view.set_moving(true);
    view.drag_pan({400, 300}, {700, 560});
    view.render();
    EXPECT_EQ(view.legend_box().bottom, at_first.bottom);
    view.set_moving(false);
    view.render();
    EXPECT_NE(view.legend_box().bottom, at_first.bottom);
}

TEST(LegendPlace, IsChosenAnewWhereOneLooksFromElsewhereWhileThePictureMoves) {
    constexpr int width = 800, height = 600;
    OsmesaContext context(width, height);
    SceneView view(context.window());
    view.show(fake_frame());
    view.render();
    const PictureBox at_first = view.legend_box();
    view.drag_pan({400, 300}, {700, 560});
    view.render();
    ASSERT_NE(view.legend_box().bottom, at_first.bottom);
    view.set_smoothing(Smoothing::none);
    view.look_from(ViewDirection::anterior);
    view.render();
    EXPECT_EQ(view.legend_box().bottom, at_first.bottom);
}

// It would jump from corner to corner while the mouse goes over vessels.
TEST(LegendPlace, IsNotChosenByARowThatComesAndGoesWithThePointer) {
    OsmesaContext context(800, 600);
    vtkNew<vtkRenderer> renderer;
    context.window().AddRenderer(renderer);
    Legend legend(*renderer);
    // One row has room below the vessels, two have not.
    const Legend::Count count = [](const std::vector<PictureBox>& boxes) {
        std::vector<int> covered;
        for (const PictureBox& box : boxes) covered.push_back(box.bottom < 300 && box.top > 50);
        return covered;
    };
    LegendContent content;
    content.systems = {VascularSystem::portal};
    const auto box_of = [&](const std::vector<LegendRow>& rows) {
        legend.update(rows, {800, 600}, dark_look, count);
        return legend.box();
    };
    const PictureBox alone = box_of(legend_rows(content));
    ASSERT_LT(alone.top, 50.0);
    content.lit = true;
    const PictureBox pointed = box_of(legend_rows(content));
    EXPECT_EQ(pointed.bottom, alone.bottom);
    EXPECT_GT(pointed.top, 50.0);
    content.lit_branch = true;  // which stays
    EXPECT_GT(box_of(legend_rows(content)).bottom, 300.0);
    context.window().RemoveRenderer(renderer);
}

// 12 points of print are 16 of a screen with 96 dots to an inch: a line of the legend is never
// lower, in a quarter of a small window neither, and twice as high where a point has two pixels.
TEST(LegendPlace, HasLettersOfTwelvePointsOfPrint) {
    EXPECT_GE(legend_letters_pt, 16.0);
    const Frame frame = fake_frame();
    const auto height_of_one_row = [&](int width, int height, double pixel_ratio) {
        OsmesaContext context(width, height);
        SceneView view(context.window());
        view.show(frame);
        view.render(pixel_ratio);
        return view.legend_box().top - view.legend_box().bottom;
    };
    const double row = height_of_one_row(870, 680, 1.0);
    EXPECT_GE(row, 16.0);
    EXPECT_DOUBLE_EQ(height_of_one_row(430, 330, 1.0), row);
    EXPECT_DOUBLE_EQ(height_of_one_row(1740, 1360, 2.0), 2.0 * row);
}

TEST(LegendRows, TwoPicturesHaveOneScale) {
    Frame frame = fake_frame(0.1);
    frame.drug.arrival_s = std::make_shared<const std::vector<float>>(3, 1.0f);
    frame.drug.end_s = 10.0;
    LegendContent content;
    set_frame_shown(content, frame, false, 25.0);
    EXPECT_EQ(content.drug_end_s, 25.0);
    set_frame_shown(content, frame, false, 5.0);
    EXPECT_EQ(content.drug_end_s, 10.0);
}

TEST(LegendRows, OfLessRankAreThoseThatExplainThemselves) {
    LegendContent content;
    content.systems = {VascularSystem::portal};
    content.touched = content.places = content.torn = content.injected = true;
    content.drug_end_s = 1.0;
    std::vector<std::string> minor, needed;
    for (const LegendRow& row : legend_rows(content)) {
        if (row.minor) minor.push_back(row.text);
        if (row.needed) needed.push_back(row.text);
    }
    EXPECT_EQ(minor, (std::vector<std::string>{"Touch and force", "Inside of what is torn",
                                               "axis: square root of time", "The drug's front"}));
    EXPECT_EQ(needed, (std::vector<std::string>{"A place of the lesson", "Portal vein"}));
}

}  // namespace
}  // namespace hepatica
