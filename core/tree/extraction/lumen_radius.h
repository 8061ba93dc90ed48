// SPDX-License-Identifier: GPL-3.0-or-later
// Cross-sections of a vessel along its centreline, and from them radii below the size of a voxel.
//
// On a CT the radius comes from the section's excess of intensity over the parenchyma, divided by
// the contrast of wide vessels nearby in the tree: the area a blood-filled disc must have to
// account for it. Blurring moves intensity about but does not change its sum, so this has no
// threshold and needs no model of the scanner. Without a CT it is the area of the mask's section.
#pragma once

#include <vector>

#include "core/image/volume.h"
#include "core/tree/extraction/centreline.h"

namespace hepatica {

// What one cross-section shows. Integrals are over the section's usable rays, scaled to the full
// circle; rays that run into another branch are not usable.
struct CrossSection {
    bool inside = false;            // the centreline point lies in the mask
    double mask_area_mm2 = 0.0;     // inside the mask
    Vec3 offset_mm = Vec3::Zero();  // from the centreline point to the section's centroid
    double usable_share = 0.0;      // of the rays
    double roundness = 0.0;         // shortest over longest usable ray

    // Only on a CT, in HU:
    double covered_area_mm2 = 0.0;  // the mask and a rim of two voxels around it
    double intensity = 0.0;         // integral over the covered area, HU mm2
    double background_hu = 0.0;     // median of the surroundings
    bool has_background = false;
    double centre_hu = 0.0;  // mean near the centre
};

// Cuts mask and CT (if not null) across `direction` at a point. reach_mm limits the rays inside the
// mask.
CrossSection cross_section(const Mask& mask, const Volume* ct, const Vec3& point_mm,
                           const Vec3& direction, double reach_mm);

}  // namespace hepatica
