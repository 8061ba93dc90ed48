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
    // quarter of the smallest spacing.
    double at(const Index3& voxel);

  private:
    struct Offset {
        double distance_mm;
        int x, y, z;
    };

    void look_further();

    const Mask& mask_;
    double reach_mm_;
    std::vector<Offset> offsets_;  // by distance, all within reach_mm_
};

}  // namespace hepatica
