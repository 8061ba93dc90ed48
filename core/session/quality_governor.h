// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the setting of the dial so that a frame keeps within its budget: a cheaper one when
// frames are late, a more accurate one when there is time left. It decides by the cost of frames
// measured on this machine and this body, which the caller passes in; it reads no clock. Each
// decision is recorded as a command.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace hepatica {

class QualityGovernor {
  public:
    // Costs and errors of the dial's settings, the cheapest first. The cost of a setting not yet
    // used here is forecast as the measured cost of the present one times the ratio of the two. Of
    // settings whose errors are as good as equal only the cheapest is ever chosen: to go from one
    // to the other would turn the dial for nothing.
    QualityGovernor(std::vector<double> front_ms, const std::vector<double>& errors);

    // The most accurate setting whose cost fits the budget; the cheapest where none does.
    std::size_t start(double budget_ms) const;

    // Takes the cost of a frame at the setting `at` and returns the setting for the next frame.
    // Where the median of nine frames exceeds the budget, it goes down to the first setting whose
    // forecast fits. Where the next better one that may be chosen would have kept within seven
    // tenths of the budget for a second, it goes up by one. A setting that proved too slow is not
    // tried again for two seconds, the next time for four, eight, ... up to two minutes.
    std::size_t next(std::size_t at, double frame_ms, double budget_ms);

  private:
    double forecast(std::size_t setting, std::size_t at, double seen_ms) const;
    std::size_t moved_to(std::size_t setting);

    std::vector<double> front_ms_;
    std::vector<std::size_t> choices_;  // the settings that are ever chosen
    std::deque<double> recent_ms_;
    std::vector<int> barred_;   // of each setting: frames until it may be tried again
    std::vector<int> penalty_;  // of each setting: frames for which it will be barred next
    int roomy_frames_ = 0;      // frames in a row after which a better setting would have fitted
    int frames_to_ignore_ = 0;  // the first frames after a change are not typical
};

}  // namespace hepatica
