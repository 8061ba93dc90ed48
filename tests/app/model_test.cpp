// SPDX-License-Identifier: GPL-3.0-or-later
// Models of links, through the real program.
#include <gtest/gtest.h>

#include <fstream>

#include "core/base/program_files.h"
#include "core/base/sha256.h"
#include "core/base/text_file.h"
#include "tests/app/tour.h"

namespace hepatica {
namespace {

using test::answer;
using test::Json;
using test::Outcome;
using test::run_cli;

class Model : public test::Tour {
  protected:
    static std::vector<std::string> reconstruct(const std::string& model) {
        return {"reconstruct", path("p/ct"), "--liver-mask", path("p/liver.nii.gz"), "--model",
                model,         "--out",      path("m.hep"),  "--tetrahedra",         "1500"};
    }
    static void expect_refused(const std::vector<std::string>& call, int exit_code,
                               const std::string& word, const std::string& place) {
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, exit_code) << run.errors;
        EXPECT_NE(run.errors.find(word), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find(place), std::string::npos) << run.errors;
        EXPECT_FALSE(std::filesystem::exists(path("m.hep")));
    }
};

TEST_F(Model, ThatIsNoneIsRefusedByItsName) {
    expect_refused(reconstruct(path("missing.json")), 1, "does not exist", "missing.json");
    std::ofstream(path("other.json")) << "{\"steps\": []}";
    expect_refused(reconstruct(path("other.json")), 1, "is no model of links", "other.json");
    std::ofstream(path("cut.json")) << "{\"format\": \"hepatica-li";
    expect_refused(reconstruct(path("cut.json")), 1, "damaged", "cut.json");
}

TEST_F(Model, IsRefusedWhereItWouldChooseNothing) {
    for (const std::vector<std::string>& other :
         {std::vector<std::string>{"--method", "multi-layer"},
          {"--window", "100,300"},
          {"--as-published"},
          {"--vessel-mask", path("p/truth_mask.nii.gz")}}) {
        std::vector<std::string> call = reconstruct("shipped");
        call.insert(call.end(), other.begin(), other.end());
        expect_refused(call, 2, "nothing to choose", "--model");
    }
}

TEST_F(Model, ThatIsShippedIsNamedInTheCase) {
    const Json made = answer(reconstruct("shipped"));
    EXPECT_TRUE(std::ranges::any_of(
        made["stages"], [](const Json& stage) { return stage["name"] == "Choosing the vessels"; }));
    EXPECT_GT(made["tree"]["length_mm"].get<double>(), 500.0);
    const Json header = Json::parse(read_text_file(path("m.hep/case.json"), ""));
    EXPECT_EQ(header["parameters"]["model_sha256"], sha256_of_file(asset("models/links.json")));
    EXPECT_FALSE(Json::parse(read_text_file(path("p.hep/case.json"), ""))["parameters"].contains(
        "model_sha256"));
}

TEST_F(Model, IsNotTrainedOnNothing) {
    for (const std::vector<std::string>& wrong :
         {std::vector<std::string>{"--volumes", "0"}, {"--seed", "-1"}, {"--seed", "0"}}) {
        std::vector<std::string> call{"train", "--out", path("t.json")};
        call.insert(call.end(), wrong.begin(), wrong.end());
        EXPECT_NE(run_cli(call).exit_code, 0);
        EXPECT_FALSE(std::filesystem::exists(path("t.json")));
    }
}

}  // namespace
}  // namespace hepatica
