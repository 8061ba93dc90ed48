// SPDX-License-Identifier: GPL-3.0-or-later
// scripts/mutation_score on a project of one small room, in a folder of its own: what it reports,
// and that it never leaves a changed file behind.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

namespace hepatica {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

class MutationScore : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(project_);
        fs::create_directories(project_ / "core" / "toy");
        fs::create_directories(project_ / "scripts");
        fs::copy_file(fs::path(HEPATICA_SOURCE_DIR) / "scripts" / "mutation_score", script_);
        std::ofstream(project_ / ".gitignore") << "/build/\n";
        // larger() is tested, untested() is not; the last line compiles with no other size.
        std::ofstream(source_) << "// larger: a < b\n"
                                  "int larger(int a, int b) { return a < b ? b : a; }\n"
                                  "int untested(int a, int b) { return a * b; }\n"
                                  "const char* const words = \"1 + 2 < 3\";\n"
                                  "static_assert(1 + 1 == 2);\n"
                                  "char letters[3] = {1, 2, 3};\n";
        std::ofstream(project_ / "toy_tests.cpp")
            << "int larger(int, int);\n"
               "int main() { return larger(2, 3) == 3 && larger(3, 2) == 3 ? 0 : 1; }\n";
        std::ofstream(project_ / "CMakeLists.txt")
            << "cmake_minimum_required(VERSION 3.25)\n"
               "project(Toy LANGUAGES CXX)\n"
               "set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)\n"
               "add_executable(toy_tests toy_tests.cpp core/toy/toy.cpp)\n";
        before_ = text_of(source_);
        ASSERT_EQ(std::system(("git init -q '" + project_.string() + "'").c_str()), 0);
    }
    void TearDown() override { fs::remove_all(project_); }

    std::string answer(const std::string& arguments, bool succeeds = true) {
        FILE* const pipe =
            popen(("'" + script_.string() + "' " + arguments + " 2>&1").c_str(), "r");
        std::string output;
        for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
            output += static_cast<char>(c);
        EXPECT_EQ(pclose(pipe) == 0, succeeds) << output;
        return output;
    }

    // There must be one.
    fs::path verdicts_file() const {
        for (const auto& entry : fs::directory_iterator(project_ / "build" / "mutation"))
            if (entry.path().extension() == ".jsonl") return entry.path();
        ADD_FAILURE() << "no verdicts were kept";
        return {};
    }
    void forget_verdicts() const { fs::remove(verdicts_file()); }

    fs::path project_ = fs::path(testing::TempDir()) /
                        (std::string("mutation_score_") +
                         testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::path script_ = project_ / "scripts" / "mutation_score";
    fs::path source_ = project_ / "core" / "toy" / "toy.cpp";
    fs::path copy_ = project_ / "build" / "mutation" / "0" / "core" / "toy" / "toy.cpp";
    std::string before_;
};

TEST_F(MutationScore, DrawsTheSameMutantsOfASeedAndNoneInWords) {
    const std::string drawn = answer("toy 100 7 --list");
    EXPECT_EQ(answer("all 100 7 --list"), drawn);
    EXPECT_NE(answer("toy 100 8 --list"), drawn);
    EXPECT_NE(drawn.find("toy.cpp:2: < -> <="), std::string::npos) << drawn;
    EXPECT_NE(drawn.find("toy.cpp:3: * -> /"), std::string::npos) << drawn;
    for (const int silent : {1, 4, 5})
        EXPECT_EQ(drawn.find("toy.cpp:" + std::to_string(silent) + ":"), std::string::npos)
            << drawn;
    EXPECT_FALSE(fs::exists(project_ / "build"));
}

TEST_F(MutationScore, TellsNoticedFromSurvivedAndLeavesTheCheckoutAsItWas) {
    const std::string report = answer("toy 100 7");
    EXPECT_NE(report.find("`* -> /` | survived"), std::string::npos) << report;
    EXPECT_NE(report.find("mutants noticed"), std::string::npos) << report;
    EXPECT_EQ(text_of(source_), before_);
    EXPECT_EQ(text_of(copy_), before_);
    // The other way round it can: the tests notice it, and the copy follows the checkout.
    std::ofstream(source_) << "int larger(int a, int b) { return b > a - 1 ? b : a; }\n";
    EXPECT_NE(answer("toy 1 1 --list").find("toy.cpp:1"), std::string::npos);
    const std::string again = answer("toy 100 7");
    EXPECT_NE(again.find("`- -> +` | noticed"), std::string::npos) << again;
}

// No change of `a < b` to `a <= b` can be seen in the larger of two numbers, and the compiler makes
// the same of both. What a header holds and nothing includes here only looks as if it were so.
TEST_F(MutationScore, CountsApartWhatTheCompilerFindsToBeTheSame) {
    std::ofstream(project_ / "core" / "toy" / "toy.h")
        << "inline int twice(int a) { return 2 * a; }\n";
    std::ofstream(source_) << "#include \"toy.h\"\n"
                           << before_
                           << "int same(int a) { int none = a; none -= a; return a + none; }\n";
    const std::string report = answer("toy 100 7");
    EXPECT_NE(report.find("`< -> <=` | equivalent |"), std::string::npos) << report;
    EXPECT_NE(report.find("`+ -> -` | equivalent |"), std::string::npos) << report;
    EXPECT_NE(report.find("`-= -> +=` | survived"), std::string::npos) << report;
    EXPECT_NE(
        report.find("toy.h:1 | `inline int twice(int a) { return 2 * a; }` | `* -> /` | survived"),
        std::string::npos)
        << report;
    EXPECT_NE(report.find("the original's: 2\n"), std::string::npos) << report;
    // Each row is one of the three.
    const auto rows = [&](const std::string& verdict) {
        int count = 0;
        for (std::size_t at = 0; (at = report.find("` | " + verdict, at)) != std::string::npos;
             ++at)
            ++count;
        return count;
    };
    EXPECT_NE(report.find("\n" + std::to_string(rows("noticed")) + " of " +
                          std::to_string(rows("noticed") + rows("survived")) + " mutants noticed"),
              std::string::npos)
        << report;
    const std::string survivors = report.substr(report.find("Survivors:"));
    EXPECT_EQ(survivors.find("< -> <="), std::string::npos) << report;
}

TEST_F(MutationScore, SaysTheSameHoweverManyAreTriedAtOnce) {
    const std::string one = answer("toy 100 7 --at-once 1");
    forget_verdicts();
    EXPECT_EQ(answer("toy 100 7 --at-once 3"), one);
    forget_verdicts();
    // The first of them, in the order of the draw.
    const std::string two = answer("toy 2 7 --at-once 3");
    EXPECT_EQ(one.substr(0, two.find("\n\n")), two.substr(0, two.find("\n\n")));
}

// Each verdict of a run that was interrupted while it wrote the last one stands, but for that.
TEST_F(MutationScore, GoesOnWhereItWasInterruptedUnlessAFileHasChanged) {
    const std::string report = answer("toy 100 7");
    const fs::path kept = verdicts_file();
    std::string lines = text_of(kept);
    const std::string survived = "* -> /\", \"survived\"]";
    ASSERT_NE(lines.find(survived), std::string::npos) << lines;
    lines.replace(lines.find(survived), survived.size(), "* -> /\", \"noticed: a trace\"]");
    std::ofstream(kept) << lines << "\n[\"core/toy/toy.cpp:";
    std::string expected = report.substr(0, report.find("\n\n"));
    expected.replace(expected.find("| survived |"), 12, "| noticed: a trace |");
    const std::string again = answer("toy 100 7");
    EXPECT_EQ(again.substr(0, again.find("\n\n")), expected);
    std::ofstream(project_ / "toy_tests.cpp", std::ios::app) << "// changed\n";
    EXPECT_EQ(answer("toy 100 7"), report);
}

TEST_F(MutationScore, EndsWhereTheTestsFailWithoutAMutant) {
    std::ofstream(project_ / "toy_tests.cpp") << "int main() { return 1; }\n";
    EXPECT_NE(answer("toy 100 7 --at-once 2", false).find("does not pass without a mutant"),
              std::string::npos);
    EXPECT_EQ(text_of(source_), before_);
}

// Killed while a mutant is in place, it leaves that in its copy alone, and the next run mends it.
TEST_F(MutationScore, LeavesTheCheckoutAsItWasEvenWhenItIsKilled) {
    std::ofstream(project_ / "toy_tests.cpp")
        << "#include <unistd.h>\n"
           "int larger(int, int);\nint untested(int, int);\n"
           "int main() { if (untested(2, 3) != 6) sleep(60); return larger(2, 3) == 3 ? 0 : 1; }\n";
    // The shell says its own number before it becomes the script.
    FILE* const pipe =
        popen(("echo $$; exec '" + script_.string() + "' toy 100 7 --at-once 1 2>&1").c_str(), "r");
    int process = 0;
    ASSERT_EQ(std::fscanf(pipe, "%d", &process), 1);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!(fs::exists(copy_) && text_of(copy_).find("a / b") != std::string::npos) &&
           std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(kill(process, SIGKILL), 0);
    pclose(pipe);
    EXPECT_EQ(text_of(source_), before_);
    EXPECT_NE(text_of(copy_), before_) << "it was killed too late to show anything";
    std::ofstream(project_ / "toy_tests.cpp") << "int main() { return 0; }\n";
    answer("toy 0 7");
    EXPECT_EQ(text_of(copy_), before_);
}

}  // namespace
}  // namespace hepatica
