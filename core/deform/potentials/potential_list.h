// SPDX-License-Identifier: GPL-3.0-or-later
// The potentials that act on one body: weight, the surrounding tissue, the hand's grabs and, where
// the body may be touched, a tool's contact and friction, and that of its surfaces and of
// obstacles, and, where it tears, what binds parted joints; each function is the sum over them in
// this order.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body.h"
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
struct BeforeTear;

// Keeps a reference to the body. Not thread-safe.
class PotentialList {
  public:
    explicit PotentialList(const Body& body);
    ~PotentialList();
    PotentialList(const PotentialList&) = delete;
    PotentialList& operator=(const PotentialList&) = delete;

    // Both throw as load_input.h says, and then keep what they had.
    void set_grabs(std::span<const Grab> grabs);
    void set_gravity(const Vec3& gravity_mm_per_s2);
    // Also where the body may not be touched.
    void set_tool(const std::optional<Tool>& tool);
    const std::vector<Grab>& grabs() const;
    const std::optional<Tool>& tool() const;
    const Vec3& gravity_mm_per_s2() const;

    // See ToolContact; without a tool nothing moves, and everything is free.
    bool lead_tool(std::span<const Vec3> positions_mm, double share, double dt_s);
    // The vertices of all patches that the tool may come near on its way to its target.
    std::vector<int> vertices_near_tool(std::span<const Vec3> positions_mm) const;
    bool free_of_tool(std::span<const Vec3> positions_mm) const;
    bool tool_in_obstacle() const;
    // Friction is there until end_step(). The impulse is that of the body over dt_s.
    ToolLoad tool_load(std::span<const Vec3> positions_mm, double dt_s = 0.0) const;

    // The body's surfaces among each other; null where they do not touch.
    SelfContact* self() const { return self_; }
    // Between these; null where they slide. It is there until end_step().
    SelfFriction* self_friction() const { return self_friction_; }
    // Obstacles; null where there are none.
    ObstacleContact* obstacles() const { return obstacles_; }
    // Friction is there until end_step().
    ObstacleLoad obstacle_load(std::span<const Vec3> positions_mm) const;
    // Whether its surfaces or obstacles are touched at these positions, or a tool is there.
    bool touches(std::span<const Vec3> positions_mm) const;
    // What binds parted joints; null where the body does not tear.
    SofteningTies* ties() const { return ties_; }
    // What of the body's surface overlaps. As a checkpoint kept it: throws InputError where it is
    // of another body, and then changes nothing of what does not fit.
    SurfacesKept kept_overlaps() const;
    void set_overlaps(const SurfacesKept& kept);
    // Lets what has come apart count; looks for it anew.
    void let_go(std::span<const Vec3> positions_mm) const;
    void find_overlaps(std::span<const Vec3> positions_mm) const;
    // What the surfaces leave to those of the body that this one was torn into.
    struct SurfacesBeforeTear {
        std::shared_ptr<const BeforeTear> self, obstacles;  // null: none
    };
    SurfacesBeforeTear before_tear() const;
    void follow_split(const SurfacesBeforeTear& before, std::span<const int> parents,
                      std::span<const Vec3> positions_mm) const;

    std::span<const std::unique_ptr<Potential>> all() const { return all_; }

    // For machines that compute contact themselves: all that may touch in one of two places, the
    // ends of a motion; with what friction acts on between begin_step() and end_step().
    TouchList touches_along(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const;
    // Where what of obstacles it names stands, behind the body's nodes.
    std::span<const Vec3> obstacles_mm() const;

    // What the potentials keep of a step while it is made; all of it is gone with end_step().
    void begin_step(const BodyState& start, double dt_s, std::span<const std::uint8_t> held) const;
    void end_step() const;
    // The least over all, as in Potential.
    double free_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const;
    double share_until_touch(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const;

    // Of the grabs alone [nJ].
    double grab_energy(std::span<const Vec3> positions_mm) const;

    // Sums over all, as in Potential.
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
    // Every term of the ledger that a potential has; returns the sum of their energies.
    double book(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                EnergyLedger& ledger) const;

  private:
    std::vector<std::unique_ptr<Potential>> all_;
    Gravity* gravity_;
    GrabSprings* grabs_;
    ToolContact* contact_ = nullptr;  // of a body that may be touched
    ToolFriction* friction_ = nullptr;
    SelfContact* self_ = nullptr;  // where its surfaces touch each other
    SelfFriction* self_friction_ = nullptr;
    ObstacleContact* obstacles_ = nullptr;
    ObstacleFriction* obstacle_friction_ = nullptr;
    SofteningTies* ties_ = nullptr;  // where it tears
    std::size_t nodes_;
};

}  // namespace hepatica
