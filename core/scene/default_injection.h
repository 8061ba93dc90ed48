// SPDX-License-Identifier: GPL-3.0-or-later
// The default injection of the window, of scripts, and of `play`, `render` and `inject`: a
// water-soluble carrier, which flows like blood.
#pragma once

namespace hepatica::default_injection {

inline constexpr double mass_flow_g_s = 2.0;
inline constexpr double void_fraction = 0.0;  // of the second phase
inline constexpr const char* second_phase = "carrier";
inline constexpr const char* pressure_model = "regime";

}  // namespace hepatica::default_injection
