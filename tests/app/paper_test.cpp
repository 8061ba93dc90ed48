// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the paper's results: whole or not there, and what it shows is there.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "tests/app/tour.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::answer;
using test::Json;
using test::Outcome;
using test::run_cli;

std::string page_text(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::set<std::string> files_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

class Paper : public test::Tour {};

TEST_F(Paper, ShowsTheFiguresAndTheTableOfOneCase) {
    const Json made = answer({"paper", path("p.hep"), "--out", path("paper")});
    const std::string page = page_text(path("paper/index.html"));
    ASSERT_EQ(made["page"], path("paper/index.html"));
    std::set<std::string> shown;
    const std::regex source("img src=\"([^\"]+)\"");
    for (std::sregex_iterator at(page.begin(), page.end(), source), end; at != end; ++at)
        shown.insert((*at)[1]);
    for (const char* name : {"fig1_a_model.png", "fig1_b_skeleton.png", "fig2_a.png", "fig2_d.png",
                             "fig3_a.png", "fig3_d.png", "fig3_force.png"})
        EXPECT_EQ(shown.count(name), 1u) << name;
    EXPECT_EQ(shown.size(), 11u);
    for (const std::string& name : shown)
        EXPECT_TRUE(page_text(path("paper/" + name)).starts_with("\x89PNG")) << name;
    // What the paper prints, beside what was measured.
    for (const char* printed : {">128<", ">768<", ">8<"})
        EXPECT_NE(page.find(printed), std::string::npos) << printed;
    for (const Json& row : made["contacts"])
        EXPECT_EQ(row["as the paper counts"].get<int>(), 6 * row["contact points"].get<int>());
    EXPECT_EQ(made["fig_1"]["of them removable"], 0);
    EXPECT_EQ(made["fig_1"]["segments"], case_["tree"]["segments"]);
    // The hand tore something off, and nothing was lost by it.
    EXPECT_GT(made["fig_3"]["joints broken"], 0);
    EXPECT_GT(made["fig_3"]["pieces"], 1);
    EXPECT_GT(made["fig_3"]["energy of fracture mJ"], 0.0);
    EXPECT_LT(made["fig_3"]["mass error relative"], 1e-12);
}

TEST_F(Paper, RefusesAFolderThatHoldsSomething) {
    fs::create_directories(path("mine"));
    std::ofstream(path("mine/notes.txt")) << "mine";
    const Outcome run = run_cli({"paper", path("p.hep"), "--out", path("mine")});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.errors.find("is not empty"), std::string::npos) << run.errors;
    EXPECT_EQ(files_in(path("mine")), std::set<std::string>{"notes.txt"});
    const Outcome file = run_cli({"paper", path("p.hep"), "--out", path("mine/notes.txt")});
    EXPECT_EQ(file.exit_code, 1);
    EXPECT_NE(file.errors.find("no folder"), std::string::npos) << file.errors;
}

TEST_F(Paper, LeavesNothingWhereItIsInterruptedOrHasNoCase) {
    const std::set<std::string> before = files_in(folder());
    const Outcome interrupted =
        run_cli({"paper", path("p.hep"), "--out", path("half")}, {.interrupt_at = "] Tearing"});
    EXPECT_EQ(interrupted.exit_code, 130) << interrupted.errors;
    EXPECT_EQ(run_cli({"paper", path("none.hep"), "--out", path("half")}).exit_code, 1);
    EXPECT_EQ(files_in(folder()), before);
}

}  // namespace
}  // namespace hepatica
