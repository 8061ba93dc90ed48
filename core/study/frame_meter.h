// SPDX-License-Identifier: GPL-3.0-or-later
// Steps a body a frame of 1/60 s at a time and keeps what that costs: wall time, or the processor's
// where that is less, which it is only where other programs made the frame wait; on a device the
// wall time.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/deform/stepper/stepper.h"
#include "core/study/tradeoff.h"

namespace hepatica {

class FrameMeter {
  public:
    // One frame in `parts` equal steps. Throws Cancelled soon after the job was cancelled.
    void step(Stepper& stepper, int parts, const Job& job);

    int frames() const { return static_cast<int>(frame_ms_.size()); }
    double last_wall_ms() const { return last_wall_ms_; }
    // Cost (what 95 of 100 frames take at most) and mean iterations of the frames so far, which are
    // one or more.
    void book(TradeoffPoint& point) const;

  private:
    std::vector<double> frame_ms_;
    double last_wall_ms_ = 0.0;
    double iterations_ = 0.0;
};

}  // namespace hepatica
