// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/heard_hand.h"

#include <cstddef>

#include "core/base/frame_time.h"
#include "core/session/hand_pace.h"

namespace hepatica {

std::vector<std::vector<Command>> heard(const std::vector<std::vector<Command>>& commands,
                                        const HeardHand& hand) {
    if (hand.every <= 1) return commands;
    const auto at = [](std::size_t frame) {
        const std::chrono::duration<double> since_begin(frame_s * static_cast<double>(frame));
        return HandPace::Clock::time_point(
            std::chrono::duration_cast<HandPace::Clock::duration>(since_begin));
    };
    HandPace pace(at(0));
    std::vector<std::vector<Command>> heard(commands.size());
    for (std::size_t f = 0; f < commands.size(); ++f) {
        for (const Command& command : commands[f]) {
            const auto* move = std::get_if<MoveGrab>(&command);
            if (move == nullptr) {
                heard[f].push_back(command);
            } else if (f % static_cast<std::size_t>(hand.every) == 0) {
                MoveGrab report = *move;
                if (!hand.at_once) report.over_s = pace.heard(at(f));
                heard[f].emplace_back(report);
            }
        }
    }
    return heard;
}

}  // namespace hepatica
