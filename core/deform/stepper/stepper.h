// SPDX-License-Identifier: GPL-3.0-or-later
// What the scene knows of a deforming body: forces in, one step of the clock, positions out.
// Back ends (CPU, later CUDA) implement it. Not thread-safe: the simulation thread owns it.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/vector.h"
#include "core/deform/body/body_state.h"
#include "core/deform/potentials/grab.h"
#include "core/deform/step/step_report.h"
#include "core/deform/stepper/stepper_options.h"

namespace hepatica {

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

    // Of the present state: kinetic, elastic, grab and tether, and the tool_work that the next step
    // will report; the rest is 0.
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
