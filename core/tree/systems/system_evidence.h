// SPDX-License-Identifier: GPL-3.0-or-later
// What speaks for portal vein or hepatic veins, piece by piece, whatever the brightness: where the
// piece lies, which way vessels become wider, and which way forks point.
#pragma once

#include <vector>

#include "core/tree/systems/anatomical_anchors.h"
#include "core/tree/systems/vessel_pieces.h"

namespace hepatica {

// The widest pieces about each anchor: what the systems' trunks are made of.
struct Trunks {
    std::vector<int> portal;
    std::vector<int> hepatic;
};
Trunks trunks_at(const std::vector<VesselPiece>& pieces, const AnatomicalAnchors& anchors);

// For each piece, log odds of hepatic over portal. Four kinds are added up:
// * a wide vessel near an anchor belongs to it;
// * a link becomes wider towards where its system begins;
// * the parent of a bifurcation, which is wide and opposite to its children, points there;
// * of the two ways from a fork along the vessels, to the hilum and to the confluence, the one
//   that a parent of the fork would take is right (by Dijkstra's algorithm over length / radius^2
//   and a toll for each bend).
std::vector<double> evidence_for_hepatic(const PieceGraph& graph, const AnatomicalAnchors& anchors);

// How much a cut between two arms of one fork costs, in the same log odds: straight ways between
// vessels of the same brightness cost most. In the order (1,0), (2,0), (2,1), (3,0) ...
std::vector<double> ties_of_fork(const std::vector<ForkArm>& arms);

// The same between two consecutive pieces of a link.
double tie_of_passage(const VesselPiece& a, const VesselPiece& b);

}  // namespace hepatica
