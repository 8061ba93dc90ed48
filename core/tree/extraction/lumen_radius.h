// SPDX-License-Identifier: GPL-3.0-or-later
// Cross-sections of a vessel along its centreline, for radii below the size of a voxel.
//
// On a CT, the area of a section is its excess of intensity over the parenchyma divided by the
// contrast of wide vessels nearby in the tree: the area of a blood-filled disc that explains it.
// Blurring moves intensity but keeps its sum, so this needs no threshold and no model of the
// scanner. Without a CT the area is that of the mask's section.
#pragma once

#include <vector>

#include "core/image/volume.h"
#include "core/tree/extraction/centreline.h"

namespace hepatica {

// The measurements of one cross-section. Integrals are over the usable rays, scaled to the full
// circle; rays that run into another branch are not usable.
struct CrossSection {
    bool inside = false;            // the point lies in the mask; false: nothing else is set
    double mask_area_mm2 = 0.0;     // inside the mask
    Vec3 offset_mm = Vec3::Zero();  // from the point to the section's centroid
    double usable_share = 0.0;      // of the rays
    double roundness = 0.0;         // shortest over longest usable ray

    // Only on a CT, in HU:
    double covered_area_mm2 = 0.0;  // the mask and a rim of two voxels around it
    double intensity = 0.0;         // integral over the covered area, HU mm2
    double background_hu = 0.0;     // median of the surroundings
    bool has_background = false;
    double centre_hu = 0.0;  // mean near the centre
};

// Cuts mask and CT (may be null) perpendicular to the unit vector `direction` at a point. reach_mm
// limits the rays inside the mask. Thread-safe.
CrossSection cross_section(const Mask& mask, const Volume* ct, const Vec3& point_mm,
                           const Vec3& direction, double reach_mm);

}  // namespace hepatica
