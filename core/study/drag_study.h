// SPDX-License-Identifier: GPL-3.0-or-later
// Summary of a motion of the hand: the tail of the frame times and the share of frames in time.
#pragma once

#include <string>

#include "core/study/hand_trial.h"

namespace hepatica {

struct DragQuantiles {
    double median = 0.0, p95 = 0.0, p99 = 0.0, longest = 0.0;
};

// Statistics over the frames in which the body was awake, or over all if it slept through all.
struct DragSummary {
    int steps = 0;  // frames of the whole motion
    int asleep = 0;
    DragQuantiles frame_ms;  // wall time, or processor time where that is less
    DragQuantiles wall_ms;
    double longest_wait_ms = 0.0;  // wall time between two pictures that a frame shows
    double frames_in_time = 0.0;   // share of frames with at most 1/60 s
    int solves_median = 0, solves_most = 0;
    int iterations_median = 0, iterations_most = 0;
    double live_median = 0.0, live_most = 0.0;  // share of the elements
    int degraded = 0;                           // number of steps
    std::string degraded_because;               // of the first of them
};

// Requires at least one frame.
DragSummary summary_of(const HandPlay& played);

}  // namespace hepatica
