// SPDX-License-Identifier: GPL-3.0-or-later
// Work that does not listen is not waited for twice, and a pipe that is closed ends no program.
#include "app/interruption.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "tests/app/run_program.h"

namespace hepatica {
namespace {

// Ends by 0 where both signals were only heard.
[[noreturn]] void send(int first, int second) {
    // A shell that starts a program in the background has it ignore them.
    for (const int number : {first, second}) std::signal(number, SIG_DFL);
    const Interruption interruption;
    if (Interruption::came()) std::_Exit(1);
    std::raise(first);
    if (!Interruption::came()) std::_Exit(2);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    std::raise(second);
    std::_Exit(0);
}

TEST(Interruption, ASecondCtrlCEndsTheProgramAtOnce) {
    EXPECT_EXIT(send(SIGINT, SIGINT), testing::ExitedWithCode(exit_interrupted), "second Ctrl-C");
    EXPECT_EXIT(send(SIGTERM, SIGINT), testing::ExitedWithCode(exit_interrupted), "");
    EXPECT_EXIT(send(SIGINT, SIGTERM), testing::ExitedWithCode(0), "");
}

// The end of a pipe that is open for writing alone: somebody had it open to read, and left.
test::Outcome into_closed_pipe(const std::string& call) {
    const std::filesystem::path pipe =
        std::filesystem::temp_directory_path() / "hepatica-closed-pipe";
    std::filesystem::remove(pipe);
    const test::Outcome run = test::run_cli(
        {"-c", "mkfifo \"$0\" && exec 3<>\"$0\" 4>\"$0\" 3<&- && exec " + call + " >&4",
         pipe.string()},
        {.signal = SIGPIPE, .program = "/bin/bash"});  // not ignored by who starts the test
    std::filesystem::remove(pipe);
    return run;
}

TEST(ClosedPipe, EndsNoProgram) {
    const test::Outcome other = into_closed_pipe("/bin/sh -c 'echo 1; echo 2'");
    EXPECT_EQ(other.exit_code, -SIGPIPE) << "what it does to others: " << other.errors;
    const test::Outcome cli = into_closed_pipe(std::string("'") + HEPATICA_CLI + "' diagnose");
    EXPECT_NE(cli.exit_code, -SIGPIPE) << cli.errors;
#ifdef HEPATICA_WINDOW_PROGRAM
    const test::Outcome window =
        into_closed_pipe(std::string("'") + HEPATICA_WINDOW_PROGRAM + "' --diagnose");
    EXPECT_EQ(window.exit_code, 0) << window.errors;
#endif
}

}  // namespace
}  // namespace hepatica
