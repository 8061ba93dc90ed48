// SPDX-License-Identifier: GPL-3.0-or-later
// How far a seed of a vascular system spreads through vessels that already have systems: a minimal
// cut between the seed and the root of the system that its vessel has now.
#pragma once

#include <vector>

#include "core/tree/systems/labelled_graph.h"
#include "core/tree/systems/vessel_pieces.h"

namespace hepatica {

// The seed, and what the cut needs to know of the tree.
struct SeededVessel {
    int piece = -1;
    VascularSystem system = VascularSystem::unknown;
    // Per piece: 1 downstream of the seed, where only ties resist a change.
    std::vector<std::uint8_t> downstream;
    // Per piece: 1 where it cannot change (the root of its system); not the seed's piece.
    std::vector<std::uint8_t> fixed;
};

// Marks the pieces that change to the seed's system. `now` holds one system per piece; pieces of
// systems other than the one the seed's piece has now stay. The changed pieces are connected to the
// seed. Deterministic.
std::vector<std::uint8_t> spread_of_seed(const PieceGraph& graph,
                                         const std::vector<PieceSystem>& now,
                                         const SeededVessel& seed);

}  // namespace hepatica
