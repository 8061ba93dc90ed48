// SPDX-License-Identifier: GPL-3.0-or-later
// Draws thin vessels anew as round tubes: the outline of a lumen a few voxels wide is mostly noise,
// but its centreline and radius, fitted to the image along the whole branch, are not.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// Returns the vessels (0 or 1) with thin parts redrawn. A voxel belongs to the part of the tree
// whose wall is nearest; where the radius there is below thin_radius_mm, the voxel becomes 1 inside
// the tube and 0 outside. Wide parts, and voxels farther than 2 mm outside every tube, stay as they
// are. The tree lies in the mask's space. The same for any number of threads. Throws Cancelled.
Mask round_thin_lumens(const Mask& vessels, const VesselTree& tree, double thin_radius_mm,
                       Job& job);

}  // namespace hepatica
