// SPDX-License-Identifier: GPL-3.0-or-later
// The lobes of a region: basins of its depth below the surface, separated at their necks, as
// touching organs form them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct Lobe {
    double depth_mm = 0.0;  // of its deepest voxel, below the surface
    double neck_mm = 0.0;   // depth of the widest neck to its parent; 0 without one
    int parent = -1;        // -1 for the deepest lobe and for lobes not connected with it
    std::size_t voxels = 0;
    Vec3 centre_mm = Vec3::Zero();  // mean of its voxels
};

struct Lobes {
    Image<std::uint32_t> labels;  // 0 outside the region, else number of the lobe + 1
    std::vector<Lobe> lobes;
};

// Two basins are separate lobes where the depth of the neck between them is at least 2 mm less than
// that of the shallower one, and at most 0.9 of it. The border of the image is not a surface of the
// region. Throws Cancelled.
Lobes lobes_of(const Mask& region, Job& job);

}  // namespace hepatica
