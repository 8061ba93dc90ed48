// SPDX-License-Identifier: GPL-3.0-or-later
// Centrelines as an undirected graph: what a vessel tree is before a root is chosen, and what it
// becomes again while it is pruned, linked, cut or read from another program's file.
#pragma once

#include <span>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// A stretch of vessel between two nodes, in no particular direction.
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

// Ids of the links that meet in each node, ascending; a link from a node to itself stands twice.
std::vector<std::vector<int>> links_of_nodes(const VesselGraph& graph);

// Removes the links that are marked; their nodes stay.
void remove_links(VesselGraph& graph, const std::vector<std::uint8_t>& removed);

// Joins the two links of every node in which exactly two links of one system meet, and drops the
// nodes that no link uses.
void join_passing_nodes(VesselGraph& graph);

// The component of each node, numbered by first node. Links join whatever their systems.
std::vector<int> component_of_nodes(const VesselGraph& graph);

// A place at which a system should begin.
struct RootWish {
    int node = -1;
    VascularSystem system = VascularSystem::unknown;
};

// Directs every system of the graph away from its roots and sorts it into a tree: parents before
// children, wide branches before narrow ones, systems in ascending order. Of each loop the
// narrowest link is the one that closes it. Links from a node to itself are split in the middle.
//   wishes: a component that none names begins at its widest end; the first of several in one
//   component counts, and those that name no node of their system are passed over.
// Nodes shared by two systems are given to each of them.
VesselTree directed(VesselGraph graph, std::span<const RootWish> wishes = {});

// The graph of a tree. Node ids are the tree's own, link i is segment i.
VesselGraph to_graph(const VesselTree& tree);

// The roots of a tree as wishes, so that it keeps them when it is built anew.
std::vector<RootWish> root_wishes(const VesselTree& tree);

// Puts a node into a link at a distance along it and returns the node. Where the place lies within
// `snap_mm` of one of the link's nodes, that node is returned and nothing changes.
int split_link(VesselGraph& graph, int link, double along_mm, double snap_mm);

}  // namespace hepatica
