// SPDX-License-Identifier: GPL-3.0-or-later
// Links between pieces of a vessel that the segmentation left apart: minimal paths through the CT
// from the open ends of one piece to another, each with a confidence, so that the doubtful ones can
// be shown to the user instead of being taken.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/image/volume.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

struct BridgeOptions {
    double longest_gap_mm = 15.0;  // length of the path outside the mask
    double confidence = 0.25;      // from here on a bridge is built without asking
};

// A proposed link.
struct Bridge {
    // From an open end to a point on another piece's centreline; of a bridge that is built, the
    // centreline as it was built.
    std::vector<Vec3> path_mm;
    double from_radius_mm = 0.0;
    double to_radius_mm = 0.0;
    double gap_mm = 0.0;  // length of the path outside the mask
    // In [0, 1]: how bright the gap is compared with the vessel, how straight on the path goes, and
    // whether it leads to the wide end of one of the pieces, as a lost branch has it. Two systems
    // that come near each other with their thin ends score low.
    double confidence = 0.0;
    bool built = false;    // whether the graph has it already
    bool refused = false;  // somebody said that it is none: it is not offered any more
};

// Finds at most one bridge for each pair of pieces, best first, builds those that are confident
// enough into the graph, and returns those and the best of each remaining piece. `ct` may be null:
// then only nearness and direction count. The masks' grid is that of the graph's skeleton.
// `progress` is told the share that is done, from any thread; what it throws ends the work.
// Deterministic.
std::vector<Bridge> bridge_gaps(VesselGraph& graph, const Mask& vessels, const Volume* ct,
                                const BridgeOptions& options,
                                const std::function<void(double share)>& progress);

// Bridges as a JSON array, and back. Reading throws InputError that names `place` (the file).
std::string bridges_to_json(const std::vector<Bridge>& bridges);
std::vector<Bridge> bridges_from_json(const std::string& text, const std::string& place);

}  // namespace hepatica
