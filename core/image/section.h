// SPDX-License-Identifier: GPL-3.0-or-later
// Where an object is cut off: the section at which a vessel leaves the region that is looked at.
#pragma once

#include <optional>

#include "core/image/volume.h"

namespace hepatica {

struct Section {
    Vec3 middle_mm = Vec3::Zero();
    double area_mm2 = 0.0;  // about: its voxels' number times their mean face
};

// The largest 26-connected patch of voxels of `object` that have a face in common with one of
// `beyond`; both on one grid, and a voxel of both counts as object. None where they do not meet.
std::optional<Section> largest_section(const Mask& object, const Mask& beyond);

}  // namespace hepatica
