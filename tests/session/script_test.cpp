// SPDX-License-Identifier: GPL-3.0-or-later
// What a written script makes of its actions, step by step, on a tree of straight vessels.
#include "core/session/script.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/error.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

VesselSegment vessel(int from, int to, int parent, std::vector<Vec3> points, double radius_mm) {
    VesselSegment segment;
    segment.proximal_node = from;
    segment.distal_node = to;
    segment.parent = parent;
    segment.radii_mm.assign(points.size(), radius_mm);
    segment.points_mm = std::move(points);
    return segment;
}

// A narrow vessel of 90 mm that stands first, and a wide tree: a trunk of 30 mm with branches of
// 10 and 20 mm.
VesselTree two_trees() {
    VesselTree tree;
    for (const Vec3& place : {Vec3(0, 50, 0), Vec3(90, 50, 0), Vec3(0, 0, 0), Vec3(30, 0, 0),
                              Vec3(30, -10, 0), Vec3(30, 0, 20)})
        tree.nodes.push_back({place, 1.0});
    tree.segments = {vessel(0, 1, -1, {{0, 50, 0}, {90, 50, 0}}, 1.0),
                     vessel(2, 3, -1, {{0, 0, 0}, {20, 0, 0}, {30, 0, 0}}, 3.0),
                     vessel(3, 4, 1, {{30, 0, 0}, {30, -10, 0}}, 2.0),
                     vessel(3, 5, 1, {{30, 0, 0}, {30, 0, 20}}, 2.0)};
    return tree;
}

TEST(LongestPath, RunsFromTheWidestRootToItsFarthestEnd) {
    const VesselTree tree = two_trees();
    EXPECT_LT((point_on_longest_path(tree, 0.0) - Vec3(0, 0, 0)).norm(), 1e-12);
    EXPECT_LT((point_on_longest_path(tree, 0.5) - Vec3(25, 0, 0)).norm(), 1e-12);
    EXPECT_LT((point_on_longest_path(tree, 0.6) - Vec3(30, 0, 0)).norm(), 1e-12);
    EXPECT_LT((point_on_longest_path(tree, 0.8) - Vec3(30, 0, 10)).norm(), 1e-12);
    EXPECT_LT((point_on_longest_path(tree, 1.0) - Vec3(30, 0, 20)).norm(), 1e-12);
    EXPECT_THROW(point_on_longest_path(VesselTree{}, 0.5), InputError);
}

// The way back from the trunk's end to the root is the longest of all, but ends at no end.
TEST(LongestPath, LeavesOutWhatClosesALoop) {
    const VesselTree tree = two_trees();
    VesselTree looped = tree;
    looped.segments.push_back(vessel(3, 2, 1, {{30, 0, 0}, {15, 30, 0}, {0, 0, 0}}, 2.0));
    looped.segments.back().closes_loop = true;
    validate(looped);
    for (const double share : {0.0, 0.5, 0.8, 1.0})
        EXPECT_EQ(point_on_longest_path(looped, share), point_on_longest_path(tree, share))
            << share;
}

ScriptAction at(double at_s, const std::string& what) {
    ScriptAction action;
    action.at_s = at_s;
    action.what = what;
    return action;
}

TEST(Schedule, SpreadsAMoveEvenlyAndGoesOnFromWhereTheHandIs) {
    Script script;
    ScriptAction grab = at(0.2, "grab"), away = at(0.2, "move"), up = at(0.6, "move");
    grab.place.share_of_longest_path = 0.5;
    away.by_mm = Vec3(12, -4, 8);
    away.over_s = 0.4;
    up.by_mm = Vec3(0, 0, 5);  // all at once
    script.actions = {grab, away, up};
    const auto commands = schedule(script, two_trees(), 0.1, 10);
    ASSERT_EQ(commands.size(), 10u);
    const Vec3 place(25, 0, 0);
    ASSERT_EQ(commands[2].size(), 2u);
    EXPECT_LT((std::get<GrabPoint>(commands[2][0]).point_mm - place).norm(), 1e-12);
    for (int i = 1; i <= 4; ++i) {
        const auto& moved = std::get<MoveGrab>(commands[1 + i].back());
        EXPECT_LT((moved.target_mm - (place + i / 4.0 * away.by_mm)).norm(), 1e-12) << i;
    }
    ASSERT_EQ(commands[6].size(), 1u);
    EXPECT_LT(
        (std::get<MoveGrab>(commands[6][0]).target_mm - (place + away.by_mm + up.by_mm)).norm(),
        1e-12);
    for (const int idle : {0, 1, 7, 8, 9}) EXPECT_TRUE(commands[idle].empty()) << idle;
}

TEST(Schedule, GoesOnFromWhereAPlainCommandPutsTheHand) {
    Script script;
    ScriptAction grab = at(0.0, "grab_point"), led = at(0.2, "move_grab");
    grab.command = GrabPoint{Vec3(25, 0, 0)};
    led.command = MoveGrab{Vec3(30, 5, 0)};
    ScriptAction first = at(0.1, "move"), second = at(0.3, "move");
    first.by_mm = second.by_mm = Vec3(0, 0, 2);
    script.actions = {grab, first, led, second};
    const auto commands = schedule(script, two_trees(), 0.1, 4);
    EXPECT_EQ(std::get<MoveGrab>(commands.at(1).at(0)).target_mm, Vec3(25, 0, 2));
    EXPECT_EQ(std::get<MoveGrab>(commands.at(2).at(0)).target_mm, Vec3(30, 5, 0));
    EXPECT_EQ(std::get<MoveGrab>(commands.at(3).at(0)).target_mm, Vec3(30, 5, 2));
}

// Where a grabbed vertex is, only the play knows; once it led from the origin of space.
TEST(Schedule, ShiftsAHandThatHoldsAVertex) {
    Script script;
    ScriptAction grab = at(0.0, "grab_vertex"), move = at(0.1, "move");
    grab.command = GrabVertex{7};
    move.by_mm = Vec3(0, 0, 6);
    move.over_s = 0.2;
    ScriptAction led = at(0.3, "move_grab"), after = at(0.4, "move");
    led.command = MoveGrab{Vec3(30, 5, 0)};
    after.by_mm = Vec3(1, 0, 0);
    script.actions = {grab, move, led, after};
    const auto commands = schedule(script, two_trees(), 0.1, 5);
    EXPECT_EQ(std::get<GrabVertex>(commands.at(0).at(0)).vertex, 7);
    for (const int step : {1, 2})
        EXPECT_EQ(std::get<ShiftGrab>(commands.at(step).at(0)).by_mm, Vec3(0, 0, 3)) << step;
    EXPECT_EQ(std::get<MoveGrab>(commands.at(4).at(0)).target_mm, Vec3(31, 5, 0));
}

TEST(Schedule, LeavesOutWhatComesAfterTheLastStep) {
    Script script;
    ScriptAction release = at(0.5, "release"), late = at(0.6, "release");
    release.command = ReleaseGrab{};
    late.command = ReleaseGrab{};
    script.actions = {release, late};
    const auto commands = schedule(script, two_trees(), 0.1, 6);
    EXPECT_EQ(commands[5].size(), 1u);
    std::size_t all = 0;
    for (const auto& step : commands) all += step.size();
    EXPECT_EQ(all, 1u);
}

class ScriptFile : public testing::Test {
  protected:
    void TearDown() override { fs::remove(file_); }
    Script read(const std::string& text) {
        std::ofstream(file_) << text;
        return read_script(file_);
    }
    // What is wrong with one action, or nothing.
    std::string refusal(const std::string& action) {
        try {
            read(R"({"actions": [{"do": "release"}, )" + action + "]}");
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    fs::path file_ =
        fs::path(testing::TempDir()) /
        (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".json");
};

TEST_F(ScriptFile, IsReadInTheOrderOfTime) {
    const Script script = read(R"({"name": "n", "actions": [
        {"at_s": 2, "do": "release"},
        {"at_s": 0.5, "do": "grab", "where": {"point_mm": [1, 2, 3]}},
        {"at_s": 0.5, "do": "move", "by_mm": [4, 5, 6], "over_s": 1.5},
        {"do": "inject", "where": {"share_of_longest_path": 0}, "mass_flow_g_s": 3}]})");
    EXPECT_EQ(script.name, "n");
    ASSERT_EQ(script.actions.size(), 4u);
    EXPECT_EQ(script.actions[0].what, "inject");
    EXPECT_EQ(script.actions[0].at_s, 0.0);
    EXPECT_EQ(std::get<InjectDrug>(*script.actions[0].command).mass_flow_g_s, 3.0);
    EXPECT_EQ(script.actions[0].place.share_of_longest_path, 0.0);
    EXPECT_EQ(script.actions[1].what, "grab");
    EXPECT_EQ(script.actions[1].place.point_mm, Vec3(1, 2, 3));
    EXPECT_EQ(script.actions[2].by_mm, Vec3(4, 5, 6));
    EXPECT_EQ(script.actions[2].over_s, 1.5);
    EXPECT_TRUE(std::holds_alternative<ReleaseGrab>(*script.actions[3].command));
}

TEST_F(ScriptFile, NamesTheActionThatIsWrong) {
    EXPECT_EQ(refusal(R"({"do": "grab", "where": {"share_of_longest_path": 1}})"), "");
    for (const char* wrong :
         {R"({"do": "grab"})", R"({"do": "grab", "where": {"share_of_longest_path": 1.1}})",
          R"({"do": "grab", "where": {"share_of_longest_path": -0.1}})",
          R"({"do": "grab", "where": {"point_mm": [1, 2]}})",
          R"({"do": "grab", "where": {"point_mm": [1, 2, "x"]}})", R"({"do": "move"})",
          R"({"do": "release", "at_s": -1})", R"({"do": "release", "at_s": "soon"})",
          R"({"at_s": 1})", R"({"do": "fly"})", "7"})
        EXPECT_NE(refusal(wrong).find("action 2"), std::string::npos) << wrong << refusal(wrong);
    EXPECT_THROW(read("[]"), InputError);
    EXPECT_THROW(read("{}"), InputError);
    EXPECT_THROW(read(R"({"actions": 3})"), InputError);
    EXPECT_THROW(read("{"), InputError);
}

TEST_F(ScriptFile, RefusesAPlaceWhereNoBodyCanBe) {
    for (const char* action : {R"({"do": "grab", "where": {"point_mm": [0, 1e308, 0]}})",
                               R"({"do": "move", "by_mm": [0, 0, -1e308]})",
                               R"({"do": "move_tool", "to_mm": [1e5, 0, 0]})",
                               R"({"do": "blade", "from_mm": [1, 2, 3], "to_mm": [1, 2, 1e5]})",
                               R"({"do": "grab_point", "point_mm": [1e5, 0, 0]})",
                               R"({"do": "set_gravity", "gravity_mm_per_s2": [0, 1e7, 0]})"}) {
        const std::string said = refusal(action);
        EXPECT_NE(said.find("action 2"), std::string::npos) << said;
        EXPECT_NE(said.find("; it must lie from "), std::string::npos) << said;
    }
}

// The steps up to such a time cannot be counted.
TEST_F(ScriptFile, RefusesATimeThatIsNoneOfAPlay) {
    for (const char* time : {"-1", "86401", "1e300"})
        for (const std::string& action :
             {std::string(R"({"do": "release", "at_s": )"),
              std::string(R"({"do": "move", "by_mm": [1, 2, 3], "over_s": )"),
              std::string(R"({"do": "move_tool", "by_mm": [1, 2, 3], "over_s": )"),
              std::string(R"({"do": "close_forceps", "over_s": )"),
              std::string(
                  R"({"do": "blade", "from_mm": [1, 2, 3], "to_mm": [1, 2, 4], "over_s": )")}) {
            const std::string said = refusal(action + time + "}");
            EXPECT_NE(said.find("_s must lie from 0 to 86400"), std::string::npos)
                << action << time << said;
            EXPECT_EQ(refusal(action + "86400}"), "") << action;
        }
}

// {"over": 2} in the place of "over_s" once made a move of a single step, without a word.
TEST_F(ScriptFile, RefusesAMisspeltKeyAndNamesTheNearest) {
    const std::string where = R"("where": {"share_of_longest_path": 0.5})";
    const auto expect = [&](const std::string& action, const std::string& key,
                            const std::string& nearest) {
        const std::string said = refusal(action);
        for (const std::string& part :
             {file_.string() + ", action 2", key + " is not known",
              nearest.empty() ? std::string("choose from") : "nearest key is \"" + nearest + "\"",
              std::string("docs/scenes.md")})
            EXPECT_NE(said.find(part), std::string::npos) << part << ": " << said;
    };
    expect(R"({"do": "move", "by_mm": [1, 2, 3], "over": 2})", "over", "over_s");
    expect(R"({"do": "grab", "place": 1, )" + where + "}", "place", "");
    expect(R"({"do": "grab", "where": {"share_of_longest_path": 1, "points": 1}})", "points",
           "point_mm");
    expect(R"({"do": "inject", "mass_flow": 2, )" + where + "}", "mass_flow", "mass_flow_g_s");
    expect(R"({"do": "inject", "point_mm": [1, 2, 3], )" + where + "}", "point_mm", "");
    expect(R"({"do": "tool", "tool": "hook", "sides": 1, )" + where + "}", "sides", "side");
    expect(R"({"do": "move_tool", "by_mm": [1, 2, 3], "share": 1})", "share", "");
    expect(R"({"do": "close_forceps", "overs": 1})", "overs", "over_s");
    expect(R"({"do": "cut_line", "from": {"point_mm": [1, 2, 3]}, "to": {"point_mm": [1, 2, 3]},
               "strengt": 1})",
           "strengt", "strength");
    expect(R"({"do": "blade", "from_mm": [1, 2, 3], "to_mm": [1, 2, 3], "over_ss": 1})", "over_ss",
           "over_s");
    expect(R"({"do": "release", "at": 1})", "at", "at_s");
    expect(R"({"do": "set_gravity", "gravity_mm_per_s2": [0, 0, 0], "gravity": 1})", "gravity",
           "gravity_mm_per_s2");
    try {
        read(R"({"actions": [], "nmae": "n"})");
        ADD_FAILURE() << "a misspelt key of the script itself was passed over";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("nearest key is \"name\""), std::string::npos)
            << error.what();
    }
    EXPECT_NE(refusal(R"({"do": "grab", "where": {"share_of_longest_path": 1,
                                                  "point_mm": [1, 2, 3]}})")
                  .find("either"),
              std::string::npos);
}

// Whatever a command may hold, an action of its name may say.
TEST_F(ScriptFile, KnowsTheKeysThatMayBeLeftOut) {
    EXPECT_EQ(refusal(R"({"do": "inject", "drug_viscosity_pa_s": 0.01, "void_fraction": 0.5,
                          "second_phase": "lipiodol", "pressure_model": "consistent",
                          "where": {"share_of_longest_path": 0}})"),
              "");
    EXPECT_EQ(refusal(R"({"do": "tool", "tool": "hook", "radius_mm": 2, "length_mm": 20,
                          "direction": [0, 0, 1], "side": [1, 0, 0],
                          "where": {"share_of_longest_path": 0}})"),
              "");
    EXPECT_EQ(refusal(R"({"do": "add_tool", "kind": "hook", "radius_mm": 2, "length_mm": 20,
                          "direction": [0, 0, 1], "side": [1, 0, 0], "point_mm": [0, 0, 0]})"),
              "");
}

// The last of the two was taken in silence.
TEST_F(ScriptFile, RefusesAKeyThatIsGivenTwice) {
    const auto said_of = [&](const std::string& text) {
        try {
            read(text);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("nothing");
    };
    EXPECT_NE(said_of(R"({"actions": [{"do": "release"}], "actions": []})")
                  .find(file_.string() + ": actions is given twice"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"at_s": 0, "do": "release", "at_s": 5})").find("at_s is given twice"),
              std::string::npos);
    // What is no JSON is named by its place, and a number that is none by its value.
    EXPECT_NE(said_of("{\"actions\":\n[NaN]}").find("line 2"), std::string::npos);
    EXPECT_NE(refusal(R"({"do": "release", "at_s": 1e400})").find("1e400"), std::string::npos);
    EXPECT_NE(said_of("{\"actions\":\n[1e400]}").find("line 2"), std::string::npos);
}

TEST(ShippedScripts, AreRead) {
    int read = 0;
    for (const auto& entry :
         fs::directory_iterator(fs::path(HEPATICA_SOURCE_DIR) / "assets" / "scripts")) {
        EXPECT_NO_THROW(read_script(entry.path())) << entry.path();
        ++read;
    }
    EXPECT_GE(read, 4);
}

}  // namespace
}  // namespace hepatica
