// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/moving_mean.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace hepatica {

namespace {

std::size_t steps_of(double span_s, double dt_s) {
    assert(span_s > 0.0 && dt_s > 0.0);
    return static_cast<std::size_t>(std::max(1.0, std::round(span_s / dt_s)));
}

}  // namespace

MovingMean::MovingMean(double span_s, double dt_s) : samples_(steps_of(span_s, dt_s), 0.0) {}

double MovingMean::take(double sample) {
    samples_[oldest_] = sample;
    oldest_ = (oldest_ + 1) % samples_.size();
    const double sum = std::accumulate(samples_.begin(), samples_.end(), 0.0);
    return sum / static_cast<double>(samples_.size());
}

}  // namespace hepatica
