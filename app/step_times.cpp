// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/step_times.h"

#include <algorithm>

namespace hepatica {

void StepTimes::add(const SessionStep& step) {
    wall_ms_ += step.step_ms;
    if (step.deform.asleep)
        ++asleep_;
    else
        awake_ms_.push_back(step.step_ms);
}

nlohmann::ordered_json StepTimes::quantile(double share) const {
    if (awake_ms_.empty()) return nullptr;
    std::vector<double> sorted = awake_ms_;
    std::ranges::sort(sorted);
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace hepatica
