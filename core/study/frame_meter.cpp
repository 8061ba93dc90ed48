// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/frame_meter.h"

#include <algorithm>
#include <chrono>
#include <ctime>

#include "core/base/median.h"

namespace hepatica {
namespace {

constexpr double frame_s = 1.0 / 60.0;

// Of all threads of this program.
double processor_ms() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

void FrameMeter::step(Stepper& stepper, int parts, const Job& job) {
    const auto start = std::chrono::steady_clock::now();
    const double processor_start_ms = processor_ms();
    for (int part = 0; part < parts; ++part) {
        job.throw_if_cancelled();
        iterations_ += stepper.step(frame_s / parts).linear_iterations;
    }
    last_wall_ms_ =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    frame_ms_.push_back(std::min(last_wall_ms_, processor_ms() - processor_start_ms));
}

void FrameMeter::book(TradeoffPoint& point) const {
    point.frame_ms = median(frame_ms_);
    point.step_ms = point.frame_ms / point.options.substeps;
    point.dt_s = frame_s / point.options.substeps;
    point.iterations = iterations_ / (static_cast<double>(frames()) * point.options.substeps);
}

}  // namespace hepatica
