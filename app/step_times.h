// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the steps of a play. A body at rest sleeps through its steps at no cost, so quantiles
// are over the other steps, and sleeping ones are counted.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/session/session.h"

namespace hepatica {

class StepTimes {
  public:
    void add(const SessionStep& step);

    std::size_t steps() const { return awake_ms_.size() + asleep_; }
    std::size_t asleep() const { return asleep_; }
    double wall_ms() const { return wall_ms_; }  // of all steps
    // Quantile in ms over the awake steps, `share` from 0 to 1; null where there are none.
    nlohmann::ordered_json quantile(double share) const;
    // Share of the awake steps that took at most 1/60 s; null where there are none.
    nlohmann::ordered_json frames_in_time() const;

  private:
    std::vector<double> awake_ms_;
    std::size_t asleep_ = 0;
    double wall_ms_ = 0.0;
};

}  // namespace hepatica
