// SPDX-License-Identifier: GPL-3.0-or-later
// The linearly implicit backward Euler step, eq. (12), on a machine: the case of BackwardEuler and
// NewtonStep of core/deform in which one full Newton iterate is accepted. State, forces, residuals
// and sums are double; the matrix and the solver's vectors are float, or double for tests.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <string>

#include "core/deform/body/body.h"
#include "core/deform/body/body_state.h"
#include "core/deform/potentials/grab.h"
#include "core/deform/potentials/potential_list.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/deform/step/step_report.h"
#include "gpu/machine/machine.h"
#include "gpu/step/device_solver.h"

namespace hepatica::gpu {

enum class Precision { single_precision, double_precision };

// Not thread-safe.
class DeviceStep {
  public:
    virtual ~DeviceStep() = default;

    virtual void set_grabs(std::span<const Grab> grabs) = 0;
    virtual void set_gravity(const Vec3& gravity_mm_per_s2) = 0;
    // 1 for each node that is fixed or frozen.
    virtual void set_held(std::span<const std::uint8_t> held) = 0;
    // To be called after the body was torn: its elements have other corners, and it may have more
    // nodes. Grabs and gravity are kept, and only fixed nodes are held; set_state() must follow.
    virtual void follow_tear() = 0;
    // Positions and velocities of every node; held nodes must have velocity 0.
    virtual void set_state(const BodyState& state) = 0;
    virtual const BodyState& state() const = 0;

    // Makes a step of dt_s > 0 and fills the report as BackwardEuler::advance() does. Returns
    // false, with the state unchanged, where its single full iterate would increase the energy or
    // could not be solved for; the step must then be made by other means. Throws Cancelled
    // within some iterations after a stop was requested; set_state() must follow then.
    virtual bool advance(double dt_s, const SolveLimits& limits, StepReport& report,
                         const std::stop_token& stop = {}) = 0;
    // The reason why the last step was not made, in words; empty where it would have increased the
    // energy or could not be solved for.
    virtual const std::string& left_because() const = 0;

    // Of the last step's linear solves: one, or one for each part of a step that is split at an
    // impact.
    virtual const SolveCost& solve_cost() const = 0;

    // The value that the linear solver carries from one step to the next.
    virtual double solver_memory() const = 0;
    virtual void set_solver_memory(double memory) = 0;
};

// Requires has_kernels(body). Throws DeviceError. Keeps references to the body, which may be torn,
// and to its potentials with their tool and grabs, whose search finds the contacts; what they store
// for a step is valid until their end_step(). With an empty skeleton the solver is preconditioned
// by the diagonal blocks alone.
std::unique_ptr<DeviceStep> make_device_step(Machine& machine, const Body& body,
                                             PotentialList& potentials,
                                             const CoarseSkeleton& skeleton, Precision precision);

}  // namespace hepatica::gpu
