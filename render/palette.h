// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of the three-dimensional view in one place: background, vessels by system, and the
// drug's map, whose lightness rises monotonically, so that colour-blind readers see the same order.
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
inline constexpr Colour tumour{0.55, 0.89, 0.50};  // no vessel, mark or drug is as green
inline constexpr Colour grab_line{0.30, 0.95, 0.85};
inline constexpr Colour rim{0.02, 0.03, 0.05};      // dark, about a line over whatever colours
inline constexpr Colour outline{0.13, 0.15, 0.18};  // of what is bright, on paper
inline constexpr Colour tool{0.74, 0.77, 0.80};
inline constexpr Colour torn{0.62, 0.10, 0.12};  // the rim of a tear
inline constexpr Colour touch = grab_line;       // what a tool touches, and what it feels
inline constexpr Colour bridge{0.98, 0.74, 0.30};
inline constexpr Colour measure{1.0, 0.84, 0.35};       // what was measured
inline constexpr Colour bent_axis{0.95, 0.16, 0.14};    // the red line of the paper's Fig. 3
inline constexpr Colour bleeding{0.72, 0.05, 0.07};     // blood out of torn vessels
inline constexpr Colour torn_circle{1.00, 0.87, 0.10};  // its yellow circle
inline constexpr Colour reached{0.10, 0.72, 0.42};      // a mark that is done with
inline constexpr Colour text{0.88, 0.90, 0.92};
inline constexpr Colour faint_text{0.58, 0.62, 0.67};

// The vessel's own colour: portal vein blue-violet, hepatic veins blue, artery red; a vessel of an
// unknown system is a bluish grey.
Colour vessel_system(VascularSystem system);

// Of the branches to one of Couinaud's segments, 1 to 8.
Colour liver_segment(int segment);

// Of a vessel that is loaded to this share of what it bears: its own colour up to a half, then
// yellow, and red at 1 and beyond.
Colour warning(const Colour& vessel, double load);

// The drug's colour at `fraction` in [0, 1] of the map; values outside are clamped.
Colour drug(double fraction);

// GLSL function `vec3 drugColour(float fraction)` that equals drug() above.
std::string drug_glsl();

}  // namespace palette
}  // namespace hepatica
