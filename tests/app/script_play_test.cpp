// SPDX-License-Identifier: GPL-3.0-or-later
// What `simulate` says where it plays another script than the one that it was given: commands that
// are refused, and pauses.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/app/tour.h"

namespace hepatica {
namespace {

using test::answer;
using test::Json;
using test::Outcome;
using test::run_cli;
using test::Tour;

// The verb and its options for a play of such actions in the default scene.
std::vector<std::string> play_of(const std::string& file, const std::string& actions) {
    std::ofstream(file) << R"({"name": "s", "actions": [)" << actions << "]}";
    return {"--script", file, "--steps", "6"};
}

TEST_F(Tour, SimulateTellsWhichCommandsWereRefused) {
    std::vector<std::string> call{"simulate", path("p.hep")};
    for (const std::string& option :
         play_of(path("refused.json"),
                 R"({"at_s": 0.02, "do": "grab_vertex", "vertex": 99999999},
                    {"at_s": 0.02, "do": "blade", "from_mm": [0, 0, 0], "to_mm": [9, 0, 0]},
                    {"at_s": 0.04, "do": "move", "by_mm": [5, 0, 0], "over_s": 0.05})"))
        call.push_back(option);
    const Json played = answer(call);
    EXPECT_EQ(played["steps"], 6);
    const Json& refused = played["refused"];
    ASSERT_EQ(refused.size(), 3u) << refused;
    EXPECT_EQ(refused[0]["step"], 2);
    EXPECT_NE(refused[0]["message"].get<std::string>().find("99999999"), std::string::npos)
        << refused;
    EXPECT_NE(refused[2]["message"].get<std::string>().find("nothing is in the hand"),
              std::string::npos)
        << refused;
    EXPECT_EQ(refused[2]["times"], 3) << "the way is led by a command in each of its steps";
    call.push_back("--quiet");
    const Outcome run = run_cli(call);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    const std::size_t warned = run.errors.find("nothing is in the hand");
    EXPECT_NE(run.errors.find("warning: step 2: "), std::string::npos) << run.errors;
    ASSERT_NE(warned, std::string::npos) << run.errors;
    EXPECT_EQ(run.errors.find("nothing is in the hand", warned + 1), std::string::npos)
        << run.errors;
}

TEST_F(Tour, SimulateRefusesNothingOfAScriptThatFits) {
    std::vector<std::string> call{"simulate", path("p.hep")};
    for (const std::string& option :
         play_of(path("fits.json"),
                 R"({"at_s": 0, "do": "grab", "where": {"share_of_longest_path": 0.5}},
                    {"at_s": 0, "do": "move", "by_mm": [1, 0, 0], "over_s": 0.05},
                    {"at_s": 0.06, "do": "release"})"))
        call.push_back(option);
    const Json played = answer(call);
    EXPECT_EQ(played["refused"], Json::array());
    EXPECT_TRUE(played["stopped_because"].is_null());
}

TEST_F(Tour, SimulateGoesOnAfterAPauseThatTheScriptEnds) {
    const std::string pause = R"({"at_s": 0.02, "do": "set_paused", "paused": true})";
    std::vector<std::string> call{"simulate", path("p.hep")};
    for (const std::string& option : play_of(path("pause.json"), pause)) call.push_back(option);
    const Json stopped = answer(call);
    EXPECT_EQ(stopped["steps"], 1);
    EXPECT_EQ(stopped["stopped_because"], "the script paused it at step 2");
    play_of(path("pause.json"), pause + R"(, {"at_s": 0.05, "do": "set_paused", "paused": false},
                         {"at_s": 0.07, "do": "grab_vertex", "vertex": 99999999})");
    const Json resumed = answer(call);
    EXPECT_EQ(resumed["steps"], 4) << "the first, and those from the fourth on";
    EXPECT_TRUE(resumed["stopped_because"].is_null());
    ASSERT_EQ(resumed["refused"].size(), 1u) << "what follows the resume is played";
    EXPECT_EQ(resumed["refused"][0]["step"], 5);
}

}  // namespace
}  // namespace hepatica
