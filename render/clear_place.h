// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a label in the plane of the picture leaves room for what must stay visible: a tool's
// parts and its arrow, drawn as thick stretches.
#pragma once

#include <array>
#include <span>

#include "render/legend_rows.h"

namespace hepatica {

// What lies within `radius` of the line between the two points, in pixels from the lower left
// corner of the picture.
struct ThickStretch {
    std::array<double, 2> from{}, to{};
    double radius = 0.0;
};

// From a rectangle and what is inside it to the line between the stretch's ends; 0 where they meet.
double distance_between(const PictureBox& box, const ThickStretch& stretch);

// A stretch that covers the rectangle, such as a label that another one must not lie on.
ThickStretch covering(const PictureBox& box);

// Whether at least `margin` is left between the rectangle and each of the stretches.
bool is_clear_of(const PictureBox& box, std::span<const ThickStretch> stretches, double margin);

}  // namespace hepatica
