// SPDX-License-Identifier: GPL-3.0-or-later
// ./run and ./test, as far as they can be tried without installing and building anything.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
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

}  // namespace
}  // namespace hepatica
