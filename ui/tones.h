// SPDX-License-Identifier: GPL-3.0-or-later
// Short tones for what happens in a play, for eyes that are on the vessels: before something tears,
// when it tears or bleeds, when a lesson's step is reached, and at the verdict.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/lesson/play_events.h"

namespace hepatica {

enum class Tone { warning, harm, reached, passed, not_passed };

inline constexpr int tone_rate_hz = 44100;

// One channel at tone_rate_hz, at most a third of a second. Tones begin and end softly and never
// exceed a quarter of the range.
std::vector<std::int16_t> samples_of(Tone tone);

// The tone of the gravest of these events; nullopt if none of them has one.
std::optional<Tone> tone_of(std::span<const PlayEvent> events, LessonOutcome outcome);

}  // namespace hepatica
