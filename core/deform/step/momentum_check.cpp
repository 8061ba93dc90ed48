// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/momentum_check.h"

#include <algorithm>

#include "core/deform/potentials/self_friction.h"

namespace hepatica {
namespace {

bool any(std::span<const std::uint8_t> flags) {
    return std::ranges::any_of(flags, [](std::uint8_t flag) { return flag != 0; });
}

bool is_free(const Body& body, const PotentialList& potentials,
             std::span<const std::uint8_t> held) {
    return !any(held) && potentials.grabs().empty() && !potentials.tool() &&
           !potentials.obstacles() && body.damping.alpha_per_s == 0.0 &&
           std::ranges::all_of(body.tether_un_per_mm, [](double k) { return k == 0.0; });
}

}  // namespace

MomentumBalance momentum_balance(const Body& body, const StepUnderway& step,
                                 std::span<const std::uint8_t> held, std::span<const Vec3> after,
                                 std::span<const Vec3> elastic_force_un) {
    std::vector<Vec3> touch(after.size(), Vec3::Zero());
    if (step.potentials.self()) step.potentials.self()->add_forces(step.positions, touch);
    if (step.potentials.self_friction())
        step.potentials.self_friction()->add_forces(step.positions, touch);
    const bool free = is_free(body, step.potentials, held);
    MomentumBalance balance;
    Vec3 left = Vec3::Zero();
    for (std::size_t i = 0; i < after.size(); ++i) {
        const Vec3 impulse = step.dt_s * (free ? Vec3(elastic_force_un[i] + touch[i]) : touch[i]);
        balance.exchanged_g_mm_per_s += impulse.norm();
        left += free ? Vec3(body.mass_g[i] * (after[i] - step.start.velocities_mm_per_s[i] -
                                              step.dt_s * step.potentials.gravity_mm_per_s2()))
                     : impulse;
    }
    balance.error_g_mm_per_s = left.norm();
    return balance;
}

}  // namespace hepatica
