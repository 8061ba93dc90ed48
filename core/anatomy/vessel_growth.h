// SPDX-License-Identifier: GPL-3.0-or-later
// Hysteresis and the labels of vascular systems: growth through whatever is connected.
#pragma once

#include <cstddef>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// The 26-connected pieces of `weak` that hold at least one voxel of `strong` and at least
// minimum_mm3 of volume. Same grid for both.
Mask hysteresis(const Mask& strong, const Mask& weak, double minimum_mm3);

}  // namespace hepatica
