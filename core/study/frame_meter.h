// SPDX-License-Identifier: GPL-3.0-or-later
// Steps a body frame by frame (1/60 s) and records the cost: wall time, or processor time where
// that is less, which happens only where other programs made the frame wait; on a device always
// wall time.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/deform/stepper/stepper.h"
#include "core/study/timing.h"
#include "core/study/tradeoff.h"

namespace hepatica {

class FrameMeter {
  public:
    // Makes one frame in `parts` equal steps. Throws Cancelled soon after the job was cancelled.
    void step(Stepper& stepper, int parts, const Job& job);

    int frames() const { return static_cast<int>(frame_ms_.size()); }
    double last_wall_ms() const { return last_wall_ms_; }
    // Writes the cost (95th percentile) and the mean iterations of the frames so far, at least one,
    // into the point.
    void book(TradeoffPoint& point) const;

  private:
    std::vector<double> frame_ms_;
    double last_wall_ms_ = 0.0;
    double iterations_ = 0.0;
};

// Steps a body until it sleeps, for `most_frames` at most. False where the clock's time is over
// before that. Throws Cancelled soon after the job was cancelled.
bool let_fall_asleep(Stepper& stepper, int most_frames, const BudgetClock& clock, const Job& job);

}  // namespace hepatica
