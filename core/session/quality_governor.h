// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the frame within its budget: steps down the dial when the machine falls behind and up again
// when there is room, by the cost of the frames it has seen on this machine and this body. It never
// looks at the clock itself; what it decides is a command in the recording.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace hepatica {

class QualityGovernor {
  public:
    // Costs of the dial's front, cheapest first: their ratios forecast what has not been seen yet.
    explicit QualityGovernor(std::vector<double> front_ms);

    // The most accurate setting whose measured cost fits; the cheapest where none does.
    std::size_t start(double budget_ms) const;

    // Takes what a frame cost at the setting `at`; returns the setting for the next one. Down, as
    // far as the forecast asks, after the median of nine frames was beyond the budget; up by one
    // after a second in which the next one would have taken seven tenths of it at most. A setting
    // that had to be left is not tried again for two seconds, then four, eight, ... up to two
    // minutes.
    std::size_t next(std::size_t at, double frame_ms, double budget_ms);

  private:
    double forecast(std::size_t setting, std::size_t at, double seen_ms) const;
    std::size_t moved_to(std::size_t setting);

    std::vector<double> front_ms_;
    std::deque<double> recent_ms_;
    std::vector<int> barred_;   // frames until a setting may be tried again
    std::vector<int> penalty_;  // the next bar, in frames
    int roomy_frames_ = 0;      // in a row
    int frames_to_ignore_ = 0;  // after a change, whose first frames are not typical
};

}  // namespace hepatica
