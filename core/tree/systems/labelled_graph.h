// SPDX-License-Identifier: GPL-3.0-or-later
// Rebuilds a vessel graph after its pieces were given systems.
#pragma once

#include <vector>

#include "core/tree/systems/vessel_pieces.h"

namespace hepatica {

struct PieceSystem {
    VascularSystem system = VascularSystem::unknown;
    double confidence = 0.0;
};

// Splits links where the system of their pieces changes, gives each system its own copies of shared
// nodes, and joins links at passing nodes. Links within a fork go to every system that needs them
// to stay connected. `systems` has one entry per piece.
VesselGraph labelled_graph(const VesselGraph& graph, const PieceGraph& pieces,
                           const std::vector<PieceSystem>& systems);

}  // namespace hepatica
