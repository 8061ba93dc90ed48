// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture sends to the graphics card: only what is new.
#include "render/tree_actor.h"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkOpenGLVertexBufferObjectGroup.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "render/osmesa_context.h"
#include "render/palette.h"
#include "tests/render/fake_frame.h"

namespace hepatica {
namespace {

using testing::fake_frame;

class TreeOnCard : public ::testing::TestWithParam<bool> {
  protected:
    TreeOnCard() {
        for (vtkActor* actor : tree_.actors()) renderer_->AddActor(actor);
        context_.window().AddRenderer(renderer_);
        tree_.set_rounded(GetParam());
        tree_.update(first_);
        renderer_->ResetCamera();
        context_.window().Render();
    }
    ~TreeOnCard() override { context_.window().RemoveRenderer(renderer_); }

    vtkActor* shown() {
        for (vtkActor* actor : tree_.actors())
            if (actor->GetVisibility() != 0) return actor;
        return nullptr;
    }
    // The same tree, bent and with its drug further on.
    Frame later(double bend, double drug_time_s) {
        Frame frame = first_;
        frame.positions_mm = fake_frame(bend).positions_mm;
        frame.drug.time_s = drug_time_s;
        return frame;
    }
    // When an array of the surface that is shown was last sent.
    vtkMTimeType sent(const char* array) {
        auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(shown()->GetMapper());
        return mapper->GetVBOs()->GetVBO(array)->GetUploadTime();
    }

    const Frame first_ = fake_frame(0.0, 1.0);
    OsmesaContext context_{64, 48};
    vtkNew<vtkRenderer> renderer_;
    TreeActor tree_;
};

TEST_P(TreeOnCard, takes_no_colours_and_no_times_of_arrival_where_only_the_body_moves) {
    const vtkMTimeType positions = sent("vertexMC");
    const vtkMTimeType colours = sent("scalarColor");
    const vtkMTimeType arrival = sent("arrivalMC");
    tree_.update(later(0.5, 1.0));
    context_.window().Render();
    EXPECT_GT(sent("vertexMC"), positions);
    EXPECT_EQ(sent("scalarColor"), colours);
    EXPECT_EQ(sent("arrivalMC"), arrival);
    tree_.set_highlight({1, 1, 1});
    context_.window().Render();
    EXPECT_GT(sent("scalarColor"), colours);
}

// The frame's bent vertices are stretched; their colours are taken while they move, until the
// stretch is hidden again.
TEST_P(TreeOnCard, takes_colours_with_every_motion_while_the_stretch_is_shown) {
    std::vector<Vec3> rest_mm;
    for (int v = 0; 3 * static_cast<std::size_t>(v) < first_.positions_mm.size(); ++v)
        rest_mm.push_back(first_.place_mm(v));
    tree_.set_rest_positions(rest_mm);
    tree_.set_stretch_shown(true);
    EXPECT_TRUE(tree_.update(first_)) << "the same frame looks different now";
    EXPECT_TRUE(tree_.shows_stretch());
    EXPECT_FALSE(tree_.update(first_));
    context_.window().Render();
    const vtkMTimeType at_rest = sent("scalarColor");
    tree_.update(later(0.5, 1.0));
    context_.window().Render();
    EXPECT_GT(sent("scalarColor"), at_rest);
    tree_.set_stretch_shown(false);
    context_.window().Render();
    const vtkMTimeType hidden = sent("scalarColor");
    tree_.update(later(0.3, 1.0));
    context_.window().Render();
    EXPECT_EQ(sent("scalarColor"), hidden);
    EXPECT_FALSE(tree_.shows_stretch());
}

// The frames of a scene without deformation have other vertices.
TEST_P(TreeOnCard, shows_no_stretch_of_what_has_no_rest_positions) {
    tree_.set_stretch_shown(true);
    EXPECT_FALSE(tree_.update(first_));
    tree_.set_rest_positions({Vec3::Zero(), Vec3::Zero()});
    EXPECT_FALSE(tree_.update(first_));
    EXPECT_FALSE(tree_.shows_stretch());
}

TEST_P(TreeOnCard, takes_colours_where_something_comes_near_its_limit_if_that_is_shown) {
    Frame near_limit = first_;
    near_limit.tear.emplace();
    near_limit.tear->loads =
        std::make_shared<const std::vector<float>>(first_.positions_mm.size() / 3, 0.9f);
    const vtkMTimeType colours = sent("scalarColor");
    EXPECT_FALSE(tree_.update(near_limit));
    context_.window().Render();
    EXPECT_EQ(sent("scalarColor"), colours);
    tree_.set_warnings(true);
    EXPECT_TRUE(tree_.update(near_limit));
    context_.window().Render();
    const vtkMTimeType warned = sent("scalarColor");
    EXPECT_GT(warned, colours);
    EXPECT_FALSE(tree_.update(near_limit));
    tree_.set_warnings(false);
    context_.window().Render();
    EXPECT_GT(sent("scalarColor"), warned);
}

// What was merely split has its own colour until its joint comes apart: no vertex is new then.
TEST_P(TreeOnCard, takes_colours_where_a_joint_comes_apart) {
    const std::size_t vertices = first_.positions_mm.size() / 3;
    std::vector<int> origins(vertices);
    std::iota(origins.begin(), origins.end(), 0);
    Frame split = first_;
    split.tear.emplace();
    split.tear->origins = std::make_shared<const std::vector<int>>(std::move(origins));
    std::vector<std::uint8_t> rims(vertices, 0);
    split.tear->rims = std::make_shared<const std::vector<std::uint8_t>>(rims);
    tree_.update(split);
    const auto colour = [this](vtkIdType vertex) {
        std::array<double, 4> rgba{};
        vtkPolyDataMapper::SafeDownCast(shown()->GetMapper())
            ->GetInput()
            ->GetPointData()
            ->GetScalars()
            ->GetTuple(vertex, rgba.data());
        return rgba;
    };
    const std::array<double, 4> own = colour(0);
    Frame torn = split;
    rims[0] = 1;
    torn.tear->rims = std::make_shared<const std::vector<std::uint8_t>>(rims);
    EXPECT_TRUE(tree_.update(torn));
    EXPECT_NE(colour(0), own);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(colour(0)[c], 255.0 * palette::torn[c], 0.5) << c;
    EXPECT_EQ(colour(30), own) << "of no rim";
    EXPECT_FALSE(tree_.update(torn)) << "the same rims";
}

// The target of a drug stays visible where what lies downstream of the pointer is shown, too.
TEST_P(TreeOnCard, has_colours_of_their_own_for_target_and_highlight) {
    const std::size_t vertices = first_.positions_mm.size() / 3;
    const auto colour_is = [this](vtkIdType vertex, const Colour& expected) {
        std::array<double, 4> rgba{};
        vtkPolyDataMapper::SafeDownCast(shown()->GetMapper())
            ->GetInput()
            ->GetPointData()
            ->GetScalars()
            ->GetTuple(vertex, rgba.data());
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(rgba[c], 255.0 * expected[c], 0.5) << c;
    };
    std::vector<std::uint8_t> target(vertices, 0), highlight(vertices, 0);
    const std::vector<int>& drawn = tree_.surface().frame_vertices();
    const auto of_drawn = [&drawn](std::size_t i) { return static_cast<std::size_t>(drawn[i]); };
    target[of_drawn(0)] = target[of_drawn(1)] = 1;
    highlight[of_drawn(1)] = highlight[of_drawn(2)] = 1;
    for (const bool bright : {false, true}) {
        SCOPED_TRACE(bright);
        tree_.set_bright(bright);
        tree_.set_target(target);
        tree_.set_highlight(highlight);
        colour_is(0, palette::drug_target(bright));
        colour_is(1, palette::lit_drug_target(bright));
        colour_is(2, palette::highlight(bright));
        colour_is(3, palette::vessel_system(VascularSystem::unknown, bright));
        tree_.set_highlight({});
        colour_is(1, palette::drug_target(bright));
        tree_.set_target({});
        colour_is(0, palette::vessel_system(VascularSystem::unknown, bright));
    }
}

// Under the present injection, until the drug is taken away; frames alike send nothing.
TEST_P(TreeOnCard, keeps_a_tint_of_what_an_injection_before_has_reached) {
    const auto colour = [this](vtkIdType vertex) {
        std::array<double, 4> rgba{};
        vtkPolyDataMapper::SafeDownCast(shown()->GetMapper())
            ->GetInput()
            ->GetPointData()
            ->GetScalars()
            ->GetTuple(vertex, rgba.data());
        return rgba;
    };
    const std::array<double, 4> own = colour(0);
    std::vector<std::uint8_t> reached(first_.positions_mm.size() / 3, 0);
    reached[static_cast<std::size_t>(tree_.surface().frame_vertices()[0])] = 1;
    Frame second = first_;
    ++second.drug.version;
    second.drug.reached_before = std::make_shared<const std::vector<std::uint8_t>>(reached);
    EXPECT_TRUE(tree_.update(second));
    context_.window().Render();
    const vtkMTimeType colours = sent("scalarColor");
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(colour(0)[c], 255.0 * palette::reached_before()[c], 0.5) << c;
    EXPECT_EQ(colour(3), own) << "not reached";
    tree_.set_highlight(std::vector<std::uint8_t>(reached.size(), 1));
    tree_.set_target(std::vector<std::uint8_t>(reached.size(), 1));
    EXPECT_NEAR(colour(0)[0], 255.0 * palette::reached_before()[0], 0.5) << "as the drug would";
    tree_.set_highlight({});
    tree_.set_target({});
    context_.window().Render();
    const vtkMTimeType now = sent("scalarColor");
    EXPECT_GT(now, colours);
    EXPECT_FALSE(tree_.update(second));
    second.drug.time_s += 0.5;
    EXPECT_TRUE(tree_.update(second));
    context_.window().Render();
    EXPECT_EQ(sent("scalarColor"), now) << "only the drug runs";
    second.drug = DrugView{};
    EXPECT_TRUE(tree_.update(second));
    EXPECT_EQ(colour(0), own);
}

TEST_P(TreeOnCard, takes_nothing_where_only_the_drug_runs) {
    const vtkMTimeType positions = sent("vertexMC");
    const vtkMTimeType arrival = sent("arrivalMC");
    EXPECT_TRUE(tree_.update(later(0.0, 2.0)));
    context_.window().Render();
    EXPECT_EQ(sent("vertexMC"), positions);
    EXPECT_EQ(sent("arrivalMC"), arrival);
}

TEST_P(TreeOnCard, shows_where_the_body_is_now_when_it_is_rounded_or_no_longer) {
    tree_.update(later(0.5, 1.0));
    tree_.set_rounded(!GetParam());
    context_.window().Render();
    std::array<double, 6> now{}, expected{};
    shown()->GetBounds(now.data());
    TreeActor other;
    other.set_rounded(!GetParam());
    other.update(fake_frame(0.5));
    for (vtkActor* actor : other.actors())
        if (actor->GetVisibility() != 0) actor->GetBounds(expected.data());
    EXPECT_EQ(now, expected);
}

INSTANTIATE_TEST_SUITE_P(PlainAndRounded, TreeOnCard, ::testing::Bool());

}  // namespace
}  // namespace hepatica
