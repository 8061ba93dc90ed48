// SPDX-License-Identifier: GPL-3.0-or-later
// A hand that is heard only now and then: what it holds goes evenly from one place to the next.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/scene/deform_part.h"
#include "core/scene/world.h"
#include "core/session/hand_pace.h"
#include "core/session/led_point.h"
#include "core/session/replay.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"

namespace hepatica {
namespace {

using namespace std::chrono_literals;
using test::keep_recording;
using test::middle_of;
using test::new_session;
using test::play;
using test::small_patient;
using testing::HasSubstr;

constexpr double dt_s = 1.0 / 60.0;

Vec3 hand_of(const Session& session) {
    return session.world().deform()->hand_mm();
}

// A session whose hand holds the vessel, and where.
std::unique_ptr<Session> holding(Vec3& at_mm) {
    auto session = new_session();
    session->post(GrabPoint{middle_of(small_patient()->tree, 1)});
    session->step();
    at_mm = hand_of(*session);
    return session;
}

TEST(LedPoint, GoesEvenlyAndArrives) {
    LedPoint point;
    EXPECT_FALSE(point.underway());
    point.lead_to(Vec3(4, 0, 0), 0.4);
    Vec3 at = Vec3::Zero();
    for (int i = 1; i <= 4; ++i) {
        ASSERT_TRUE(point.underway());
        at = point.next(at, 0.1);
        EXPECT_NEAR(at.x(), i, 1e-12);
    }
    EXPECT_EQ(at, Vec3(4, 0, 0));  // to the last bit
    EXPECT_FALSE(point.underway());
}

TEST(LedHand, IsALittleFurtherInEveryStep) {
    Vec3 begin;
    const auto session = holding(begin);
    const Vec3 target = begin + Vec3(3, -6, 0);
    session->post(MoveGrab{target, 3.0 * dt_s});
    for (int i = 1; i <= 3; ++i) {
        session->step();
        EXPECT_NEAR((hand_of(*session) - begin - i / 3.0 * (target - begin)).norm(), 0.0, 1e-9);
    }
    session->step();
    EXPECT_EQ(hand_of(*session), target);
}

TEST(LedHand, ANewPlaceTakesTheRestOfTheWayFromWhereItIs) {
    Vec3 begin;
    const auto session = holding(begin);
    session->post(MoveGrab{begin + Vec3(4, 0, 0), 4.0 * dt_s});
    session->step();
    session->post(MoveGrab{begin + Vec3(1, 2, 0), 2.0 * dt_s});
    session->step();
    EXPECT_NEAR((hand_of(*session) - begin - Vec3(1, 1, 0)).norm(), 0.0, 1e-9);
    session->post(MoveGrab{begin});  // at once
    session->step();
    EXPECT_EQ(hand_of(*session), begin);
    session->step();
    EXPECT_EQ(hand_of(*session), begin);
}

TEST(LedHand, IsShiftedFromTheVertexThatItGrabbed) {
    const auto session = new_session();
    session->post(ShiftGrab{Vec3(0, 0, 1)});  // holds nothing
    session->step();
    EXPECT_FALSE(session->world().deform()->holding());
    session->post(GrabVertex{0});
    session->step();
    const Vec3 begin = hand_of(*session);
    session->post(ShiftGrab{Vec3(0, 0, 1)});
    session->post(ShiftGrab{Vec3(2, 0, 0)});
    session->step();
    EXPECT_LT((hand_of(*session) - begin - Vec3(2, 0, 1)).norm(), 1e-9);
}

TEST(LedHand, StopsWhereItIsWhenItLetsGoOrTakesAnew) {
    Vec3 begin;
    const auto session = holding(begin);
    session->post(MoveGrab{begin + Vec3(4, 0, 0), 4.0 * dt_s});
    session->step();
    session->post(ReleaseGrab{});
    session->post(GrabPoint{middle_of(small_patient()->tree, 1)});
    session->step();
    const Vec3 anew = hand_of(*session);
    play(*session, 3);
    EXPECT_EQ(hand_of(*session), anew);
    session->post(MoveGrab{anew + Vec3(4, 0, 0), 4.0 * dt_s});
    session->step();
    session->post(ReleaseGrab{});
    EXPECT_EQ(play(*session, 3).paused, false);
    EXPECT_FALSE(session->world().deform()->holding());
}

TEST(LedHand, IsThereAtOnceWhileTimeStands) {
    Vec3 begin;
    const auto session = holding(begin);
    session->post(SetPaused{true});
    session->post(MoveGrab{begin + Vec3(4, 0, 0), 0.5});
    session->step();
    EXPECT_EQ(hand_of(*session), begin + Vec3(4, 0, 0));
}

TEST(LedHand, TheRecordingHoldsEachPieceAndPlaysAgainToTheSameBits) {
    auto session = new_session();
    const auto recording = keep_recording(*session);
    session->post(GrabPoint{middle_of(small_patient()->tree, 1)});
    session->step();
    const Vec3 begin = hand_of(*session);
    session->post(MoveGrab{begin + Vec3(3, 2, 0), 5.0 * dt_s});
    play(*session, 8);
    int pieces = 0;
    for (const RecordedStep& step : recording->steps)
        for (const Command& command : step.commands)
            if (const auto* move = std::get_if<MoveGrab>(&command)) {
                EXPECT_FALSE(move->over_s);
                ++pieces;
            }
    EXPECT_EQ(pieces, 5);
    Job job;
    const ReplayResult again = replay(*recording, small_patient(), job);
    EXPECT_FALSE(again.diverged_at);
    EXPECT_EQ(again.state_hash, recording->steps.back().state_hash);
}

TEST(LedHand, GoesOnWhereWhatCameNextWasRefused) {
    Vec3 begin;
    const auto session = holding(begin);
    const Vec3 target = begin + Vec3(3, -6, 0);
    const Vec3 nowhere = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    session->post(MoveGrab{target, 3.0 * dt_s});
    session->step();
    session->post(GrabPoint{nowhere});
    session->post(GrabVertex{-1});
    session->post(MoveGrab{nowhere});
    session->step();
    session->step();
    session->step();
    EXPECT_EQ(hand_of(*session), target);
}

TEST(LedHand, RefusesATimeOrAPlaceThatIsNone) {
    Vec3 begin;
    const auto session = holding(begin);
    for (const double over_s : {0.0, -1.0, 1.5, std::numeric_limits<double>::quiet_NaN()}) {
        session->post(MoveGrab{begin + Vec3(1, 0, 0), over_s});
        session->step();
        session->update_frame();
        EXPECT_THAT(session->frame().statistics.message, HasSubstr("the time of a move"));
    }
    session->post(MoveGrab{begin + Vec3(1, 0, 0), -1e-9});
    session->step();
    session->update_frame();
    EXPECT_THAT(session->frame().statistics.message, HasSubstr("is -1e-09 s"));
    session->post(MoveGrab{Vec3::Constant(std::numeric_limits<double>::infinity()), 0.1});
    session->step();
    session->update_frame();
    EXPECT_THAT(session->frame().statistics.message, HasSubstr("not within 10 m"));
    play(*session, 2);
    EXPECT_EQ(hand_of(*session), begin);
}

TEST(HandPace, TakesNoTimeWhereAReportComesInEveryStep) {
    HandPace::Clock::time_point now{};
    HandPace pace(now);
    for (int i = 0; i < 20; ++i) {
        now += i % 2 == 0 ? 8ms : 16ms;
        EXPECT_FALSE(pace.heard(now));
    }
}

TEST(HandPace, TakesSomewhatMoreThanTheLongestOfTheRecentGaps) {
    HandPace::Clock::time_point now{};
    HandPace pace(now);
    std::optional<double> over_s;
    for (int i = 0; i < 12; ++i) over_s = pace.heard(now += i % 3 == 0 ? 30ms : 8ms);
    ASSERT_TRUE(over_s);
    EXPECT_GT(*over_s, 0.030 + 1.0 * dt_s);
    EXPECT_LT(*over_s, 0.030 + 2.0 * dt_s);
    for (int i = 0; i < 40; ++i) over_s = pace.heard(now += 8ms);
    EXPECT_FALSE(over_s);  // it has forgotten them
    over_s = pace.heard(now += 10s);
    EXPECT_FALSE(over_s);  // the hand had rested
    EXPECT_DOUBLE_EQ(*pace.heard(now += 140ms), HandPace::longest_s);
}

// What it is for: of a hand that goes evenly and is heard unevenly, the way of one step to the
// next.
TEST(HandPace, MakesAnUnevenlyHeardHandEven) {
    const auto largest_change = [](bool paced) {
        HandPace::Clock::time_point now{};
        HandPace pace(now);
        LedPoint point;
        Vec3 at = Vec3::Zero();
        double before = 0.0, largest = 0.0;
        int next_report_ms = 28;
        for (int step = 1; step <= 240; ++step) {
            const int now_ms = static_cast<int>(step * 1000 / 60);
            for (; next_report_ms <= now_ms; next_report_ms += next_report_ms % 44 < 28 ? 28 : 8) {
                const Vec3 target(0.06 * next_report_ms, 0, 0);
                now = HandPace::Clock::time_point(std::chrono::milliseconds(next_report_ms));
                const auto over_s = pace.heard(now);
                point.lead_to(target, paced && over_s ? *over_s : 0.0);
            }
            const double was = at.x();
            if (point.underway()) at = point.next(at, dt_s);
            const double by = at.x() - was;
            if (step > 30) largest = std::max(largest, std::abs(by - before));
            before = by;
        }
        return largest;
    };
    EXPECT_LT(largest_change(true), 0.35 * largest_change(false));
    EXPECT_GT(largest_change(false), 1.0);  // of the 1.0 mm that it goes in a step
}

}  // namespace
}  // namespace hepatica
