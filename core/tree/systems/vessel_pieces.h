// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a vessel graph into pieces of about 4 mm and the forks at which they meet: the units that
// get systems in tell_systems_apart.h.
#pragma once

#include <array>
#include <vector>

#include "core/image/volume.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// A stretch of one link.
struct VesselPiece {
    int link = -1;
    int first_point = 0;  // of the link, both included; consecutive pieces share a point
    int last_point = 0;
    Vec3 centre_mm = Vec3::Zero();
    double length_mm = 0.0;
    double radius_mm = 0.0;  // median
    // Median brightness relative to vessels of the same radius in the graph, in robust standard
    // deviations; 0 without a CT.
    double brightness = 0.0;
    // Growth of log(radius) over the link (slope of a least-squares line), 0 for links too short to
    // tell; and the unit vector from the link's first point to its last.
    double link_taper = 0.0;
    Vec3 link_direction = Vec3::Zero();
    Vec3 link_centre_mm = Vec3::Zero();
};

// Where a piece leaves a fork.
struct ForkArm {
    int piece = -1;
    int node = -1;                    // of the graph
    Vec3 direction = Vec3::Zero();    // away from the fork, measured beyond its lumen
    Vec3 position_mm = Vec3::Zero();  // where that direction begins
    double radius_mm = 0.0;           // over the first millimetres
    double brightness = 0.0;          // over the first three pieces
};

// Nodes joined by links that are shorter than their diameter count as one fork, because crossing
// vessels share a skeleton there.
struct PieceGraph {
    std::vector<VesselPiece> pieces;           // link by link, along each
    std::vector<std::array<int, 2>> passages;  // consecutive pieces of one link
    std::vector<std::vector<ForkArm>> forks;   // two arms or more
    std::vector<std::uint8_t> within_fork;     // per link: 1 where it joins two nodes of one fork
};

// `ct` may be null. Deterministic.
PieceGraph pieces_of(const VesselGraph& graph, const Volume* ct);

// Angle in radians by which the path from one arm into the other deviates from straight on.
double bend_between(const ForkArm& a, const ForkArm& b);

}  // namespace hepatica
