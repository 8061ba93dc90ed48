// SPDX-License-Identifier: GPL-3.0-or-later
// Centrelines as an undirected graph: the form of a vessel tree before it has a root, and while it
// is pruned, linked, cut or read from another program's file.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// A vessel between two nodes, without a direction.
struct VesselLink {
    int from = -1;
    int to = -1;
    VascularSystem system = VascularSystem::unknown;
    double system_confidence = 0.0;  // see VesselSegment
    std::vector<Vec3> points_mm;     // from node to node, both included
    std::vector<double> radii_mm;    // one per point
};

struct VesselGraph {
    std::vector<VesselNode> nodes;
    std::vector<VesselLink> links;
};

double length_mm(const VesselLink& link);

// The same link from its other end.
void reverse(VesselLink& link);

// Ids of the links at each node, ascending; a link from a node to itself appears twice.
std::vector<std::vector<int>> links_of_nodes(const VesselGraph& graph);

// Removes the marked links; their nodes stay.
void remove_links(VesselGraph& graph, const std::vector<std::uint8_t>& removed);

// Joins the two links at every node with exactly two links of one system, and removes nodes without
// links. Ids change.
void join_passing_nodes(VesselGraph& graph);

// Gives each system its own copy of a node that it shares with others; the first link there keeps
// the node. Returns the node that each system has in place of an old one.
using SystemNodes = std::map<std::pair<int, VascularSystem>, int>;
SystemNodes separate_systems(VesselGraph& graph);

// The connected component of each node, numbered in the order of first nodes. Systems do not
// matter.
std::vector<int> component_of_nodes(const VesselGraph& graph);

// A node at which a system should begin.
struct RootWish {
    int node = -1;
    VascularSystem system = VascularSystem::unknown;
};

// Directs every system of the graph away from its roots and sorts it into a tree: parents before
// children, wide branches before narrow ones, systems in ascending order. The narrowest link of a
// loop closes it. Links from a node to itself are split in the middle, or dropped where they have
// fewer than three points. Systems that share a node each get a copy of it.
//   wishes: the first one for a component counts; a component without one begins at its widest end,
//   and wishes for a node without their system are ignored.
VesselTree directed(VesselGraph graph, std::span<const RootWish> wishes = {});

// The graph of a tree. Node ids are the tree's own, link i is segment i.
VesselGraph to_graph(const VesselTree& tree);

// The links as segments with nothing but points and radii, to look up what is nearest to a place:
// segment i is link i.
std::vector<VesselSegment> segments_of(const VesselGraph& graph);

// The roots of a tree as wishes, to keep them when it is built anew.
std::vector<RootWish> root_wishes(const VesselTree& tree);

// Inserts a node into a link at a distance along it and returns it. Within `snap_mm` of one of the
// link's nodes, that node is returned and nothing changes. The second half becomes the last link.
int split_link(VesselGraph& graph, int link, double along_mm, double snap_mm);

}  // namespace hepatica
