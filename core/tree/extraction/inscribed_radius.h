// SPDX-License-Identifier: GPL-3.0-or-later
// Distance from single voxels of a mask to the nearest background, by searching outwards: much
// cheaper than a distance map of the volume when only skeleton voxels are needed.
#pragma once

#include <vector>

#include "core/image/volume.h"

namespace hepatica {

// Not thread-safe.
class InscribedRadius {
  public:
    // Keeps a reference to the mask.
    explicit InscribedRadius(const Mask& mask);

    // Distance in mm from a voxel's centre to the mask's surface, which is taken half a voxel
    // before the centre of the nearest background voxel. The space outside the grid is background.
    // At least a quarter of the smallest spacing. Cheapest for a voxel near the previous one.
    double at(const Index3& voxel);

  private:
    struct Offset {
        double distance_mm;
        int x, y, z;
    };

    void look_further();

    const Mask& mask_;
    Index3 last_voxel_{0, 0, 0};
    double last_distance_mm_ = 0.0;  // from the last voxel to the nearest background
    double reach_mm_;
    std::vector<Offset> offsets_;  // by distance, all within reach_mm_
};

}  // namespace hepatica
