// SPDX-License-Identifier: GPL-3.0-or-later
// Bridges gaps that the segmentation left between pieces of a vessel: minimal paths through the CT
// from the open ends of one piece to another, each with a confidence, so that doubtful ones are
// offered to the user instead of being built. Branches that may be vessels are offered likewise
// (core/links/offered_branches.h).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/image/volume.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

struct BridgeOptions {
    double longest_gap_mm = 15.0;  // length of the path outside the mask
    double confidence = 0.25;      // bridges are built from this confidence on
};

// A proposed link over a gap, or a proposed branch.
struct Bridge {
    // From an open end to a point on another piece's centreline; for a built bridge, its
    // centreline. A branch leads from a vessel to its own tip.
    std::vector<Vec3> path_mm;
    // Of a branch, one per point; empty: a gap.
    std::vector<double> radii_mm;
    double from_radius_mm = 0.0;
    double to_radius_mm = 0.0;
    double gap_mm = 0.0;  // length of the path outside the mask
    // In [0, 1]. Of a branch: the share of it that is vessel, as the model estimates it. Of a gap:
    // product of the brightness of the gap relative to the vessel, the straightness of
    // the path, and whether it leads to a wide end of one of the pieces, as for a lost branch. Two
    // systems that come near each other with their thin ends score low.
    double confidence = 0.0;
    bool built = false;  // is in the graph
    bool is_branch() const { return !radii_mm.empty(); }
};

// Finds bridges and builds those of at least `options.confidence` into the graph. Returns them and
// at most one offer for each remaining pair of pieces, best first. `ct` may be null: then only
// distance and direction count. The mask's grid is that of the graph's skeleton. `progress` gets
// the share done, from any thread; an exception it throws ends the work. Deterministic.
std::vector<Bridge> bridge_gaps(VesselGraph& graph, const Mask& vessels, const Volume* ct,
                                const BridgeOptions& options,
                                const std::function<void(double share)>& progress);

// Bridges as a JSON array, and back. Reading throws InputError, naming `place` (the file).
std::string bridges_to_json(const std::vector<Bridge>& bridges);
std::vector<Bridge> bridges_from_json(const std::string& text, const std::string& place);

}  // namespace hepatica
