// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps what a hand still does as a play ends, such as the rest of a series of notches of the
// wheel, from doing something else than it was meant for. Time is that of the events
// themselves.
#pragma once

#include <cstdint>

namespace hepatica {

class CalmAfterPlay {
  public:
    static constexpr std::uint64_t lasts_ms = 500;  // after the last event of a series

    void play_ended() { ended_ = true; }
    // A press is meant for what is seen, however soon it comes.
    void pressed() { ended_ = false; }
    // Call with the time of each other event. Returns whether it is to have no effect: it belongs
    // to a series that began before the end of the play, each less than lasts_ms after the one
    // before. Events without a time (0) always have their effect.
    bool swallows(std::uint64_t at_ms);

  private:
    bool ended_ = false;  // and the calm is not over
    std::uint64_t last_ms_ = 0;
};

inline bool CalmAfterPlay::swallows(std::uint64_t at_ms) {
    if (at_ms == 0) return false;
    const bool follows = at_ms < last_ms_ + lasts_ms;
    last_ms_ = at_ms;
    ended_ = ended_ && follows;
    return ended_;
}

}  // namespace hepatica
