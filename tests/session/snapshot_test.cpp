// SPDX-License-Identifier: GPL-3.0-or-later
// Going back to the last good state goes on with the same bits, and the hash of the state is of all
// that determines the steps to come and of nothing else.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "core/scene/deform_part.h"
#include "core/scene/flow_part.h"
#include "core/scene/world.h"
#include "core/scene/world_checkpoint.h"
#include "core/session/replay.h"
#include "core/session/script.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

using test::keep_recording;
using test::middle_of;
using test::small_patient;

// With the hash of every step.
std::unique_ptr<Session> hashing_session() {
    auto session = test::new_session();
    session->record([](const RecordedStep&) {});
    return session;
}

// Step `n` (from 1) of a pull that leads a branch about, with a drug that runs.
std::uint64_t pull_step(Session& session, int n) {
    const Vec3 start = middle_of(small_patient()->tree, 4);
    if (n == 1) {
        session.post(InjectDrug{.point_mm = small_patient()->tree.nodes[0].position_mm});
        session.post(GrabPoint{start});
    }
    session.post(MoveGrab{start + Vec3(0.05 * n, 2.0 * std::sin(0.1 * n), 0)});
    return session.step().state_hash;
}

constexpr int snapshot_step = 60;

TEST(Snapshot, RestoringGoesOnWithTheSameBits) {
    const auto whole = hashing_session();
    std::vector<std::uint64_t> hashes(1, 0);
    for (int n = 1; n <= 200; ++n) hashes.push_back(pull_step(*whole, n));
    for (const int further : {0, 1, 25, 59}) {
        SCOPED_TRACE(std::to_string(further) + " steps after the snapshot");
        const auto session = hashing_session();
        for (int n = 1; n <= snapshot_step + further; ++n)
            ASSERT_EQ(pull_step(*session, n), hashes[n]);
        session->post(RestoreSnapshot{});
        for (int n = snapshot_step + 1; n <= 119; ++n)
            ASSERT_EQ(pull_step(*session, n), hashes[n]) << "step " << n;
    }
}

TEST(Snapshot, AHandThatHasOpenedSinceStaysOpenAndWhatWasSetStaysSet) {
    const auto session = hashing_session();
    for (int n = 1; n <= snapshot_step; ++n) pull_step(*session, n);
    session->post(ReleaseGrab{});
    session->post(SetGravity{Vec3(0, 500, 0)});
    session->post(SetTether{7.0});
    session->post(SetWall{0.5});
    session->post(SetDrugSpeed{3.0});
    session->post(UseSetting{{.substeps = 3}});
    session->step();
    session->post(RestoreSnapshot{});
    session->step();
    const DeformPart& deform = *session->world().deform();
    EXPECT_FALSE(deform.holding());
    EXPECT_EQ(deform.settings().gravity_mm_per_s2, Vec3(0, 500, 0));
    EXPECT_EQ(deform.settings().tether_pa_per_mm2, 7.0);
    EXPECT_EQ(deform.settings().wall_mm, 0.5);
    EXPECT_EQ(deform.setting().substeps, 3);
    EXPECT_EQ(session->world().flow()->speed(), 3.0);
}

// A world's own checkpoint, in the middle of anything, through its text.
TEST(Snapshot, AWorldGoesOnFromTheTextOfItsCheckpoint) {
    Job job;
    World world(small_patient(), default_scene(), job),
        other(small_patient(), default_scene(), job);
    const Vec3 start = middle_of(small_patient()->tree, 4);
    world.flow()->inject({.at = {0, 0.0, 0.0}});
    world.deform()->grab(start);
    for (int n = 0; n < 47; ++n) {
        world.deform()->move_grab(start + Vec3(0.1 * n, 0, 0));
        world.step();
    }
    const std::string text = to_json(world.checkpoint()).dump();
    other.restore(world_checkpoint_from_json(nlohmann::ordered_json::parse(text)));
    EXPECT_EQ(to_json(other.checkpoint()).dump(), text);
    EXPECT_EQ(*other.flow()->drug().arrival_s, *world.flow()->drug().arrival_s);
    EXPECT_EQ(other.flow()->drug().end_s, world.flow()->drug().end_s);
    EXPECT_EQ(other.time_s(), world.time_s());
    for (int n = 0; n < 80; ++n) {
        ASSERT_EQ(other.state_hash(), world.state_hash()) << n;
        if (n == 40)
            for (World* each : {&world, &other}) each->deform()->release();
        world.step();
        other.step();
    }
}

TEST(StateHash, IsOfEverythingThatDeterminesWhatComesNext) {
    const VesselTree& tree = small_patient()->tree;
    std::set<std::uint64_t> seen;
    const auto session = hashing_session();
    for (int n = 1; n <= 30; ++n) seen.insert(pull_step(*session, n));
    EXPECT_EQ(seen.size(), 30u);
    std::size_t expected = seen.size();
    session->post(SetPaused{true});
    for (const Command& command :
         {Command(SetPaused{true}), Command(MoveGrab{Vec3(1, 2, 3)}), Command(ReleaseGrab{}),
          Command(GrabPoint{middle_of(tree, 2)}), Command(SetGravity{Vec3(0, 0, -1)}),
          Command(SetTether{21.0}), Command(SetWall{0.7}), Command(UseSetting{{.substeps = 7}}),
          Command(SetDrugTime{12.0}), Command(SetDrugSpeed{2.0}), Command(PlayDrug{false}),
          Command(InjectDrug{.point_mm = tree.nodes[0].position_mm, .mass_flow_g_s = 1.0}),
          Command(InjectDrug{.point_mm = tree.nodes[0].position_mm, .mass_flow_g_s = 1.5}),
          // Computed from here on; what is shown stays.
          Command(InjectDrug{.point_mm = tree.nodes[0].position_mm, .void_fraction = 0.5}),
          Command(InjectDrug{.point_mm = tree.nodes[0].position_mm, .void_fraction = 0.4}),
          Command(FinishInjection{}), Command(RemoveDrug{}), Command(ResetWorld{})}) {
        session->post(command);
        if (std::holds_alternative<ResetWorld>(command)) session->post(SetPaused{true});
        seen.insert(session->step().state_hash);
        EXPECT_EQ(seen.size(), ++expected) << to_json(command).dump();
    }
}

TEST(StateHash, IsOfNothingElse) {
    const auto paused = hashing_session(), straight = hashing_session();
    for (int n = 1; n <= 70; ++n) {
        if (n == 40) {
            paused->post(SetPaused{true});
            for (int i = 0; i < 7; ++i) paused->step();
            paused->post(SetPaused{false});
        }
        ASSERT_EQ(pull_step(*paused, n), pull_step(*straight, n)) << n;
    }
    EXPECT_NE(paused->world().time_s(), 0.0);
    // The same place by another way: gravity that is set and taken back between two steps.
    const std::uint64_t before = straight->state_hash();
    straight->world().flow()->set_speed(9.0);
    EXPECT_NE(straight->state_hash(), before);
    straight->world().flow()->set_speed(1.0);
    EXPECT_EQ(straight->state_hash(), before);
}

// The window's session takes over an injection when it is ready; the recording says at which step.
TEST(Injections, OfTheThreadAreShownWhenTheyAreReadyAndReplayAtThatStep) {
    Job job;
    Session session(small_patient(), default_scene(), job);
    const auto recording = keep_recording(session);
    session.post(InjectDrug{.point_mm = small_patient()->tree.nodes[0].position_mm,
                            .void_fraction = 0.4,
                            .second_phase = "gas"});
    {
        std::jthread thread([&](const std::stop_token& stop) { session.run(stop); });
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (std::chrono::steady_clock::now() < deadline) {
            session.update_frame();
            if (session.frame().drug.arrival_s && session.frame().drug.time_s > 0.05) break;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }
    session.update_frame();
    EXPECT_NE(session.frame().drug.arrival_s, nullptr);
    int finished = 0;
    for (const RecordedStep& step : recording->steps)
        for (const Command& command : step.commands)
            finished += std::holds_alternative<FinishInjection>(command) ? 1 : 0;
    EXPECT_EQ(finished, 1);
    const ReplayResult replayed = replay(*recording, small_patient(), job);
    EXPECT_EQ(replayed.steps, recording->steps.size());
    EXPECT_FALSE(replayed.diverged_at.has_value());
}

TEST(Injections, OfAScriptAreWaitedForAtTheirStep) {
    Script script;
    ScriptAction action;
    action.at_s = 0.1;
    action.what = "inject";
    action.place.share_of_longest_path = 0.0;
    action.command = InjectDrug{.void_fraction = 0.4, .second_phase = "gas"};
    script.actions.push_back(action);
    const auto commands = schedule(script, small_patient()->tree, 0.05, 5);
    ASSERT_EQ(commands[2].size(), 2u);
    const auto session = hashing_session();
    for (int step = 0; step < 5; ++step) {
        for (const Command& command : commands[step]) session->post(command);
        session->step();
        session->update_frame();
        EXPECT_EQ(session->frame().drug.arrival_s != nullptr, step >= 2);
        EXPECT_FALSE(session->frame().drug.computing);
    }
}

}  // namespace
}  // namespace hepatica
