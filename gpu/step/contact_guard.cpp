// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/contact_guard.h"

#include "core/deform/potentials/obstacle_contact.h"
#include "core/deform/potentials/self_contact.h"
#include "core/deform/step/momentum_check.h"
#include "core/deform/step/rigid_motion.h"

namespace hepatica::gpu {
namespace {

StepUnderway in_terms_of_core(const Underway& step, const PotentialList& potentials,
                              const std::vector<Vec3>& velocities) {
    return {.potentials = potentials,
            .start = step.start,
            .dt_s = step.dt_s,
            .before = {},
            .velocity = velocities,
            .positions = step.to_mm};
}

}  // namespace

std::vector<Vec3> places_ahead(const BodyState& state, double dt_s) {
    std::vector<Vec3> ahead(state.positions_mm.size());
    for (std::size_t i = 0; i < ahead.size(); ++i)
        ahead[i] = state.positions_mm[i] + dt_s * state.velocities_mm_per_s[i];
    return ahead;
}

bool ContactGuard::flies_into_itself(const Underway& step,
                                     std::span<const std::uint8_t> held) const {
    return potentials_.self() && !potentials_.tool() && step.before.sum(Energies::kinetic) > 0.0 &&
           common_velocity(body_.mass_g, held, step.start.velocities_mm_per_s) &&
           (potentials_.coupled(step.to_mm) ||
            potentials_.free_share(step.from_mm, step.to_mm) < 1.0);
}

bool ContactGuard::overdrawn(const EnergyLimiter& limiter, const Underway& step,
                             const std::vector<Vec3>& velocities,
                             std::span<const std::uint8_t> held) const {
    if (limiter.pieces() == 1) return false;
    // Contacts at the end join pieces.
    if (potentials_.self()) potentials_.self()->contacts(step.to_mm);
    return !limiter
                .overdrawn(in_terms_of_core(step, potentials_, velocities), step.before.by_piece(),
                           step.after.by_piece(), held)
                .empty();
}

void ContactGuard::report(const Underway& step, const std::vector<Vec3>& velocities,
                          std::span<const std::uint8_t> held,
                          const std::function<std::vector<Vec3>()>& elastic_force_un,
                          StepReport& report) const {
    const std::vector<Vec3>& end = step.to_mm;
    report.tool = potentials_.tool_load(end, step.dt_s);
    if (potentials_.self() || potentials_.ties()) {
        const MomentumBalance balance =
            momentum_balance(body_, in_terms_of_core(step, potentials_, velocities), held,
                             velocities, elastic_force_un());
        report.momentum_error_g_mm_per_s = balance.error_g_mm_per_s;
        report.momentum_exchanged_g_mm_per_s = balance.exchanged_g_mm_per_s;
    }
    if (potentials_.self()) {
        report.self = load_of(potentials_.self()->contacts(end));
        report.self_cost = potentials_.self()->pairs().take_cost();
    }
    if (potentials_.obstacles()) {
        report.obstacles = potentials_.obstacle_load(end);
        report.obstacles.impulse_un_s = step.dt_s * report.obstacles.force_un;
        report.obstacle_cost = potentials_.obstacles()->pairs().take_cost();
    }
}

}  // namespace hepatica::gpu
