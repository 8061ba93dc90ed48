// SPDX-License-Identifier: GPL-3.0-or-later
// A tool in a session: it comes beside a vessel, pushes it, and is part of everything that is kept
// and played again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.h"
#include "core/contact/closest_points.h"
#include "core/scene/deform_part.h"
#include "core/scene/world.h"
#include "core/session/recording_file.h"
#include "core/session/replay.h"
#include "core/session/script.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using test::keep_recording;
using test::middle_of;
using test::new_session;
using test::play;
using test::small_patient;
using testing::HasSubstr;

SceneSpec touchable() {
    SceneSpec spec = default_scene();
    spec.flow.reset();
    spec.contact = ContactSpec{};
    return spec;
}

AddTool ball() {
    return {.radius_mm = 2.0,
            .direction = Vec3(0, 0, -1),
            .point_mm = middle_of(small_patient()->tree, 1)};
}

// A second and a half in which a ball comes from above, pushes down and stays.
SessionStep push(Session& session) {
    session.post(ball());
    for (int i = 0; i < 40; ++i) {
        session.post(ShiftTool{Vec3(0.02, 0, -0.15)});
        session.step();
    }
    return play(session, 50);
}

TEST(ToolSession, AToolComesBesideTheVesselAndPushesIt) {
    const auto session = new_session(touchable());
    session->post(ball());
    session->step();
    const DeformPart& deform = *session->world().deform();
    ASSERT_TRUE(deform.tool());
    EXPECT_EQ(session->frame().statistics.message, "");
    const Vec3 begin = deform.tool()->parts[0].shape.centre_mm;
    EXPECT_GT(begin.z(), ball().point_mm.z());  // it comes from where its direction points away
    EXPECT_NEAR((begin - ball().point_mm).head<2>().norm(), 0.0, 1e-9);
    const SessionStep last = push(*session);
    EXPECT_GT(last.deform.tool.contacts, 0);
    EXPECT_GT(last.deform.tool.force_un.z(), 0.0);
    EXPECT_GT(last.deform.tool.least_gap_mm, 0.0);
    session->post(RemoveTool{});
    EXPECT_EQ(session->step().deform.tool.contacts, 0);
    EXPECT_FALSE(deform.tool());
}

TEST(ToolSession, IsLedEvenlyOverSomeTimeAndRecordsEachPiece) {
    const auto session = new_session(touchable());
    const auto recording = keep_recording(*session);
    session->post(ball());
    session->step();
    const DeformPart& deform = *session->world().deform();
    const Vec3 begin = deform.tool()->target_mm;
    session->post(MoveTool{.target_mm = begin + Vec3(0, 0, 3), .over_s = 3.0 / 60.0});
    for (int i = 1; i <= 3; ++i) {
        session->step();
        EXPECT_NEAR((deform.tool()->target_mm - begin - Vec3(0, 0, i)).norm(), 0.0, 1e-9);
    }
    session->post(MoveTool{.target_mm = begin, .over_s = 3.0 / 60.0});
    session->step();
    session->post(ShiftTool{Vec3(1, 0, 0)});  // goes on from where it is led now, and ends the way
    play(*session, 3);
    EXPECT_NEAR((deform.tool()->target_mm - begin - Vec3(1, 0, 2)).norm(), 0.0, 1e-9);
    int pieces = 0;
    for (const RecordedStep& step : recording->steps)
        for (const Command& command : step.commands)
            if (const auto* move = std::get_if<MoveTool>(&command)) {
                EXPECT_FALSE(move->over_s);
                ++pieces;
            }
    EXPECT_EQ(pieces, 4);
    Job job;
    EXPECT_FALSE(replay(*recording, small_patient(), job).diverged_at);
}

TEST(ToolSession, TheRecordingPlaysAgainFromItsStartAndFromItsKeyframes) {
    const auto session = new_session(touchable());
    const auto recording = keep_recording(*session);
    play(*session, 560);
    push(*session);  // over the keyframe at 600
    session->post(MoveTool{middle_of(small_patient()->tree, 1) + Vec3(0, 0, -4), 0.5});
    play(*session, 20);
    session->post(RestoreSnapshot{});
    play(*session, 20);
    session->post(ResetWorld{});
    play(*session, 3);
    test::expect_to_play_again(*session, *recording, {620});
}

// What tools need is built when they are first used and let go of afterwards; all of it plays
// again.
TEST(ToolSession, ToolsComeAndGoWithTheirPartOfTheScene) {
    SceneSpec spec = default_scene();
    spec.flow.reset();
    const auto session = new_session(spec);
    const auto recording = keep_recording(*session);
    const DeformPart& deform = *session->world().deform();
    play(*session, 550);
    EXPECT_FALSE(deform.touchable());
    session->post(UseTools{true});
    session->step();
    EXPECT_TRUE(deform.touchable());
    AddTool rod = ball();
    rod.kind = "capsule";
    rod.length_mm = 12.0;
    session->post(rod);
    session->post(TurnTool{Vec3(0.4, 0, 0)});
    for (int i = 0; i < 60; ++i) {  // over the keyframe at 600
        session->post(ShiftTool{Vec3(0, 0, -0.1)});
        session->step();
    }
    ASSERT_TRUE(deform.tool());
    const Vec3 along = deform.tool()->parts[0].shape.half_axis_mm.normalized();
    EXPECT_NEAR(std::acos(std::abs(along.z())), 0.4, 1e-6);
    session->post(UseTools{false});
    session->step();
    EXPECT_FALSE(deform.touchable());
    EXPECT_FALSE(deform.tool());
    EXPECT_EQ(session->frame().statistics.message, "");
    play(*session, 20);
    session->post(RestoreSnapshot{});  // to when there was a tool
    session->step();
    EXPECT_FALSE(deform.touchable());
    EXPECT_FALSE(deform.tool());
    play(*session, 5);
    test::expect_to_play_again(*session, *recording, {610});
}

// Forceps around a vessel close, hold it, lift it and let it go; it all plays again.
TEST(ToolSession, ForcepsTakeAVesselAndLiftIt) {
    const auto session = new_session(touchable());
    const auto recording = keep_recording(*session);
    const VesselTree& tree = small_patient()->tree;
    const auto& line = tree.segments[1].points_mm;
    const std::size_t m = line.size() / 2;
    const Vec3 along = (line[m + 1] - line[m - 1]).normalized();
    const Vec3 from = along.unitOrthogonal();
    AddTool forceps{"forceps", 1.5, 16.0, -from, line[m], along.cross(from)};
    session->post(forceps);
    session->step();
    session->update_frame();
    ASSERT_EQ(session->frame().statistics.message, "");
    const DeformPart& deform = *session->world().deform();
    ASSERT_EQ(deform.tool()->parts.size(), 2u);
    EXPECT_EQ(deform.tool()->opening_mm, 9.0);
    EXPECT_FALSE(session->frame().tool->at_limit);
    EXPECT_FALSE(session->frame().tool->closing);
    for (int i = 0; i < 30; ++i) {
        session->post(CloseForceps{1.0 / (30 - i)});
        session->step();
    }
    const SessionStep held = play(*session, 60);
    EXPECT_GT(held.deform.tool.grip_un, 100.0);
    session->update_frame();
    EXPECT_TRUE(session->frame().tool->at_limit) << "a vessel is softer than jaws";
    EXPECT_TRUE(session->frame().tool->closing);
    EXPECT_GT(session->frame().tool->grip_un, 100.0);
    EXPECT_LT(deform.tool()->opening_mm, 2.0 * 4.0);
    const auto nearest = [&] {
        int best = 0;
        for (int v = 0; v < static_cast<int>(session->world().vertex_count()); ++v)
            if ((session->world().rest_positions_mm()[v] - line[m]).norm() <
                (session->world().rest_positions_mm()[best] - line[m]).norm())
                best = v;
        return best;
    }();
    const Vec3 before = session->world().vertex_mm(nearest);
    for (int i = 0; i < 40; ++i) {
        session->post(ShiftTool{0.05 * from});
        session->step();
    }
    const SessionStep lifted = play(*session, 20);
    EXPECT_GT((session->world().vertex_mm(nearest) - before).dot(from), 0.8);
    EXPECT_LT(lifted.deform.tool.force_un.dot(from), 0.0);
    session->post(OpenForceps{});
    session->step();
    session->update_frame();
    EXPECT_FALSE(session->frame().tool->closing);
    EXPECT_EQ(session->frame().tool->grip_un, 0.0) << "open jaws hold nothing";
    EXPECT_EQ(play(*session, 30).deform.tool.grip_un, 0.0);
    test::expect_to_play_again(*session, *recording, {});
}

TEST(ToolSession, OnlyForcepsHaveJaws) {
    const auto session = new_session(touchable());
    session->post(CloseForceps{});  // nothing to close
    session->step();
    session->update_frame();
    EXPECT_EQ(session->frame().statistics.message, "");
    session->post(ball());
    session->step();
    session->post(CloseForceps{});
    session->step();
    session->update_frame();
    EXPECT_THAT(session->frame().statistics.message, HasSubstr("no jaws"));
}

TEST(ToolSession, AFrameShowsTheToolWhatItTouchesAndWhatItFeels) {
    const auto session = new_session(touchable());
    session->update_frame();
    EXPECT_FALSE(session->frame().tool);
    const SessionStep last = push(*session);
    session->update_frame();
    const Frame& frame = session->frame();
    ASSERT_TRUE(frame.tool);
    EXPECT_EQ(frame.tool->centre_mm, session->world().deform()->tool()->centre_mm());
    EXPECT_EQ(frame.tool->parts.at(0).radius_mm, 2.0);
    EXPECT_EQ(frame.tool->force_un, last.deform.tool.force_un);
    // Each is of a triangle of which a part is in the pad, which is 0.2 mm thick.
    ASSERT_GE(frame.tool->touched.size(), 3u);
    const auto place = [&](int v) {
        const float* x = &frame.positions_mm[3 * static_cast<std::size_t>(v)];
        return Vec3(x[0], x[1], x[2]);
    };
    const auto near = [&](const std::array<int, 3>& triangle) {
        const Triangle corners{place(triangle[0]), place(triangle[1]), place(triangle[2])};
        const Vec3& c = frame.tool->centre_mm;
        return std::sqrt(closest(Segment{c, c}, corners).squared_mm2) < 2.0 + 0.2;
    };
    std::set<int> expected;
    for (const auto& triangle : *frame.surface)
        if (near(triangle)) expected.insert(triangle.begin(), triangle.end());
    for (const int v : frame.tool->touched) EXPECT_TRUE(expected.contains(v)) << v;
    EXPECT_GE(2 * frame.tool->touched.size(), expected.size());
}

// Ways that are superseded before a step are not gone; shares of a way are.
TEST(ToolSession, OfSeveralWaysBeforeAStepTheNewestCounts) {
    const auto session = new_session(touchable());
    const auto recording = keep_recording(*session);
    session->post(ball());
    session->step();
    const Vec3 begin = session->world().deform()->tool()->centre_mm();
    for (int i = 1; i <= 5; ++i) session->post(MoveTool{begin + Vec3(0, 0, i)});
    session->step();
    EXPECT_EQ(recording->steps.back().commands.size(), 1u);
    EXPECT_EQ(session->world().deform()->tool()->target_mm, Vec3(begin + Vec3(0, 0, 5)));
    session->post(MoveTool{begin, 0.5});
    session->post(MoveTool{begin, 0.5});
    session->step();
    EXPECT_EQ(recording->steps.back().commands.size(), 2u);
}

TEST(ToolSession, TheHashIsOfTheToolToo) {
    const auto session = new_session(touchable());
    const std::uint64_t without = session->state_hash();
    session->post(SetPaused{true});
    session->post(ball());
    session->step();
    const std::uint64_t with = session->state_hash();
    session->post(ShiftTool{Vec3(0, 0, -0.1)});
    session->step();
    EXPECT_NE(with, without);
    EXPECT_NE(session->state_hash(), with);
}

TEST(ToolSession, AToolThatHasGoneStaysAwayAndAResetTakesItAway) {
    const auto session = new_session(touchable());
    push(*session);
    session->post(RestoreSnapshot{});
    session->step();
    EXPECT_TRUE(session->world().deform()->tool());
    session->post(RemoveTool{});
    session->step();
    session->post(RestoreSnapshot{});
    session->step();
    EXPECT_FALSE(session->world().deform()->tool());
    session->post(ball());
    session->post(ResetWorld{});
    session->step();
    EXPECT_FALSE(session->world().deform()->tool());
}

TEST(ToolSession, OtherSettingsKeepTheTool) {
    const auto session = new_session(touchable());
    push(*session);
    const Vec3 centre = session->world().deform()->tool()->parts[0].shape.centre_mm;
    session->post(SetTether{25.0});
    session->post(UseSetting{{.newton_iterations = 3}});
    session->step();
    ASSERT_TRUE(session->world().deform()->tool());
    EXPECT_LT((session->world().deform()->tool()->parts[0].shape.centre_mm - centre).norm(), 1.0);
}

TEST(ToolSession, WhatIsOutOfRangeIsNamed) {
    const auto message_of = [](const SceneSpec& spec, const Command& command) {
        const auto session = new_session(spec);
        const std::uint64_t before = session->state_hash();
        session->post(command);
        session->post(SetPaused{true});
        session->step();
        session->post(SetPaused{false});
        session->update_frame();
        EXPECT_FALSE(session->world().deform()->tool());
        EXPECT_NE(session->state_hash(), before);  // paused alone
        return session->frame().statistics.message;
    };
    const auto with = [](auto change) {
        AddTool tool = ball();
        change(tool);
        return Command(tool);
    };
    EXPECT_THAT(message_of(default_scene(), ball()), HasSubstr("contacts of the scene"));
    EXPECT_THAT(message_of(touchable(), with([](auto& t) { t.kind = "saw"; })), HasSubstr("saw"));
    EXPECT_THAT(message_of(touchable(), with([](auto& t) {
                               t.kind = "hook";
                               t.side = t.direction;
                           })),
                HasSubstr("side"));
    EXPECT_THAT(message_of(touchable(), with([](auto& t) { t.radius_mm = 0.0; })),
                HasSubstr("radius"));
    EXPECT_THAT(message_of(touchable(), with([](auto& t) { t.length_mm = -1.0; })),
                HasSubstr("length"));
    EXPECT_THAT(message_of(touchable(), with([](auto& t) { t.direction.setZero(); })),
                HasSubstr("direction"));
    EXPECT_THAT(message_of(touchable(), with([](auto& t) { t.point_mm.x() = NAN; })),
                HasSubstr("not within 10 m"));
}

TEST(ToolSession, ASceneNamesItsContacts) {
    const SceneSpec all = scene_from_json(Json::parse(R"({"deform": {}, "contact": {}})"));
    ASSERT_TRUE(all.contact);
    EXPECT_TRUE(all.contact->tools);
    EXPECT_TRUE(all.contact->self);
    EXPECT_EQ(all.contact->obstacles, WantedObstacles::known);
    EXPECT_EQ(to_json(all)["contact"], Json::object());
    const SceneSpec self =
        scene_from_json(Json::parse(R"({"deform": {}, "contact": {"self": true}})"));
    EXPECT_TRUE(self.contact->self);
    EXPECT_FALSE(self.contact->tools);
    EXPECT_EQ(to_json(self)["contact"]["self"], true);
    EXPECT_FALSE(scene_from_json(Json::parse(R"({"deform": {}})")).contact);
    EXPECT_FALSE(default_scene().contact);
    EXPECT_FALSE(scene_from_json(Json::parse(R"({"deform": {}, "contact": {"tools": false}})"))
                     .contact->tools);
    for (const char* text :
         {R"({"flow": {}, "contact": {}})", R"({"deform": {}, "contact": {"obstacles": 1}})",
          R"({"deform": {}, "contact": {"tool": true}})", R"({"deform": {}, "contact": 1})"})
        EXPECT_THROW(scene_from_json(Json::parse(text)), InputError) << text;
}

TEST(ToolSession, AScriptLeadsATool) {
    const fs::path file = fs::path(testing::TempDir()) / "tool.json";
    std::ofstream(file) << R"({"scene": {"deform": {}, "contact": {"tools": true}}, "actions": [
        {"at_s": 0, "do": "tool", "tool": "capsule", "radius_mm": 1.5, "length_mm": 10,
         "direction": [0, 0, -1], "where": {"point_mm": [1, 2, 3]}},
        {"at_s": 0.2, "do": "move_tool", "by_mm": [0, 0, -3], "over_s": 0.3},
        {"at_s": 0.6, "do": "move_tool", "to_mm": [5, 6, 7], "over_s": 0.2},
        {"at_s": 0.9, "do": "remove_tool"},
        {"at_s": 1.0, "do": "tool", "tool": "forceps", "radius_mm": 1, "length_mm": 12,
         "direction": [0, 0, -1], "side": [1, 0, 0], "where": {"point_mm": [1, 2, 3]}},
        {"at_s": 1.0, "do": "close_forceps", "over_s": 0.2},
        {"at_s": 1.2, "do": "open_forceps"}]})";
    const auto commands = schedule(read_script(file), small_patient()->tree, 0.1, 14);
    const AddTool tool = std::get<AddTool>(commands[0][0]);
    EXPECT_EQ(tool.kind, "capsule");
    EXPECT_EQ(tool.radius_mm, 1.5);
    EXPECT_EQ(tool.length_mm, 10.0);
    EXPECT_EQ(tool.direction, Vec3(0, 0, -1));
    EXPECT_EQ(tool.point_mm, Vec3(1, 2, 3));
    for (int i = 2; i < 5; ++i)
        EXPECT_NEAR(std::get<ShiftTool>(commands[i][0]).by_mm.z(), -1.0, 1e-12);
    // Half of the way, then what is left.
    EXPECT_EQ(std::get<MoveTool>(commands[6][0]).share, 0.5);
    EXPECT_EQ(std::get<MoveTool>(commands[7][0]).share, 1.0);
    EXPECT_EQ(std::get<MoveTool>(commands[7][0]).target_mm, Vec3(5, 6, 7));
    EXPECT_TRUE(std::holds_alternative<RemoveTool>(commands[9][0]));
    EXPECT_EQ(std::get<AddTool>(commands[10][0]).side, Vec3(1, 0, 0));
    EXPECT_EQ(std::get<CloseForceps>(commands[10][1]).share, 0.5);
    EXPECT_EQ(std::get<CloseForceps>(commands[11][0]).share, 1.0);
    EXPECT_EQ(std::get<OpenForceps>(commands[12][0]).share, 1.0);
    for (const char* action : {R"({"do": "tool", "tool": "saw", "where": {"point_mm": [1, 2, 3]}})",
                               R"({"do": "tool", "tool": "sphere"})", R"({"do": "move_tool"})",
                               R"({"do": "move_tool", "by_mm": [1, 2, 3], "to_mm": [1, 2, 3]})"}) {
        std::ofstream(file) << R"({"actions": [)" << action << "]}";
        EXPECT_THROW(read_script(file), InputError) << action;
    }
}

}  // namespace
}  // namespace hepatica
