// SPDX-License-Identifier: GPL-3.0-or-later
// Distance from single voxels of a mask to the nearest background, found by looking outwards: far
// cheaper than a distance map of the whole volume when only the voxels of a skeleton are asked.
#pragma once

#include <vector>

#include "core/image/volume.h"

namespace hepatica {

class InscribedRadius {
  public:
    // Keeps a reference to the mask.
    explicit InscribedRadius(const Mask& mask);

    // Distance in mm from a voxel's centre to the mask's surface, taken half a voxel before the
    // nearest background voxel's centre. The space outside the grid is background. At least a
    // quarter of the smallest spacing. Cheapest where a voxel lies near the one asked before.
    double at(const Index3& voxel);

  private:
    struct Offset {
        double distance_mm;
        int x, y, z;
    };

    void look_further();

    const Mask& mask_;
    Index3 last_voxel_{0, 0, 0};
    double last_distance_mm_ = 0.0;  // from the voxel asked last to the nearest background
    double reach_mm_;
    std::vector<Offset> offsets_;  // by distance, all within reach_mm_
};

}  // namespace hepatica
