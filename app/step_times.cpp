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

nlohmann::ordered_json StepTimes::frames_in_time() const {
    constexpr double frame_ms = 1000.0 / 60.0;
    if (awake_ms_.empty()) return nullptr;
    const auto in_time = std::ranges::count_if(awake_ms_, [](double ms) { return ms <= frame_ms; });
    return static_cast<double>(in_time) / static_cast<double>(awake_ms_.size());
}

}  // namespace hepatica
