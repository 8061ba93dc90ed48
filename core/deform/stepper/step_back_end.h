// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic of a body's steps, on one kind of machine: a state, the forces on it, one step of
// the clock. What is computed and when (substeps, sleep, the live region, recovery from inversion)
// is decided above it, in GovernedStepper, once for all back ends.
// Not thread-safe: the simulation thread owns it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body.h"
#include "core/deform/body/body_state.h"
#include "core/deform/potentials/grab.h"
#include "core/deform/step/step_report.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/deform/stepper/stepper_options.h"

namespace hepatica {

class StepBackEnd {
  public:
    virtual ~StepBackEnd() = default;

    // As built from the description: nodes, masses, elements.
    virtual const Body& body() const = 0;

    // From the next step on. What is out of range was refused above.
    virtual void set_grabs(std::span<const Grab> grabs) = 0;
    virtual void set_gravity(const Vec3& gravity_mm_per_s2) = 0;
    // False where these options need another back end.
    virtual bool set_options(const StepperOptions& options) = 0;
    // Freezes the nodes with frozen[i] != 0 where they are, and no others. Their velocities are 0.
    virtual void freeze(std::span<const std::uint8_t> frozen) = 0;
    virtual int live_elements() const = 0;

    // One step of dt_s > 0; fills everything in the report but tool_work. The work of a step is
    // bounded, see BackwardEuler::advance. Energies are those of the whole body.
    virtual StepReport advance(double dt_s) = 0;

    // Puts right what settled inside out, if anything is, and books it in the report of the step
    // that was just made; the body is then at rest. False where nothing was done.
    virtual bool recover_from_inversion(StepReport& report) = 0;

    // Every node. Where the state lies on a device, asking for it reads it back, once after a step;
    // nothing else does.
    virtual const BodyState& state() const = 0;
    virtual void set_state(const BodyState& state) = 0;
    // The velocities alone.
    virtual void set_velocities(const std::vector<Vec3>& velocities_mm_per_s) = 0;

    // Of the present state: kinetic, elastic, grab and tether; the rest is 0.
    virtual EnergyLedger energies() const = 0;
    // Of the grabs alone, and of everything that moves [nJ].
    virtual double grab_energy() const = 0;
    virtual double kinetic_energy() const = 0;

    // What the linear solver carries from step to step. restore() throws InputError where it does
    // not fit, and then changes nothing.
    virtual SolverCheckpoint checkpoint() const = 0;
    virtual void restore(const SolverCheckpoint& checkpoint) = 0;
};

}  // namespace hepatica
