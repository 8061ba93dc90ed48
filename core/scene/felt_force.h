// SPDX-License-Identifier: GPL-3.0-or-later
// What a hand feels of the forces in a play's frames: their means over a moment, because the force
// of a single step jumps where a vessel snaps or a contact opens. A lesson judges these means, and
// the view shows them.
#pragma once

#include "core/scene/frame.h"
#include "core/scene/moving_mean.h"

namespace hepatica {

// Not thread-safe.
class FeltForce {
  public:
    // Means are over this time [s], or over one step where that is longer.
    static constexpr double over_s = 0.05;

    // `dt_s` above 0: time from one frame to the next.
    explicit FeltForce(double dt_s);

    // Call with each frame in order. A paused frame changes nothing. O(over_s / dt_s).
    void see(const Frame& frame);
    // Writes the means into the frame's pull and tool.
    void show_in(Frame& frame) const;
    // Of pull and tool together [mN].
    double sum_mn() const { return pull_mn_ + tool_mn_; }

  private:
    MovingMean pulls_, tools_;
    double pull_mn_ = 0.0, tool_mn_ = 0.0;
};

}  // namespace hepatica
