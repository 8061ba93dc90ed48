// SPDX-License-Identifier: GPL-3.0-or-later
// All colours of the three-dimensional view: background, vessels by system, and the drug's colour
// map, whose lightness rises monotonically, so that colour-blind readers see the same order.
#pragma once

#include <array>
#include <string>

#include "core/base/vascular_system.h"

namespace hepatica {

// Red, green, blue in [0, 1], sRGB.
using Colour = std::array<double, 3>;

namespace palette {

inline constexpr Colour background_top{0.110, 0.129, 0.157};
inline constexpr Colour background_bottom{0.043, 0.051, 0.066};
inline constexpr Colour distance{0.055, 0.066, 0.085};
inline constexpr Colour liver{0.62, 0.36, 0.31};
inline constexpr Colour tumour{0.55, 0.89, 0.50};  // no vessel, mark or drug has a similar green
inline constexpr Colour grab_line{0.30, 0.95, 0.85};
inline constexpr Colour rim{0.02, 0.03, 0.05};      // dark, about a line over any colours
inline constexpr Colour outline{0.13, 0.15, 0.18};  // outline of bright things on white paper
inline constexpr Colour tool{0.74, 0.77, 0.80};
inline constexpr Colour tool_rim{0.96, 0.98, 1.0};      // about a tool, seen through vessels
inline constexpr Colour torn{0.45, 0.00, 0.35};         // the rim of a tear: wine, no red of blood
inline constexpr Colour torn_inside{0.93, 0.58, 0.52};  // what was inside: flesh, inside that rim
inline constexpr Colour touch = grab_line;              // what a tool touches, and its force
inline constexpr Colour bridge{0.98, 0.74, 0.30};
inline constexpr Colour measure{1.0, 0.84, 0.35};     // measurements
inline constexpr Colour bent_axis{0.95, 0.16, 0.14};  // the red line of the paper's Fig. 3
inline constexpr Colour bleeding{0.72, 0.05, 0.07};   // blood from torn vessels
inline constexpr Colour torn_circle{
    1.00, 0.87, 0.10};  // the yellow circle of the paper's Fig. 3; marks of lessons
inline constexpr Colour reached{0.10, 0.72, 0.42};  // a mark that is done
inline constexpr Colour text{0.88, 0.90, 0.92};
inline constexpr Colour faint_text{0.58, 0.62, 0.67};

// `from` at share 0, `to` at share 1, linear between them in each channel.
Colour mixed(const Colour& from, const Colour& to, double share);

// Contrast ratio of the two, 1 to 21, as WCAG 2.1 defines it: 3 lets a shape be seen, 4.5 a text be
// read.
double contrast(const Colour& one, const Colour& other);

// Colour of a vascular system: portal vein blue-violet, hepatic veins blue, arteries red, unknown
// bluish grey. `bright`: the same hues with a contrast of at least 7 : 1 to black.
Colour vessel_system(VascularSystem system, bool bright = false);

// Colours that a vessel has instead of its system's, distinct for normal and for colour-blind eyes
// from each other, the systems, the drug and its white front, marks and warnings
// (palette_test.cpp). `bright`: beside the bright colours of the systems.
// What a lesson wants the drug in, and that with a highlight over it.
Colour drug_target(bool bright = false);
Colour lit_drug_target(bool bright = false);
// What an injection before the present one has reached.
Colour reached_before(bool bright = false);
// A highlight: what lies downstream of the pointer.
Colour highlight(bool bright = false);

// The branch that is chosen in a table: yellow, which no system has.
Colour chosen_branch(bool bright = false);

// Colour of the branches to one of Couinaud's segments, 1 to 8; values outside are clamped.
Colour liver_segment(int segment);

// Colour of a vessel under `load`, the ratio of its load to the load at which it tears: its own
// colour below 0.5, then towards yellow, and red at 1 and beyond.
Colour warning(const Colour& vessel, double load);

// Colour of a vessel that is stretched by this factor (SurfaceStretch): grey at 1 and below, pink
// at largest_stretch and beyond, lighter with every stretch, along its logarithm.
inline constexpr double largest_stretch = 1.6;
Colour stretch(double factor, bool bright = false);

// Of a cut line that has not torn yet.
Colour weak_line();

// Colour of the drug at `fraction` in [0, 1] of the map; values outside are clamped.
Colour drug(double fraction);

// Source of a GLSL function `vec3 drugColour(float fraction)` that equals drug().
std::string drug_glsl();

}  // namespace palette
}  // namespace hepatica
