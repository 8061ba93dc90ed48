// SPDX-License-Identifier: GPL-3.0-or-later
// Evidence for portal or hepatic veins, piece by piece, apart from brightness: position, the
// direction in which vessels become wider, and the direction in which forks point.
#pragma once

#include <functional>
#include <vector>

#include "core/tree/systems/anatomical_anchors.h"
#include "core/tree/systems/potts_labelling.h"
#include "core/tree/systems/vessel_pieces.h"

namespace hepatica {

// The widest pieces around each anchor, which form the trunks of the systems.
struct Trunks {
    std::vector<int> portal;
    std::vector<int> hepatic;
};
Trunks trunks_at(const std::vector<VesselPiece>& pieces, const AnatomicalAnchors& anchors);

// For each piece, log odds of hepatic over portal, the sum of four terms:
// * a wide vessel near an anchor belongs to it;
// * a link becomes wider towards the beginning of its system;
// * the parent of a bifurcation, which is wide and opposite to its children, points there;
// * of the two paths from a fork along the vessels, to the hilum and to the confluence, the one
//   through the arm that looks like the fork's parent is right (Dijkstra's algorithm over
//   length / radius^2, with a penalty for bends).
std::vector<double> evidence_for_hepatic(const PieceGraph& graph, const AnatomicalAnchors& anchors);

// The cost of a cut between two arms of one fork, in the same log odds: it is highest for straight
// continuations of equal brightness. In the order (1,0), (2,0), (2,1), (3,0) ...
std::vector<double> ties_of_fork(const std::vector<ForkArm>& arms);

// The same for two consecutive pieces of a link.
double tie_of_passage(const VesselPiece& a, const VesselPiece& b);

// The ties of all passages, then of all pairs of arms that belong to different pieces. `changed`
// gets every strength in that order, pairs of one piece included, and returns the one to use; it
// may be empty.
std::vector<Tie> ties_between(const PieceGraph& graph,
                              const std::function<double(double strength)>& changed = {});

}  // namespace hepatica
