// SPDX-License-Identifier: GPL-3.0-or-later
// The cohesive ties between the two sides of parted joints (core/tear/softening.h): pairs of
// vertices that were one, each with a block in the matrix of a torn body.
#pragma once

#include <span>
#include <vector>

#include "core/deform/potentials/potential.h"
#include "core/deform/potentials/touch_list.h"
#include "core/tear/softening.h"

namespace hepatica {

class SofteningTies final : public Potential {
  public:
    // Computes the ties' normals from the positions.
    void set(const SofteningLaw& law, std::vector<SofteningTie> ties,
             std::span<const Vec3> positions_mm);
    const std::vector<SofteningTie>& all() const { return ties_; }

    void list_touches(TouchList& list) const;

    // Recomputes the ties' normals from other positions.
    void turn(std::span<const Vec3> positions_mm);

    // To be called after a step or a part of one: the ties remember their largest opening. Returns
    // the energy that this takes from them [nJ], the energy of fracture, >= 0.
    double settle(std::span<const Vec3> positions_mm);

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
    void join_pieces(std::span<const int> piece_of_node, DisjointSets& pieces) const override;
    void begin_step(const BodyState&, double, std::span<const std::uint8_t> held) override {
        held_ = held;
    }
    void end_step() override { held_ = {}; }
    void book(double energy_nj, EnergyLedger& ledger) const override {
        ledger.cohesion = energy_nj;
    }

  private:
    bool held(int node) const { return !held_.empty() && held_[node] != 0; }

    SofteningLaw law_;
    std::vector<SofteningTie> ties_;
    std::span<const std::uint8_t> held_;
};

}  // namespace hepatica
