// SPDX-License-Identifier: GPL-3.0-or-later
// The vessel tree: centrelines with radii between bifurcations and ends. Plain data read by all
// later stages (mesh, flow, preconditioner, rendering); tree_extraction.h extracts it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/vascular_system.h"
#include "core/base/vector.h"

namespace hepatica {

// A bifurcation, an end, or a root.
struct VesselNode {
    Vec3 position_mm = Vec3::Zero();
    double radius_mm = 0.0;
};

// The vessel between two nodes, directed away from the root of its system.
struct VesselSegment {
    int proximal_node = -1;
    int distal_node = -1;
    int parent = -1;  // segment that ends where this one begins; -1 at a root
    VascularSystem system = VascularSystem::unknown;
    // In [0, 1]: the share of draws with perturbed evidence that gave this system
    // (tell_systems_apart.h), or the share of the segment in voxels of it; 1 where the user stated
    // it. 0: not known, as for an unknown system and for a segment that only a bridge joined to its
    // system.
    double system_confidence = 0.0;
    int strahler_order = 1;
    bool closes_loop = false;      // closes a loop: not part of the spanning tree
    std::vector<Vec3> points_mm;   // centreline from node to node, both included; 2 or more points,
                                   // no two consecutive ones equal
    std::vector<double> radii_mm;  // lumen radius at each point, > 0
    // Per point: 1 where a gap of the segmentation was bridged. Empty: nowhere.
    std::vector<std::uint8_t> bridged;
};

// A forest (one tree per system and component) plus the segments that close loops. Parents stand
// before their children; a segment's index is its id.
struct VesselTree {
    std::vector<VesselNode> nodes;
    std::vector<VesselSegment> segments;
};

double length_mm(const VesselSegment& segment);
double length_mm(const VesselTree& tree);
// Length of the stretches that bridge gaps.
double bridged_length_mm(const VesselTree& tree);

// Ids of the segments without a parent, in order, apart from those that close loops.
std::vector<int> roots(const VesselTree& tree);
// children[i]: ids of the segments whose parent is i, in order.
std::vector<std::vector<int>> children(const VesselTree& tree);
// Number of segments that meet in each node.
std::vector<int> node_degrees(const VesselTree& tree);
int bifurcation_count(const VesselTree& tree);  // nodes of degree 3 or more
int end_count(const VesselTree& tree);          // nodes of degree 1
// Marks a segment and all segments downstream of it.
std::vector<std::uint8_t> downstream_of(const VesselTree& tree, int segment);
// Sets the Strahler orders: 1 at the ends, the highest of the children, one more where two or more
// have it. Segments that close loops count as no children.
void set_strahler_orders(VesselTree& tree);

// A point on the tree: a segment and the distance along it from its proximal node.
struct TreePoint {
    int segment = -1;
    double arclength_mm = 0.0;
    double distance_mm = 0.0;  // from the query to the centreline
};

// The centreline point nearest to a position. O(points). Throws InputError if the tree is empty.
TreePoint nearest_point(const VesselTree& tree, const Vec3& position_mm);

// Checks what this header promises (indices, order, radii, points, confidences). Throws InputError
// that names the first segment that breaks it. Readers call it on all input from outside.
void validate(const VesselTree& tree);

}  // namespace hepatica
