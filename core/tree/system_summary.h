// SPDX-License-Identifier: GPL-3.0-or-later
// Summary of each vascular system of a tree: length, roots, confidence and loops. The same table
// stands in case.json and in answers of the command line.
#pragma once

#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// A segment's system is in doubt where VesselSegment::system_confidence is less.
inline constexpr double sure_confidence = 0.8;

struct SystemRoot {
    Vec3 at_mm = Vec3::Zero();
    double radius_mm = 0.0;
};

struct SystemSummary {
    VascularSystem system = VascularSystem::unknown;
    double length_mm = 0.0;
    std::vector<SystemRoot> roots;  // in the tree's order
    // Mean of VesselSegment::system_confidence over the length; 0: not known.
    double confidence = 0.0;
    int loops = 0;
};

// One entry for each system in the tree, in the order of their numbers.
std::vector<SystemSummary> systems_of(const VesselTree& tree);

}  // namespace hepatica
