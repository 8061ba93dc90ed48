// SPDX-License-Identifier: GPL-3.0-or-later
// The deformable body as the scene sees it: it takes forces, advances in time steps and gives
// positions. GovernedStepper implements it for all back ends (step_back_end.h). Not thread-safe:
// the simulation thread owns it.
#pragma once

#include <cstdint>
#include <functional>
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

    // Adds a tool, replaces the present one, or removes it. Throws where the tool would stand in
    // the body or in a solid obstacle.
    virtual void set_tool(const std::optional<Tool>& tool) = 0;
    // Sets the target of the tool's centre for the next step; contact may stop the tool before.
    // Does nothing without a tool.
    virtual void lead_tool(const Vec3& target_mm) = 0;
    // turn_tool() adds a rotation about the tool's centre to the remaining one; open_tool() sets
    // the target opening of its jaws, >= 0. Contact may stop both.
    virtual void turn_tool(const Vec3& by_rad) = 0;
    virtual void open_tool(double opening_mm) = 0;
    // The tool's present position, and the load on it in the last step.
    virtual const std::optional<Tool>& tool() const = 0;
    virtual const ToolLoad& tool_load() const = 0;

    // Returns false and changes nothing where these options need a new stepper, to which the caller
    // then passes the state. Throws InputError where the options are not valid.
    virtual bool set_options(const StepperOptions& options) = 0;

    // Advances the state by dt_s > 0. The state stays finite for every input. Throws Cancelled soon
    // after a stop is requested: it checks before each substep, iterate and linear iteration, and
    // between columns of a factorisation. The state is then one within the step, and restore() must
    // be called before another step.
    // `part_done` is called between substeps with the share of the step that is done, in (0, 1):
    // positions are those of that moment and may be shown. It must change nothing here.
    using PartDone = std::function<void(double share)>;
    virtual StepReport step(double dt_s, const std::stop_token& stop = {},
                            const PartDone& part_done = {}) = 0;

    // Whether a device makes the steps, apart from single ones that it leaves to the processor. May
    // become false with any step, because devices fail.
    virtual bool on_device() const { return false; }

    // One entry per vertex of the stepper's mesh.
    virtual std::span<const Vec3> positions_mm() const = 0;
    virtual std::span<const Vec3> velocities_mm_per_s() const = 0;

    // How the body is torn; null where it cannot tear. Tearing appends vertices, so that spans and
    // states grow.
    virtual const Tearing* tearing() const { return nullptr; }
    // For bodies that tear; otherwise these do nothing. Multiplies the strength of these joints by
    // a factor, see Tearing::weaken.
    virtual void weaken(std::span<const int> /*joints*/, double /*factor*/) {}
    // Cuts along a parallelogram with this corner and these edges, see Tearing::crossing.
    virtual void cut(const Vec3& /*corner_mm*/, const Vec3& /*first_edge_mm*/,
                     const Vec3& /*second_edge_mm*/) {}
    // Sets the tear; the default state is a whole body. Vertices may appear or vanish; the others
    // keep their positions. Throws InputError and changes nothing where the state is not of this
    // mesh.
    virtual void set_tear(const TearState& /*state*/) {}

    // Kinetic, elastic, grab, tether, contact and cohesion energy of the present state, and the
    // tool_work that the next step will report; all other terms are 0.
    virtual EnergyLedger energies() const = 0;

    // The state of every node: the vertices, then in quadratic bodies the mid-edge nodes.
    virtual BodyState state() const = 0;

    // Replaces the state. Takes one finite value per node as in state(), or one per vertex;
    // mid-edge nodes are then placed halfway. Throws where the tool would be inside the body.
    virtual void set_state(std::span<const Vec3> positions_mm,
                           std::span<const Vec3> velocities_mm_per_s) = 0;

    // Everything except body and options that determines later steps. Costs a copy of a few arrays.
    virtual StepperCheckpoint checkpoint() const = 0;

    // Continues from a checkpoint of a stepper with the same body and options; all later steps have
    // the same bits as there. Costs a factorisation. Throws InputError and changes nothing where
    // the checkpoint does not fit.
    virtual void restore(const StepperCheckpoint& checkpoint) = 0;

    // Hash of the checkpoint: steppers with equal hashes make equal steps.
    std::uint64_t state_hash() const;
};

}  // namespace hepatica
