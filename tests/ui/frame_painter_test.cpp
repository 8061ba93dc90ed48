// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a report: the colours of a torn body.
#include "app/report/frame_painter.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

namespace hepatica {
namespace {

constexpr float never = std::numeric_limits<float>::infinity();

// One triangle of a body with three vertices; vertex 3 was split off from vertex 0.
Frame triangle(int corner) {
    Frame frame;
    frame.positions_mm = {0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0, 0};
    frame.surface = std::make_shared<const std::vector<std::array<int, 3>>>(
        std::vector<std::array<int, 3>>{{corner, 1, 2}});
    frame.tear.emplace();
    frame.tear->origins = std::make_shared<const std::vector<int>>(std::vector<int>{0, 1, 2, 0});
    frame.drug.time_s = 1.0;
    frame.drug.end_s = 4.0;
    return frame;
}

// Three values; the fourth is in memory, but not in the vector.
std::shared_ptr<const std::vector<float>> three_of(std::vector<float> values) {
    values.pop_back();
    return std::make_shared<const std::vector<float>>(std::move(values));
}

QImage picture_of(const Frame& frame) {
    return paint(frame,
                 {200, 200, {Vec3::Zero(), Vec3(100, 1, 100)}, {VascularSystem::portal}, {}});
}

TEST(FramePainter, ColoursWhatWasSplitOffAsWhatItComesFrom) {
    const auto drug_at_0 = three_of({0.25F, never, never, never});
    const auto no_drug = three_of({never, never, never, 0.25F});
    const auto load_at_0 = three_of({1.0F, 0.0F, 0.0F, 0.0F});
    const QImage plain = picture_of(triangle(0));
    EXPECT_EQ(picture_of(triangle(3)), plain);

    Frame whole = triangle(0), torn = triangle(3);
    whole.drug.arrival_s = torn.drug.arrival_s = drug_at_0;
    EXPECT_NE(picture_of(whole), plain);
    EXPECT_EQ(picture_of(torn), picture_of(whole));
    torn.drug.arrival_s = no_drug;
    EXPECT_EQ(picture_of(torn), plain);

    whole = triangle(0), torn = triangle(3);
    whole.tear->loads = torn.tear->loads = load_at_0;
    EXPECT_NE(picture_of(whole), plain);
    EXPECT_EQ(picture_of(torn), picture_of(whole));
}

TEST(FramePainter, ColoursWhatAnInjectionBeforeHasReached) {
    Frame frame = triangle(0);
    frame.drug.arrival_s = three_of({0.25F, never, never, never});
    const QImage present = picture_of(frame);
    frame.drug.arrival_s = three_of({never, never, never, never});
    const QImage plain = picture_of(frame);
    frame.drug.reached_before =
        std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{1, 0, 0, 0});
    EXPECT_NE(picture_of(frame), plain);
    EXPECT_NE(picture_of(frame), present);
    frame.drug.arrival_s = three_of({0.25F, never, never, never});
    EXPECT_EQ(picture_of(frame), present);
}

// Where the drug went elsewhere can be told only beside where it was to go.
TEST(FramePainter, ColoursTheTargetUntilTheDrugHasReachedIt) {
    const auto with_target = [](const Frame& frame) {
        return paint(
            frame,
            {200, 200, {Vec3::Zero(), Vec3(100, 1, 100)}, {VascularSystem::portal}, {}, {1, 0, 0}});
    };
    EXPECT_NE(with_target(triangle(0)), picture_of(triangle(0)));
    EXPECT_EQ(with_target(triangle(3)), with_target(triangle(0))) << "what was split off, too";
    Frame reached = triangle(0);
    reached.drug.arrival_s = three_of({0.25F, never, never, never});
    EXPECT_EQ(with_target(reached), picture_of(reached));
}

}  // namespace
}  // namespace hepatica
