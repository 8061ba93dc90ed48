// SPDX-License-Identifier: GPL-3.0-or-later
// Where the hand is in each motion, as the commands of a session have it.
#include "core/study/hand_motion.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/frame_time.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

struct Hand {
    Vec3 start_mm = Vec3::Zero();
    std::vector<Vec3> from_start_mm;  // at the end of each step in which it moves
    int released_at = -1;
};

Hand hand_of(const HandMotion& motion) {
    const VesselTree& tree = test::small_patient()->tree;
    Hand hand;
    int step = 0;
    for (const auto& now : schedule(motion.script, tree, frame_s, motion.steps)) {
        for (const Command& command : now) {
            if (const auto* grab = std::get_if<GrabPoint>(&command))
                hand.start_mm = grab->point_mm;
            else if (const auto* move = std::get_if<MoveGrab>(&command))
                hand.from_start_mm.push_back(move->target_mm - hand.start_mm);
            else if (std::holds_alternative<ReleaseGrab>(command))
                hand.released_at = step;
        }
        ++step;
    }
    return hand;
}

TEST(HandMotion, PullGoesOutInHalfASecondAndAcrossInAnother) {
    const HandMotion pull = hand_motion("pull");
    const Hand hand = hand_of(pull);
    EXPECT_EQ(hand.start_mm, point_on_longest_path(test::small_patient()->tree, 0.5));
    ASSERT_EQ(hand.from_start_mm.size(), 60u);
    EXPECT_LT((hand.from_start_mm[14] - Vec3(15, 10, 0)).norm(), 1e-9);
    EXPECT_LT((hand.from_start_mm[29] - Vec3(30, 20, 0)).norm(), 1e-9);
    EXPECT_LT((hand.from_start_mm[59] - Vec3(0, -20, 10)).norm(), 1e-9);
    EXPECT_EQ(hand.released_at, 60);
    EXPECT_EQ(pull.steps, 120);
    EXPECT_EQ(pull.held_steps, 60) << "up to the step that lets go";
}

TEST(HandMotion, JerkIsBackAfterAFifthOfASecond) {
    const Hand hand = hand_of(hand_motion("jerk"));
    ASSERT_EQ(hand.from_start_mm.size(), 12u);
    EXPECT_LT((hand.from_start_mm[5] - Vec3(40, 0, 0)).norm(), 1e-9);
    EXPECT_LT(hand.from_start_mm[11].norm(), 1e-9);
    EXPECT_EQ(hand.released_at, 12);
}

TEST(HandMotion, TwistStaysOnItsCircle) {
    const Hand hand = hand_of(hand_motion("twist"));
    ASSERT_EQ(hand.from_start_mm.size(), 180u);
    for (const Vec3& place : hand.from_start_mm)
        EXPECT_NEAR((place + Vec3(15, 0, 0)).norm(), 15.0, 1e-9);
    EXPECT_LT((hand.from_start_mm[44] - Vec3(-15, 15, 0)).norm(), 1e-9);  // a quarter
    EXPECT_LT((hand.from_start_mm[89] - Vec3(-30, 0, 0)).norm(), 1e-9);   // a half
    EXPECT_LT(hand.from_start_mm[179].norm(), 1e-9);
    EXPECT_EQ(hand.released_at, 180);
}

TEST(HandMotion, TheDialsGoesThirtyMillimetresAndBackInASecond) {
    const HandMotion motion = dial_motion();
    const Hand hand = hand_of(motion);
    ASSERT_EQ(hand.from_start_mm.size(), 60u);
    EXPECT_NEAR(hand.from_start_mm[29].norm(), 30.0, 1e-9);
    EXPECT_LT(hand.from_start_mm[59].norm(), 1e-9);
    EXPECT_EQ(motion.steps, 60);
    EXPECT_EQ(motion.held_steps, 60);
}

TEST(HandMotion, AScriptIsWatchedForASecondAfterItsLastAction) {
    Script script;
    script.actions.push_back(
        {.at_s = 0.5, .what = "grab", .place = {.share_of_longest_path = 0.5}});
    script.actions.push_back({.at_s = 1.0, .what = "move", .by_mm = Vec3(1, 0, 0), .over_s = 2.0});
    EXPECT_EQ(motion_of(script).steps, 240);
    EXPECT_THROW(static_cast<void>(hand_motion("shake")), InputError);
}

}  // namespace
}  // namespace hepatica
