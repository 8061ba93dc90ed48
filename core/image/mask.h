// SPDX-License-Identifier: GPL-3.0-or-later
// The object voxels of a mask, counted and exchanged for the others.
#pragma once

#include <cstddef>

#include "core/image/volume.h"

namespace hepatica {

// The number of voxels that are not 0.
std::size_t object_count(const Mask& mask);

// 1 where the mask is 0, 0 elsewhere.
Mask complement(const Mask& mask);

}  // namespace hepatica
