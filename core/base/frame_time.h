// SPDX-License-Identifier: GPL-3.0-or-later
// The time between two pictures on a 60 Hz screen: the default time step of a simulation.
#pragma once

namespace hepatica {

inline constexpr double frame_s = 1.0 / 60.0;
inline constexpr double frame_length_ms = 1000.0 / 60.0;

}  // namespace hepatica
