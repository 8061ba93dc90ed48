// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates the two anatomical anchors of a liver: the hilum, where the portal vein enters, and the
// confluence, where the hepatic veins join the vena cava.
#pragma once

#include <Eigen/Geometry>

#include "core/tree/systems/vessel_pieces.h"

namespace hepatica {

// An adult's confluence in shares of the liver's box, from right to left, front to back and foot to
// head.
inline const Vec3 usual_confluence(0.50, 0.60, 0.82);

struct AnatomicalAnchors {
    Vec3 hilum_mm = Vec3::Zero();
    Vec3 confluence_mm = Vec3::Zero();
};

// Starts from an adult's positions in the box around the liver (LPS: the confluence lies above and
// behind the hilum) and moves each to the wide vessels around it, weighted by likelihood, in three
// rounds. `liver_mm` must not be empty. Linear in the number of pieces.
AnatomicalAnchors find_anchors(const std::vector<VesselPiece>& pieces,
                               const Eigen::AlignedBox3d& liver_mm);

}  // namespace hepatica
