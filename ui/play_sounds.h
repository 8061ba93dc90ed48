// SPDX-License-Identifier: GPL-3.0-or-later
// Follows the play that is shown and sounds its tones (tones.h). Off at first: nothing is then
// followed, and no sound device is opened. UI thread only.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "core/lesson/play_events.h"
#include "core/scene/frame.h"
#include "ui/tones.h"

namespace hepatica {

class PlaySounds {
  public:
    // `sound` plays a tone at once and returns.
    explicit PlaySounds(std::function<void(Tone)> sound) : sound_(std::move(sound)) {}

    void set_on(bool on);
    bool on() const { return on_; }
    // Another play is shown from now on; what it has behind it is not sounded.
    void begin() { events_.reset(); }
    // To be called with each frame that is shown, in order. `standing`: of the lesson after this
    // frame; null if none is played.
    void follow(const Frame& frame, const LessonStanding* standing);

  private:
    std::function<void(Tone)> sound_;
    std::optional<PlayEvents> events_;  // of this play, once its first frame was seen
    bool on_ = false;
};

}  // namespace hepatica
