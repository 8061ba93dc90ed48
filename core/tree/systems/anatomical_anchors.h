// SPDX-License-Identifier: GPL-3.0-or-later
// Where the great vessels of the liver begin: the hilum, at which the portal vein enters, and the
// confluence, at which the hepatic veins join the vena cava.
#pragma once

#include <Eigen/Geometry>

#include "core/tree/systems/vessel_pieces.h"

namespace hepatica {

struct AnatomicalAnchors {
    Vec3 hilum_mm = Vec3::Zero();
    Vec3 confluence_mm = Vec3::Zero();
};

// Begins where an adult's lie in the box around the liver (LPS, so that the confluence is above
// and behind the hilum) and moves each to the wide vessels about it. `liver_mm` must not be empty.
AnatomicalAnchors find_anchors(const std::vector<VesselPiece>& pieces,
                               const Eigen::AlignedBox3d& liver_mm);

}  // namespace hepatica
