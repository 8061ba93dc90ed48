// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/play_sounds.h"

namespace hepatica {

void PlaySounds::set_on(bool on) {
    on_ = on;
    begin();
}

void PlaySounds::follow(const Frame& frame, const LessonStanding* standing) {
    if (!on_) return;
    const bool first = !events_;
    if (first) events_.emplace();
    const auto events = events_->see(frame.time_s, {}, frame, standing);
    if (first) return;
    const LessonOutcome outcome = standing ? standing->outcome : LessonOutcome::running;
    if (const auto tone = tone_of(events, outcome)) sound_(*tone);
}

}  // namespace hepatica
