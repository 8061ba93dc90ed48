// SPDX-License-Identifier: GPL-3.0-or-later
// The lobes of a region: the basins of its depth, parted at their necks, as several organs that
// touch form them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct Lobe {
    double depth_mm = 0.0;  // of its deepest voxel below the surface
    double neck_mm = 0.0;   // the depth of the widest way to its parent; 0 without one
    int parent = -1;        // the lobe it hangs on; -1 of the deepest, and of other pieces
    std::size_t voxels = 0;
    Vec3 centre_mm = Vec3::Zero();  // of its voxels
};

struct Lobes {
    Image<std::uint32_t> labels;  // 0 outside of the region, else number of the lobe + 1
    std::vector<Lobe> lobes;
};

// A basin is a lobe of its own where its neck is at least 2 mm less deep than it is, and at most
// 0.9 of that. Outside of the image the region goes on. Throws Cancelled.
Lobes lobes_of(const Mask& region, Job& job);

}  // namespace hepatica
