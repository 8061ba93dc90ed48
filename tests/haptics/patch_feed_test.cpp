// SPDX-License-Identifier: GPL-3.0-or-later
// A device presses a vessel of a real session: the loop at 1 kHz, the simulation at 60 Hz. At rest
// the hand feels what the simulation's pad presses with; what was played plays again without a
// device.
#include "core/haptics/patch_feed.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "core/haptics/force_loop.h"
#include "core/haptics/simulated_device.h"
#include "core/scene/world.h"
#include "core/session/replay.h"
#include "tests/haptics/touchable_patient.h"
#include "tests/session/recorded.h"

namespace hepatica {
namespace {

using test::ball;
using test::keep_recording;
using test::new_session;
using test::small_patient;
using test::touchable;

// Down by so much within a second, then still.
std::function<HapticPose(double)> down(double by_mm) {
    return [by_mm](double t) { return HapticPose{.at_mm = Vec3(0, 0, -by_mm * std::min(1.0, t))}; };
}

struct Felt {
    Session& session;
    SimulatedDevice device;
    TripleBuffer<LocalModel> models;
    PatchFeed feed;
    ForceLoop loop;
    SessionStep step;
    Tick tick;
    int ticks = 0, most_contacts = 0;

    Felt(Session& played, const SimulatedHand& hand, const HapticTraits& traits = {})
        : session(played),
          device(hand, traits),
          loop(device, models, [this](const Command& c) { session.post(c); }) {}
    // A second is 60 steps and 1000 ticks.
    void play(int steps) {
        for (int i = 0; i < steps; ++i) {
            step = session.step();
            feed.fill(*session.world().deform(), 1.0 / 60.0, models.back());
            most_contacts =
                std::max(most_contacts, static_cast<int>(models.back().contacts.size()));
            models.publish();
            for (const int until = ticks + (i % 3 == 2 ? 16 : 17); ticks < until; ++ticks)
                tick = loop.tick();
        }
    }
};

TEST(PatchFeed, AtRestTheHandFeelsTheSimulationsForce) {
    for (const double by_mm : {1.5, 3.0}) {
        const auto session = new_session(touchable());
        session->post(ball());
        Felt felt(*session, {.path = down(by_mm)}, {.damping_un_s_per_mm = 5e3});
        felt.play(300);
        const Vec3 tool = felt.step.deform.tool.force_un, hand = felt.tick.force.force_un;
        EXPECT_GT(felt.step.deform.tool.contacts, 0);
        EXPECT_GT(hand.norm(), 1e3);
        EXPECT_LT((hand - tool).norm(), 0.03 * tool.norm())
            << "hand " << hand.transpose() << ", tool " << tool.transpose();
        EXPECT_LT(felt.device.velocity_mm_per_s().norm(), 0.05);
        EXPECT_LE(felt.most_contacts, most_local_contacts);
        EXPECT_LT(felt.device.most_work_nj(), 5e4);
    }
}

TEST(PatchFeed, JoinsManyContactsToSixtyFourAndKeepsTheirForce) {
    const auto session = new_session(touchable());
    session->post(ball(12.0));
    Felt felt(*session, {.path = down(5.0)}, {.damping_un_s_per_mm = 5e3});
    felt.play(120);
    ASSERT_GT(felt.step.deform.tool.contacts, 70);
    LocalModel model;
    felt.feed.fill(*session->world().deform(), 1.0 / 60.0, model);
    EXPECT_LE(model.contacts.size(), 64u);
    EXPECT_GT(model.contacts.size(), 30u);
    PatchCompliance whole(session->world().deform()->body(), ElementModel::corotated);
    ToolContact contact(whole.body());
    contact.set(session->world().deform()->tool());
    Vec3 sum = Vec3::Zero(), of_model = Vec3::Zero();
    for (const PadContact& point : contact.contacts(session->world().deform()->positions_mm()))
        sum += point.force_un * point.normal;
    for (const LocalContact& joined : model.contacts) of_model += joined.force_un * joined.normal;
    EXPECT_LT((sum - of_model).norm(), 1e-9 * sum.norm());
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(model.compliance);
    EXPECT_GT(modes.eigenvalues()[0], 0.0);
    EXPECT_LT((model.compliance - model.compliance.transpose()).norm(),
              1e-9 * model.compliance.norm());
}

TEST(PatchFeed, WithoutAToolThereIsNothing) {
    const auto session = new_session(touchable());
    Felt felt(*session, {.path = down(3.0)});
    felt.play(20);
    EXPECT_FALSE(felt.tick.tool);
    EXPECT_EQ(felt.most_contacts, 0);
    session->post(ball());
    felt.play(2);
    EXPECT_TRUE(felt.tick.tool);
    session->post(RemoveTool{});
    felt.play(1);
    EXPECT_FALSE(felt.tick.tool);
    EXPECT_EQ(felt.device.acting().both(), Vec6(Vec6::Zero()));
}

TEST(PatchFeed, WhatWasPlayedPlaysAgainWithoutADevice) {
    const auto session = new_session(touchable());
    const auto recording = keep_recording(*session);
    session->post(ball());
    SimulatedHand hand{.encoder_mm = 0.02};
    hand.path = [](double t) {
        return HapticPose{.at_mm = Vec3(std::sin(3.0 * t), 0, -3.0 * std::min(1.0, t)),
                          .turned = Eigen::Quaterniond(Eigen::AngleAxisd(0.3 * t, Vec3::UnitX()))};
    };
    Felt felt(*session, hand, {.damping_un_s_per_mm = 5e3});
    felt.play(100);
    ASSERT_GT(felt.step.deform.tool.contacts, 0);
    int moves = 0, turns = 0;
    for (const RecordedStep& step : recording->steps)
        for (const Command& command : step.commands) {
            moves += std::holds_alternative<MoveTool>(command) ? 1 : 0;
            turns += std::holds_alternative<TurnTool>(command) ? 1 : 0;
        }
    EXPECT_GT(moves, 90);
    EXPECT_GT(turns, 90);
    Job job;
    EXPECT_FALSE(replay(*recording, small_patient(), job).diverged_at);
}

// Whoever feels a play does not change it.
TEST(PatchFeed, ChangesNoBitOfThePlay) {
    std::vector<std::uint64_t> hashes;
    for (const bool felt : {false, true}) {
        const auto session = new_session(touchable());
        session->post(ball());
        PatchFeed feed;
        LocalModel model;
        for (int i = 0; i < 60; ++i) {
            session->post(ShiftTool{Vec3(0, 0, -0.05)});
            session->step();
            if (felt) feed.fill(*session->world().deform(), 1.0 / 60.0, model);
        }
        EXPECT_EQ(model.contacts.empty(), !felt);
        hashes.push_back(session->state_hash());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace hepatica
