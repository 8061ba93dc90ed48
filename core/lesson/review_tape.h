// SPDX-License-Identifier: GPL-3.0-or-later
// Frames and events of a play within a memory limit, for immediate display of any moment. When the
// limit is reached, every second frame is dropped and later ones are kept half as often. One thread
// fills the tape while others read it.
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
    // A frame takes 12 bytes per vertex, more if torn. 256 MB hold 2,700 frames of 8,200 vertices
    // (the built-in patient): 45 s at 60 frames per second.
    explicit ReviewTape(std::size_t most_bytes = std::size_t{256} << 20);

    // Adds the next frame; `at_s` must not decrease. Of frames with equal time (paused) the last is
    // kept.
    void add(double at_s, Frame frame);
    void note(PlayEvent event);

    // The last kept frame at or before `at_s`; the first if there is none. Null while empty.
    std::shared_ptr<const Frame> at(double at_s) const;
    // Time of the newest frame; 0 while empty.
    double end_s() const;
    // Sorted by time.
    std::vector<PlayEvent> events() const;
    // Number of frames kept: every frame, or evenly one of 2, 4, 8 and so on, and the newest.
    std::size_t size() const;

  private:
    struct Kept {
        double at_s = 0.0;
        std::size_t number = 0;  // among all frames, from 0
        std::shared_ptr<const Frame> frame;
    };
    bool stays(const Kept& one) const { return one.number % stride_ == 0; }
    void keep_half();

    mutable std::mutex mutex_;  // guards all members below
    std::size_t most_bytes_;
    std::size_t bytes_ = 0;
    std::size_t stride_ = 1;
    std::size_t frames_ = 0;  // frames added with distinct times
    std::vector<Kept> kept_;
    std::vector<PlayEvent> events_;
};

}  // namespace hepatica
