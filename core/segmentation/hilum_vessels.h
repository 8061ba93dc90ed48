// SPDX-License-Identifier: GPL-3.0-or-later
// The porta hepatis: where the portal vein divides, it runs in a fissure between the lobes, outside
// of every mask that follows the liver's surface. Without it the left and the right portal vein are
// two trees that begin nowhere. The vena cava lies in a groove of its own and is left out.
#pragma once

#include <optional>

#include "core/base/job.h"
#include "core/segmentation/liver_frame.h"

namespace hepatica {

// Where to look, and for what; positions in LPS.
struct Hilum {
    Vec3 at_mm = Vec3::Zero();
    Vec3 confluence_mm = Vec3::Zero();  // of the hepatic veins: the cava runs down from there
    double parenchyma_hu = 0.0;
    double vessel_hu = 0.0;  // of the middle of a vessel, > parenchyma_hu
};

struct HilumVessels {
    Mask vessels;                  // 0 or 1, on the frame's grid; none of it in the liver
    std::optional<Vec3> trunk_mm;  // middle of the widest of them where they go on beyond
};

// Vessels in the liver's fissures (what closing it by 30 mm adds to it), within 30 mm of the hilum
// and nearer to it than to the cava: brighter than half of a vessel's rise, 3 mm wide or more, and
// connected with one of `vessels` (on the frame's grid) that is as wide where it leaves the liver.
// Throws Cancelled.
HilumVessels hilum_vessels(const LiverFrame& frame, const Mask& vessels, const Hilum& hilum,
                           Job& job);

}  // namespace hepatica
