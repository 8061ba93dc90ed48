// SPDX-License-Identifier: GPL-3.0-or-later
// Anti-aliased lines and circles drawn over a finished picture, to point something out in a figure.
// Depends on no toolkit.
#pragma once

#include <array>
#include <span>

#include "core/base/vector.h"
#include "render/palette.h"
#include "render/picture.h"

namespace hepatica {

// Positions are pixels from the upper left corner, x to the right and y down; parts outside of the
// picture are left out. Widths are in pixels, > 0. Costs one visit of each pixel in the bounding
// boxes of the segments.
void draw_line(Picture& picture, std::span<const std::array<double, 2>> points, double width,
               const Colour& colour);
void draw_circle(Picture& picture, const std::array<double, 2>& centre, double radius, double width,
                 const Colour& colour);

}  // namespace hepatica
