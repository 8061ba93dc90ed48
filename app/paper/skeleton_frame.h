// SPDX-License-Identifier: GPL-3.0-or-later
// The unit-width skeleton for display: one bead for each of its voxels.
#pragma once

#include <vector>

#include "core/image/volume.h"
#include "core/scene/frame.h"

namespace hepatica {

struct SkeletonFrame {
    Frame frame;
    std::vector<Vec3> vertices_mm;  // of the frame
    int voxels = 0;
};

// An octahedron, slightly larger than a voxel so that neighbours touch, at each voxel that is not
// 0.
SkeletonFrame frame_of_skeleton(const Mask& skeleton);

}  // namespace hepatica
