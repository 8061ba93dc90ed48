// SPDX-License-Identifier: GPL-3.0-or-later
// One step of backward Euler. The published step, eq. (12), is one Newton iterate from the current
// state:  (M + dt B + dt^2 K) dv = dt f - dt B v - dt^2 K v,  v += dv,  x += dt v.  More iterates
// minimise the incremental potential (incremental_potential.h) with a line search that never
// accepts an increase. The work of one step is bounded in linear solves, not by the clock.
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
    // To be called after the body's nodes were split; `before` is the body until then, `parents` as
    // in TornBody. The result is that of a new object with the same solver, but what splits do not
    // change is kept.
    void follow_split(const Body& before, std::span<const int> parents);

    // Advances `state` by dt_s > 0 under `potentials` and fills the report except tool_work, which
    // only the caller knows. A step that cannot be made without an increase of the incremental
    // potential or of some pieces' energy (or, where surfaces may touch, without taking a free
    // piece's momentum) is repeated in halves, and these again, within iterations + extra_solves
    // linear solves. When they are used up, the shortened step is taken or the body is stopped.
    // Energy is never created (except by the published step without line search), and positions
    // stay finite; the report says what was done. Where a contact is about to begin, the step is
    // cut at that moment, into at most four parts that share the solves. What potentials keep of a
    // step stays until their end_step(). Throws Cancelled within a few iterations after a stop is
    // requested. The state is then one within the step: set the state and restore the solver before
    // the next step.
    StepReport advance(BodyState& state, double dt_s, const PotentialList& potentials,
                       const std::stop_token& stop = {});

    // Takes effect with the next step. Switching between one iterate and several needs a new
    // object, because the tangent differs.
    void set_settings(const NewtonSettings& settings);

    // Energy of elements and potentials at any positions, with weight counted from rest [nJ].
    double potential_energy(std::span<const Vec3> positions_mm,
                            const PotentialList& potentials) const;

    // Elastic energy alone [nJ].
    double elastic_energy(std::span<const Vec3> positions_mm) const {
        return potential_.assembly().energy(positions_mm);
    }

    // Stress and energy of each tetrahedron at the state; see ElementSlots::find_stress.
    void find_stress(const BodyState& state, std::vector<Mat3>& stress_pa,
                     std::vector<double>& energy_nj);

    // To be called after the state was changed from outside.
    void forget() { energies_known_ = forces_known_ = false; }

    // Freezes exactly these nodes from the next step on; their velocities must be 0.
    void freeze(std::span<const std::uint8_t> frozen);
    const LiveSet& live() const { return potential_.live(); }

    // The state that the linear solver carries from step to step. restore() recomputes its factor
    // to the same bits; it throws InputError and changes nothing where the checkpoint does not fit
    // the body or the solver.
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
    // False where a piece is left with more energy than its motion can give back.
    bool decline(StepUnderway& step, StepReport& report);
    void stand_still(StepUnderway& step, StepReport& report);
    MomentumLost limit_energy(const StepUnderway& step, std::vector<Vec3>& velocities,
                              StepReport& report);

    const Body& body_;
    NewtonSettings settings_;
    IncrementalPotential potential_;
    // Always set; made anew when the body tears.
    std::optional<NewtonStep> newton_;
    std::optional<StepBooks> books_;
    std::optional<EnergyLimiter> limiter_;
    std::stop_token stop_;  // of the current step
    // Whether the potential was evaluated at the state: the energies of all elements; the forces on
    // live nodes.
    bool energies_known_ = false, forces_known_ = false;
};

}  // namespace hepatica
