// SPDX-License-Identifier: GPL-3.0-or-later
// A vessel of which a person says what system it is of, and all that goes with it: the tree's
// graph with that part given to the system (core/tree/systems/seeded_spread.h says how far).
#pragma once

#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

struct SystemSeed {
    Vec3 at_mm = Vec3::Zero();
    TreePoint at;  // of the tree, nearest to at_mm
    VascularSystem system = VascularSystem::unknown;
};

struct SeededGraph {
    VesselGraph graph;
    Vec3 begin_mm = Vec3::Zero();  // most proximal point of what was given to the system
};

// `graph` is that of the tree, link i of segment i, in which vessels that touch share their nodes.
// Throws InputError where the vessel is of the system already, or where it is no longer than the
// fork it lies in.
SeededGraph seeded_graph(const VesselTree& tree, const VesselGraph& graph, const SystemSeed& seed);

}  // namespace hepatica
