// SPDX-License-Identifier: GPL-3.0-or-later
// What a person or the session itself chooses in mid-play: the dial, tissue, the wall.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/scene/deform_part.h"
#include "core/scene/measured_dial.h"
#include "core/scene/world.h"
#include "core/session/replay.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"

namespace hepatica {
namespace {

using test::keep_recording;
using test::middle_of;
using test::new_session;
using test::play;
using test::small_patient;

// What a setting changes is the next step, not the state that it begins with: to the last bit.
TEST(Session, ChangesQualityTetherAndWallInMidPullWithoutAJump) {
    SceneSpec spec = default_scene();
    spec.deform->tether_pa_per_mm2 = 0.0;
    const auto session = new_session(spec);
    session->post(GrabPoint{middle_of(small_patient()->tree, 0)});
    session->post(MoveGrab{middle_of(small_patient()->tree, 0) + Vec3(5, 0, 0)});
    play(*session, 60);
    for (const Command& command :
         {Command(SetQuality{1.0}), Command(SetQuality{0.0}), Command(SetTether{1.0}),
          Command(SetTether{0.0}), Command(SetWall{0.5}), Command(SetWall{0.0})}) {
        const BodyState before = session->world().deform()->state();
        session->post(SetPaused{true});
        session->post(command);
        session->step();
        const BodyState set = session->world().deform()->state();
        const std::size_t vertices = small_patient()->mesh.vertices_mm.size();
        for (std::size_t v = 0; v < vertices; ++v) {
            ASSERT_EQ(set.positions_mm[v], before.positions_mm[v]) << to_json(command).dump();
            ASSERT_EQ(set.velocities_mm_per_s[v], before.velocities_mm_per_s[v]);
        }
        session->post(SetPaused{false});
        session->step();
        EXPECT_NE(session->world().deform()->state().positions_mm, before.positions_mm);
        EXPECT_TRUE(session->world().deform()->plausible());
    }
}

// A wall given in mid-play is the wall that a scene begins with, and comes back in a replay.
TEST(Session, AWallChosenLaterIsThatOfTheScene) {
    const auto hash_after = [](const SceneSpec& spec, double wall_mm) {
        const auto session = new_session(spec);
        const auto recording = keep_recording(*session);
        session->post(SetWall{wall_mm});
        session->post(GrabPoint{middle_of(small_patient()->tree, 0)});
        session->post(MoveGrab{middle_of(small_patient()->tree, 0) + Vec3(5, 0, 0)});
        const std::uint64_t hash = play(*session, 20).state_hash;
        Job job;
        const ReplayResult same = replay(*recording, small_patient(), job);
        EXPECT_FALSE(same.diverged_at.has_value());
        EXPECT_EQ(same.state_hash, hash);
        return hash;
    };
    SceneSpec hollow = default_scene();
    hollow.deform->wall_mm = 0.6;
    EXPECT_EQ(hash_after(default_scene(), 0.6), hash_after(hollow, 0.6));
    EXPECT_EQ(hash_after(hollow, 0.0), hash_after(default_scene(), 0.0));
    EXPECT_NE(hash_after(default_scene(), 0.6), hash_after(default_scene(), 0.0));
}

// Turning the dial, and the session that turns it by itself, are in the recording as the settings
// that were used: another machine with another dial plays them alike.
TEST(Session, TheSettingsUsedAreInTheRecordingWhateverTheDialOffers) {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    StepperOptions two, five;
    two.substeps = 2;
    five.substeps = 5;
    patient->dial_json =
        dial_json({{two, 1e-6, 0.2, "this body"}, {five, 2e-6, 0.1, "this body"}}, *patient);
    SceneSpec spec = default_scene();
    spec.dt_s = 1.0;  // a budget that no machine misses
    Job job;
    Session session(patient, spec, job);
    const auto kept = keep_recording(session);
    session.post(SetAutomaticQuality{true});  // both cost next to nothing: the better one
    session.post(GrabPoint{middle_of(patient->tree, 1)});
    session.post(MoveGrab{middle_of(patient->tree, 1) + Vec3(4, 0, 0)});
    play(session, 10);
    session.update_frame();
    EXPECT_TRUE(session.frame().statistics.automatic);
    EXPECT_EQ(session.frame().statistics.quality, 1.0);
    EXPECT_EQ(session.frame().statistics.expected_error, 0.1);
    EXPECT_EQ(session.frame().statistics.error_reference, "this body");
    session.post(SetQuality{0.0});
    const std::uint64_t end = play(session, 10).state_hash;
    session.update_frame();
    EXPECT_FALSE(session.frame().statistics.automatic);
    EXPECT_EQ(session.frame().statistics.expected_error, 0.2);

    const Recording& recording = *kept;
    const auto* first = std::get_if<UseSetting>(&recording.steps[0].commands.at(0));
    const auto* later = std::get_if<UseSetting>(&recording.steps[10].commands.at(0));
    ASSERT_NE(first, nullptr);
    ASSERT_NE(later, nullptr);
    EXPECT_EQ(first->setting.substeps, 5);
    EXPECT_EQ(later->setting.substeps, 2);
    const ReplayResult same = replay(recording, small_patient(), job);  // with the built-in dial
    EXPECT_FALSE(same.diverged_at.has_value());
    EXPECT_EQ(same.state_hash, end);
}

// Of a frame of 17 ms the picture takes 10: a setting of 10 ms is too slow to begin with.
TEST(Session, AutomaticQualityBeginsWithWhatDrawingLeaves) {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    StepperOptions two, five;
    two.substeps = 2;
    five.substeps = 5;
    patient->dial_json =
        dial_json({{two, 1.0, 0.2, "this body"}, {five, 10.0, 0.1, "this body"}}, *patient);
    Job job;
    for (const double drawing_ms : {0.0, 10.0}) {
        Session session(patient, default_scene(), job);
        session.set_drawing_ms(drawing_ms);
        session.post(SetAutomaticQuality{true});
        session.step();
        session.update_frame();
        EXPECT_EQ(session.frame().statistics.quality, drawing_ms == 0.0 ? 1.0 : 0.0);
    }
}

// A machine for which every step is too slow: the session goes down the dial by itself.
TEST(Session, StepsDownWhenTheMachineFallsBehind) {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    StepperOptions cheap, dear;
    dear.substeps = 8;
    patient->dial_json =
        dial_json({{cheap, 1e-7, 0.2, "this body"}, {dear, 1e-6, 0.1, "this body"}}, *patient);
    SceneSpec spec = default_scene();
    spec.dt_s = 1e-4;  // a tenth of a millisecond for a step
    Job job;
    Session session(patient, spec, job);
    const auto recording = keep_recording(session);
    session.post(SetAutomaticQuality{true});
    session.post(SetGravity{Vec3(0, 0, -9810)});
    play(session, 30);
    session.update_frame();
    EXPECT_EQ(session.frame().statistics.quality, 0.0);
    int changes = 0;
    for (const RecordedStep& step : recording->steps)
        for (const Command& command : step.commands)
            changes += std::holds_alternative<UseSetting>(command) ? 1 : 0;
    EXPECT_EQ(changes, 2);  // the one it began with, and the one it stepped down to
    EXPECT_FALSE(replay(*recording, small_patient(), job).diverged_at.has_value());
}

QualityDial dial_with(int cheap, int dear) {
    StepperOptions one, other;
    one.substeps = cheap;
    other.substeps = dear;
    return QualityDial({{one, 1.0, 0.2, "another dial"}, {other, 9.0, 0.1, "another dial"}});
}

// A dial that was measured during the play: the frames tell its errors, and what was chosen stays
// chosen where the dial has it.
TEST(Session, TakesAnotherDialInMidPlayAndRecordsWhatItUsesFromThere) {
    const auto session = new_session();
    const auto kept = keep_recording(*session);
    const auto substeps = [&] { return session->world().deform()->setting().substeps; };
    const auto reference = [&] {
        session->update_frame();
        return session->frame().statistics.error_reference;
    };
    session->post(SetQuality{0.0});
    session->post(GrabPoint{middle_of(small_patient()->tree, 1)});
    session->post(MoveGrab{middle_of(small_patient()->tree, 1) + Vec3(4, 0, 0)});
    session->step();
    ASSERT_EQ(substeps(), 1);
    session->use_dial(dial_with(1, 4));  // the setting in use is on it
    session->step();
    EXPECT_EQ(substeps(), 1);
    EXPECT_EQ(reference(), "another dial");
    session->use_dial(dial_with(3, 5));  // and is not on this one: the same turn of the dial
    session->step();
    EXPECT_EQ(substeps(), 3);
    session->post(SetQuality{1.0});
    session->step();
    EXPECT_EQ(substeps(), 5);
    StepperOptions chosen;
    chosen.substeps = 7;
    session->post(UseSetting{chosen});  // one setting exactly stays what it is
    session->step();
    session->use_dial(dial_with(1, 4));
    session->step();
    EXPECT_EQ(substeps(), 7);
    session->post(SetQuality{1.0});
    session->post(SetAutomaticQuality{true});
    session->step();
    session->use_dial(dial_with(2, 6));
    session->step();
    EXPECT_TRUE(substeps() == 2 || substeps() == 6) << substeps();
    const SessionStep last = play(*session, 3);
    Job job;
    const ReplayResult same = replay(*kept, small_patient(), job);
    EXPECT_FALSE(same.diverged_at.has_value());
    EXPECT_EQ(same.state_hash, last.state_hash);
}

// It may be the last step, after which the automatic would have chosen another setting.
TEST(Session, HasTheRecordedStateAfterEveryStepOfAutomaticQuality) {
    const auto session = new_session();
    const auto kept = keep_recording(*session);
    // The second is chosen after some seventy steps, for it costs little more than the first, which
    // is chosen at the start.
    StepperOptions better;
    better.substeps = 2;
    session->use_dial(QualityDial({{{}, 13.0, 0.2, "a dial"}, {better, 13.5, 0.1, "a dial"}}));
    session->post(SetAutomaticQuality{true});
    const Vec3 hand = middle_of(small_patient()->tree, 1);
    session->post(GrabPoint{hand});
    int changed_after = 0;
    for (int k = 0; k < 100; ++k) {
        session->post(MoveGrab{hand + Vec3(3.0 * std::sin(0.2 * k), 0, 0)});
        session->step();
        EXPECT_EQ(session->state_hash(), kept->steps.back().state_hash) << k;
        if (changed_after == 0 && session->world().deform()->setting().substeps == 2)
            changed_after = k;
    }
    EXPECT_GT(changed_after, 60);
}

// What can tear is taken from this dial; the replay has the built-in one.
TEST(Session, RecordsTheSettingThatTearingTakesFromItsDial) {
    const auto session = new_session();
    const auto kept = keep_recording(*session);
    session->use_dial(dial_with(5, 6));
    session->post(UseSetting{{.order = ElementOrder::quadratic}});
    session->post(GrabPoint{middle_of(small_patient()->tree, 1)});
    session->post(MoveGrab{middle_of(small_patient()->tree, 1) + Vec3(4, 0, 0)});
    session->step();
    session->post(UseTear{true, 1.0});
    session->step();
    ASSERT_EQ(session->world().deform()->setting().order, ElementOrder::linear);
    ASSERT_EQ(session->world().deform()->setting().substeps, 5);
    const SessionStep last = play(*session, 3);
    Job job;
    const ReplayResult same = replay(*kept, small_patient(), job);
    EXPECT_FALSE(same.diverged_at.has_value()) << *same.diverged_at;
    EXPECT_EQ(same.state_hash, last.state_hash);
}

TEST(Session, AnotherTearFactorKeepsTheStopOfTheScene) {
    SceneSpec spec = default_scene();
    spec.tear = TearSpec{.stop = TearStop::vertices, .vertex_budget = 7};
    const auto session = new_session(spec);
    session->post(UseTear{true, 0.5});
    session->step();
    const std::optional<TearSpec> tear = session->world().deform()->settings().tear;
    ASSERT_TRUE(tear);
    EXPECT_EQ(tear->tear_factor, 0.5);
    EXPECT_EQ(tear->stop, TearStop::vertices);
    EXPECT_EQ(tear->vertex_budget, 7);
}

TEST(Session, TheHandHoldsOnWhereTearingEnds) {
    SceneSpec spec = default_scene();
    spec.tear.emplace();
    const auto session = new_session(spec);
    const Vec3 place = middle_of(small_patient()->tree, 1);
    session->post(GrabPoint{place});
    session->step();
    session->post(UseTear{false, 1.0});
    session->step();
    ASSERT_TRUE(session->world().deform()->holding());
    EXPECT_EQ(session->world().deform()->hand_mm(), place);
    session->update_frame();
    EXPECT_TRUE(session->frame().grab.has_value());
}

// The vertices that a tear made vanish with it, and with them what the hand held.
TEST(Session, TearingEndsWhileTheHandHoldsWhatItMade) {
    SceneSpec spec = default_scene();
    spec.tear.emplace();
    const auto session = new_session(spec);
    const auto& points = small_patient()->tree.segments[0].points_mm;
    const std::size_t m = points.size() / 2;
    const Vec3 across = 15.0 * (points[m + 1] - points[m - 1]).unitOrthogonal();
    session->post(Blade{points[m] - across, points[m] + across});
    play(*session, 2);
    const std::size_t whole = small_patient()->mesh.vertices_mm.size();
    ASSERT_GT(session->world().vertex_count(), whole);
    session->post(GrabVertex{static_cast<int>(session->world().vertex_count()) - 1});
    play(*session, 2);
    session->post(UseTear{false, 1.0});
    session->step();
    session->update_frame();
    EXPECT_EQ(session->frame().statistics.message, "");
    EXPECT_FALSE(session->frame().grab.has_value());
    EXPECT_EQ(session->world().vertex_count(), whole);
    EXPECT_EQ(session->frame().positions_mm.size(), 3 * whole);
}

// A frame has one message, but a step keeps what was refused of each of its commands.
TEST(Session, KeepsWhatOfItsCommandsWasRefused) {
    const auto session = new_session();
    session->post(GrabVertex{-7});
    session->post(SetGravity{});
    session->post(SetTether{-1.0});
    const SessionStep step = session->step();
    ASSERT_EQ(step.refused.size(), 2u);
    EXPECT_NE(step.refused[0].find("-7"), std::string::npos) << step.refused[0];
    session->update_frame();
    EXPECT_EQ(step.refused[1], session->frame().statistics.message);
    EXPECT_TRUE(session->step().refused.empty());
}

}  // namespace
}  // namespace hepatica
