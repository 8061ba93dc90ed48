// SPDX-License-Identifier: GPL-3.0-or-later
// How evenly a hand is heard while it leads something: pictures that take long to draw come between
// two reports of the mouse. What is led takes the longest of the recent gaps, and one and a half
// steps more, for its way to each place: so it is still on its way when the next report comes, and
// moves about as evenly as the hand does. It lags behind by that much; where a report comes in
// every step, by nothing.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "core/base/frame_time.h"

namespace hepatica {

class HandPace {
  public:
    using Clock = std::chrono::steady_clock;

    // The hand begins to lead something.
    explicit HandPace(Clock::time_point now = {}) : heard_(now) {}

    // A report of where the hand is. How long what is led takes for the way there [s], at most
    // longest_s; none: it is there at once.
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
    static constexpr double rest_s = 0.15;  // in such a gap the hand has rested
    static constexpr double kept = 0.95;    // of a gap, from one report to the next

    Clock::time_point heard_;
    double longest_gap_s_ = 0.0;
};

}  // namespace hepatica
