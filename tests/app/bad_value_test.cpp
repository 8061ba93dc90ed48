// SPDX-License-Identifier: GPL-3.0-or-later
// Options whose value is a number, but none that can be meant: refused by name and value, with what
// may be given instead, and nothing written.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/app/tour.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::run_cli;

struct BadValue {
    std::string option, value, remedy;
};

TEST(BadValue, OfAPhantomIsRefusedAndItsRangeStandsInTheHelp) {
    const std::string out = (fs::path(testing::TempDir()) / "bad value").string();
    const std::string help = run_cli({"phantom", "--help"}).output;
    for (const BadValue& bad : {BadValue{"--seed", "-1", "from 0 on"},
                                {"--contrast-hu", "-5", "1 to 1000"},
                                {"--contrast-hu", "0", "1 to 1000"},
                                {"--noise-hu", "-3", "0 to 500"},
                                {"--dims", "64.9,64,64", "16 to 2048"},
                                {"--dims", "1e300,64,64", "16 to 2048"},
                                {"--generations", "0", "1 to 10"}}) {
        const Outcome run = run_cli({"phantom", out, bad.option + "=" + bad.value});
        EXPECT_EQ(run.exit_code, 1) << bad.option;
        EXPECT_FALSE(fs::exists(out)) << bad.option;
        for (const std::string& named : {bad.option, bad.value, bad.remedy})
            EXPECT_NE(run.errors.find(named), std::string::npos) << run.errors;
        EXPECT_NE(help.find(bad.remedy), std::string::npos) << help;
    }
}

TEST(BadValue, OfVeinsThatAPhantomLacksIsRefused) {
    const std::string out = (fs::path(testing::TempDir()) / "no veins").string();
    const Outcome run = run_cli({"phantom", out, "--dims", "32,32,32", "--spacing", "6,6,6",
                                 "--generations", "1", "--hepatic-contrast-hu", "30"});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_FALSE(fs::exists(out));
    for (const char* named : {"--hepatic-contrast-hu", "--systems 2"})
        EXPECT_NE(run.errors.find(named), std::string::npos) << run.errors;
}

// It was wrapped into a large one, of which the message spoke.
TEST(BadValue, OfAWholeNumberIsNotWrapped) {
    for (const std::vector<std::string>& call :
         {std::vector<std::string>{"replay", "none.hrec", "--from-step", "-5"},
          {"replay", "none.hrec", "--from-step", "99999999999999999999999"},
          {"embolize", "none.vtp", "--seed", "-3"},
          {"extremes", "--suite", "touch", "--seed", "-3"},
          {"edit", "none.hep", "--undo", "-1"},
          {"render", "none.hep", "--out", "none.png", "--time-s", "-1"}}) {
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 2) << call[0] << ": " << run.errors;
        EXPECT_NE(run.errors.find(call[call.size() - 2] + ": "), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find(call.back()), std::string::npos) << run.errors;
        EXPECT_LT(run.errors.size(), 300u) << "a range of 300 digits helps nobody: " << run.errors;
    }
}

TEST(BadValue, OfABenchmarkIsRefused) {
    for (const std::vector<std::string>& call :
         {std::vector<std::string>{"bench", "contacts", "--steps", "5", "--budget-ms", "-1"},
          {"bench", "refinement", "--generations", "1", "--recursions", "0", "--seed", "-1"},
          {"bench", "reconstruct", "--dims", "32,32,32", "--seed", "-1"},
          {"bench", "peers", "--steps", "1", "--largest", "5"}}) {
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 2) << call[1] << ": " << run.errors;
        EXPECT_NE(run.errors.find(call[call.size() - 2]), std::string::npos) << run.errors;
        EXPECT_EQ(run.output, "");
    }
}

// What an option asks for would not happen: it is refused, and named.
TEST(BadUsage, OfOptionsThatOthersLeaveWithoutEffect) {
    struct Call {
        std::vector<std::string> words;
        std::string named;
    };
    for (const auto& [words, named] :
         {Call{{"reconstruct", "ct", "--out", "x.hep", "--liver-label", "5"}, "--liver-mask"},
          {{"reconstruct", "ct", "--out", "x.hep", "--vessel-label", "1=portal"}, "--vessel-mask"},
          {{"reconstruct", "ct", "--out", "x.hep", "--vessel-mask", "m", "--window", "1,2"},
           "--window"},
          {{"reconstruct", "ct", "--out", "x.hep", "--vessel-mask", "m", "--method", "vesselness"},
           "--method"},
          {{"reconstruct", "ct", "--out", "x.hep", "--vessel-mask", "m", "--spacing-mm", "1"},
           "--spacing-mm"},
          {{"bench", "drag", "x.hep", "--motion", "pull", "--script", "s"}, "--script"},
          {{"bench", "drag", "x.hep", "--no-error", "--references", "r"}, "--references"},
          {{"simulate", "x.hep", "--script", "s", "--quality", "1", "--automatic"}, "--automatic"},
          {{"tradeoff", "--out", "t", "--tear", "--budget", "5"}, "--budget"},
          {{"tradeoff", "--out", "t", "--contact", "--budget", "5"}, "--budget"},
          {{"tradeoff", "x.hep", "--out", "t", "--quick"}, "--quick"},
          {{"tradeoff", "x.hep", "--out", "t", "--contact"}, "--contact"},
          {{"tradeoff", "x.hep", "--out", "t", "--tear"}, "--tear"},
          {{"tradeoff", "--out", "t", "--backend", "cuda-emulated"}, "--backend"},
          {{"extremes", "--case", "x.hep"}, "--case"},
          {{"compare", "x.hep", "--truth-mask", "portal=m", "--tree-space", "ras"}, "--truth-tree"},
          {{"extremes", "--trials", "3"}, "--trials"},
          {{"bench", "tear", "--breaking", "2000", "--plot-force", "f.csv"}, "--plot-force"},
          {{"bench", "iterations", "--tetrahedra", "2000"}, "--case"},
          {{"bench", "reconstruct", "ct", "--dims", "32,32,32"}, "--dims"},
          {{"bench", "reconstruct", "--liver-mask", "m"}, "--liver-mask"},
          {{"bench", "reconstruct", "--vessel-mask", "m"}, "--vessel-mask"}}) {
        const Outcome run = run_cli(words);
        EXPECT_EQ(run.exit_code, 2) << words[0] << " " << named << ": " << run.errors;
        EXPECT_EQ(run.output, "");
        EXPECT_NE(run.errors.find(named), std::string::npos) << run.errors;
    }
}

// As of a variable of the shell that is not set. Left out, --out would mean the case itself.
TEST(BadUsage, OfAnEmptyValue) {
    struct Call {
        std::vector<std::string> words;
        std::string named;
    };
    for (const auto& [words, named] :
         {Call{{"edit", "x.hep", "--undo", "1", "--out", ""}, "--out"},
          {{"remake", "x.hep", "--line-share", "0.8", "--out", ""}, "--out"},
          {{"reconstruct", "ct", "--out", ""}, "--out"},
          {{"reconstruct", "ct", "--out", "x.hep", "--liver-mask", ""}, "--liver-mask"},
          {{"reconstruct", "ct", "--out", "x.hep", "--tumour-mask", ""}, "--tumour-mask"},
          {{"inject", ""}, "CASE"},
          {{"bench", "drag", "x.hep", "--script", ""}, "--script"}}) {
        const Outcome run = run_cli(words);
        EXPECT_EQ(run.exit_code, 2) << words[0] << " " << named << ": " << run.errors;
        EXPECT_EQ(run.output, "");
        EXPECT_NE(run.errors.find(named + ": is given an empty value"), std::string::npos)
            << run.errors;
    }
}

#ifdef HEPATICA_WINDOW_PROGRAM
TEST(BadUsage, OfADrugThatNobodyWouldSee) {
    for (const auto& [words, named] :
         {std::pair<std::vector<std::string>, std::string>{{"--at-mm", "1,2,3"}, "--time-s"},
          {{"--mass-flow-g-s", "3"}, "--time-s"},
          {{"--mass-flow-g-s", "3", "--time-s", "1", "--recording", "r"}, "--recording"}}) {
        std::vector<std::string> call{"render", "x.hep", "--out", "x.png"};
        call.insert(call.end(), words.begin(), words.end());
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 2) << words[0] << ": " << run.errors;
        EXPECT_NE(run.errors.find(named), std::string::npos) << run.errors;
    }
}
#endif

#ifdef HEPATICA_WINDOW_PROGRAM
// The window would open in another language than was asked for.
TEST(BadUsage, OfWhatTheWindowHasNoUseFor) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"--language", "de"},
          {"--out", "report"},
          {"--progress"},
          {"--json"},
          {"case.hep", "--report", "play.hrec", "--out", "report"}}) {
        const Outcome run = run_cli(words, {.program = HEPATICA_WINDOW_PROGRAM});
        EXPECT_EQ(run.exit_code, 2) << words[0] << ": " << run.errors;
        EXPECT_NE(run.errors.find(words[0]), std::string::npos) << run.errors;
    }
}
#endif

class BadValueOfInject : public test::Tour {};

// Nothing would be injected, and a list of zeros says so to nobody.
TEST_F(BadValueOfInject, IsRefusedWhereNothingWouldFlow) {
    for (const std::vector<std::string>& values :
         {std::vector<std::string>{"--pressure-pa=-5"},
          {"--pressure-pa=100", "--outlet-pressure-pa=2000"},
          {"--mass-flow-g-s=0"},
          {"--mass-flow-g-s=-1"}}) {
        std::vector<std::string> call{"inject", path("p/truth_tree.vtp")};
        call.insert(call.end(), values.begin(), values.end());
        const Outcome run = run_cli(call);
        EXPECT_EQ(run.exit_code, 1) << values[0];
        EXPECT_EQ(run.output, "");
        const std::string value = values[0].substr(values[0].find('=') + 1);
        EXPECT_NE(run.errors.find("is " + value), std::string::npos) << run.errors;
        EXPECT_NE(run.errors.find("Give a"), std::string::npos) << run.errors;
    }
}

}  // namespace
}  // namespace hepatica
