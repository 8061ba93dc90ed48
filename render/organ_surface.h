// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of an organ, or of tumours, from their voxels, to be looked at: an organ's is
// smoothed by two millimetres, which takes the steps between slices away, and no finer than that.
// It is no measure of the organ.
#pragma once

#include <cstdint>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {

// The closed surface, in mm, of the voxels that hold `label`, triangles counter-clockwise from
// outside; empty where none does. Where the organ reaches the edge of the grid it is closed there.
// Any thread. Costs some 0.2 s for the liver of a CT. Throws Cancelled.
TriangleMesh organ_surface(const Mask& organs, std::uint8_t label, Job& job);

// The same of every voxel that is not 0, each piece by itself: smoothed by 0.8 mm and no finer than
// one, as tumours are small; what would vanish by that has the surface of its voxels.
TriangleMesh tumour_surface(const Mask& tumours, Job& job);

}  // namespace hepatica
