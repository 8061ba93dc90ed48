// SPDX-License-Identifier: GPL-3.0-or-later
// A device presses a vessel of a real session: the loop at 1 kHz, the simulation at 60 Hz. At rest
// the hand feels what the simulation's pad presses with, and no friction; what was played plays
// again without a device.
#include "core/haptics/patch_feed.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "core/haptics/force_loop.h"
#include "core/haptics/simulated_device.h"
#include "core/mesh/brick_mesh.h"
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
          loop(device, models, [this](const Command& c) { return session.post(c); }) {}
    // A second is 60 steps and 1000 ticks.
    void play(int steps) {
        for (int i = 0; i < steps; ++i) {
            step = session.step();
            feed.fill(*session.world().deform(), 1.0 / 60.0, models.back());
            models.back().commands_taken = session.commands_taken();
            most_contacts =
                std::max(most_contacts, static_cast<int>(models.back().contacts.size()));
            models.publish();
            for (const int until = ticks + (i % 3 == 2 ? 16 : 17); ticks < until; ++ticks)
                tick = loop.tick();
        }
    }
};

// Of the body on the tool, without friction.
Vec3 force_of_pads(const Session& session) {
    const DeformPart& part = *session.world().deform();
    const Body body = build_body(part.body(), ElementModel::corotated, ElementOrder::linear);
    ToolContact contact(body);
    contact.set(part.tool());
    Vec3 sum = Vec3::Zero();
    for (const PadContact& point : contact.contacts(part.positions_mm()))
        sum -= point.force_un * point.normal;
    return sum;
}

TEST(PatchFeed, AtRestTheHandFeelsTheSimulationsForce) {
    for (const double by_mm : {1.5, 3.0}) {
        const auto session = new_session(touchable());
        session->post(ball());
        Felt felt(*session, {.path = down(by_mm)}, {.damping_un_s_per_mm = 5e3});
        felt.play(300);
        // When exactly it is still enough to sleep hangs on the last bits of the machine's sines.
        for (int more = 0; more < 20 && !felt.step.deform.asleep; ++more) felt.play(30);
        const Vec3 tool = felt.step.deform.tool.force_un, hand = felt.tick.force.force_un;
        const Vec3 pads = force_of_pads(*session);
        EXPECT_GT(felt.step.deform.tool.contacts, 0);
        EXPECT_GT(hand.norm(), 1e3);
        EXPECT_LT((hand - pads).norm(), 1e-3 * pads.norm());
        EXPECT_NEAR(hand.norm(), tool.norm(), 0.03 * tool.norm());
        EXPECT_LT(felt.device.velocity_mm_per_s().norm(), 1e-3);
        EXPECT_TRUE(felt.step.deform.asleep);
        EXPECT_LE(felt.most_contacts, most_local_contacts);
        EXPECT_LT(felt.device.most_work_nj(), 5e4);
    }
}

// Forceps that hold a vessel touch it at many points.
TEST(PatchFeed, JoinsManyContactsToSixtyFourAndKeepsTheirForce) {
    const auto session = new_session(touchable());
    session->post(AddTool{.kind = "forceps",
                          .radius_mm = 1.6,
                          .length_mm = 16.0,
                          .direction = Vec3(0, 0, -1),
                          .point_mm = ball().point_mm});
    session->step();
    session->post(ShiftTool{Vec3(0, 0, -4.0)});
    test::play(*session, 30);
    session->post(CloseForceps{});
    const SessionStep last = test::play(*session, 60);
    ASSERT_GT(last.deform.tool.contacts, 80);
    const DeformPart& part = *session->world().deform();
    PatchFeed feed;
    LocalModel model;
    feed.fill(part, 1.0 / 60.0, model);
    EXPECT_GE(model.contacts.size(), 64u);
    EXPECT_LE(model.contacts.size(), 65u);
    Vec3 sum = Vec3::Zero();
    for (const LocalContact& joined : model.contacts) sum -= joined.force_un * joined.normal;
    double most = 0.0;
    for (const LocalContact& joined : model.contacts) most += joined.force_un;
    EXPECT_LT((sum - force_of_pads(*session)).norm(), 1e-9 * most);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(model.compliance);
    EXPECT_GT(modes.eigenvalues()[0], 0.0);
    EXPECT_LT((model.compliance - model.compliance.transpose()).norm(),
              1e-9 * model.compliance.norm());
}

// Pairs that push from two sides, as a rod between two walls has them. Only the first pushes more
// from one side; what is left of the second is rounding.
TEST(PatchFeed, LeavesOutJoinedContactsWhoseForcesCancel) {
    BodyDescription brick;
    brick.mesh = kuhn_brick(Vec3(4, 4, 4), {2, 2, 2});
    brick.touchable = true;
    const Body body = build_body(brick, ElementModel::corotated, ElementOrder::linear);
    const ToolContact pads(body);
    std::vector<PadContact> points(2 * most_local_contacts);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].weights = {1.0, 0.0, 0.0};
        points[i].normal = i % 2 == 0 ? Vec3::UnitZ() : Vec3(-Vec3::UnitZ());
        points[i].at_mm = Vec3(static_cast<double>(i), 0.0, 0.0);
        points[i].force_un = 1.0;
        points[i].stiffness_un_per_mm = 5.0;
    }
    points[0].force_un = 3.0;
    points[2].force_un = 1.0 + 1e-15;
    JoinedContacts joined;
    join(points, pads, joined);
    ASSERT_EQ(joined.contacts.size(), 1u);
    ASSERT_EQ(joined.loads.size(), 1u);
    EXPECT_EQ(joined.stiffness_un_per_mm, std::vector<double>{10.0});
    EXPECT_EQ(joined.contacts[0].force_un, 2.0);
    EXPECT_EQ(joined.contacts[0].normal, Vec3(0, 0, 1));
    EXPECT_EQ(joined.contacts[0].at_mm, Vec3(0.25, 0, 0));
    Vec3 load = Vec3::Zero();
    for (const Vec3& force : joined.loads[0].forces) load += force;
    EXPECT_EQ(load, Vec3(0, 0, 1));
}

// A ball of 5 mm above the vessel that ball() is put on.
std::shared_ptr<const PatientCase> with_a_tumour() {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    const Vec3 above = test::middle_of(patient->tree, 1) + Vec3(0, 0, 14);
    Grid grid{{20, 20, 20}};
    grid.origin_mm = above - Vec3::Constant(9.5);
    patient->organs = Mask(grid);
    for (std::size_t i = 0; i < patient->organs.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        if ((grid.to_mm(x, y, z) - above).norm() <= 5.0)
            patient->organs.voxels[i] = organ_label::first_tumour;
    }
    return patient;
}

// Obstacles are rigid: what gives is their pad alone.
TEST(PatchFeed, ATumourIsFelt) {
    Job job;
    SceneSpec spec = touchable();
    spec.contact->obstacles = WantedObstacles::known;
    Session session(with_a_tumour(), spec, job);
    ASSERT_TRUE(session.world().deform()->body().obstacles);
    session.post(ball());
    Felt felt(session, {.path = down(6.0)}, {.damping_un_s_per_mm = 5e3});
    // The feed knew the same vessels without obstacles.
    const auto plain = new_session(touchable());
    plain->post(ball());
    plain->step();
    LocalModel before;
    felt.feed.fill(*plain->world().deform(), 1.0 / 60.0, before);
    felt.play(120);
    const DeformPart& part = *session.world().deform();
    const Body body = build_body(part.body(), ElementModel::corotated, ElementOrder::linear);
    ToolContact contact(body);
    contact.set(part.tool());
    const ToolContact::ObstaclePress press = contact.pressed_by_obstacles();
    ASSERT_FALSE(press.contacts.empty());
    ASSERT_TRUE(contact.contacts(part.positions_mm()).empty());
    Vec3 of_tumour = Vec3::Zero();
    for (const PadContact& point : press.contacts)
        of_tumour -= press.share * point.force_un * point.normal;
    LocalModel model;
    felt.feed.fill(part, 1.0 / 60.0, model);
    ASSERT_FALSE(model.contacts.empty());
    EXPECT_LE(model.contacts.size(), std::size_t{most_rigid_contacts});
    Vec3 sum = Vec3::Zero();
    for (const LocalContact& joined : model.contacts) sum -= joined.force_un * joined.normal;
    EXPECT_LT((sum - of_tumour).norm(), 1e-9 * of_tumour.norm());
    EXPECT_GT(model.compliance.diagonal().minCoeff(), 0.0);
    EXPECT_TRUE(model.compliance.isDiagonal());
    EXPECT_GT(felt.tick.force.force_un.z(), 1e3) << "it holds the hand up";
}

// The trunk is cut through, and what is beyond stands 8 mm away. Its wall at rest spans that gap.
TEST(PatchFeed, InTheGapOfATornVesselNothingIsFelt) {
    SceneSpec spec = touchable();
    spec.tear.emplace();
    const auto session = new_session(spec);
    const auto& points = small_patient()->tree.segments[0].points_mm;
    const std::size_t m = points.size() / 2;
    const Vec3 along = (points[m + 1] - points[m - 1]).normalized();
    const Vec3 across = along.unitOrthogonal();
    session->post(ball(1.0));  // the feed knows the whole body first
    session->step();
    PatchFeed feed;
    LocalModel model;
    DeformPart& part = *session->world().deform();
    feed.fill(part, 1.0 / 60.0, model);
    session->post(RemoveTool{});
    session->post(Blade{points[m] - 15.0 * across, points[m] + 15.0 * across});
    ASSERT_EQ(session->step().deform.tear.pieces, 2);
    const std::vector<int> piece = part.torn()->piece_of_vertices({});
    BodyState state = part.state();
    for (std::size_t v = 0; v < piece.size(); ++v) {
        const Vec3& rest = part.rest_positions_mm()[v];
        const bool beyond = piece[v] != piece[0];
        EXPECT_LT((rest - points[m]).dot(along) * (beyond ? -1.0 : 1.0), 4.0);
        if (beyond) state.positions_mm[v] += 8.0 * along;
        state.velocities_mm_per_s[v].setZero();
    }
    part.set_state(state);
    const Vec3 gap = points[m] + 4.0 * along;
    const double radius_mm = small_patient()->tree.segments[0].radii_mm[m];
    session->post(AddTool{
        .radius_mm = 1.0, .direction = -across, .point_mm = gap + (radius_mm - 1.0) * across});
    ASSERT_EQ(session->step().deform.tool.contacts, 0);
    feed.fill(part, 1.0 / 60.0, model);
    EXPECT_TRUE(model.contacts.empty());
}

// The small patient's vessels and, beside them, the same once more.
std::shared_ptr<const PatientCase> twice_the_small_patient(const Vec3& beside_mm) {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    const VesselTree one = patient->tree;
    const int vertices = static_cast<int>(patient->mesh.vertices_mm.size());
    const int nodes = static_cast<int>(one.nodes.size());
    const int segments = static_cast<int>(one.segments.size());
    for (VesselNode node : one.nodes) {
        node.position_mm += beside_mm;
        patient->tree.nodes.push_back(node);
    }
    for (VesselSegment segment : one.segments) {
        segment.proximal_node += nodes;
        segment.distal_node += nodes;
        if (segment.parent >= 0) segment.parent += segments;
        for (Vec3& point : segment.points_mm) point += beside_mm;
        patient->tree.segments.push_back(segment);
    }
    TetMesh& mesh = patient->mesh;
    for (int v = 0; v < vertices; ++v)
        mesh.vertices_mm.push_back(Vec3(mesh.vertices_mm[v] + beside_mm));
    for (std::array<int, 4> corners : small_patient()->mesh.tetrahedra) {
        for (int& corner : corners) corner += vertices;
        mesh.tetrahedra.push_back(corners);
    }
    patient->surface = surface_of(mesh).mesh;
    return patient;
}

// The first of two like vessels is cut, then it is whole again and the second is cut, which splits
// as many vertices. The tool then presses where the first was cut.
TEST(PatchFeed, FollowsATearThatSplitsAsManyVerticesElsewhere) {
    const Vec3 beside_mm(256, 0, 0);
    const auto patient = twice_the_small_patient(beside_mm);
    SceneSpec spec = touchable();
    spec.tear.emplace();
    Job job;
    Session session(patient, spec, job);
    const auto& points = patient->tree.segments[0].points_mm;
    const std::size_t m = points.size() / 2;
    const Vec3 across = (points[m + 1] - points[m - 1]).normalized().unitOrthogonal();
    AddTool ball{.radius_mm = 4.0, .direction = -across, .point_mm = points[m] + 25.0 * across};
    session.post(ball);  // without a tool the feed would begin anew
    session.step();
    DeformPart& part = *session.world().deform();
    const int whole = part.torn()->vertex_count();
    PatchFeed feed;
    LocalModel model;
    const auto cut_at = [&](const Vec3& place) {
        part.cut(patient->tree, place - 15.0 * across, place + 15.0 * across);
        feed.fill(part, 1.0 / 60.0, model);
        return part.torn()->vertex_count() - whole;
    };
    const int split = cut_at(points[m]);
    ASSERT_GT(split, 0);
    part.mend();
    ASSERT_EQ(cut_at(points[m] + beside_mm), split);

    ball.point_mm = points[m];
    session.post(ball);
    session.step();
    session.post(ShiftTool{-across});
    test::play(session, 30);
    ASSERT_EQ(part.torn()->vertex_count() - whole, split) << "the press itself tears nothing";
    feed.fill(part, 1.0 / 60.0, model);
    LocalModel expected;
    PatchFeed fresh;
    fresh.fill(part, 1.0 / 60.0, expected);
    ASSERT_FALSE(expected.contacts.empty());
    ASSERT_EQ(model.contacts.size(), expected.contacts.size());
    for (std::size_t i = 0; i < expected.contacts.size(); ++i) {
        EXPECT_EQ(model.contacts[i].at_mm, expected.contacts[i].at_mm) << i;
        EXPECT_EQ(model.contacts[i].force_un, expected.contacts[i].force_un) << i;
    }
}

TEST(PatchFeed, GivesWhatTheToolHasStillToTurn) {
    const auto session = new_session(touchable());
    session->post(ball());
    session->step();
    DeformPart& part = *session->world().deform();
    PatchFeed feed;
    LocalModel model;
    feed.fill(part, 1.0 / 60.0, model);
    EXPECT_EQ(model.left_rad, Vec3(0, 0, 0));
    part.turn_tool(Vec3(0, 0.1, 0));
    feed.fill(part, 1.0 / 60.0, model);
    EXPECT_EQ(model.left_rad, Vec3(0, 0.1, 0));
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
    EXPECT_GE(moves, 90);
    EXPECT_GE(turns, 90);
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
