// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way of the paper, as printed, through the real program: CT, vessels, skeleton,
// injection, and a pull of a body of springs.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/base/atomic_write.h"
#include "tests/app/tour.h"

namespace hepatica::test {
namespace {

class AsPublished : public Tour {};

TEST_F(AsPublished, GoesTheWholeWayFromTheCtToThePulledVessel) {
    const Json made =
        answer({"reconstruct", path("p/ct"), "--liver-mask", path("p/liver.nii.gz"),
                "--as-published", "--tetrahedra", "3000", "--out", path("paper.hep")});
    std::ifstream file(path("paper.hep/case.json"));
    const Json header = Json::parse(file);
    EXPECT_EQ(header.at("parameters").at("method"), "multi_layer");
    EXPECT_EQ(header.at("parameters").at("thinning"), "parallel");
    EXPECT_EQ(header.at("parameters").at("refinement_recursions"), 1);
    // VDSM leaves a skeleton as thin as it can be, with the topology of the vessels.
    EXPECT_EQ(made.at("mask").at("components"), made.at("skeleton").at("components"));
    EXPECT_EQ(made.at("mask").at("tunnels"), made.at("skeleton").at("tunnels"));
    EXPECT_GT(made.at("tree").at("segments"), 10);

    const Json injected = answer({"inject", path("paper.hep"), "--as-published"});
    EXPECT_EQ(injected.at("model"), "published");
    EXPECT_EQ(injected.at("drug").at("void_fraction"), 0.40);
    EXPECT_EQ(injected.at("drug").at("phase"), "gas");
    EXPECT_LT(std::abs(injected.at("volume_error_relative").get<double>()), 1e-9);
    // The switch is these options and no other.
    const Json spelt_out = answer({"inject", path("paper.hep"), "--model", "published",
                                   "--void-fraction", "0.4", "--phase", "gas"});
    EXPECT_EQ(injected, spelt_out);
    EXPECT_NE(injected.at("inlet_pressure_pa"),
              answer({"inject", path("paper.hep")})["inlet_pressure_pa"]);

    const std::string script = std::string(HEPATICA_ASSETS) + "/scripts/drag.json";
    const Json pulled = answer(
        {"simulate", path("paper.hep"), "--script", script, "--steps", "240", "--as-published"});
    EXPECT_EQ(pulled.at("finite"), true);
    EXPECT_EQ(pulled.at("steps"), 240);
    EXPECT_NE(pulled.at("setting").get<std::string>().find("spring"), std::string::npos)
        << pulled.at("setting");
    EXPECT_EQ(pulled.at("degraded_steps"), 0) << "a published step is never shortened";
    const Json by_default =
        answer({"simulate", path("paper.hep"), "--script", script, "--steps", "240"});
    EXPECT_NE(pulled.at("state_hash"), by_default.at("state_hash"));
}

TEST_F(AsPublished, RefusesWhatWouldContradictIt) {
    for (const std::vector<std::string>& also :
         {std::vector<std::string>{"reconstruct", path("p/ct"), "--out", path("x.hep"), "--method",
                                   "coherent"},
          {"inject", path("p.hep"), "--model", "regime"},
          {"simulate", path("p.hep"), "--script", "s.json", "--quality", "1"}}) {
        std::vector<std::string> arguments = also;
        arguments.push_back("--as-published");
        const Outcome run = run_cli(arguments);
        EXPECT_EQ(run.exit_code, 2) << run.errors;
        EXPECT_NE(run.errors.find("--as-published"), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find(also[also.size() - 2]), std::string::npos) << run.errors;
    }
}

// A script, too, may ask for what the switch excludes.
TEST_F(AsPublished, RefusesAScriptThatLeavesIt) {
    for (const std::string action : {"set_quality", "set_automatic_quality", "use_tear"}) {
        write_text_atomically(path("leaves.json"),
                              R"({"name": "s", "scene": {"name": "s", "deform": {}}, "actions": [)"
                              R"({"at_s": 0.1, "do": ")" +
                                  action + R"("}]})");
        const Outcome run = run_cli({"simulate", path("p.hep"), "--script", path("leaves.json"),
                                     "--steps", "20", "--as-published"});
        EXPECT_EQ(run.exit_code, 1) << run.errors;
        EXPECT_NE(run.errors.find(action), std::string::npos) << run.errors;
    }
}

}  // namespace
}  // namespace hepatica::test
