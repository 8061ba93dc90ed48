// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures compared with baselines: whatever a person would see must be noticed, be it as small as
// the line of a pull; another driver's smoothing of edges must not.
#pragma once

#include <string>

#include "render/picture.h"

namespace hepatica::testing {

// The difference of two pictures in the tile of 16 x 16 pixels where it is largest, mean of 255, by
// vtkImageDifference: a pixel may be shifted by up to two each way, and differences up to 8 do not
// count. 255 where the sizes differ. A mean over the whole picture would hide what is small.
double worst_tile_difference(const Picture& a, const Picture& b);

// Edges that are smoothed otherwise come to 1, the smallest mark of a picture that is left out to
// about 2, and most marks to 5 and more (scene_elements_test.cpp).
inline constexpr double unnoticed_difference = 1.5;
bool look_alike(const Picture& a, const Picture& b);

// Fails, and leaves the picture in NAME_differs.png, unless it looks like the baseline of this
// name. With HEPATICA_UPDATE_BASELINES in the environment it writes the baseline instead.
void expect_matches_baseline(const Picture& picture, const std::string& name);

}  // namespace hepatica::testing
