// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session_inbox.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stop_token>
#include <thread>
#include <utility>

namespace hepatica {
namespace {

using namespace std::chrono_literals;

MoveGrab to(double x_mm) {
    return {Vec3(x_mm, 0, 0)};
}

TEST(SessionInbox, KeepsTheNewestOfConsecutiveMovesAndTheOrderOfAllElse) {
    SessionInbox inbox;
    inbox.post(to(1));
    inbox.post(to(2));
    inbox.post(SetPaused{true});
    inbox.post(to(3));
    inbox.post_first(FinishInjection{});
    const std::vector<Command> taken = inbox.take_commands();
    ASSERT_EQ(taken.size(), 4u);
    EXPECT_TRUE(std::holds_alternative<FinishInjection>(taken[0]));
    EXPECT_EQ(std::get<MoveGrab>(taken[1]).target_mm.x(), 2.0);
    EXPECT_TRUE(std::holds_alternative<SetPaused>(taken[2]));
    EXPECT_EQ(std::get<MoveGrab>(taken[3]).target_mm.x(), 3.0);
    EXPECT_TRUE(inbox.take_commands().empty());
}

// One that was replaced counts as taken with the one that replaced it.
TEST(SessionInbox, NumbersCommandsAndKnowsWhichWereTaken) {
    SessionInbox inbox;
    EXPECT_EQ(inbox.post(to(1)), 1u);
    EXPECT_EQ(inbox.post(to(2)), 2u);
    EXPECT_EQ(inbox.commands_taken(), 0u);
    inbox.post_first(FinishInjection{});
    inbox.take_commands();
    EXPECT_EQ(inbox.commands_taken(), 2u);
    EXPECT_EQ(inbox.post(SetPaused{true}), 3u);
    EXPECT_EQ(inbox.commands_taken(), 2u);
    inbox.take_commands();
    EXPECT_EQ(inbox.commands_taken(), 3u);
}

// A move of the tool by a share of its way adds to the one before.
TEST(SessionInbox, KeepsEveryMoveThatGoesOnlyAShareOfItsWay) {
    SessionInbox inbox;
    inbox.post(MoveTool{.target_mm = Vec3::Zero(), .share = 0.5});
    inbox.post(MoveTool{.target_mm = Vec3::Zero(), .share = 1.0});
    EXPECT_EQ(inbox.take_commands().size(), 2u);
}

TEST(SessionInbox, GivesWhatWasHandedOverOnceAndTheNewestOnly) {
    SessionInbox inbox;
    EXPECT_FALSE(inbox.take_dial());
    EXPECT_FALSE(inbox.take_recording());
    int begun = 0;
    inbox.hand_over([&](const Recording&) -> SessionInbox::Keep { return begun = 1, nullptr; });
    inbox.hand_over([&](const Recording&) -> SessionInbox::Keep { return begun = 2, nullptr; });
    const auto begin = inbox.take_recording();
    ASSERT_TRUE(begin);
    (*begin)({});
    EXPECT_EQ(begun, 2);
    EXPECT_FALSE(inbox.take_recording());
}

TEST(SessionInbox, SleepsUntilACommandOrAStop) {
    SessionInbox inbox;
    std::stop_source source;
    int woken = 0;
    std::jthread stepping([&] {
        inbox.wait(source.get_token());
        woken += static_cast<int>(inbox.take_commands().size());
        inbox.wait(source.get_token());
    });
    while (!inbox.waited_for()) std::this_thread::yield();
    inbox.post(SetPaused{true});
    while (!inbox.waited_for()) std::this_thread::yield();
    source.request_stop();
    stepping.join();
    EXPECT_EQ(woken, 1);
}

TEST(SessionInbox, ASleepForATimeEndsAtAStop) {
    SessionInbox inbox;
    std::stop_source source;
    source.request_stop();
    const auto start = std::chrono::steady_clock::now();
    inbox.sleep_until(start + 60s, source.get_token());
    EXPECT_LT(std::chrono::steady_clock::now() - start, 30s);
}

}  // namespace
}  // namespace hepatica
