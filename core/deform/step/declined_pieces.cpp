// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/declined_pieces.h"

#include <algorithm>
#include <utility>

#include "core/deform/step/rigid_motion.h"

namespace hepatica {

DeclinedPieces::DeclinedPieces(const Body& body, const EnergyLimiter& limiter,
                               const StepUnderway& step)
    : body_(body), limiter_(limiter), step_(step), group_of_(step.velocity.size(), -1) {}

bool DeclinedPieces::add(std::span<const EnergyLimiter::Overdrawn> overdrawn) {
    bool changed = false;
    for (const EnergyLimiter::Overdrawn& pieces : overdrawn) changed |= add(pieces);
    return changed;
}

bool DeclinedPieces::add(const EnergyLimiter::Overdrawn& pieces) {
    const std::vector<int> met = groups_in(pieces.nodes);
    // What has joined others has not its own momentum any more; only energy matters then.
    if (!met.empty() && !pieces.unpaid) return false;
    Group all{.flies = pieces.flies};
    for (const int i : pieces.nodes)
        if (group_of_[i] < 0) all.nodes.push_back(i);
    const bool same = met.size() == 1 && all.nodes.empty();
    // On its flight it made energy by itself.
    if (same) all.flies = false;
    if (same && !groups_[met[0]].flies) return false;
    for (const int g : met) {
        Group joined = std::exchange(groups_[g], {});
        all.flies &= joined.flies;
        all.nodes.insert(all.nodes.end(), joined.nodes.begin(), joined.nodes.end());
    }
    for (const int i : all.nodes) group_of_[i] = static_cast<int>(groups_.size());
    groups_.push_back(std::move(all));
    return true;
}

// Ascending.
std::vector<int> DeclinedPieces::groups_in(const std::vector<int>& nodes) const {
    std::vector<int> found;
    for (const int i : nodes)
        if (group_of_[i] >= 0) found.push_back(group_of_[i]);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::vector<Vec3> DeclinedPieces::velocities() const {
    std::vector<Vec3> all = step_.velocity;
    const BodyState& start = step_.start;
    for (const auto& [nodes, flies] : groups_) {
        std::vector<Vec3> ways(nodes.size(), Vec3::Zero());
        if (flies && !nodes.empty()) {
            RigidMotion motion =
                rigid_motion(nodes, body_.mass_g, start.positions_mm, start.velocities_mm_per_s);
            motion.velocity_mm_per_s = limiter_.flight(step_, motion.velocity_mm_per_s);
            ways = straight_ways(motion, nodes, start.positions_mm, step_.dt_s);
        }
        for (std::size_t k = 0; k < nodes.size(); ++k) all[nodes[k]] = ways[k];
    }
    return all;
}

}  // namespace hepatica
