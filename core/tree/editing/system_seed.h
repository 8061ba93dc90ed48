// SPDX-License-Identifier: GPL-3.0-or-later
// A seed set by the user: the vessel at a place belongs to a system. Gives that vessel, and what
// belongs to it (core/tree/systems/seeded_spread.h), to the system in the tree's graph.
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
    Vec3 begin_mm = Vec3::Zero();  // most proximal point of the part that changed
};

// `graph` is that of the tree (link i is segment i), with touching vessels sharing nodes. Throws
// InputError where the vessel has that system already, or where it lies within a fork, so that it
// is not clear which vessel is meant.
SeededGraph seeded_graph(const VesselTree& tree, const VesselGraph& graph, const SystemSeed& seed);

}  // namespace hepatica
