// SPDX-License-Identifier: GPL-3.0-or-later
// What a tree holds of each vascular system: its length, where it begins, how sure it is, and the
// loops in it. The same table stands in case.json and in the answers of the command line.
#pragma once

#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

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

// One entry for each system that the tree holds, by rising number.
std::vector<SystemSummary> systems_of(const VesselTree& tree);

}  // namespace hepatica
