// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/step_times.h"

#include <algorithm>

#include "core/base/frame_time.h"
#include "core/study/timing.h"

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
    return hepatica::quantile(awake_ms_, share);
}

nlohmann::ordered_json StepTimes::frames_in_time() const {
    if (awake_ms_.empty()) return nullptr;
    const auto in_time =
        std::ranges::count_if(awake_ms_, [](double ms) { return ms <= frame_length_ms; });
    return static_cast<double>(in_time) / static_cast<double>(awake_ms_.size());
}

}  // namespace hepatica
