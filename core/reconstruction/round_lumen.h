// SPDX-License-Identifier: GPL-3.0-or-later
// Thin vessels drawn anew as round tubes: where a lumen is a few voxels wide its outline is mostly
// noise, but its centreline and radius, fitted to the image along the whole branch, are not.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// The vessels (0 or 1) with every voxel that belongs to a part of the tree with a radius below
// thin_radius_mm decided by that part's tube: inside where the voxel's centre is no further from
// the centreline than the radius. A voxel belongs to the part whose wall it is nearest to; wide
// parts, and what is further than 2 mm outside every tube, stay as they are. The tree lies in the
// mask's space, radii in mm. Same bytes for any number of threads. Throws Cancelled.
Mask round_thin_lumens(const Mask& vessels, const VesselTree& tree, double thin_radius_mm,
                       Job& job);

}  // namespace hepatica
