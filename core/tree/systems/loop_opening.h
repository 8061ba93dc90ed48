// SPDX-License-Identifier: GPL-3.0-or-later
// Opens loops: veins of the liver branch and do not meet again, so a loop within one system is two
// branches that touch.
#pragma once

#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

struct OpenedLoops {
    VesselGraph graph;
    int count = 0;
};

// The graph of a tree without its loops. Each segment that closes one is detached at the end where
// it continues less straight, and shortened until it is clear of the lumen there; it is removed
// where the rest would be shorter than it is wide. Node ids are new. `count` is the number of
// loops.
OpenedLoops open_loops(const VesselTree& tree);

}  // namespace hepatica
