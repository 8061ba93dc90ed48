// SPDX-License-Identifier: GPL-3.0-or-later
// History of tearing in the frames of a play: entropy over time, and events. No widgets; not
// thread-safe.
#pragma once

#include <string>
#include <vector>

#include "core/scene/frame.h"
#include "render/chart.h"

namespace hepatica {

class TearHistory {
  public:
    struct Event {
        double time_s = 0.0;  // since tearing was enabled, as in the chart
        std::string text;
    };

    // Adds a frame; returns whether the chart has changed. A frame without tearing clears
    // everything; one of an earlier time removes what came after it.
    bool follow(const Frame& frame);
    // Forgets all points and events.
    void clear();

    bool empty() const { return time_s_.empty(); }
    // Entropy, and the part produced since the first split, in nats.
    Chart chart() const;
    const std::vector<Event>& events() const { return events_; }

    // Above this number every second point is dropped.
    static constexpr std::size_t most_points = 2000;

  private:
    void note_events(double time_s, const TearView& now);
    void forget_after(double time_s);

    double begin_s_ = 0.0;
    std::vector<double> time_s_, entropy_, produced_;
    std::vector<Event> events_;
    TearView last_;
};

}  // namespace hepatica
