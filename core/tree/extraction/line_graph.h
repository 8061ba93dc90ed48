// SPDX-License-Identifier: GPL-3.0-or-later
// A vessel graph rebuilt from the bare lines of a file that knows nothing of segments.
#pragma once

#include <vector>

#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// A straight piece between two points of the file, with the lumen radius at both.
struct LineEdge {
    int from = -1;
    int to = -1;
    double from_radius_mm = 0.0;
    double to_radius_mm = 0.0;
    VascularSystem system = VascularSystem::unknown;
};

struct LineGraph {
    VesselGraph graph;
    std::vector<int> node_of_point;  // graph node that stands at a point, -1 inside a link
};

// Points within a micrometre of each other count as one. Every point in which not exactly two edges
// of one system meet becomes a node, and so does every point named in `kept_points`. Edges of no
// length and edges given twice are left out. Indices must be valid.
LineGraph graph_of_edges(const std::vector<Vec3>& points_mm, const std::vector<LineEdge>& edges,
                         const std::vector<int>& kept_points = {});

}  // namespace hepatica
