// SPDX-License-Identifier: GPL-3.0-or-later
// Where Couinaud's segments (Couinaud, Le Foie, 1957) are expected in a liver. Three upright planes
// through the axis of the vena cava, along the right and the middle hepatic vein and the umbilical
// fissure, divide it into the right posterior (6, 7), right anterior (5, 8), medial (4) and lateral
// sector (2, 3). The level of the portal vein's branches divides each but the medial one into a
// lower and an upper segment. The caudate lobe (1) lies between portal vein and vena cava. This is
// evidence for the labels of branches (couinaud_branches.h), not the labels themselves.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "core/tree/vessel_tree.h"

namespace hepatica {

inline constexpr int couinaud_count = 8;

struct CouinaudFrame {
    double scale = 1.0;                  // lengths relative to an adult's liver of 1.5 litres
    Vec3 confluence_mm = Vec3::Zero();   // of the hepatic veins, on the upright axis of the vena
                                         // cava
    int trunk = -1;                      // end_of_portal_trunk()
    Vec3 bifurcation_mm = Vec3::Zero();  // of the portal trunk
    // Angles of the right, middle and left hepatic vein around the axis: 0 to the right, pi/2 to
    // the front, pi to the left.
    std::array<double, 3> vein_azimuth_rad{};
    // Angles of the borders: right vein, middle vein, and the umbilical fissure between the middle
    // and the left vein.
    std::array<double, 3> border_azimuth_rad{};
    std::array<bool, 3> vein_known{};  // false: an adult's usual angle
    bool confluence_known = false;
    // Centres of the portal vein's main branches right of the middle vein and left of the fissure.
    Vec3 right_branch_mm = Vec3::Zero();
    Vec3 left_branch_mm = Vec3::Zero();
};

// The frame of a tree with a portal segment that closes no loop, in a liver with this box and
// volume > 0. Patient space is LPS; mirrored organs (situs inversus) are not recognised.
CouinaudFrame couinaud_frame(const VesselTree& tree, const Eigen::AlignedBox3d& liver_mm,
                             double liver_ml);

// Probabilities that a point of the liver belongs to segments 1 to 8 (index 0 to 7), with sum 1.
// Borders are soft over about 8 mm in an adult. Thread-safe.
std::array<double, couinaud_count> segment_likelihoods(const CouinaudFrame& frame,
                                                       const Vec3& at_mm);

}  // namespace hepatica
