// SPDX-License-Identifier: GPL-3.0-or-later
// The vessel tree as pipes: the conical elements of the paper's section II.B joined at nodes, their
// volumes, and the places where a catheter or a tear divides them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/flow/pressure_drop.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// A piece of vessel between two nodes. Positive flow runs from proximal to distal.
struct FlowSegment {
    int proximal_node = -1;
    int distal_node = -1;
    int first_cone = 0;  // into FlowNetwork::cones, from proximal to distal
    int cone_count = 1;
    // Where this piece lies in the vessel tree: the segment there, and the distance from that
    // segment's proximal node (0 unless it was divided).
    int tree_segment = -1;
    double offset_mm = 0.0;
    bool open = true;
    // Head lost behind a stenosis, as a share of the dynamic pressure at the proximal end.
    double jet_loss = 0.0;
};

struct FlowNetwork {
    int node_count = 0;
    std::vector<FlowSegment> segments;  // one per segment of the vessel tree, then the divided ones
    std::vector<Cone> cones;
    std::vector<int> root_nodes;    // where each vascular system is supplied, in order
    std::vector<int> outlet_nodes;  // ends of the resolved vessels, ascending; never a root
    std::vector<int> torn_nodes;    // stumps and open sides, which bleed into the surroundings
};

// one_cone:   the best straight line through the segment's radii (least squares over arclength),
//             limited to the smallest and the largest of them. Drops go with R^-4, so the voxel
//             noise of single radii would otherwise act as narrowing.
// centreline: a cone between neighbouring centreline points, with the radii as they are.
enum class SegmentShape { one_cone, centreline };

// Segment i and node i of the network are those of the tree. Throws InputError where the tree is
// not valid (see validate(VesselTree)).
FlowNetwork network_of(const VesselTree& tree, SegmentShape shape = SegmentShape::one_cone);

// Checks indices and cones; throws InputError that names the segment.
void validate(const FlowNetwork& network);

// Length, volume (of a cone: pi L (R1^2 + R1 R2 + R2^2)/3) and smallest radius of a segment.
double length_mm(const FlowNetwork& network, int segment);
double volume_mm3(const FlowNetwork& network, int segment);
double smallest_radius_mm(const FlowNetwork& network, int segment);
double volume_mm3(const FlowNetwork& network);
double volume_mm3(const Cone& cone);

// Volume of the lumen between the proximal node and a place along the segment, and the inverse.
// Both clamp to the segment; the inverse is exact for every taper.
double volume_up_to_mm3(const FlowNetwork& network, int segment, double arclength_mm);
double arclength_at_mm(const FlowNetwork& network, int segment, double volume_mm3);

double proximal_radius_mm(const FlowNetwork& network, int segment);
double distal_radius_mm(const FlowNetwork& network, int segment);

// The segment of the network that contains a point of the vessel tree, and the point's distance
// from that segment's proximal node. `point.segment` is a segment of the vessel tree. Throws
// InputError where there is no such segment.
struct NetworkPoint {
    int segment = -1;
    double arclength_mm = 0.0;
};
NetworkPoint locate(const FlowNetwork& network, const TreePoint& point);

// Puts a node at a point and returns it; an existing node if the point is within 1e-6 mm (or 1e-9
// of the length) of it. The part up to the point keeps the segment's index; the rest becomes the
// last segment of the network.
int divide(FlowNetwork& network, const TreePoint& point);

// Places a catheter's tip at a point and returns its node. A wedged tip fills the lumen: nothing
// passes it from upstream, and nothing that it injects flows back.
int place_catheter(FlowNetwork& network, const TreePoint& tip, bool wedged);

// Tears the vessel through at a point: both stumps bleed. At an end of the segment it alone is
// severed from what it joins there, which stays joined and bleeds from the hole. Returns the nodes
// of the two stumps, that on the proximal side first, each of which is in torn_nodes once; they are
// the same where nothing else was there to be severed from.
std::array<int, 2> tear(FlowNetwork& network, const TreePoint& point);

// Opens the side of a vessel at a point between its ends, where it goes on as before. Returns the
// node there, which is in torn_nodes once.
int open_side(FlowNetwork& network, const TreePoint& point);

// Where a tear bleeds; several tears may share a node, as of branches that were torn off one fork.
struct TearOpening {
    std::size_t tear = 0;
    std::size_t torn_node = 0;  // index into FlowNetwork::torn_nodes
    double area_mm2 = 0.0;
};

// Tears the vessels through at all of these points, each with an opening of this area at both
// stumps; where `sides` is not 0, only their side is opened. As many areas as points, and as many
// `sides` or none.
std::vector<TearOpening> tear_all(FlowNetwork& network, std::span<const TreePoint> points,
                                  std::span<const double> areas_mm2,
                                  std::span<const std::uint8_t> sides = {});
// Of each torn node, the sum over its openings.
std::vector<double> torn_areas_mm2(const FlowNetwork& network,
                                   std::span<const TearOpening> openings);

// What belongs to the outlets of the whole vessels, in the order of their nodes, for those outlets
// that are left in torn ones: a tear at the end of an end vessel takes its outlet away.
std::vector<double> of_outlets_left(const FlowNetwork& torn, std::span<const int> whole_outlets,
                                    std::span<const double> values);

// Closes (or opens) every part of a segment of the vessel tree: a clamp, a plug, a spasm.
void set_open(FlowNetwork& network, int tree_segment, bool open);

// Narrows the lumen between two places of one segment of the vessel tree to a share of its area,
// above 0 and up to 1. Friction is that of a narrower pipe, and the jet behind it loses its head
// (tube_law.h), once, however the stretch is divided. Where squeezes overlap, their shares multiply
// and each has its jet.
void squeeze(FlowNetwork& network, int tree_segment, double from_mm, double to_mm, double share);

// The segments at each node, ascending; [first[n], first[n+1]) for node n.
struct NodeSegments {
    std::vector<int> first;
    std::vector<int> segments;
};
NodeSegments segments_at_nodes(const FlowNetwork& network);

}  // namespace hepatica
