// SPDX-License-Identifier: GPL-3.0-or-later
// Over what time a led point moves from one report of the mouse to the next. Pictures that take
// long to draw delay these reports. The time is the longest of the recent gaps between reports plus
// one and a half steps, so that the point is still moving when the next report comes and moves
// about as evenly as the hand. It lags behind by that time; not at all where a report comes in
// every step.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "core/base/frame_time.h"

namespace hepatica {

class HandPace {
  public:
    using Clock = std::chrono::steady_clock;

    // The hand starts to lead something.
    explicit HandPace(Clock::time_point now = {}) : heard_(now) {}

    // To be called with each report of the hand's position. Returns the time for the way there [s],
    // at most longest_s; none: move at once.
    std::optional<double> heard(Clock::time_point now) {
        const double gap_s = std::chrono::duration<double>(now - heard_).count();
        heard_ = now;
        longest_gap_s_ *= kept;
        if (gap_s < rest_s) longest_gap_s_ = std::max(longest_gap_s_, gap_s);
        if (longest_gap_s_ < 1.01 * frame_s) return std::nullopt;
        return std::min(longest_gap_s_ + 1.5 * frame_s, longest_s);
    }

    static constexpr double longest_s = 0.1;

  private:
    static constexpr double rest_s = 0.15;  // after a longer gap the hand had stopped
    static constexpr double kept = 0.95;    // decay of the longest gap per report

    Clock::time_point heard_;
    double longest_gap_s_ = 0.0;
};

}  // namespace hepatica
