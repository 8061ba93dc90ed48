// SPDX-License-Identifier: GPL-3.0-or-later
// The tools' grabs as potentials. A grab stretched by s stores k s^2 / 2 up to s_limit = limit / k,
// and limit s - limit^2 / (2 k) beyond, where its force is the constant limit. Their term of the
// ledger is `grab`.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/deform/potentials/grab.h"
#include "core/deform/potentials/potential.h"

namespace hepatica {

class GrabSprings final : public Potential {
  public:
    // The grabs must satisfy validate_grabs.
    void set(std::span<const Grab> grabs) { grabs_.assign(grabs.begin(), grabs.end()); }
    const std::vector<Grab>& all() const { return grabs_; }

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
    void join_pieces(std::span<const int> piece_of_node, DisjointSets& pieces) const override;
    void begin_step(const BodyState&, double, std::span<const std::uint8_t> held) override {
        held_ = held;
    }
    void end_step() override { held_ = {}; }
    void book(double energy_nj, EnergyLedger& ledger) const override { ledger.grab = energy_nj; }

  private:
    bool held(int node) const { return !held_.empty() && held_[node] != 0; }
    // Calls visit(i, j, block) for every nonzero block of the stiffness of one grab.
    template <class Visit>
    void for_each_block(const Grab& grab, std::span<const Vec3> positions_mm,
                        const BlockMatrix& pattern, const Visit& visit) const;

    std::vector<Grab> grabs_;
    std::span<const std::uint8_t> held_;  // during a step
};

}  // namespace hepatica
