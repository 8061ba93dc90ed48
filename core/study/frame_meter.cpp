// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/frame_meter.h"

#include "core/base/frame_time.h"

namespace hepatica {

void FrameMeter::step(Stepper& stepper, int parts, const Job& job) {
    const FrameTimer timer;
    for (int part = 0; part < parts; ++part) {
        job.throw_if_cancelled();
        iterations_ += stepper.step(frame_s / parts, job.stop_token()).linear_iterations;
    }
    const FrameTime time = timer.passed();
    last_wall_ms_ = time.wall_ms;
    // While a device computes, the processor is idle, so its time says nothing.
    frame_ms_.push_back(stepper.on_device() ? time.wall_ms : time.cost_ms());
}

void FrameMeter::book(TradeoffPoint& point) const {
    point.frame_ms = quantile(frame_ms_, 0.95);
    point.step_ms = point.frame_ms / point.options.substeps;
    point.dt_s = frame_s / point.options.substeps;
    point.iterations = iterations_ / (static_cast<double>(frames()) * point.options.substeps);
}

bool let_fall_asleep(Stepper& stepper, int most_frames, const BudgetClock& clock, const Job& job) {
    for (int f = 0; f < most_frames; ++f) {
        job.throw_if_cancelled();
        if (clock.left_s() <= 0.0) return false;
        if (stepper.step(frame_s, job.stop_token()).asleep) break;
    }
    return true;
}

}  // namespace hepatica
