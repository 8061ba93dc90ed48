// SPDX-License-Identifier: GPL-3.0-or-later
// The units of the whole program: millimetre, gram, second. Pressure and stress are then exactly in
// pascal (1 g/(mm s2) = 1 Pa), viscosity in Pa s = g/(mm s), density in g/mm3, volume flow in
// mm3/s, mass flow in g/s and force in micronewton (g mm/s2).
#pragma once

namespace hepatica::units {

inline constexpr double kilogram_per_cubic_metre = 1e-6;        // in g/mm3
inline constexpr double millilitre = 1e3;                       // in mm3
inline constexpr double millilitre_per_minute = 1e3 / 60.0;     // in mm3/s
inline constexpr double newton = 1e6;                           // in micronewton
inline constexpr double standard_gravity = 9806.65;             // in mm/s2
inline constexpr double millimetre_of_mercury = 133.322387415;  // in Pa

}  // namespace hepatica::units
