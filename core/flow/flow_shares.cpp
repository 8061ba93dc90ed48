// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/flow_shares.h"

#include <cmath>
#include <cstddef>

#include "core/base/error.h"
#include "core/base/units.h"
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
        // A parent stands before its children.
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

}  // namespace hepatica
