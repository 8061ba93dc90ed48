// SPDX-License-Identifier: GPL-3.0-or-later
// The governor against a machine whose costs are known.
#include "core/session/quality_governor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hepatica {
namespace {

const std::vector<double> front{2.0, 4.0, 8.0, 16.0, 32.0};  // as measured somewhere
const std::vector<double> front_errors{0.5, 0.25, 0.12, 0.06, 0.03};
constexpr double budget_ms = 16.0;

// Where the dial stands after so many frames on a machine that is `slowness` times as slow, and how
// often it was turned on the way.
struct Play {
    std::size_t at;
    int turns = 0;

    void frames(QualityGovernor& governor, int count, double slowness) {
        for (int i = 0; i < count; ++i) {
            const std::size_t next = governor.next(at, slowness * front[at], budget_ms);
            if (next != at) ++turns;
            at = next;
        }
    }
};

TEST(QualityGovernor, BeginsWithTheMostAccurateThatFits) {
    const QualityGovernor governor(front, front_errors);
    EXPECT_EQ(governor.start(budget_ms), 2u);
    EXPECT_EQ(governor.start(1000.0), 4u);
    EXPECT_EQ(governor.start(0.1), 0u);
}

TEST(QualityGovernor, StepsDownAtOnceWhenTheMachineFallsBehind) {
    QualityGovernor governor(front, front_errors);
    Play play{2};
    play.frames(governor, 20, 6.0);  // 48 ms instead of 8
    EXPECT_EQ(play.at, 0u);
    EXPECT_EQ(play.turns, 1);
}

TEST(QualityGovernor, StepsUpWhereThereIsRoomAndStaysThere) {
    QualityGovernor governor(front, front_errors);
    Play play{0};
    play.frames(governor, 1000, 0.3);
    EXPECT_EQ(play.at, 4u);  // 9.6 ms
    EXPECT_EQ(play.turns, 4);
    play.frames(governor, 1000, 0.3);
    EXPECT_EQ(play.turns, 4);
}

// One frame that waited for another program is no reason to turn.
TEST(QualityGovernor, OverlooksSingleLateFrames) {
    QualityGovernor governor(front, front_errors);
    std::size_t at = 2;
    for (int i = 0; i < 500; ++i) {
        at = governor.next(at, i % 7 == 0 ? 100.0 : 12.0, budget_ms);
        EXPECT_EQ(at, 2u);
    }
}

// The front's ratios promise more than this body keeps: 8 ms are 20 here. It tries, and tries less
// and less often.
TEST(QualityGovernor, DoesNotSwingWhereTheForecastIsWrong) {
    QualityGovernor governor(front, front_errors);
    std::size_t at = 1;
    int turns = 0, late = 0;
    constexpr int minutes = 10, frames = 60 * 60 * minutes;
    for (int i = 0; i < frames; ++i) {
        const double ms = at >= 2 ? 20.0 : 5.0;
        late += ms > budget_ms ? 1 : 0;
        const std::size_t next = governor.next(at, ms, budget_ms);
        turns += next != at ? 1 : 0;
        at = next;
    }
    EXPECT_LE(turns, 24);
    EXPECT_LT(late, frames / 100);
}

// Shares of a budget of 10 ms: 8 keep the machine busy enough to stay, 7 leave room to go up.
TEST(QualityGovernor, WhatJustFitsFits) {
    // Each setting misses half of what the one before it does.
    const auto governor_of = [](const std::vector<double>& front_ms) {
        std::vector<double> halves;
        for (std::size_t i = 0; i < front_ms.size(); ++i) halves.push_back(std::pow(0.5, i));
        return QualityGovernor(front_ms, halves);
    };
    const auto after = [&](const std::vector<double>& front_ms, std::size_t at, double frame_ms) {
        QualityGovernor governor = governor_of(front_ms);
        for (int i = 0; i < 80; ++i)
            if (const std::size_t next = governor.next(at, frame_ms, 10.0); next != at) return next;
        return at;
    };
    EXPECT_EQ(governor_of({1.0, 8.0}).start(10.0), 1u);
    EXPECT_EQ(governor_of({1.0, 8.1}).start(10.0), 0u);
    EXPECT_EQ(after({1.0, 2.0}, 0, 3.5), 1u);
    EXPECT_EQ(after({1.0, 2.0}, 0, 3.6), 0u);
    EXPECT_EQ(after({1.0, 2.0, 4.0}, 2, 10.0), 2u) << "all of the budget, and no more";
    EXPECT_EQ(after({1.0, 2.0, 4.0}, 2, 16.0), 1u);
    EXPECT_EQ(after({1.0, 2.0, 4.0}, 2, 16.1), 0u);
}

// The dearer of two settings that miss the same is at the other end of the dial, and worth nothing:
// it is never chosen, however much time is left or is lacking.
TEST(QualityGovernor, StaysWithTheCheaperOfTwoThatMissTheSame) {
    const std::vector<double> alike{0.0135, 0.0134};
    QualityGovernor governor({2.0, 12.0}, alike);
    EXPECT_EQ(governor.start(1000.0), 0u);
    for (int i = 0; i < 1000; ++i)
        ASSERT_EQ(governor.next(0, i % 200 < 100 ? 0.1 : 40.0, budget_ms), 0u);
    // Where a person had set the dearer one, it is left where it is late, and for the cheaper one.
    std::size_t at = 1;
    for (int i = 0; i < 20 && at == 1; ++i) at = governor.next(at, 40.0, budget_ms);
    EXPECT_EQ(at, 0u);
    // Between others it is passed over in both directions.
    Play play{1};
    QualityGovernor of_three({2.0, 4.0, 6.0, 8.0}, {0.2, 0.1, 0.098, 0.05});
    for (int i = 0; i < 200; ++i) {
        const std::size_t next = of_three.next(play.at, 1.0, budget_ms);
        ASSERT_NE(next, 2u);
        play.at = next;
    }
    EXPECT_EQ(play.at, 3u);
    for (int i = 0; i < 200; ++i) {
        const std::size_t next = of_three.next(play.at, play.at == 3 ? 20.0 : 10.0, budget_ms);
        ASSERT_NE(next, 2u);
        play.at = next;
    }
    EXPECT_EQ(play.at, 1u);
}

TEST(QualityGovernor, HasNothingToChooseOnADialOfOneSetting) {
    QualityGovernor governor({5.0}, {0.1});
    for (const double ms : {1.0, 100.0})
        for (int i = 0; i < 100; ++i) EXPECT_EQ(governor.next(0, ms, budget_ms), 0u);
}

}  // namespace
}  // namespace hepatica
