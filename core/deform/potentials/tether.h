// SPDX-License-Identifier: GPL-3.0-or-later
// The surrounding tissue: a spring from every node to its rest position, with the stiffness that
// the body gives it (see BodyDescription::tether_pa_per_mm2). Its term of the ledger is `tether`.
#pragma once

#include "core/deform/body/body.h"
#include "core/deform/potentials/potential.h"

namespace hepatica {

// Keeps a reference to the body. Costs nothing where the body has no tether.
class Tether final : public Potential {
  public:
    explicit Tether(const Body& body);

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
    void book(double energy_nj, EnergyLedger& ledger) const override { ledger.tether = energy_nj; }

  private:
    double energy_of(std::size_t i, const Vec3& position_mm) const;

    const Body& body_;
    bool any_ = false;
};

}  // namespace hepatica
