// SPDX-License-Identifier: GPL-3.0-or-later
// The section at which an object is cut off, for example where a vessel leaves the region under
// study.
#pragma once

#include <optional>

#include "core/image/volume.h"

namespace hepatica {

struct Section {
    // Mean of the centres of its voxels.
    Vec3 middle_mm = Vec3::Zero();
    double area_mm2 = 0.0;  // approximate: number of voxels times their mean face
};

// The largest 26-connected patch of voxels of `object` that share a face with a voxel of `beyond`.
// Both masks lie on one grid; a voxel of both counts as object. None if they do not touch.
std::optional<Section> largest_section(const Mask& object, const Mask& beyond);

}  // namespace hepatica
