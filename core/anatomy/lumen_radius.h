// SPDX-License-Identifier: GPL-3.0-or-later
// Radii of the lumen below the size of a voxel, from cross-sections of the mask.
#pragma once

#include <vector>

#include "core/anatomy/centreline.h"
#include "core/image/volume.h"

namespace hepatica {

// What a cross-section of the mask looks like from a point inside it.
struct CrossSection {
    double radius_mm = 0.0;         // of the circle with the same area
    Vec3 offset_mm = Vec3::Zero();  // from the point to the area's centroid
    double roundness = 1.0;         // shortest over longest ray; low near junctions
};

// Cuts the mask's half-value surface (trilinear) across `direction` at a point, along rays of at
// most `reach_mm`. The radius is 0 where the point itself lies outside.
CrossSection mask_cross_section(const Mask& mask, const Vec3& point_mm, const Vec3& direction,
                                double reach_mm);

}  // namespace hepatica
