// SPDX-License-Identifier: GPL-3.0-or-later
// Formulates the spread of a seed as a Potts problem with two labels, stay and change.
#include "core/tree/systems/seeded_spread.h"

#include <Eigen/Geometry>

#include "core/base/disjoint_sets.h"
#include "core/tree/systems/anatomical_anchors.h"
#include "core/tree/systems/potts_labelling.h"
#include "core/tree/systems/system_evidence.h"

namespace hepatica {

namespace {

constexpr double never = 1e4;  // log odds that exclude a label
constexpr int stays = 0, changes = 1;

// For each piece, log odds of its present system over the seed's; 0 unless both are veins, because
// anatomy gives no evidence for others.
std::vector<double> evidence_to_stay(const PieceGraph& graph, VascularSystem from,
                                     VascularSystem to) {
    const bool veins = (from == VascularSystem::portal && to == VascularSystem::hepatic) ||
                       (from == VascularSystem::hepatic && to == VascularSystem::portal);
    if (!veins) return std::vector<double>(graph.pieces.size(), 0.0);
    Eigen::AlignedBox3d box;
    for (const VesselPiece& piece : graph.pieces) box.extend(piece.centre_mm);
    std::vector<double> odds = evidence_for_hepatic(graph, find_anchors(graph.pieces, box));
    if (from == VascularSystem::portal)
        for (double& value : odds) value = -value;
    return odds;
}

}  // namespace

std::vector<std::uint8_t> spread_of_seed(const PieceGraph& graph,
                                         const std::vector<PieceSystem>& now,
                                         const SeededVessel& seed) {
    const VascularSystem from = now[seed.piece].system;
    const std::vector<double> evidence = evidence_to_stay(graph, from, seed.system);
    PottsProblem problem;
    problem.ties = ties_between(graph);
    for (int i = 0; i < std::ssize(graph.pieces); ++i) {
        std::vector<double> cost{0.0, 0.0};
        if (i == seed.piece || now[i].system == seed.system)
            cost[stays] = never;
        else if (now[i].system != from || seed.fixed[i] != 0)
            cost[changes] = never;
        else if (seed.downstream[i] == 0)
            cost[changes] = evidence[i];
        problem.costs.push_back(std::move(cost));
    }
    const std::vector<int> labels = least_energy_labels(problem);
    // Only pieces connected to the seed through vessels of the same present system change.
    const auto free = [&](int i) { return labels[i] == changes && now[i].system == from; };
    DisjointSets parts(labels.size());
    for (const Tie& tie : problem.ties)
        if (free(tie.a) && free(tie.b))
            parts.unite(static_cast<std::uint32_t>(tie.a), static_cast<std::uint32_t>(tie.b));
    const auto seeded = parts.root(static_cast<std::uint32_t>(seed.piece));
    std::vector<std::uint8_t> changed(labels.size(), 0);
    for (std::uint32_t i = 0; i < labels.size(); ++i)
        changed[i] = free(static_cast<int>(i)) && parts.root(i) == seeded ? 1 : 0;
    return changed;
}

}  // namespace hepatica
