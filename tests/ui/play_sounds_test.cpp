// SPDX-License-Identifier: GPL-3.0-or-later
// The tones of a play, and when they are heard.
#include "ui/play_sounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <set>
#include <vector>

#include "tests/render/fake_frame.h"
#include "tests/ui/fake_window_test.h"
#include "ui/actions.h"

namespace hepatica {
namespace {

using testing::fake_frame;
using testing::FakeWindowTest;

constexpr std::array all_tones{Tone::warning, Tone::harm, Tone::reached, Tone::passed,
                               Tone::not_passed};

TEST(Tones, AreShortSoftAndTellThemselvesApart) {
    std::set<std::vector<std::int16_t>> seen;
    for (const Tone tone : all_tones) {
        const std::vector<std::int16_t> samples = samples_of(tone);
        ASSERT_GT(samples.size(), tone_rate_hz / 20u);
        EXPECT_LE(samples.size(), tone_rate_hz / 3u);
        const auto [least, most] = std::ranges::minmax(samples);
        EXPECT_LE(most, 8192);
        EXPECT_GT(most, 7500);
        EXPECT_GE(least, -8192);
        // No click: neither at its ends nor from one note to the next.
        EXPECT_LT(std::abs(samples.front()), 100);
        EXPECT_LT(std::abs(samples.back()), 100);
        for (std::size_t i = 1; i < samples.size(); ++i)
            ASSERT_LT(std::abs(samples[i] - samples[i - 1]), 1700) << i;
        seen.insert(samples);
    }
    EXPECT_EQ(seen.size(), all_tones.size());
}

// A wave crosses 0 upwards once a period.
TEST(Tones, TheWarningIsOneHighNote) {
    const std::vector<std::int16_t> samples = samples_of(Tone::warning);
    int periods = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
        periods += samples[i - 1] < 0 && samples[i] >= 0;
    const double seconds = static_cast<double>(samples.size()) / tone_rate_hz;
    EXPECT_NEAR(periods / seconds, 1320.0, 30.0);
}

TEST(Tones, TheGravestEventIsHeard) {
    const PlayEvent near{0.0, PlayEventKind::near_tear, ""}, torn{0.0, PlayEventKind::tear, ""},
        lesson{0.0, PlayEventKind::lesson, ""}, failed{0.0, PlayEventKind::not_passed, ""},
        hand{0.0, PlayEventKind::hand, ""};
    const auto heard = [](std::vector<PlayEvent> events, LessonOutcome outcome) {
        return tone_of(events, outcome);
    };
    EXPECT_EQ(heard({hand}, LessonOutcome::running), std::nullopt);
    EXPECT_EQ(heard({near, hand}, LessonOutcome::running), Tone::warning);
    EXPECT_EQ(heard({torn, near}, LessonOutcome::running), Tone::harm);
    EXPECT_EQ(heard({lesson, torn}, LessonOutcome::running), Tone::harm);
    EXPECT_EQ(heard({lesson}, LessonOutcome::running), Tone::reached);
    EXPECT_EQ(heard({lesson, lesson}, LessonOutcome::passed), Tone::passed);
    EXPECT_EQ(heard({torn, failed}, LessonOutcome::failed), Tone::not_passed);
}

class PlaySoundsTest : public ::testing::Test {
  protected:
    static Frame under_load(float load) {
        Frame frame = fake_frame();
        frame.tear.emplace();
        frame.tear->loads = std::make_shared<const std::vector<float>>(1, load);
        return frame;
    }

    std::vector<Tone> heard_;
    PlaySounds sounds_{[this](Tone tone) { heard_.push_back(tone); }};
};

TEST_F(PlaySoundsTest, nothing_is_heard_until_it_is_wanted) {
    for (const float load : {0.0F, 0.9F}) sounds_.follow(under_load(load), nullptr);
    EXPECT_TRUE(heard_.empty());
    sounds_.set_on(true);
    for (const float load : {0.0F, 0.9F, 0.95F, 0.9F}) sounds_.follow(under_load(load), nullptr);
    EXPECT_EQ(heard_, std::vector{Tone::warning}) << "once";
}

TEST_F(PlaySoundsTest, what_was_before_a_play_was_shown_is_not_heard) {
    sounds_.set_on(true);
    sounds_.follow(under_load(0.9F), nullptr);
    sounds_.begin();
    Frame torn = under_load(0.0F);
    torn.tear->joints_broken = 3;
    torn.tear->pieces = 2;
    torn.tear->leak_g_s = 0.1;
    LessonStanding standing;
    standing.step = 1;
    sounds_.follow(torn, &standing);
    EXPECT_TRUE(heard_.empty());
    standing.outcome = LessonOutcome::passed;
    sounds_.follow(torn, &standing);
    sounds_.follow(torn, &standing);
    EXPECT_EQ(heard_, std::vector{Tone::passed});
}

class SoundsInTheWindow : public FakeWindowTest {};

TEST_F(SoundsInTheWindow, are_off_by_default_and_kept_as_chosen) {
    QAction& sounds = window_.actions()[ActionId::sounds];
    EXPECT_TRUE(sounds.isCheckable());
    EXPECT_FALSE(sounds.isChecked());
    EXPECT_FALSE(settings_.sounds());
    sounds.trigger();
    EXPECT_TRUE(settings_.sounds());
    sounds.trigger();
    EXPECT_FALSE(settings_.sounds());
}

}  // namespace
}  // namespace hepatica
