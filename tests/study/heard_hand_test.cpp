// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/heard_hand.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

// A hand that takes the vessel, is a millimetre further in each frame, and lets go in the tenth.
std::vector<std::vector<Command>> steady_hand() {
    std::vector<std::vector<Command>> commands(10);
    commands.front().emplace_back(GrabVertex{7});
    for (int f = 0; f < 10; ++f) commands[f].emplace_back(MoveGrab{Vec3(f, 0, 0)});
    commands.back().emplace_back(ReleaseGrab{});
    return commands;
}

// The frames in which moves are heard, and how long each takes.
std::vector<std::pair<int, std::optional<double>>> moves_of(
    const std::vector<std::vector<Command>>& commands) {
    std::vector<std::pair<int, std::optional<double>>> moves;
    for (int f = 0; f < static_cast<int>(commands.size()); ++f)
        for (const Command& command : commands[f])
            if (const auto* move = std::get_if<MoveGrab>(&command)) {
                EXPECT_EQ(move->target_mm.x(), f);
                moves.emplace_back(f, move->over_s);
            }
    return moves;
}

TEST(HeardHand, InEveryFrameIsTheHandItself) {
    const auto moves = moves_of(heard(steady_hand(), {}));
    ASSERT_EQ(moves.size(), 10U);
    for (const auto& [frame, over_s] : moves) EXPECT_FALSE(over_s);
}

TEST(HeardHand, LosesMovesButNothingElse) {
    const auto commands = heard(steady_hand(), {.every = 3});
    EXPECT_TRUE(std::holds_alternative<GrabVertex>(commands.front().front()));
    EXPECT_TRUE(std::holds_alternative<ReleaseGrab>(commands.back().back()));
    const auto moves = moves_of(commands);
    ASSERT_EQ(moves.size(), 4U);
    for (std::size_t m = 0; m < moves.size(); ++m) {
        EXPECT_EQ(moves[m].first, 3 * static_cast<int>(m));
        if (m == 0) continue;  // the first report is the hand's beginning
        ASSERT_TRUE(moves[m].second);
        EXPECT_GT(*moves[m].second, 3.0 / 60.0);
        EXPECT_LT(*moves[m].second, 6.0 / 60.0);
    }
}

TEST(HeardHand, IsThereAtOnceWhereThatIsAskedFor) {
    const auto moves = moves_of(heard(steady_hand(), {.every = 3, .at_once = true}));
    ASSERT_EQ(moves.size(), 4U);
    for (const auto& [frame, over_s] : moves) EXPECT_FALSE(over_s);
}

}  // namespace
}  // namespace hepatica
