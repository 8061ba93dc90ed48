// SPDX-License-Identifier: GPL-3.0-or-later
// What the steps of a play cost. A body that nothing moves sleeps through its steps, in no time at
// all: quantiles are over the others, and the sleeping ones are counted.
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
    // Over the steps that were awake, `share` from 0 to 1; null where there was none.
    nlohmann::ordered_json quantile(double share) const;
    // Of the same steps, the share that took at most 1/60 s; null where there was none.
    nlohmann::ordered_json frames_in_time() const;

  private:
    std::vector<double> awake_ms_;
    std::size_t asleep_ = 0;
    double wall_ms_ = 0.0;
};

}  // namespace hepatica
