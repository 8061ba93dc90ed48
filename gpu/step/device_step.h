// SPDX-License-Identifier: GPL-3.0-or-later
// The linearly implicit step of backward Euler, eq. (12), on a machine: what BackwardEuler and
// NewtonStep of core/deform do where one iterate is taken whole. State, forces, residuals and sums
// are double; the matrix and the vectors of its solver are float, or double for tests.
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
    // For each node 1 where it is fixed or frozen.
    virtual void set_held(std::span<const std::uint8_t> held) = 0;
    // The body has been torn: its elements have other corners, and it may have more nodes. Grabs
    // and weight stay, all but what is fixed is free; the state is to be set anew.
    virtual void follow_tear() = 0;
    // Of every node; held ones have velocity 0.
    virtual void set_state(const BodyState& state) = 0;
    virtual const BodyState& state() const = 0;

    // Makes a step of dt_s > 0 and fills the report as BackwardEuler::advance does. False where
    // its one iterate, taken whole, would make energy or could not be solved for: nothing has then
    // changed, and the step wants to be made by other means.
    // Throws Cancelled within some iterations after a stop was asked for; nothing has changed then,
    // either.
    virtual bool advance(double dt_s, const SolveLimits& limits, StepReport& report,
                         const std::stop_token& stop = {}) = 0;
    // After a step that was not made: why, in words; empty where it would have made energy or could
    // not be solved for.
    virtual const std::string& left_because() const = 0;

    virtual const SolveCost& solve_cost() const = 0;  // of the last step's linear solve

    // What the linear solver carries from one step to the next.
    virtual double solver_memory() const = 0;
    virtual void set_solver_memory(double memory) = 0;
};

// Throws DeviceError. The body has_kernels(). Keeps references to the body, which may be torn, and
// to the potentials, which are those of the body and have its tool and its grabs: they search for
// what touches, and what they keep of a step is there until their end_step(). With an empty
// skeleton the solver is preconditioned by the diagonal blocks alone.
std::unique_ptr<DeviceStep> make_device_step(Machine& machine, const Body& body,
                                             PotentialList& potentials,
                                             const CoarseSkeleton& skeleton, Precision precision);

}  // namespace hepatica::gpu
