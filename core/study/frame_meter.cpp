// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/frame_meter.h"

#include <algorithm>
#include <chrono>

namespace hepatica {
namespace {

constexpr double frame_s = 1.0 / 60.0;

}  // namespace

void FrameMeter::step(Stepper& stepper, int parts, const Job& job) {
    const auto start = std::chrono::steady_clock::now();
    for (int part = 0; part < parts; ++part) {
        job.throw_if_cancelled();
        iterations_ += stepper.step(frame_s / parts).linear_iterations;
    }
    frame_ms_.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count());
}

void FrameMeter::book(TradeoffPoint& point) const {
    std::vector<double> sorted = frame_ms_;
    std::ranges::nth_element(sorted, sorted.begin() + sorted.size() / 2);
    point.frame_ms = sorted[sorted.size() / 2];
    point.step_ms = point.frame_ms / point.options.substeps;
    point.dt_s = frame_s / point.options.substeps;
    point.iterations = iterations_ / (static_cast<double>(frames()) * point.options.substeps);
}

}  // namespace hepatica
