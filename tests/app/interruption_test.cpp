// SPDX-License-Identifier: GPL-3.0-or-later
// Work that does not listen is not waited for twice.
#include "app/interruption.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

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

}  // namespace
}  // namespace hepatica
