// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever was put onto a tape, it stays within its memory and finds the frame of every moment.
#include "core/lesson/review_tape.h"

#include <gtest/gtest.h>

#include <thread>

namespace hepatica {
namespace {

Frame frame_of(int number, std::size_t coordinates = 300) {
    Frame frame;
    frame.step = static_cast<std::uint64_t>(number);
    frame.positions_mm.assign(coordinates, static_cast<float>(number));
    return frame;
}

std::uint64_t step_at(const ReviewTape& tape, double at_s) {
    return tape.at(at_s)->step;
}

TEST(ReviewTape, FindsTheFrameOfEveryMoment) {
    ReviewTape tape;
    EXPECT_EQ(tape.at(0.0), nullptr);
    EXPECT_EQ(tape.end_s(), 0.0);
    for (int k = 0; k < 10; ++k) tape.add(0.5 * k, frame_of(k));
    EXPECT_EQ(step_at(tape, -1.0), 0u);
    EXPECT_EQ(step_at(tape, 0.0), 0u);
    EXPECT_EQ(step_at(tape, 0.49), 0u);
    EXPECT_EQ(step_at(tape, 0.5), 1u);
    EXPECT_EQ(step_at(tape, 4.4), 8u);
    EXPECT_EQ(step_at(tape, 99.0), 9u);
    EXPECT_EQ(tape.end_s(), 4.5);
    EXPECT_EQ(tape.size(), 10u);
}

TEST(ReviewTape, WhileTheClockIsHeldTheLastFrameStays) {
    ReviewTape tape;
    for (int k = 0; k < 5; ++k) tape.add(k < 2 ? 0.1 * k : 0.1, frame_of(k));
    EXPECT_EQ(tape.size(), 2u);
    EXPECT_EQ(step_at(tape, 0.1), 4u);
}

TEST(ReviewTape, KeepsFewerFramesEvenlyRatherThanMoreMemory) {
    constexpr std::size_t coordinates = 5000, bytes = coordinates * sizeof(float) + sizeof(Frame);
    ReviewTape tape(20 * bytes);
    for (int k = 0; k < 1000; ++k) {
        tape.add(k, frame_of(k, coordinates));
        EXPECT_LE(tape.size(), 20u);
        EXPECT_EQ(tape.end_s(), k);
        EXPECT_EQ(step_at(tape, k), static_cast<std::uint64_t>(k)) << "the newest is always there";
        EXPECT_EQ(step_at(tape, 0.0), 0u);
    }
    EXPECT_GE(tape.size(), 10u);
    constexpr int stride = 64;
    for (int k = 0; k < 999; ++k)
        EXPECT_EQ(step_at(tape, k), static_cast<std::uint64_t>(k / stride * stride));
}

// However often the clock is held, what stays is evenly spaced in time.
TEST(ReviewTape, FramesOfOneTimeCountOnce) {
    constexpr std::size_t coordinates = 5000, bytes = coordinates * sizeof(float) + sizeof(Frame);
    ReviewTape tape(20 * bytes);
    for (int k = 0; k < 200; ++k)
        for (int again = 0; again < 1 + k % 3; ++again) tape.add(k, frame_of(k, coordinates));
    int stride = 1;
    while (stride < 199 && step_at(tape, stride) == 0) ++stride;
    EXPECT_GT(stride, 4);
    EXPECT_LT(stride, 100);
    for (int k = 0; k < 199; ++k)
        EXPECT_EQ(step_at(tape, k), static_cast<std::uint64_t>(k / stride * stride));
}

// A bound below two frames still shows where it began and where it is.
TEST(ReviewTape, KeepsTheFirstAndTheNewestWhateverTheBound) {
    ReviewTape tape(0);
    for (int k = 0; k < 300; ++k) tape.add(k, frame_of(k));
    EXPECT_EQ(tape.size(), 2u);
    EXPECT_EQ(step_at(tape, 298.0), 0u);
    EXPECT_EQ(step_at(tape, 299.0), 299u);
}

TEST(ReviewTape, IsLookedAtWhileItIsFilled) {
    constexpr std::size_t coordinates = 1000;
    ReviewTape tape(50 * (coordinates * sizeof(float) + sizeof(Frame)));
    std::jthread filling([&] {
        for (int k = 0; k < 5000; ++k) {
            tape.add(k, frame_of(k, coordinates));
            if (k % 100 == 0) tape.note({double(k), PlayEventKind::tool, "Touched"});
        }
    });
    double last_s = 0.0;
    while (last_s < 4999.0) {
        const double end_s = tape.end_s();
        EXPECT_GE(end_s, last_s);
        last_s = end_s;
        if (const auto frame = tape.at(end_s / 2)) {
            EXPECT_LE(frame->step, static_cast<std::uint64_t>(end_s / 2));
            EXPECT_EQ(frame->positions_mm.back(), static_cast<float>(frame->step));
        }
    }
    EXPECT_EQ(tape.events().size(), 50u);
}

}  // namespace
}  // namespace hepatica
