// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/flow_shares.h"

#include <cmath>
#include <cstddef>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/base/vascular_system.h"
#include "core/flow/flow_solution.h"

namespace hepatica {
namespace {

// Portal vein at rest, 945 mL/min (Carlisle 1992, at 70 kg).
constexpr double resting_flow_mm3_s = 945.0 * units::millilitre_per_minute;

}  // namespace

std::vector<double> flow_shares(const VesselTree& tree) {
    try {
        const FlowNetwork network = network_of(tree);
        FlowConditions conditions;
        conditions.resident = pure(blood());
        for (const int root : network.root_nodes) {
            conditions.inlets.push_back({root, InletKind::mass_flow,
                                         resting_flow_mm3_s * conditions.resident.density_g_mm3,
                                         conditions.resident});
        }
        const FlowSolution solution = solve_flow(network, conditions);
        std::vector<double> shares(tree.segments.size(), 0.0);
        std::vector<double> inflow(tree.segments.size(), 0.0);
        // A parent precedes its children.
        for (std::size_t s = 0; s < shares.size(); ++s) {
            const int parent = tree.segments[s].parent;
            const double flow = std::abs(solution.volume_flow_mm3_s[s]);
            inflow[s] = parent < 0 ? flow : inflow[static_cast<std::size_t>(parent)];
            shares[s] = inflow[s] > 0.0 ? flow / inflow[s] : 0.0;
        }
        return shares;
    } catch (const Error&) {
        return {};
    }
}

std::vector<std::string> warnings_of_ends(const VesselTree& tree,
                                          const std::vector<double>& shares) {
    constexpr double too_much = 0.5;
    constexpr int fewest_ends = 4;
    std::vector<std::string> warnings;
    if (shares.size() != tree.segments.size()) return warnings;
    // A segment that closes a loop has no children, though its vessel goes on at its end.
    const std::vector<int> degrees = node_degrees(tree);
    const auto is_end = [&](std::size_t s) {
        return degrees[static_cast<std::size_t>(tree.segments[s].distal_node)] == 1;
    };
    std::vector<int> root(shares.size()), ends(shares.size(), 0);
    for (std::size_t s = 0; s < shares.size(); ++s) {
        const int parent = tree.segments[s].parent;
        root[s] = parent < 0 ? static_cast<int>(s) : root[static_cast<std::size_t>(parent)];
        if (is_end(s)) ++ends[static_cast<std::size_t>(root[s])];
    }
    for (std::size_t s = 0; s < shares.size(); ++s) {
        if (!is_end(s) || !(shares[s] > too_much) ||
            ends[static_cast<std::size_t>(root[s])] < fewest_ends)
            continue;
        warnings.push_back("Branch " + std::to_string(s + 1) + " is an end and takes " +
                           std::to_string(std::lround(100.0 * shares[s])) +
                           " % of the flow of its tree (" + title_of(tree.segments[s].system) +
                           ", root: branch " + std::to_string(root[s] + 1) +
                           "): it may be cut off there, or blood may come in by it. "
                           "Delete it, or set the root there; else drugs go the wrong way.");
    }
    return warnings;
}

}  // namespace hepatica
