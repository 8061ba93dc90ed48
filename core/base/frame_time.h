// SPDX-License-Identifier: GPL-3.0-or-later
// The time between two pictures on a screen of 60 Hz: the step of a play, unless a scene says
// otherwise.
#pragma once

namespace hepatica {

inline constexpr double frame_s = 1.0 / 60.0;

}  // namespace hepatica
