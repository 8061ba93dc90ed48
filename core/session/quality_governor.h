// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the setting of the dial so that frames keep within their budget: a cheaper one when
// frames are late, a more accurate one when there is time left. Decisions depend on the cost of
// frames on this machine and body, which the caller passes in; the class reads no clock. Each
// decision is recorded as a command.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace hepatica {

class QualityGovernor {
  public:
    // Costs and errors of the dial's settings, cheapest first. The cost of a setting that was not
    // yet used here is forecast as the measured cost of the present setting times the ratio of the
    // two. Of settings with nearly equal errors only the cheapest is ever chosen.
    QualityGovernor(std::vector<double> front_ms, const std::vector<double>& errors);

    // The most accurate setting whose cost fits the budget; the cheapest where none does.
    std::size_t start(double budget_ms) const;

    // Takes the cost of a frame at the setting `at` and returns the setting for the next frame.
    // Where the median of nine frames exceeds the budget, it goes down to the first setting whose
    // forecast fits. Where the next better setting would have kept within seven tenths of the
    // budget for a second, it goes up by one. A setting that proved too slow is not tried again for
    // two seconds, next time for four, eight, ... up to two minutes.
    std::size_t next(std::size_t at, double frame_ms, double budget_ms);

  private:
    double forecast(std::size_t setting, std::size_t at, double seen_ms) const;
    std::size_t moved_to(std::size_t setting);

    std::vector<double> front_ms_;
    std::vector<std::size_t> choices_;  // the settings that are ever chosen
    std::deque<double> recent_ms_;
    std::vector<int> barred_;   // per setting: frames until it may be tried again
    std::vector<int> penalty_;  // per setting: frames for which it will be barred next time
    int roomy_frames_ = 0;      // consecutive frames in which a better setting would have fitted
    int frames_to_ignore_ = 0;  // the first frames after a change are not typical
};

}  // namespace hepatica
