// SPDX-License-Identifier: GPL-3.0-or-later
// What the host does for the contacts of a step on a machine: it says whether anything would pass
// through anything, which steps the CPU would begin otherwise, and what to report of them; by the
// potentials' own search, as BackwardEuler and NewtonStep of core/deform do.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/deform/potentials/potential_list.h"
#include "core/deform/step/energy_limiter.h"
#include "core/deform/step/step_report.h"
#include "gpu/step/step_balance.h"

namespace hepatica::gpu {

// Where the body would be after dt_s without a change of velocity.
std::vector<Vec3> places_ahead(const BodyState& state, double dt_s);

// Keeps references to both.
class ContactGuard {
  public:
    ContactGuard(const Body& body, PotentialList& potentials)
        : body_(body), potentials_(potentials) {}

    // Whether the body may touch anything or tear; without, nothing else is to be called.
    bool any() const {
        return potentials_.tool() || potentials_.self() || potentials_.obstacles() ||
               potentials_.ties();
    }
    // See Potential.
    double share_until_touch(const BodyState& state, double dt_s) const {
        return potentials_.share_until_touch(state.positions_mm, places_ahead(state, dt_s));
    }
    // After a prediction that failed: whether the CPU would begin at the velocity of the centre of
    // mass.
    bool flies_into_itself(const Underway& step, std::span<const std::uint8_t> held) const;
    // Whether pieces of the body would not take a step that ends with these velocities.
    bool overdrawn(const EnergyLimiter& limiter, const Underway& step,
                   const std::vector<Vec3>& velocities, std::span<const std::uint8_t> held) const;
    // Of a step that ended with these velocities; elastic forces are asked for where surfaces touch
    // each other.
    void report(const Underway& step, const std::vector<Vec3>& velocities,
                std::span<const std::uint8_t> held,
                const std::function<std::vector<Vec3>()>& elastic_force_un,
                StepReport& report) const;

  private:
    const Body& body_;
    PotentialList& potentials_;
};

}  // namespace hepatica::gpu
