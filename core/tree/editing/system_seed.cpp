// SPDX-License-Identifier: GPL-3.0-or-later
// Describes a seed to spread_of_seed() and relabels the graph with the result.
#include "core/tree/editing/system_seed.h"

#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/patient_space.h"
#include "core/tree/systems/seeded_spread.h"

namespace hepatica {

namespace {

int piece_of(const PieceGraph& graph, const SystemSeed& seed) {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < graph.pieces.size(); ++i) {
        const double away = (graph.pieces[i].centre_mm - seed.at_mm).norm();
        if (graph.pieces[i].link != seed.at.segment || away >= least) continue;
        least = away;
        nearest = static_cast<int>(i);
    }
    if (nearest < 0)
        throw InputError("vessels meet here, and it is not clear which of them is meant",
                         place_text(seed.at_mm), "Name a place on the vessel away from the fork");
    return nearest;
}

// What lies downstream of the seed, and the root segment that it is cut from. A seed on the root's
// own segment has no such opponent: it decides for the whole tree.
SeededVessel seeded_vessel(const VesselTree& tree, const PieceGraph& graph,
                           const SystemSeed& seed) {
    SeededVessel vessel{piece_of(graph, seed), seed.system, {}, {}};
    const std::vector<std::uint8_t> hangs = downstream_of(tree, seed.at.segment);
    int root = seed.at.segment;
    while (tree.segments[root].parent >= 0) root = tree.segments[root].parent;
    for (int i = 0; i < std::ssize(graph.pieces); ++i) {
        const int link = graph.pieces[i].link;
        const bool is_upstream = link == seed.at.segment && i < vessel.piece;
        vessel.downstream.push_back(hangs[link] != 0 && !is_upstream ? 1 : 0);
        vessel.fixed.push_back(link == root && link != seed.at.segment ? 1 : 0);
    }
    return vessel;
}

}  // namespace

SeededGraph seeded_graph(const VesselTree& tree, const VesselGraph& graph, const SystemSeed& seed) {
    if (tree.segments[seed.at.segment].system == seed.system)
        throw InputError("the vessel is of that system already: " + title_of(seed.system),
                         place_text(seed.at_mm), "Name another vessel, or another system");
    const PieceGraph pieces = pieces_of(graph, nullptr);
    std::vector<PieceSystem> systems;
    for (const VesselPiece& piece : pieces.pieces)
        systems.push_back(
            {tree.segments[piece.link].system, tree.segments[piece.link].system_confidence});
    const std::vector<std::uint8_t> changed =
        spread_of_seed(pieces, systems, seeded_vessel(tree, pieces, seed));
    std::optional<Vec3> begin_mm;
    for (std::size_t i = 0; i < changed.size(); ++i) {
        if (changed[i] == 0) continue;
        systems[i] = {seed.system, seed.system == VascularSystem::unknown ? 0.0 : 1.0};
        const VesselPiece& piece = pieces.pieces[i];
        if (!begin_mm) begin_mm = graph.links[piece.link].points_mm[piece.first_point];
    }
    return {labelled_graph(graph, pieces, systems), begin_mm.value_or(seed.at_mm)};
}

}  // namespace hepatica
