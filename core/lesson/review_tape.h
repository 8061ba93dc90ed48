// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of a play, kept so that any moment of it can be shown at once, within a bound of
// memory: where they get too many, every second one is let go of and the later ones are kept half
// as often. Filled by one thread while others look at it.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "core/lesson/play_events.h"
#include "core/scene/frame.h"

namespace hepatica {

// Thread-safe.
class ReviewTape {
  public:
    // A frame takes 12 bytes a vertex and more where it shows a tear. 256 MB hold 2,700 frames of
    // 8,200 vertices, as the built-in patient has: three quarters of a minute at 60 a second.
    explicit ReviewTape(std::size_t most_bytes = std::size_t{256} << 20);

    // The next frame, not earlier than the one before. Of frames of one time (the clock was held)
    // the last stays.
    void add(double at_s, Frame frame);
    void note(PlayEvent event);

    // The newest kept frame that is not later; the first where there is none. Null while empty.
    std::shared_ptr<const Frame> at(double at_s) const;
    // When the newest frame was, 0 while empty.
    double end_s() const;
    // In the order of time.
    std::vector<PlayEvent> events() const;
    // How many frames are kept, and of how many frames one.
    std::size_t size() const;
    std::size_t stride() const;

  private:
    struct Kept {
        double at_s = 0.0;
        std::size_t number = 0;  // among all frames, from 0
        std::shared_ptr<const Frame> frame;
    };
    bool stays(const Kept& one) const { return one.number % stride_ == 0; }
    void keep_half();

    mutable std::mutex mutex_;  // guards all below
    std::size_t most_bytes_;
    std::size_t bytes_ = 0;
    std::size_t stride_ = 1;
    std::size_t frames_ = 0;  // that came, at different times
    std::vector<Kept> kept_;
    std::vector<PlayEvent> events_;
};

}  // namespace hepatica
