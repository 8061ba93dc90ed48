// SPDX-License-Identifier: GPL-3.0-or-later
// Holds the state of a body and computes one time step of it, on one kind of machine.
// GovernedStepper decides, for all back ends alike, what is computed and when: substeps, sleep, the
// live region and the repair of inverted elements. Not thread-safe: the simulation thread owns it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body.h"
#include "core/deform/body/body_state.h"
#include "core/deform/body/torn_body.h"
#include "core/deform/potentials/grab.h"
#include "core/deform/potentials/tool.h"
#include "core/deform/step/step_report.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/deform/stepper/stepper_options.h"

namespace hepatica {

class StepBackEnd {
  public:
    virtual ~StepBackEnd() = default;

    // The nodes, masses and elements that were built from the description.
    virtual const Body& body() const = 0;
    // Whether a device makes the steps, apart from single ones that it leaves to the processor.
    virtual bool on_device() const { return false; }

    // Take effect in the next step. The caller has checked the values.
    virtual void set_grabs(std::span<const Grab> grabs) = 0;
    virtual void set_gravity(const Vec3& gravity_mm_per_s2) = 0;
    virtual void set_tool(const std::optional<Tool>& tool) = 0;
    virtual const std::optional<Tool>& tool() const = 0;
    // Leads the tool over dt_s by `share` of the way to its target, past a body that stands still.
    virtual void lead_tool(double share, double dt_s) = 0;
    // The vertices that are near a tool on its way to its target.
    virtual std::vector<int> vertices_near_tool() const = 0;
    // Whether no part of the body is in the tool when its nodes are at these places.
    virtual bool free_of_tool(std::span<const Vec3> positions_mm) const = 0;
    virtual bool tool_in_obstacle() const = 0;
    // What presses on the tool between two steps: without friction.
    virtual ToolLoad tool_load() const = 0;
    // What of the body overlaps itself or obstacles and does not count as touching; none where it
    // does not touch these. set_overlaps() throws InputError where it is not of this body.
    virtual SurfacesKept overlaps() const = 0;
    virtual void set_overlaps(const SurfacesKept& kept) = 0;
    // Nodes that touch each other, by pairs.
    virtual std::vector<std::array<int, 2>> touching_nodes() const = 0;
    // Returns false, and changes nothing, where these options need another back end.
    virtual bool set_options(const StepperOptions& options) = 0;
    // Freezes exactly the nodes with frozen[i] != 0, in place and with velocity 0.
    virtual void freeze(std::span<const std::uint8_t> frozen) = 0;
    virtual int live_elements() const = 0;

    // One step of dt_s > 0. The report has the energies of the whole body and everything else but
    // tool_work. The cost of a step is bounded, see BackwardEuler::advance; it throws Cancelled
    // soon after a stop was asked for, and state and solver must then be set anew.
    virtual StepReport advance(double dt_s, const std::stop_token& stop = {}) = 0;

    // Repairs inverted elements, books the energy in the report of the step just made and sets all
    // velocities to 0. Returns false where no element is inverted.
    virtual bool recover_from_inversion(StepReport& report) = 0;

    // Of a body that tears, which not every back end can compute.
    // Stress [Pa] and energy [nJ] of each tetrahedron at the present state; those that are not live
    // keep their entries.
    virtual void find_stress(std::vector<Mat3>& /*stress_pa*/, std::vector<double>& /*energy_nj*/) {
    }
    // Goes on with the body torn so far; state and forces from outside stay, all is live.
    virtual void tear(const BodyDescription& /*whole*/, const TornBody& /*tear*/) {}
    // The ties of the last tear(), with how far they have been opened since.
    virtual std::span<const SofteningTie> ties() const { return {}; }

    // Of every node. This is the only function that copies the state from a device, once per step.
    virtual const BodyState& state() const = 0;
    virtual void set_state(const BodyState& state) = 0;
    // Replaces the velocities only.
    virtual void set_velocities(const std::vector<Vec3>& velocities_mm_per_s) = 0;

    // Kinetic, elastic, grab, tether and contact energy of the present state; all other terms are
    // 0.
    virtual EnergyLedger energies() const = 0;
    // Parts of energies() alone [nJ].
    virtual double grab_energy() const = 0;
    virtual double contact_energy() const = 0;
    virtual double kinetic_energy() const = 0;

    // What the linear solver carries from one step to the next. restore() throws InputError, and
    // changes nothing, where the checkpoint is of another body or solver.
    virtual SolverCheckpoint checkpoint() const = 0;
    virtual void restore(const SolverCheckpoint& checkpoint) = 0;
};

}  // namespace hepatica
