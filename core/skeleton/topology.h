// SPDX-License-Identifier: GPL-3.0-or-later
// Betti numbers of a mask, which thinning must preserve. Counted by components and the Euler number
// of the union of closed voxels, independently of the thinning code that they check.
#pragma once

#include "core/image/volume.h"

namespace hepatica {

struct Betti {
    long long components = 0;  // b0: 26-connected components of the object
    long long tunnels = 0;     // b1 = b0 + b2 - chi
    long long cavities = 0;    // b2: 6-connected components of the background, minus the outer one

    bool operator==(const Betti&) const = default;
};

// The space outside the grid is background. Any nonzero voxel is object. Thread-safe. Cost: linear
// in the grid.
Betti betti_numbers(const Mask& mask);

}  // namespace hepatica
