// SPDX-License-Identifier: GPL-3.0-or-later
// What the scene knows of a deforming body: forces in, one step of the clock, positions out.
// Back ends (CPU, later CUDA) implement it. Not thread-safe: the simulation thread owns it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body_state.h"
#include "core/deform/stepper/stepper_options.h"

namespace hepatica {

// A compliant pull: a spring of limited force between a point of the body and a target. Never a
// prescribed position, so that no speed of the mouse can make the body explode.
struct Grab {
    std::array<int, 4> vertices{-1, -1, -1, -1};  // the held point is their weighted mean
    std::array<double, 4> weights{1, 0, 0, 0};    // sum 1
    Vec3 target_mm = Vec3::Zero();
    double stiffness_un_per_mm = 0.0;  // micronewton per millimetre, > 0
    double force_limit_un = 0.0;       // micronewton, > 0
};

// Energies in nanojoule (g mm2/s2) at the end of the step; the ledger's terms over the step.
struct EnergyLedger {
    double kinetic = 0.0;
    double elastic = 0.0;
    double grab = 0.0;             // stored in grab springs and tethers
    double gravity_work = 0.0;     // done on the body during the step
    double tool_work = 0.0;        // done by moving targets during the step
    double damping_loss = 0.0;     // >= 0
    double integrator_loss = 0.0;  // dissipated by backward Euler
    double unfolding_loss = 0.0;   // given up where elements inside out were put right, >= 0
    double solver_work = 0.0;      // done by the forces that the linear solver left unbalanced,
                                   // and by E of eq. (11) where it is used
    double imbalance = 0.0;        // what does not add up; 0 but for rounding
};

struct StepReport {
    double dt_s = 0.0;
    int newton_iterations = 0;
    int linear_iterations = 0;         // 0 for a direct solve
    double linear_residual = 0.0;      // relative, achieved
    double linear_energy_error = 0.0;  // relative estimate in the energy norm, achieved
    bool degraded = false;             // a line search failed or the budget ran out
    bool asleep = false;               // nothing moved: the step was skipped
    std::string message;               // why degraded, in words
    EnergyLedger energy;
};

struct StepperCheckpoint;  // core/deform/stepper/stepper_checkpoint.h

class Stepper {
  public:
    virtual ~Stepper() = default;

    // What is out of range (see stepper_input.h) throws InputError here and in the functions below,
    // and changes nothing.

    // Replaces all grabs; applies from the next step on.
    virtual void set_grabs(std::span<const Grab> grabs) = 0;
    virtual void set_gravity(const Vec3& gravity_mm_per_s2) = 0;

    // Changes what can be changed without touching the state; false where another stepper has to be
    // made and given the state. Throws InputError where the options are not valid.
    virtual bool set_options(const StepperOptions& options) = 0;

    // Advances the state by dt_s > 0. The state stays finite whatever happens.
    virtual StepReport step(double dt_s) = 0;

    // One per vertex of the mesh the stepper was built on.
    virtual std::span<const Vec3> positions_mm() const = 0;
    virtual std::span<const Vec3> velocities_mm_per_s() const = 0;

    // Of the present state: kinetic, elastic and grab, and the tool_work that the next step will
    // report; the rest is 0.
    virtual EnergyLedger energies() const = 0;

    // Every node, the vertices first: what a snapshot keeps. Quadratic bodies have the middles of
    // their edges behind the vertices.
    virtual BodyState state() const = 0;

    // Replaces the state: for resets, snapshots and replays. One value per vertex (middles of edges
    // are then placed on their straight middles) or one per node as in state(); all finite.
    virtual void set_state(std::span<const Vec3> positions_mm,
                           std::span<const Vec3> velocities_mm_per_s) = 0;

    // Everything that determines the steps to come, apart from the body and the options. Costs a
    // copy of a few arrays, never a factorisation.
    virtual StepperCheckpoint checkpoint() const = 0;

    // Goes on from a checkpoint with the same bits as the stepper it was taken from, which must
    // have been made of the same body and have had the same options. Costs a factorisation. Throws
    // InputError where the checkpoint cannot be of such a stepper, and then changes nothing.
    virtual void restore(const StepperCheckpoint& checkpoint) = 0;

    // Of all that the checkpoint holds: equal hashes, equal steps to come.
    std::uint64_t state_hash() const;
};

}  // namespace hepatica
