// SPDX-License-Identifier: GPL-3.0-or-later
// The dial and the body that uses its settings: turned by hand, given exactly, or chosen by the
// cost of frames, and exchanged for another dial of the same body.
#include "core/session/dial_in_use.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/scene/deform_part.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

using test::small_patient;

// A frame's budget [ms]; the governor begins with settings that cost 8 of these or less.
constexpr double ten_ms = 10.0;

StepperOptions in_substeps(int count) {
    StepperOptions options;
    options.substeps = count;
    return options;
}

// 1, 2 and 4 substeps, which cost 2, 4 and 8 ms: qualities 0, 0.5 and 1.
QualityDial dial_of_three() {
    return QualityDial({{in_substeps(1), 2.0, 0.4, "this body"},
                        {in_substeps(2), 4.0, 0.2, "this body"},
                        {in_substeps(4), 8.0, 0.1, "this body"}});
}

// 3 and 6 substeps, which cost as much as 1 and 4 of the other.
QualityDial dial_of_two() {
    return QualityDial({{in_substeps(3), 2.0, 0.3, "later"}, {in_substeps(6), 8.0, 0.05, "later"}});
}

DeformPart part_in_substeps(int count) {
    return DeformPart(*small_patient(), DeformSpec{.setting = in_substeps(count)});
}

TEST(DialInUse, KnowsNoQualityBeforeItHasSeenTheBody) {
    const DialInUse dial(dial_of_three());
    EXPECT_FALSE(dial.automatic());
    EXPECT_FALSE(dial.quality().has_value());
    FrameStatistics said;
    said.expected_error = 7.0;
    said.error_reference = "another";
    said.quality = 0.7;
    said.automatic = true;
    dial.fill(said);
    EXPECT_EQ(said.expected_error, 0.0);
    EXPECT_EQ(said.quality, 0.0);
    EXPECT_EQ(said.error_reference, "");
    EXPECT_FALSE(said.automatic);
}

TEST(DialInUse, FindsTheBodysSettingWhereTheDialHasIt) {
    DeformPart part = part_in_substeps(2);
    DialInUse dial(dial_of_three());
    dial.follow(part);
    ASSERT_TRUE(dial.quality().has_value());
    EXPECT_DOUBLE_EQ(*dial.quality(), 0.5);
    FrameStatistics said;
    dial.fill(said);
    EXPECT_DOUBLE_EQ(said.quality, 0.5);
    EXPECT_EQ(said.expected_error, 0.2);
    EXPECT_EQ(said.error_reference, "this body");
    part.use(in_substeps(4));
    EXPECT_DOUBLE_EQ(*dial.quality(), 0.5) << "until it is told";
    dial.follow(part);
    EXPECT_EQ(dial.quality(), 1.0);
    part.use(in_substeps(3));
    dial.follow(part);
    EXPECT_FALSE(dial.quality().has_value());
    EXPECT_EQ(part.setting().substeps, 3) << "it looks only";
    dial.fill(said);
    EXPECT_EQ(said.expected_error, 0.0);
    EXPECT_EQ(said.quality, 0.0) << "a frame's statistics are filled again and again";
    EXPECT_EQ(said.error_reference, "");
}

TEST(DialInUse, IsTurnedByHandWhichEndsAutomaticQuality) {
    DeformPart part = part_in_substeps(3);
    DialInUse dial(dial_of_three());
    dial.set_automatic(true);
    EXPECT_TRUE(dial.automatic());
    EXPECT_EQ(part.setting().substeps, 3) << "nothing is chosen yet";
    dial.turn(1.0, part);
    EXPECT_FALSE(dial.automatic());
    EXPECT_EQ(part.setting().substeps, 4);
    EXPECT_EQ(dial.quality(), 1.0);
    dial.turn(0.49, part);
    EXPECT_EQ(part.setting().substeps, 1);
    EXPECT_EQ(dial.quality(), 0.0);
    dial.turn(0.5, part);
    EXPECT_EQ(part.setting().substeps, 2);
    // By hand no cost of frames turns it.
    for (int i = 0; i < 100; ++i) ASSERT_FALSE(dial.govern(100.0, ten_ms, &part));
    for (int i = 0; i < 400; ++i) ASSERT_FALSE(dial.govern(0.1, ten_ms, &part));
    EXPECT_EQ(part.setting().substeps, 2);
}

TEST(DialInUse, BeginsAutomaticQualityWithTheMostAccurateThatFits) {
    DeformPart part = part_in_substeps(3);
    DialInUse dial(dial_of_three());
    for (const auto& [budget_ms, substeps] :
         {std::pair(ten_ms, 4), std::pair(9.9, 2), std::pair(5.0, 2), std::pair(0.1, 1)}) {
        dial.turn_automatically(budget_ms, part);
        EXPECT_TRUE(dial.automatic());
        EXPECT_EQ(part.setting().substeps, substeps) << budget_ms;
    }
    EXPECT_EQ(dial.quality(), 0.0);
    FrameStatistics said;
    dial.fill(said);
    EXPECT_TRUE(said.automatic);
}

// How many frames of this cost it takes until another setting is chosen; `most` where none is.
int frames_until_chosen(DialInUse& dial, DeformPart& part, double frame_ms, int most) {
    for (int frame = 1; frame <= most; ++frame)
        if (dial.govern(frame_ms, ten_ms, &part)) return frame;
    return most;
}

TEST(DialInUse, GoesDownWhereFramesAreLateAndUpWhereTheyAreInTimeAgain) {
    DeformPart part = part_in_substeps(1);
    DialInUse dial(dial_of_three());
    dial.turn_automatically(ten_ms, part);
    EXPECT_EQ(frames_until_chosen(dial, part, 10.0, 500), 500) << "all of the budget is in time";
    // Late by six tenths: half of that fits into eight tenths of the budget.
    EXPECT_LT(frames_until_chosen(dial, part, 16.0, 500), 10);
    EXPECT_EQ(part.setting().substeps, 2);
    EXPECT_DOUBLE_EQ(*dial.quality(), 0.5);
    // The better setting would take eight tenths.
    EXPECT_EQ(frames_until_chosen(dial, part, 4.0, 500), 500);
    EXPECT_EQ(part.setting().substeps, 2);
    // It would take six tenths: it is tried after a second of such frames.
    const int frames = frames_until_chosen(dial, part, 3.0, 500);
    EXPECT_GE(frames, 60);
    EXPECT_LT(frames, 100);
    EXPECT_EQ(part.setting().substeps, 4);
    EXPECT_EQ(dial.quality(), 1.0);
    // Far too late: down to the cheapest at once, and no further.
    EXPECT_LT(frames_until_chosen(dial, part, 90.0, 500), 20);
    EXPECT_EQ(part.setting().substeps, 1);
    EXPECT_EQ(frames_until_chosen(dial, part, 90.0, 100), 100);
    EXPECT_TRUE(dial.automatic());
}

// What was too slow is barred for two seconds, but only of the same body and play.
TEST(DialInUse, ForgetsTheCostsOfAnotherBodyAndOfAnEarlierTime) {
    for (const bool another_body : {true, false}) {
        DeformPart part = part_in_substeps(1);
        DialInUse dial(dial_of_three());
        dial.turn_automatically(ten_ms, part);
        ASSERT_LT(frames_until_chosen(dial, part, 16.0, 500), 10);
        ASSERT_EQ(part.setting().substeps, 2);
        if (another_body) {
            dial.forget_costs();
        } else {
            dial.turn(0.5, part);
            dial.turn_automatically(5.0, part);
        }
        ASSERT_EQ(part.setting().substeps, 2);
        EXPECT_LT(frames_until_chosen(dial, part, 3.0, 500), 100) << another_body;
        EXPECT_EQ(part.setting().substeps, 4);
    }
}

TEST(DialInUse, ChoosesNothingWithoutABodyOrForASettingThatItLacks) {
    DeformPart part = part_in_substeps(3);
    DialInUse dial(dial_of_three());
    dial.follow(part);
    dial.set_automatic(true);
    EXPECT_EQ(frames_until_chosen(dial, part, 90.0, 100), 100);
    EXPECT_EQ(part.setting().substeps, 3);
    dial.turn_automatically(ten_ms, part);
    for (int i = 0; i < 100; ++i) ASSERT_FALSE(dial.govern(90.0, ten_ms, nullptr));
    EXPECT_EQ(part.setting().substeps, 4);
    EXPECT_EQ(dial.quality(), 1.0);
}

TEST(DialInUse, IsExchangedWithoutABody) {
    DialInUse dial(dial_of_three());
    EXPECT_FALSE(dial.take(dial_of_two(), nullptr, ten_ms));
    EXPECT_FALSE(dial.quality().has_value());
    DeformPart part = part_in_substeps(4);
    dial.turn(1.0, part);
    EXPECT_EQ(part.setting().substeps, 6);
}

TEST(DialInUse, KeepsASettingThatTheNewDialHasToo) {
    DeformPart part = part_in_substeps(4);
    DialInUse dial(dial_of_three());
    dial.follow(part);
    const QualityDial with_four(
        {{in_substeps(4), 1.0, 0.3, "later"}, {in_substeps(6), 3.0, 0.05, "later"}});
    EXPECT_FALSE(dial.take(with_four, &part, ten_ms));
    EXPECT_EQ(part.setting().substeps, 4);
    EXPECT_EQ(dial.quality(), 0.0) << "where it is on the new dial";
    // One that was given exactly is none of a dial, and stays.
    part.use(in_substeps(5));
    dial.follow(part);
    EXPECT_FALSE(dial.take(dial_of_two(), &part, ten_ms));
    EXPECT_EQ(part.setting().substeps, 5);
    EXPECT_FALSE(dial.quality().has_value());
    // Unless the new dial has it.
    EXPECT_FALSE(dial.take(QualityDial({{in_substeps(5), 1.0, 0.3, "latest"}}), &part, ten_ms));
    EXPECT_EQ(part.setting().substeps, 5);
    EXPECT_EQ(dial.quality(), 0.0);
}

TEST(DialInUse, ReplacesASettingThatTheNewDialLacks) {
    DeformPart part = part_in_substeps(1);
    DialInUse by_hand(dial_of_three());
    by_hand.turn(1.0, part);
    EXPECT_TRUE(by_hand.take(dial_of_two(), &part, ten_ms));
    EXPECT_EQ(part.setting().substeps, 6) << "as far as it was turned";
    EXPECT_EQ(by_hand.quality(), 1.0);
    EXPECT_FALSE(by_hand.automatic());

    DialInUse halfway(dial_of_three());
    halfway.turn(0.5, part);
    EXPECT_TRUE(halfway.take(dial_of_two(), &part, 1000.0));
    EXPECT_EQ(part.setting().substeps, 3) << "whatever the budget";

    // Automatic quality chooses anew, by the costs of the new dial.
    for (const auto& [budget_ms, substeps] : {std::pair(ten_ms, 6), std::pair(9.0, 3)}) {
        DialInUse chosen(dial_of_three());
        chosen.turn_automatically(5.0, part);
        ASSERT_EQ(part.setting().substeps, 2);
        EXPECT_TRUE(chosen.take(dial_of_two(), &part, budget_ms));
        EXPECT_EQ(part.setting().substeps, substeps) << budget_ms;
        EXPECT_TRUE(chosen.automatic());
        // Late by half: 6 substeps are left for 3, and 3 are the cheapest.
        EXPECT_EQ(frames_until_chosen(chosen, part, 15.0, 50) < 50, substeps == 6);
        EXPECT_EQ(part.setting().substeps, 3);
    }
}

}  // namespace
}  // namespace hepatica
