// SPDX-License-Identifier: GPL-3.0-or-later
// Holds the state of a body and computes one time step of it, on one kind of machine.
// GovernedStepper decides for all back ends alike what is computed and when: substeps, sleep, the
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

    // These take effect in the next step. The caller has checked the values.
    virtual void set_grabs(std::span<const Grab> grabs) = 0;
    virtual void set_gravity(const Vec3& gravity_mm_per_s2) = 0;
    virtual void set_tool(const std::optional<Tool>& tool) = 0;
    virtual const std::optional<Tool>& tool() const = 0;
    // Moves the tool over dt_s by `share` of the way to its target, past the resting body.
    virtual void lead_tool(double share, double dt_s) = 0;
    // The vertices near the tool's way to its target.
    virtual std::vector<int> vertices_near_tool() const = 0;
    // Whether the tool contains no part of the body at these positions of its nodes.
    virtual bool free_of_tool(std::span<const Vec3> positions_mm) const = 0;
    virtual bool tool_in_obstacle() const = 0;
    // The load on the tool between two steps, without friction.
    virtual ToolLoad tool_load() const = 0;
    // The overlaps of the body's surfaces with each other and with obstacles, which do not count as
    // contact; empty where the body does not touch these. set_overlaps() throws InputError and
    // changes nothing where they are not of this body.
    virtual SurfacesKept overlaps() const = 0;
    virtual void set_overlaps(const SurfacesKept& kept) = 0;
    // Pairs of nodes that touch each other.
    virtual std::vector<std::array<int, 2>> touching_nodes() const = 0;
    // Returns false and changes nothing where these options need another back end.
    virtual bool set_options(const StepperOptions& options) = 0;
    // Freezes exactly the nodes with frozen[i] != 0, in place and with velocity 0.
    virtual void freeze(std::span<const std::uint8_t> frozen) = 0;
    virtual int live_elements() const = 0;

    // Makes one step of dt_s > 0. The report has the energies of the whole body and everything else
    // except tool_work. The cost of a step is bounded, see BackwardEuler::advance. Throws Cancelled
    // soon after a stop is requested; then state and solver must be set again.
    virtual StepReport advance(double dt_s, const std::stop_token& stop = {}) = 0;

    // Repairs inverted elements, books the energy in the report of the step just made and sets all
    // velocities to 0. Returns false where nothing was repaired.
    virtual bool recover_from_inversion(StepReport& report) = 0;

    // For bodies that tear, which not every back end supports. Stress [Pa] and energy [nJ] of each
    // tetrahedron at the present state; entries of frozen ones are kept.
    virtual void find_stress(std::vector<Mat3>& /*stress_pa*/, std::vector<double>& /*energy_nj*/) {
    }
    // Continues with the body torn so far. State and external forces are kept; everything is live.
    virtual void tear(const BodyDescription& /*whole*/, const TornBody& /*tear*/) {}
    // The ties of the last tear() with their largest openings since.
    virtual std::span<const SofteningTie> ties() const { return {}; }

    // State of every node. The only function that copies it from a device, once per step.
    virtual const BodyState& state() const = 0;
    virtual void set_state(const BodyState& state) = 0;
    // Replaces the velocities only.
    virtual void set_velocities(const std::vector<Vec3>& velocities_mm_per_s) = 0;

    // Kinetic, elastic, grab, tether, contact and cohesion energy of the present state; all other
    // terms are 0.
    virtual EnergyLedger energies() const = 0;
    // Single terms of energies() [nJ].
    virtual double grab_energy() const = 0;
    virtual double contact_energy() const = 0;
    virtual double cohesion_energy() const = 0;
    virtual double kinetic_energy() const = 0;

    // The state that the linear solver carries from step to step. restore() throws InputError and
    // changes nothing where the checkpoint is of another body or solver.
    virtual SolverCheckpoint checkpoint() const = 0;
    virtual void restore(const SolverCheckpoint& checkpoint) = 0;
};

}  // namespace hepatica
