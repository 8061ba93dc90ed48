// SPDX-License-Identifier: GPL-3.0-or-later
// A step of several substeps shows them: the same frames as those of a session whose steps are as
// long as these substeps, and the same bits afterwards as without showing them.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/session/new_session.h"

namespace hepatica {
namespace {

using test::middle_of;
using test::new_session;
using test::play;
using test::small_patient;

constexpr double never_ms = std::numeric_limits<double>::infinity();

std::unique_ptr<Session> session_of(double dt_s, int substeps, double parts_after_ms) {
    SceneSpec scene;
    scene.dt_s = dt_s;
    scene.deform.emplace();
    scene.deform->setting = StepperOptions{.substeps = substeps};
    auto session = new_session(scene);
    session->show_parts_after(parts_after_ms);
    return session;
}

// A vessel in the hand, which is 3 mm away from it.
void pull(Session& session) {
    const Vec3 held = middle_of(small_patient()->tree, 1);
    session.post(GrabPoint{held});
    session.post(MoveGrab{held + Vec3(3.0, 0.0, 0.0)});
}

// All frames published from now on.
std::vector<Frame>& frames_of(Session& session, std::vector<Frame>& frames) {
    session.on_frame([&] {
        session.update_frame();
        frames.push_back(session.frame());
    });
    return frames;
}

TEST(PartsOfAStep, AreTheStepsOfASessionWithShorterOnes) {
    const int parts = 4;
    const auto session = session_of(frame_s, parts, 0.0);
    const auto shorter = session_of(frame_s / parts, 1, never_ms);
    std::vector<Frame> frames, expected;
    frames_of(*session, frames);
    frames_of(*shorter, expected);
    pull(*session);
    pull(*shorter);
    play(*session, 3);
    play(*shorter, 3 * parts);
    ASSERT_EQ(frames.size(), 3U * parts);
    ASSERT_EQ(expected.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(frames[i].positions_mm, expected[i].positions_mm) << i;
        EXPECT_NEAR(frames[i].time_s, expected[i].time_s, 1e-12) << i;
        EXPECT_EQ(frames[i].step, 1 + i / parts);
        EXPECT_TRUE(frames[i].grab.has_value());
    }
    EXPECT_NE(frames[0].positions_mm, frames[1].positions_mm);
}

TEST(PartsOfAStep, AreShownWhereAVesselSwingsBackAndChangeNothing) {
    const auto session = session_of(frame_s, 1, 0.0);
    const auto silent = session_of(frame_s, 1, never_ms);
    for (Session* each : {session.get(), silent.get()}) {
        pull(*each);
        play(*each, 30);
        each->post(ReleaseGrab{});
    }
    std::vector<Frame> frames, expected;
    frames_of(*session, frames);
    frames_of(*silent, expected);
    EXPECT_GT(play(*session, 1).deform.linear_solves, 1);
    play(*silent, 1);
    EXPECT_GT(frames.size(), 1U);
    EXPECT_EQ(expected.size(), 1U);
    EXPECT_EQ(frames.back().positions_mm, expected.back().positions_mm);
    play(*session, 20);
    play(*silent, 20);
    EXPECT_EQ(session->state_hash(), silent->state_hash());
}

TEST(PartsOfAStep, EndTheWaitForAFrame) {
    const auto session = session_of(frame_s, 4, 0.0);
    const auto silent = session_of(frame_s, 4, never_ms);
    pull(*session);
    pull(*silent);
    const SessionStep shown = session->step();
    EXPECT_GT(shown.longest_wait_ms, 0.0);
    EXPECT_LT(shown.longest_wait_ms, shown.step_ms);
    const SessionStep whole = silent->step();
    EXPECT_GE(whole.longest_wait_ms, whole.step_ms);
}

// The session was paused before; then it goes on and lets go, and no part says that it is paused.
TEST(PartsOfAStep, SayWhatThisStepIs) {
    const auto session = session_of(frame_s, 1, 0.0);
    pull(*session);
    play(*session, 30);
    session->post(SetPaused{true});
    session->step();
    session->update_frame();
    ASSERT_TRUE(session->frame().statistics.paused && session->frame().statistics.resting);
    session->post(SetPaused{false});
    session->post(ReleaseGrab{});
    int parts = 0;
    session->on_frame([&] {
        session->update_frame();
        parts += session->within_step() ? 1 : 0;
        EXPECT_FALSE(session->frame().statistics.resting);
        EXPECT_FALSE(session->frame().statistics.paused);
    });
    session->step();
    EXPECT_GT(parts, 0);
    EXPECT_FALSE(session->within_step());
}

TEST(PartsOfAStep, AreNeitherWatchedNorRecorded) {
    const auto session = session_of(frame_s, 4, 0.0);
    int watched = 0, kept = 0;
    session->watch([&](const auto&, const auto&, const auto&) {
        ++watched;
        return true;
    });
    session->record([&](const RecordedStep&) { ++kept; });
    pull(*session);
    play(*session, 3);
    EXPECT_EQ(watched, 3);
    EXPECT_EQ(kept, 3);
}

}  // namespace
}  // namespace hepatica
