// SPDX-License-Identifier: GPL-3.0-or-later
// A vessel graph rebuilt from the systems that its pieces were given.
#pragma once

#include <vector>

#include "core/tree/systems/vessel_pieces.h"

namespace hepatica {

struct PieceSystem {
    VascularSystem system = VascularSystem::unknown;
    double confidence = 0.0;
};

// Links are split where the system of their pieces changes, each system gets copies of the nodes
// that it shares with another, and what passes straight through a node becomes one link. Links
// within a fork go to every system that needs them to hang together.
VesselGraph labelled_graph(const VesselGraph& graph, const PieceGraph& pieces,
                           const std::vector<PieceSystem>& systems);

}  // namespace hepatica
