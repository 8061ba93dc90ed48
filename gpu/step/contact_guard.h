// SPDX-License-Identifier: GPL-3.0-or-later
// The host's part in the contacts of a step on a machine: whether surfaces would pass through each
// other, which steps the CPU would begin differently, and what to report. Uses the potentials' own
// search, as BackwardEuler and NewtonStep of core/deform do.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/deform/potentials/potential_list.h"
#include "core/deform/step/energy_limiter.h"
#include "core/deform/step/step_report.h"
#include "gpu/step/step_balance.h"

namespace hepatica::gpu {

// Positions after dt_s without a change of velocity.
std::vector<Vec3> places_ahead(const BodyState& state, double dt_s);

// Keeps references to both arguments. Not thread-safe.
class ContactGuard {
  public:
    ContactGuard(const Body& body, PotentialList& potentials)
        : body_(body), potentials_(potentials) {}

    // Whether the body may touch anything or tear; if not, the other functions must not be called.
    bool any() const {
        return potentials_.tool() || potentials_.self() || potentials_.obstacles() ||
               potentials_.ties();
    }
    // See Potential::share_until_touch().
    double share_until_touch(const BodyState& state, double dt_s) const {
        return potentials_.share_until_touch(state.positions_mm, places_ahead(state, dt_s));
    }
    // For a step whose prediction failed: whether the CPU would begin at the velocity of the centre
    // of mass.
    bool flies_into_itself(const Underway& step, std::span<const std::uint8_t> held) const;
    // Whether a step with these final velocities would violate the energy or momentum balance of a
    // piece of the body.
    bool overdrawn(const EnergyLimiter& limiter, const Underway& step,
                   const std::vector<Vec3>& velocities, std::span<const std::uint8_t> held) const;
    // Reports a step that ended with these velocities. Elastic forces are requested only where the
    // body has self-contact or ties.
    void report(const Underway& step, const std::vector<Vec3>& velocities,
                std::span<const std::uint8_t> held,
                const std::function<std::vector<Vec3>()>& elastic_force_un,
                StepReport& report) const;

  private:
    const Body& body_;
    PotentialList& potentials_;
};

}  // namespace hepatica::gpu
