// SPDX-License-Identifier: GPL-3.0-or-later
// Veins of the liver branch and do not meet again: a loop within one system is two branches that
// touch, and is opened there.
#pragma once

#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

struct OpenedLoops {
    VesselGraph graph;
    int count = 0;
};

// The graph of a tree without its loops: each segment that closes one is detached from that of its
// two ends at which it bends more away from what it meets, and ends clear of the lumen there. What
// would be left shorter than it is wide is removed. Nodes are numbered anew.
OpenedLoops open_loops(const VesselTree& tree);

}  // namespace hepatica
