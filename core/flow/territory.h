// SPDX-License-Identifier: GPL-3.0-or-later
// What lies downstream of a point and how much of the flow it gets: the virtual injection that
// interventional radiologists know from cone-beam CT.
#pragma once

#include <vector>

#include "core/flow/flow_solution.h"

namespace hepatica {

struct Territory {
    // Share of each segment's flow that has passed the point, per segment of the network: 1
    // downstream of it on a tree, between 0 and 1 where loops add other blood, otherwise 0. The
    // segment of the point counts as downstream; it belongs to the territory from `begins_mm` on.
    std::vector<double> passed_share;
    int segment = -1;          // of the point
    double begins_mm = 0.0;    // distance of the point from that segment's proximal node
    std::vector<int> outlets;  // positions in network.outlet_nodes that receive flow from the point
    std::vector<double> outlet_shares;  // of each such outlet's flow that has passed the point
    double share_of_flow = 0.0;         // of all that enters the network
    double share_of_outflow = 0.0;      // of all that leaves through the outlets
    double flow_mm3_s = 0.0;            // through the point
    double volume_mm3 = 0.0;            // of the lumen downstream, weighted by passed_share
};

// Downstream follows the solved flow, not the root of the tree, and is downstream of that one flow:
// vessels and outlets that get nothing from the point in it are none of the territory's, also where
// flow from the point reaches them later. `point` is a point of the vessel tree. Costs O(segments);
// throws InputError where there is no such segment.
Territory territory_of(const FlowNetwork& network, const FlowSolution& solution,
                       const TreePoint& point);

}  // namespace hepatica
