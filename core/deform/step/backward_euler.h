// SPDX-License-Identifier: GPL-3.0-or-later
// One step of backward Euler. The published step, eq. (12), is one Newton iterate from the state at
// hand:  (M + dt B + dt^2 K) dv = dt f - dt B v - dt^2 K v,  v += dv,  x += dt v.  More iterates
// minimise the incremental potential (incremental_potential.h) with a line search that never
// accepts an increase. The work of one step is bounded in linear solves, never by the clock.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/body/body_state.h"
#include "core/deform/potentials/potential_list.h"
#include "core/deform/step/energy_limiter.h"
#include "core/deform/step/newton_step.h"
#include "core/deform/step/step_books.h"

namespace hepatica {

// Advances one body. Keeps a reference to the body. Not thread-safe.
class BackwardEuler {
  public:
    BackwardEuler(const Body& body, const NewtonSettings& settings,
                  std::unique_ptr<LinearSolver> solver);
    // The body's nodes were split, `parents` says how (see TornBody); it was as `before`. Gives
    // what would be made anew with the solver, which knows of it, and keeps what splits do not
    // change.
    void follow_split(const Body& before, std::span<const int> parents);

    // Advances `state` by dt_s > 0 under `potentials`; fills everything in the report but
    // tool_work, which only the caller knows. A step that cannot be made without an increase of the
    // incremental potential (or, where surfaces may touch, of a free piece's energy) is tried again
    // in halves, and those again, as far as iterations + extra_solves linear solves reach; where
    // they end, the shortened step stands or the body is stopped. Energy is never made (but as
    // published) and positions stay finite; the report says what was done. Where the body flies
    // against a tool, the step is cut where it touches, into four parts at most, which share the
    // solves. What potentials keep of a step is there until their end_step().
    // Throws Cancelled soon after a stop was asked for, within a few iterations. The state is then
    // that of some moment of the step: it is to be set, and the solver restored, before the next.
    StepReport advance(BodyState& state, double dt_s, const PotentialList& potentials,
                       const std::stop_token& stop = {});

    // Holds from the next step on. The change between one iterate and several needs a new object,
    // because the tangent differs.
    void set_settings(const NewtonSettings& settings);

    // Energy of elements and potentials at any positions, weight counted from rest [nJ].
    double potential_energy(std::span<const Vec3> positions_mm,
                            const PotentialList& potentials) const;

    // That of the elements alone [nJ].
    double elastic_energy(std::span<const Vec3> positions_mm) const {
        return potential_.assembly().energy(positions_mm);
    }

    // Stress and energy of each tetrahedron at the state, see ElementSlots::find_stress.
    void find_stress(const BodyState& state, std::vector<Mat3>& stress_pa,
                     std::vector<double>& energy_nj);

    // To be called after the state was changed from outside.
    void forget() { energies_known_ = forces_known_ = false; }

    // Freezes these nodes and no others, from the next step on; their velocities must be 0.
    void freeze(std::span<const std::uint8_t> frozen);
    const LiveSet& live() const { return potential_.live(); }

    // What the linear solver carries from step to step. restore() makes its factor anew to the bit;
    // it throws InputError where the checkpoint does not fit the body or the solver, and then
    // changes nothing.
    SolverCheckpoint checkpoint() const { return newton_->checkpoint(); }
    void restore(const SolverCheckpoint& checkpoint) {
        forget();
        newton_->restore(checkpoint);
    }

  private:
    void make_parts(std::unique_ptr<LinearSolver> solver);
    void know_forces(const BodyState& state);
    double share_until_touch(const BodyState& state, double dt_s,
                             const PotentialList& potentials) const;
    StepReport advance_in_parts(BodyState& state, double dt_s, const PotentialList& potentials,
                                int halvings_left, int most_solves);
    StepReport advance_in_halves(BodyState& state, double dt_s, const PotentialList& potentials,
                                 int halvings_left, int solves_left, const StepReport& tried);
    void decline(StepUnderway& step, StepReport& report);
    MomentumLost limit_energy(const StepUnderway& step, std::vector<Vec3>& velocities,
                              StepReport& report);

    const Body& body_;
    NewtonSettings settings_;
    IncrementalPotential potential_;
    // Always there; made anew when the body tears.
    std::optional<NewtonStep> newton_;
    std::optional<StepBooks> books_;
    std::optional<EnergyLimiter> limiter_;
    std::stop_token stop_;  // of the step that is being made
    // The potential was evaluated at the state: the energies of all elements, and the forces on
    // live nodes.
    bool energies_known_ = false, forces_known_ = false;
};

}  // namespace hepatica
