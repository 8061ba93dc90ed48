// SPDX-License-Identifier: GPL-3.0-or-later
// ./run and ./test, as far as they can be tried without installing and building anything.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace hepatica {
namespace {

namespace fs = std::filesystem;

struct Answer {
    int status = -1;
    std::string output;
};

Answer run(const std::string& command) {
    Answer answer;
    FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return answer;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        answer.output += static_cast<char>(c);
    answer.status = pclose(pipe);
    return answer;
}

// The copies stand alone, without the scripts that install and build: help needs neither.
TEST(TwoCommands, PrintHelpBeforeTheyInstallAndBuild) {
    const fs::path alone = fs::path(testing::TempDir()) / "alone";
    fs::create_directories(alone);
    for (const std::string name : {"run", "test"}) {
        fs::copy_file(fs::path(HEPATICA_SOURCE_DIR) / name, alone / name);
        for (const char* option : {"--help", "-h"}) {
            const Answer answer = run("'" + (alone / name).string() + "' " + option);
            EXPECT_EQ(answer.status, 0) << answer.output;
            EXPECT_NE(answer.output.find("./" + name + " "), std::string::npos) << answer.output;
            EXPECT_EQ(answer.output.find("set -"), std::string::npos) << answer.output;
        }
        EXPECT_NE(run("'" + (alone / name).string() + "'").status, 0) << "it did not stand alone";
    }
}

TEST(TwoCommands, RefuseWhatTheyDoNotKnowBeforeTheyInstallAndBuild) {
    const std::string program = "'" + (fs::path(HEPATICA_SOURCE_DIR) / "run").string() + "' ";
    for (const char* wrong : {"--full-screen", "/no/such/case.hep", ". --json", ". ."}) {
        const Answer answer = run(program + wrong);
        EXPECT_NE(answer.status, 0) << wrong;
        EXPECT_TRUE(answer.output.starts_with("run: ")) << wrong << ": " << answer.output;
    }
}

// With programs that install and build nothing in place of those of the tree.
class TestWithoutTests : public testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(folder_ / "scripts");
        fs::copy_file(fs::path(HEPATICA_SOURCE_DIR) / "test", folder_ / "test");
        for (const char* name : {"install_packages", "build"}) {
            std::ofstream(folder_ / "scripts" / name) << "#!/bin/sh\n";
            fs::permissions(folder_ / "scripts" / name, fs::perms::owner_all);
        }
        for (const char* preset : {"asan", "tsan", "release"}) {
            fs::create_directories(folder_ / "build" / preset);
            std::ofstream(folder_ / "build" / preset / "CTestTestfile.cmake")
                << "add_test(room.Suite.Test true)\n";
        }
    }
    void TearDown() override { fs::remove_all(folder_); }

    Answer answer(const std::string& words) const {
        return run("env -u DASHBOARD_TEST_FROM_CTEST '" + (folder_ / "test").string() + "' " +
                   words);
    }

    const fs::path folder_ = fs::path(testing::TempDir()) / "test alone";
};

TEST_F(TestWithoutTests, FailsWhereNoTestIsCalledSo) {
    EXPECT_EQ(answer("room").status, 0) << answer("room").output;
    EXPECT_EQ(answer("--quick").status, 0) << answer("--quick").output;
    EXPECT_EQ(answer("--quick room").status, 0) << answer("--quick room").output;
    for (const char* wrong : {"rooom", "--quick rooom"})
        EXPECT_NE(answer(wrong).status, 0) << wrong << ": " << answer(wrong).output;
}

// The rooms that run under the sanitizers are not here.
TEST_F(TestWithoutTests, FailsWhereTheSanitizersHaveNothingToLookAt) {
    EXPECT_NE(answer("").status, 0) << answer("").output;
}

TEST_F(TestWithoutTests, RefusesWhatItDoesNotKnow) {
    for (const char* wrong : {"--quik", "room Suite", "--quick room Suite", "-R room", "''"}) {
        const Answer refused = answer(wrong);
        EXPECT_NE(refused.status, 0) << wrong;
        EXPECT_TRUE(refused.output.starts_with("test: ")) << wrong << ": " << refused.output;
    }
}

// A mistyped preset, or a question for help, once left a folder of its name.
TEST(Build, PrintsHelpAndRefusesAnUnknownPresetWithoutMakingAFolder) {
    const fs::path alone = fs::path(testing::TempDir()) / "build alone";
    fs::create_directories(alone / "scripts");
    fs::copy_file(fs::path(HEPATICA_SOURCE_DIR) / "CMakePresets.json", alone / "CMakePresets.json");
    fs::copy_file(fs::path(HEPATICA_SOURCE_DIR) / "scripts" / "build", alone / "scripts" / "build");
    const std::string program = "'" + (alone / "scripts" / "build").string() + "' ";
    for (const char* option : {"--help", "-h"}) {
        const Answer help = run(program + option);
        EXPECT_EQ(help.status, 0) << help.output;
        EXPECT_NE(help.output.find("PRESET"), std::string::npos) << help.output;
    }
    for (const char* wrong : {"", "relase", "base", "--release"}) {
        const Answer answer = run(program + wrong);
        EXPECT_NE(answer.status, 0) << wrong;
        EXPECT_NE(answer.output.find("no preset"), std::string::npos) << answer.output;
    }
    EXPECT_FALSE(fs::exists(alone / "build"));
}

}  // namespace
}  // namespace hepatica
