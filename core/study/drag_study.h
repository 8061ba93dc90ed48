// SPDX-License-Identifier: GPL-3.0-or-later
// What a motion of the hand costs and misses, in the few numbers that say whether frames are kept:
// the tail of the frames' times, the share of them in time, and the error of that very motion.
#pragma once

#include <optional>
#include <string>

#include "core/study/hand_trial.h"

namespace hepatica {

struct DragQuantiles {
    double median = 0.0, p95 = 0.0, p99 = 0.0, longest = 0.0;
};

// Over the frames that the body did not sleep through; where it slept through all, the figures are
// those of the sleeping ones.
struct DragSummary {
    int steps = 0;  // all of the motion
    int asleep = 0;
    DragQuantiles frame_ms;  // wall time, or the processor's where that is less
    DragQuantiles wall_ms;
    double frames_in_time = 0.0;  // share of frame_ms of at most 1/60 s
    int solves_median = 0, solves_most = 0;
    int iterations_median = 0, iterations_most = 0;
    double live_median = 0.0, live_most = 0.0;  // share of the elements
    int degraded = 0;                           // steps
    std::string degraded_because;               // of the first of them
};

DragSummary summary_of(const HandPlay& played);

}  // namespace hepatica
