// SPDX-License-Identifier: GPL-3.0-or-later
// Adds a centreline drawn by hand to a graph as a link. Where one of its ends lies in the lumen of
// a vessel, it is connected to that vessel.
#pragma once

#include <vector>

#include "core/tree/extraction/centreline.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

inline constexpr double drawn_touch_mm = 1.0;  // an end this near to a lumen's wall touches it

struct DrawnVessel {
    int from = -1;  // nodes of its ends
    int to = -1;
    VascularSystem system = VascularSystem::unknown;        // of its link
    VascularSystem system_at_to = VascularSystem::unknown;  // of the vessel at its end
    bool grows_out = false;                                 // begins in or at an existing vessel
    bool leads_in = false;                                  // ends in or at an existing vessel
};

// Adds the link. The part of the curve inside vessels that it touches becomes a straight line to
// their centrelines, and beside their walls it is no wider than where it is first clear of them.
// Its system is that of the vessel at its beginning, else of that at its end, else `system`.
// `drawn` has two points or more. Throws InputError, with its first point as the place, where more
// than half of it lies in existing vessels, or where both ends meet in one node or one point.
DrawnVessel add_drawn_vessel(VesselGraph& graph, const Centreline& drawn, VascularSystem system);

}  // namespace hepatica
