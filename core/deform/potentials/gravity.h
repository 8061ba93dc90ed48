// SPDX-License-Identifier: GPL-3.0-or-later
// Weight: a constant force m g. Its term of the ledger is its work, `gravity_work`.
#pragma once

#include "core/deform/body/body.h"
#include "core/deform/potentials/potential.h"

namespace hepatica {

// Keeps a reference to the body.
class Gravity final : public Potential {
  public:
    explicit Gravity(const Body& body) : body_(body) {}

    void set(const Vec3& gravity_mm_per_s2) { gravity_ = gravity_mm_per_s2; }
    const Vec3& mm_per_s2() const { return gravity_; }

    double energy(std::span<const Vec3> positions_mm,
                  std::span<const Vec3> reference_mm) const override;
    void add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                             std::span<const int> piece_of_node,
                             std::span<double> energy_nj) const override;
    void add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const override;
    void add_stiffness(std::span<const Vec3>, double, BlockMatrix&) const override {}
    void add_product(std::span<const Vec3>, double, std::span<const Vec3>, const BlockMatrix&,
                     std::span<Vec3>) const override {}
    void book(double energy_nj, EnergyLedger& ledger) const override {
        ledger.gravity_work = -energy_nj;
    }

  private:
    const Body& body_;
    Vec3 gravity_ = Vec3::Zero();
};

}  // namespace hepatica
