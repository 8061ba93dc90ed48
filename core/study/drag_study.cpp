// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drag_study.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <vector>

#include "core/base/frame_time.h"

namespace hepatica {
namespace {

using Frames = std::vector<const HandFrame*>;

std::vector<double> values_of(const Frames& frames,
                              const std::function<double(const HandFrame&)>& value) {
    std::vector<double> values;
    values.reserve(frames.size());
    for (const HandFrame* frame : frames) values.push_back(value(*frame));
    return values;
}

DragQuantiles quantiles_of(const std::vector<double>& values) {
    return {quantile(values, 0.5), quantile(values, 0.95), quantile(values, 0.99),
            quantile(values, 1.0)};
}

}  // namespace

DragSummary summary_of(const HandPlay& played) {
    assert(!played.frames.empty());
    DragSummary summary;
    Frames frames, awake;
    for (const HandFrame& frame : played.frames) {
        frames.push_back(&frame);
        if (!frame.asleep) awake.push_back(&frame);
        if (frame.degraded && summary.degraded++ == 0) summary.degraded_because = frame.message;
    }
    summary.steps = static_cast<int>(frames.size());
    summary.asleep = static_cast<int>(frames.size() - awake.size());
    if (!awake.empty()) frames = awake;
    const auto cost = values_of(frames, [](const HandFrame& f) { return f.time.cost_ms(); });
    summary.frame_ms = quantiles_of(cost);
    summary.wall_ms =
        quantiles_of(values_of(frames, [](const HandFrame& f) { return f.time.wall_ms; }));
    for (const HandFrame* frame : frames)
        summary.longest_wait_ms = std::max(summary.longest_wait_ms, frame->longest_wait_ms);
    const auto in_time =
        std::ranges::count_if(cost, [](double ms) { return ms <= frame_length_ms; });
    summary.frames_in_time = static_cast<double>(in_time) / static_cast<double>(cost.size());
    const DragQuantiles solves =
        quantiles_of(values_of(frames, [](const HandFrame& f) { return f.linear_solves; }));
    const DragQuantiles iterations =
        quantiles_of(values_of(frames, [](const HandFrame& f) { return f.linear_iterations; }));
    const DragQuantiles live = quantiles_of(values_of(frames, [&](const HandFrame& f) {
        return static_cast<double>(f.live_elements) / played.elements;
    }));
    summary.solves_median = static_cast<int>(solves.median);
    summary.solves_most = static_cast<int>(solves.longest);
    summary.iterations_median = static_cast<int>(iterations.median);
    summary.iterations_most = static_cast<int>(iterations.longest);
    summary.live_median = live.median;
    summary.live_most = live.longest;
    return summary;
}

}  // namespace hepatica
