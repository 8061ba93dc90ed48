// SPDX-License-Identifier: GPL-3.0-or-later
// Where Couinaud's segments (Couinaud, Le Foie, 1957) are to be expected in a liver. Three upright
// planes through the axis of the vena cava, along the right and the middle hepatic vein and the
// umbilical fissure, part it into right posterior (6, 7), right anterior (5, 8), medial (4) and
// lateral sector (2, 3); the
// level of the portal vein's branches parts each but the medial one into a lower and an upper
// segment; the caudate lobe (1) lies between portal vein and vena cava.
// It is what the branches are labelled by, not the label: see couinaud_branches.h.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "core/tree/vessel_tree.h"

namespace hepatica {

inline constexpr int couinaud_count = 8;

struct CouinaudFrame {
    double scale = 1.0;                  // of lengths, against an adult's liver of 1.5 litres
    Vec3 confluence_mm = Vec3::Zero();   // of the hepatic veins, on the vena cava's upright axis
    int trunk = -1;                      // end_of_portal_trunk()
    Vec3 bifurcation_mm = Vec3::Zero();  // of the portal trunk
    // Of right, middle and left hepatic vein about the axis: 0 to the right, quarter turn to the
    // front, half a turn to the left.
    std::array<double, 3> vein_azimuth_rad{};
    // Of the borders: right and middle vein, and the umbilical fissure between the middle and the
    // left one.
    std::array<double, 3> border_azimuth_rad{};
    std::array<bool, 3> vein_known{};  // false: an adult's, for want of such a vein
    bool confluence_known = false;
    // Middles of the portal vein's main branches right of the middle vein and left of the fissure.
    Vec3 right_branch_mm = Vec3::Zero();
    Vec3 left_branch_mm = Vec3::Zero();
};

// Of a tree with a portal system, in a liver of this box and volume. Patient space is LPS: organs
// that lie mirrored in the body are not known.
CouinaudFrame couinaud_frame(const VesselTree& tree, const Eigen::AlignedBox3d& liver_mm,
                             double liver_ml);

// How likely a place of the liver belongs to segments 1 to 8 (index 0 to 7); the sum is 1. Borders
// are soft over some 8 mm of an adult.
std::array<double, couinaud_count> segment_likelihoods(const CouinaudFrame& frame,
                                                       const Vec3& at_mm);

}  // namespace hepatica
