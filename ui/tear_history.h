// SPDX-License-Identifier: GPL-3.0-or-later
// What the frames of a play have shown of tearing so far: entropy over time, and when something
// happened. No toolkit.
#pragma once

#include <string>
#include <vector>

#include "core/scene/frame.h"
#include "render/chart.h"

namespace hepatica {

class TearHistory {
  public:
    struct Event {
        double time_s = 0.0;  // since the vessels may tear, as in the chart
        std::string text;
    };

    // Takes over a frame; true where the chart is another now. A frame in which nothing can tear
    // forgets everything, one of an earlier time what came after it.
    bool follow(const Frame& frame);
    void clear();

    bool empty() const { return time_s_.empty(); }
    // Entropy, and what of it was produced since the first split, in nats.
    Chart chart() const;
    const std::vector<Event>& events() const { return events_; }

    // Beyond that every second point is left out.
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
