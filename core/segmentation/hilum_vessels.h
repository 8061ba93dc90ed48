// SPDX-License-Identifier: GPL-3.0-or-later
// The vessels of the porta hepatis. Where the portal vein divides, it runs in a fissure between the
// lobes, outside every mask that follows the liver's surface; without it the left and right portal
// veins are two trees without a common root. The vena cava lies in a groove of its own and is left
// out.
#pragma once

#include <optional>

#include "core/base/job.h"
#include "core/segmentation/liver_frame.h"

namespace hepatica {

// Where to look, and the intensities to look for; positions in LPS.
struct Hilum {
    Vec3 at_mm = Vec3::Zero();
    Vec3 confluence_mm = Vec3::Zero();  // of the hepatic veins; the cava runs down from here
    double parenchyma_hu = 0.0;
    double vessel_hu = 0.0;  // at the centre of a vessel, > parenchyma_hu
};

struct HilumVessels {
    Mask vessels;  // 0 or 1, on the frame's grid, outside the liver
    // Centre of the widest section in which a vessel leaves the fissures away from the liver; none
    // below 10 mm^2.
    std::optional<Vec3> trunk_mm;
};

// Vessels in the fissures of the liver (voxels that a closing by 30 mm adds to it), within 30 mm of
// the hilum and nearer to it than to the cava. They are brighter than the tissue by half of a
// vessel's rise or more, at least 3 mm wide, and connected with one of `vessels` (on the frame's
// grid) that is also at least 3 mm wide. Throws Cancelled.
HilumVessels hilum_vessels(const LiverFrame& frame, const Mask& vessels, const Hilum& hilum,
                           Job& job);

}  // namespace hepatica
