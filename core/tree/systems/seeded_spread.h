// SPDX-License-Identifier: GPL-3.0-or-later
// How far a seed of a vascular system reaches through vessels that were told apart already: a
// minimal cut between the seed and the root of the system that its vessel has now.
#pragma once

#include <vector>

#include "core/tree/systems/labelled_graph.h"
#include "core/tree/systems/vessel_pieces.h"

namespace hepatica {

// Where the seed lies, and what the cut must know of the tree.
struct SeededVessel {
    int piece = -1;
    VascularSystem system = VascularSystem::unknown;
    // Per piece: blood comes to it through the seed, so that nothing but ties holds it back.
    std::vector<std::uint8_t> downstream;
    // Per piece: it stays, whatever the seed says (the root of its system); may not be the seed.
    std::vector<std::uint8_t> fixed;
};

// Marks the pieces that change to the seed's system. `now` holds one system per piece; pieces of
// systems other than the seed's present one stay. What changes hangs together with the seed.
// Deterministic.
std::vector<std::uint8_t> spread_of_seed(const PieceGraph& graph,
                                         const std::vector<PieceSystem>& now,
                                         const SeededVessel& seed);

}  // namespace hepatica
