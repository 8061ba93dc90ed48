// SPDX-License-Identifier: GPL-3.0-or-later
// Contact between the body's surface and obstacles, as a potential: the pads of surface_pairs.h
// between its features and those of rigid, fixed surfaces. Every block of the stiffness lies within
// one feature of the body, so that the matrix has a place for it. An obstacle is a surface that
// nothing passes, from either side: what is outside a tumour stays outside, what is inside the
// liver stays inside. Its term of the ledger is `contact`. Overlaps at rest: see Overlaps.
#pragma once

#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/potentials/coulomb_friction.h"
#include "core/deform/potentials/potential.h"
#include "core/deform/potentials/self_load.h"
#include "core/deform/potentials/surface_pairs.h"

namespace hepatica {

// A point of the body in the pad of an obstacle: a vertex or a point of an edge or a triangle.
struct ObstacleContactPoint {
    std::array<int, 3> nodes{};  // as in Grip
    std::array<double, 3> weights{};
    Vec3 normal = Vec3::Zero();  // from the obstacle to the body, of length 1
};

// Keeps a reference to the body, which must have obstacles. Caches the last search: not
// thread-safe.
class ObstacleContact final : public Potential {
  public:
    explicit ObstacleContact(const Body& body);

    // Node numbers from Body::node_count() on belong to the obstacles, one after the other.
    const std::vector<SurfaceContact>& contacts(std::span<const Vec3> positions_mm) const;
    // See SurfacePairs.
    void list_touches(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                      std::vector<PadPair>& list) const;
    // Positions of the obstacles' nodes, in the order of their numbers.
    std::span<const Vec3> standing_mm() const {
        return std::span(rest_mm_).subspan(static_cast<std::size_t>(body_.node_count()));
    }
    ObstacleContactPoint point_of(const SurfaceContact& contact) const;
    double friction() const { return body_.obstacles->friction; }
    // Overlaps and costs of the search. Positions below are those of the body's nodes alone.
    SurfacePairs& pairs() { return *pairs_; }
    const SurfacePairs& pairs() const { return *pairs_; }
    void let_go(std::span<const Vec3> positions_mm) { pairs_->let_go(all_from(positions_mm)); }
    void find_overlaps(std::span<const Vec3> positions_mm) {
        pairs_->find_overlaps(all_from(positions_mm));
    }
    BeforeTear before_tear(std::span<const Vec3> positions_mm) const {
        return pairs_->before_tear(all_from(positions_mm));
    }
    void follow_split(const BeforeTear& before, std::span<const int> parents,
                      std::span<const Vec3> positions_mm) {
        pairs_->follow_split(before, parents, all_from(positions_mm));
    }

    double energy(std::span<const Vec3> positions_mm,
                  std::span<const Vec3> reference_mm) const override;
    void add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                             std::span<const int> piece_of_node,
                             std::span<double> energy_nj) const override;
    void add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const override;
    void add_stiffness(std::span<const Vec3> positions_mm, double factor,
                       BlockMatrix& matrix) const override;
    void add_product(std::span<const Vec3> positions_mm, double factor, std::span<const Vec3> d,
                     const BlockMatrix& pattern, std::span<Vec3> product) const override;
    void mark_held(std::span<const Vec3> positions_mm, std::span<char> held) const override;
    void begin_step(const BodyState&, double, std::span<const std::uint8_t> held) override {
        held_ = held;
    }
    void end_step() override { held_ = {}; }
    void book(double energy_nj, EnergyLedger& ledger) const override {
        ledger.contact += energy_nj;
    }
    double free_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const override;
    double share_until_touch(std::span<const Vec3> from_mm,
                             std::span<const Vec3> to_mm) const override;

  private:
    // Positions of all nodes, the body's first; valid until the next call.
    std::span<const Vec3> all_from(std::span<const Vec3> positions_mm) const;
    std::span<const Vec3> all_to(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const;

    const Body& body_;
    std::vector<Vec3> rest_mm_;                  // of all nodes
    mutable std::vector<Vec3> from_mm_, to_mm_;  // scratch copies for from and to
    std::optional<SurfacePairs> pairs_;          // set once constructed
    std::span<const std::uint8_t> held_;
};

// Friction between the body and obstacles. Keeps references to the body and the contact.
class ObstacleFriction final : public CoulombFriction {
  public:
    ObstacleFriction(const Body& body, const ObstacleContact& contact)
        : CoulombFriction(body), contact_(contact) {}

  private:
    std::vector<Grip> grips_of(std::span<const Vec3> start_mm, double dt_s) const override;

    const ObstacleContact& contact_;
};

// The load on the obstacles, friction included, without its impulse.
ObstacleLoad load_of(const ObstacleContact& contact, const ObstacleFriction& friction,
                     std::span<const Vec3> positions_mm);

}  // namespace hepatica
