// SPDX-License-Identifier: GPL-3.0-or-later
// The deforming body as the scene sees it: it takes forces, advances in time steps, gives
// positions. Back ends (CPU, later CUDA) implement it. Not thread-safe: the simulation thread owns
// it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>

#include "core/base/vector.h"
#include "core/deform/body/body_state.h"
#include "core/deform/potentials/grab.h"
#include "core/deform/potentials/tool.h"
#include "core/deform/step/step_report.h"
#include "core/deform/stepper/stepper_options.h"
#include "core/tear/tear_state.h"

namespace hepatica {

class Tearing;             // core/tear/tearing.h
struct StepperCheckpoint;  // core/deform/stepper/stepper_checkpoint.h

class Stepper {
  public:
    virtual ~Stepper() = default;

    // These functions throw InputError for values out of range (see load_input.h, step_input.h,
    // stepper_input.h) and then change nothing.

    // Replaces all grabs from the next step on.
    virtual void set_grabs(std::span<const Grab> grabs) = 0;
    virtual void set_gravity(const Vec3& gravity_mm_per_s2) = 0;

    // Puts a tool beside the body, in the place of one that is there, or takes it away. Throws
    // where it would stand in the body or in a solid obstacle.
    virtual void set_tool(const std::optional<Tool>& tool) = 0;
    // Where its centre is to go in the next step, as far as what it meets lets it. Without a tool
    // it does nothing.
    virtual void lead_tool(const Vec3& target_mm) = 0;
    // How far it is to turn about its centre beside what it has still to turn, and how far its jaws
    // are to open, >= 0; as far as what it meets lets it, too.
    virtual void turn_tool(const Vec3& by_rad) = 0;
    virtual void open_tool(double opening_mm) = 0;
    // Where it is now, and what body and obstacles did to it in the last step.
    virtual const std::optional<Tool>& tool() const = 0;
    virtual const ToolLoad& tool_load() const = 0;

    // Returns false, and changes nothing, where these options need a new stepper, to which the
    // caller then gives the state. Throws InputError where the options are not valid.
    virtual bool set_options(const StepperOptions& options) = 0;

    // Advances the state by dt_s > 0. The state stays finite for every input. Throws Cancelled soon
    // after a stop was asked for: it looks before each substep, iterate and linear iteration, and
    // between columns of a factorisation. The state is then that of some moment of the step, and
    // only restore() may be called before another step.
    virtual StepReport step(double dt_s, const std::stop_token& stop = {}) = 0;

    // Whether a device makes the steps, apart from single ones that it leaves to the processor.
    // That may end with any step: devices fail.
    virtual bool on_device() const { return false; }

    // One per vertex of the mesh the stepper was built on.
    virtual std::span<const Vec3> positions_mm() const = 0;
    virtual std::span<const Vec3> velocities_mm_per_s() const = 0;

    // How the body is torn; null where it does not tear. While it does, vertices are added behind
    // the others: spans and states grow.
    virtual const Tearing* tearing() const { return nullptr; }
    // Of a body that tears; otherwise they do nothing.
    // Multiplies the limit of these joints by a factor, see Tearing::weaken.
    virtual void weaken(std::span<const int> /*joints*/, double /*factor*/) {}
    // Cuts along a parallelogram with this corner and these edges, see Tearing::crossing.
    virtual void cut(const Vec3& /*corner_mm*/, const Vec3& /*first_edge_mm*/,
                     const Vec3& /*second_edge_mm*/) {}
    // Makes it torn like that, whole by default; vertices come and go. The places of those that
    // stay are as before. Throws InputError, and changes nothing, where it is not of this mesh.
    virtual void set_tear(const TearState& /*state*/) {}

    // Kinetic, elastic, grab, tether and contact energy of the present state, and the tool_work
    // that the next step will report; all other terms are 0.
    virtual EnergyLedger energies() const = 0;

    // The state of every node: the vertices, then, in quadratic bodies, the middles of the edges.
    virtual BodyState state() const = 0;

    // Replaces the state. Takes one finite value per node as in state(), or one per vertex; edge
    // middles are then put halfway between their vertices. A tool must not stand in the body there.
    virtual void set_state(std::span<const Vec3> positions_mm,
                           std::span<const Vec3> velocities_mm_per_s) = 0;

    // Everything but body and options that determines later steps. Costs a copy of a few arrays.
    virtual StepperCheckpoint checkpoint() const = 0;

    // Continues from a checkpoint of a stepper with the same body and options; all later steps have
    // the same bits as there. Costs a factorisation. Throws InputError, and changes nothing, where
    // the checkpoint does not fit.
    virtual void restore(const StepperCheckpoint& checkpoint) = 0;

    // Hash of the checkpoint: steppers with equal hashes make equal steps.
    std::uint64_t state_hash() const;
};

}  // namespace hepatica
