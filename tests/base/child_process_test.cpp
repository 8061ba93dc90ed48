// SPDX-License-Identifier: GPL-3.0-or-later
// Children that end well, badly, not at all, and that want more than they may have: shells, so that
// the test needs no program of its own.
#include "core/base/child_process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"

namespace hepatica {
namespace {

using End = ChildOutcome::End;

constexpr ChildLimits ample{std::uint64_t{1} << 32, 60};

ChildOutcome shell(const std::string& commands, const ChildLimits& limits = ample) {
    const Job job;
    return run_child("/bin/sh", {"-c", commands}, limits, job);
}

bool is_running(pid_t id) {
    return kill(id, 0) == 0;
}

TEST(ChildProcess, ItsExitCodeAndErrorsComeBack) {
    const ChildOutcome outcome = shell("echo not seen; echo \"$0 $1\" >&2; exit 3");
    EXPECT_EQ(outcome.end, End::exited);
    EXPECT_EQ(outcome.number, 3);
    EXPECT_EQ(outcome.errors, "/bin/sh \n");
}

TEST(ChildProcess, ArgumentsArriveAsTheyAre) {
    const Job job;
    const ChildOutcome outcome = run_child(
        "/bin/sh", {"-c", "printf '%s|' \"$@\" >&2", "sh", "a b", "肝", "$HOME", ""}, ample, job);
    EXPECT_EQ(outcome.errors, "a b|肝|$HOME||");
}

TEST(ChildProcess, NoMoreOfItsErrorsIsKeptThanAPage) {
    const ChildOutcome outcome = shell("yes '0123456789' | head -c 300000 >&2");
    EXPECT_EQ(outcome.end, End::exited);
    EXPECT_EQ(outcome.number, 0);
    EXPECT_EQ(outcome.errors.size(), 4096u);
}

TEST(ChildProcess, ACrashIsToldByItsSignal) {
    const ChildOutcome outcome = shell("kill -SEGV $$");
    EXPECT_EQ(outcome.end, End::killed);
    EXPECT_EQ(outcome.number, SIGSEGV);
}

TEST(ChildProcess, AProgramThatIsNotThereExitsWith127) {
    const Job job;
    EXPECT_EQ(run_child("/nowhere/program", {}, ample, job).number, 127);
}

TEST(ChildProcess, OneThatSleepsIsEndedByTheClock) {
    const auto start = std::chrono::steady_clock::now();
    const ChildOutcome outcome = shell("exec 2>&-; sleep 60", {ample.memory_bytes, 1});
    EXPECT_EQ(outcome.end, End::out_of_time);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

// The shell names its own limits. That of processor time holds where a child hides from the clock:
// SIGXCPU at the first, which says why, and SIGKILL a second later.
TEST(ChildProcess, HasLimitsOfProcessorTimeAndLeavesNoCore) {
    EXPECT_EQ(shell("{ ulimit -S -t; ulimit -H -t; ulimit -S -c; ulimit -H -c; } >&2",
                    {ample.memory_bytes, 7})
                  .errors,
              "7\n8\n0\n0\n");
}

// Ctrl+C in a terminal reaches the parent alone: a group of processes is what a terminal speaks to.
TEST(ChildProcess, IsAGroupOfItsOwn) {
    EXPECT_EQ(shell("test \"$(cut -d ' ' -f 5 /proc/$$/stat)\" = $$").number, 0);
}

// Gone, or dead and not yet taken note of by whoever inherited it.
bool is_dead(const std::string& id) {
    std::ifstream stat("/proc/" + id + "/stat");
    std::string number, name, state;
    return !(stat >> number >> name >> state) || state == "Z";
}

TEST(ChildProcess, EndsWithItsParentHoweverThatEnds) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "id";
    const std::string half = (folder.path() / "half").string();
    const pid_t parent = fork();
    if (parent == 0) {
        shell("echo $$ > '" + half + "' && mv '" + half + "' '" + file.string() +
              "' && exec sleep 600");
        _exit(0);
    }
    ASSERT_GT(parent, 0);
    const auto waits = [](const auto& condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (!condition() && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return condition();
    };
    const bool began = waits([&] { return std::filesystem::exists(file); });
    kill(parent, SIGKILL);
    waitpid(parent, nullptr, 0);
    ASSERT_TRUE(began);
    std::string id;
    std::ifstream(file) >> id;
    ASSERT_FALSE(id.empty());
    const bool died = waits([&] { return is_dead(id); });
    EXPECT_TRUE(died);
    if (!died) kill(std::stoi(id), SIGKILL);
}

TEST(ChildProcess, OneThatTakesMemoryWithoutEndFails) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers reserve more addresses than any limit";
#endif
    // The shell doubles a string to a gigabyte; without the limit it would end with 0.
    const std::string greedy =
        "s=0123456789abcdef; i=0; while [ $i -lt 26 ]; do s=$s$s; "
        "i=$((i+1)); done; exit 0";
    const ChildOutcome outcome = shell(greedy, {std::uint64_t{1} << 28, 60});
    EXPECT_FALSE(outcome.end == End::exited && outcome.number == 0);
    EXPECT_NE(outcome.end, End::out_of_time);
}

TEST(ChildProcess, FilesOfItsParentAreClosedInIt) {
    const TemporaryFolder folder;
    const int file = open((folder.path() / "open").c_str(), O_CREAT | O_RDWR, 0600);
    ASSERT_GE(file, 3);
    const ChildOutcome outcome = shell("[ -e /proc/$$/fd/" + std::to_string(file) + " ]");
    EXPECT_EQ(outcome.number, 1);
    close(file);
}

TEST(ChildProcess, CancellingKillsItAndWaitsUntilItIsGone) {
    const TemporaryFolder folder;
    const std::filesystem::path note = folder.path() / "id";
    Job job;
    pid_t id = 0;
    std::thread impatient([&] {
        while (id == 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            std::ifstream(note) >> id;
        }
        job.cancel();
    });
    EXPECT_THROW(
        run_child("/bin/sh",
                  {"-c", "echo $$ >\"$0.new\"; mv \"$0.new\" \"$0\"; exec sleep 60", note.string()},
                  ample, job),
        Cancelled);
    impatient.join();
    EXPECT_GT(id, 0);
    EXPECT_FALSE(is_running(id));
}

}  // namespace
}  // namespace hepatica
