// SPDX-License-Identifier: GPL-3.0-or-later
// Where a body is torn through: vessels of which one part is no longer connected to the next.
// side_tears.h finds where only their side is open.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/vertex_places.h"
#include "core/tear/tearing.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct ThroughTear {
    // Arclength 0: torn off its fork, which stays joined to the other branches. The whole length:
    // torn off all branches behind it, which stay joined with each other.
    TreePoint at;
    double area_mm2 = 0.0;  // of the lumen there, or of the opening in its side
    bool side = false;      // only the side is open, and the vessel goes on
    // Whether they are in the same place; areas may differ.
    bool operator==(const ThroughTear& other) const {
        return at.segment == other.at.segment && at.arclength_mm == other.at.arclength_mm &&
               side == other.side;
    }
};

// Of a vessel there, pi R^2.
double lumen_mm2(const VesselSegment& segment, double arclength_mm);

// While it is the same, so is where a body is torn through and where its sides have parted.
struct TornSoFar {
    std::uint64_t version = 0;  // of the topology
    int joints_broken = 0;
    int pieces = 0;
    int open_corners = 0;  // of joints; a corner that has come apart stays so
    bool operator==(const TornSoFar&) const = default;
};

// Compares consecutive sections of `stretch_mm` along each segment, and of forks, by the piece that
// most tetrahedra of a section belong to. Only what holds within the segment or the fork counts: a
// branch that is cut through may still hang on a neighbour that it touches farther on. What was
// apart from the start is no tear. `tetrahedra` has the place of each tetrahedron.
std::vector<ThroughTear> through_tears(const VesselTree& tree, const Tearing& tearing,
                                       std::span<const VertexPlace> tetrahedra, double stretch_mm);

}  // namespace hepatica
