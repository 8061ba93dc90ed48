// SPDX-License-Identifier: GPL-3.0-or-later
// The unit-width skeleton as a picture shows it: a bead for each of its voxels.
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

// An octahedron a little larger than a voxel at each that is not 0, so that neighbours touch.
SkeletonFrame frame_of_skeleton(const Mask& skeleton);

}  // namespace hepatica
