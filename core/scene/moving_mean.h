// SPDX-License-Identifier: GPL-3.0-or-later
// Mean of a quantity over the last stretch of time, sampled in equal steps. Forces of single steps
// jump where a vessel snaps or a contact opens; what a hand feels, and a force sensor shows, does
// not.
#pragma once

#include <cstddef>
#include <vector>

namespace hepatica {

// Before the first sample the quantity counts as 0. Not thread-safe.
class MovingMean {
  public:
    // `span_s` and `dt_s` above 0, in seconds; a span shorter than a step is one step.
    MovingMean(double span_s, double dt_s);

    // Takes the next sample in place of the oldest and returns the mean. Costs one pass over the
    // span's samples, so that no rounding is carried on.
    double take(double sample);

  private:
    std::vector<double> samples_;
    std::size_t oldest_ = 0;
};

}  // namespace hepatica
