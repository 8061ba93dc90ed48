// SPDX-License-Identifier: GPL-3.0-or-later
// Rebuilds a vessel graph from the bare lines of a file without segments.
#pragma once

#include <vector>

#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// An edge between two points of the file, with the lumen radius at both.
struct LineEdge {
    int from = -1;
    int to = -1;
    double from_radius_mm = 0.0;
    double to_radius_mm = 0.0;
    VascularSystem system = VascularSystem::unknown;
};

struct LineGraph {
    VesselGraph graph;
    std::vector<int> node_of_point;  // graph node at each point, -1 inside a link
};

// Positions are rounded to a micrometre, and points at one rounded position are merged. Every point
// where not exactly two edges of one system meet becomes a node, and so does every point in
// `kept_points`. Edges without length and repeated edges are dropped. Indices must be valid.
LineGraph graph_of_edges(const std::vector<Vec3>& points_mm, const std::vector<LineEdge>& edges,
                         const std::vector<int>& kept_points = {});

}  // namespace hepatica
