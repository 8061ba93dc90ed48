// SPDX-License-Identifier: GPL-3.0-or-later
// A centreline drawn by hand becomes a link of the graph: where one of its ends lies in the lumen
// of a vessel it grows out of that vessel, else it ends there.
#pragma once

#include <vector>

#include "core/tree/extraction/centreline.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

struct DrawnVessel {
    int from = -1;  // nodes of its ends
    int to = -1;
    VascularSystem system = VascularSystem::unknown;        // of its link
    VascularSystem system_at_to = VascularSystem::unknown;  // of the vessel it leads to
    bool grows_out = false;  // its beginning lies in a vessel that was there
    bool leads_in = false;   // its end does
};

// Adds the link. Its part within the vessels that it grows out of becomes a straight way to their
// centrelines, and it is no wider beside their walls than where it is first clear of them. It has
// the system of the vessel at its beginning, else of that at its end, else `system`. Throws
// InputError, which names its first point, where more than half of it lies in vessels that are
// there, or where both ends are one place.
DrawnVessel add_drawn_vessel(VesselGraph& graph, const Centreline& drawn, VascularSystem system);

}  // namespace hepatica
