// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and circles drawn over a finished picture, with smooth edges: what a figure points at. No
// toolkit.
#pragma once

#include <array>
#include <span>

#include "core/base/vector.h"
#include "render/palette.h"
#include "render/picture.h"

namespace hepatica {

// Places are pixels from the upper left corner, x to the right and y down; what lies outside of the
// picture is left out. Widths in pixels, > 0. Costs the pixels of the lines' boxes.
void draw_line(Picture& picture, std::span<const std::array<double, 2>> points, double width,
               const Colour& colour);
void draw_circle(Picture& picture, const std::array<double, 2>& centre, double radius, double width,
                 const Colour& colour);

}  // namespace hepatica
