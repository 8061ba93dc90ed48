// SPDX-License-Identifier: GPL-3.0-or-later
// The potentials that act on one body, in this order: weight, surrounding tissue, grabs; then,
// where the body has them, contact and friction of its own surfaces, of obstacles, the ties of
// parted joints, and contact and friction of a tool. What every potential has is summed over all in
// this order; what one of them has alone is reached through it, or asked here whether or not the
// body has it.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body.h"
#include "core/deform/potentials/body_surfaces.h"
#include "core/deform/potentials/grab.h"
#include "core/deform/potentials/potential.h"
#include "core/deform/potentials/self_load.h"
#include "core/deform/potentials/tool.h"
#include "core/deform/potentials/touch_list.h"

namespace hepatica {

class Gravity;
class GrabSprings;
class ToolContact;
class ToolFriction;
class SelfContact;
class SelfFriction;
class ObstacleContact;
class ObstacleFriction;
class SofteningTies;

// All positions are in mm, forces in uN, energies in nJ; spans have one entry per node of the body.
// Keeps a reference to the body. Not thread-safe.
class PotentialList {
  public:
    explicit PotentialList(const Body& body);
    ~PotentialList();
    PotentialList(const PotentialList&) = delete;
    PotentialList& operator=(const PotentialList&) = delete;

    // The setters throw as load_input.h says and then keep the former value.
    void set_grabs(std::span<const Grab> grabs);
    void set_gravity(const Vec3& gravity_mm_per_s2);
    // Throws also where the body is not touchable.
    void set_tool(const std::optional<Tool>& tool);
    const std::vector<Grab>& grabs() const;
    const std::optional<Tool>& tool() const;
    const Vec3& gravity_mm_per_s2() const;

    // See ToolContact. Without a tool nothing moves and everything is free.
    bool lead_tool(std::span<const Vec3> positions_mm, double share, double dt_s);
    // The vertices of all patches that the tool may come near on its way to its target.
    std::vector<int> vertices_near_tool(std::span<const Vec3> positions_mm) const;
    bool free_of_tool(std::span<const Vec3> positions_mm) const;
    bool tool_in_obstacle() const;
    // Includes friction, which exists until end_step(). The impulse is the body's force times dt_s.
    ToolLoad tool_load(std::span<const Vec3> positions_mm, double dt_s = 0.0) const;

    // Contact between the body's own surfaces; null where they do not touch.
    SelfContact* self() const { return self_; }
    // Friction between them, which exists until end_step(); null where they are frictionless.
    SelfFriction* self_friction() const { return self_friction_; }
    // Contact with obstacles; null where there are none.
    ObstacleContact* obstacles() const { return obstacles_; }
    // Includes friction, which exists until end_step().
    ObstacleLoad obstacle_load(std::span<const Vec3> positions_mm) const;
    // Whether the body touches itself or obstacles at these positions, or there is a tool.
    bool touches(std::span<const Vec3> positions_mm) const;
    // The ties of parted joints; null where the body does not tear.
    SofteningTies* ties() const { return ties_; }
    // What its surfaces keep from step to step.
    BodySurfaces surfaces() const { return {self_, obstacles_, contact_}; }

    std::span<const std::unique_ptr<Potential>> all() const { return all_; }

    // For back ends that compute contact themselves: all pairs and points that may touch at either
    // end of a motion, and the friction contacts between begin_step() and end_step().
    TouchList touches_along(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const;
    // Positions of the obstacles' nodes that the list names; their numbers follow the body's nodes.
    std::span<const Vec3> obstacles_mm() const;

    // What potentials keep during a step is discarded by end_step().
    void begin_step(const BodyState& start, double dt_s, std::span<const std::uint8_t> held) const;
    void end_step() const;
    // Minima over all potentials; see Potential.
    double free_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const;
    double share_until_touch(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const;

    // Energy of the grabs alone [nJ].
    double grab_energy(std::span<const Vec3> positions_mm) const;

    // Sums over all potentials; see Potential.
    double energy(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm) const;
    void add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const;
    void foresee(std::span<const Vec3> positions_mm, std::span<const Vec3> forces_un) const;
    void add_stiffness(std::span<const Vec3> positions_mm, double factor,
                       BlockMatrix& matrix) const;
    void add_product(std::span<const Vec3> positions_mm, double factor, std::span<const Vec3> d,
                     const BlockMatrix& pattern, std::span<Vec3> product) const;
    bool coupled(std::span<const Vec3> positions_mm) const;
    void add_coupling(std::span<const Vec3> positions_mm, double factor, std::span<const Vec3> d,
                      std::span<Vec3> product) const;
    void append_coupling(std::span<const Vec3> positions_mm, double factor,
                         CouplingBlocks& blocks) const;
    // Sets every potential's term of the ledger; returns the sum of their energies.
    double book(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                EnergyLedger& ledger) const;

  private:
    std::vector<std::unique_ptr<Potential>> all_;
    Gravity* gravity_;
    GrabSprings* grabs_;
    ToolContact* contact_ = nullptr;  // null where the body is not touchable
    ToolFriction* friction_ = nullptr;
    SelfContact* self_ = nullptr;  // null where its surfaces do not touch each other
    SelfFriction* self_friction_ = nullptr;
    ObstacleContact* obstacles_ = nullptr;
    ObstacleFriction* obstacle_friction_ = nullptr;
    SofteningTies* ties_ = nullptr;  // null where it does not tear
    std::size_t nodes_;
};

}  // namespace hepatica
