// SPDX-License-Identifier: GPL-3.0-or-later
// How different two pictures look: tolerant of a pixel's shift along edges and of rounding between
// drivers, strict about anything that a person would see.
#pragma once

#include "render/picture.h"

namespace hepatica {

struct PictureDifference {
    bool same_size = false;
    double mean = 0.0;             // mean difference per channel, of 255
    double different_share = 0.0;  // share of pixels that differ visibly from all 9 neighbours
};

// A pixel differs visibly where every pixel in the 3 x 3 around its place in the other picture is
// more than `tolerance` (of 255, in the largest channel) away from it, in either direction.
PictureDifference compare_pictures(const Picture& a, const Picture& b, int tolerance = 24);

}  // namespace hepatica
