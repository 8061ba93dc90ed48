// SPDX-License-Identifier: GPL-3.0-or-later
// Contact between the body's own surfaces, as a potential: the pads of surface_pairs.h between all
// features of its surface. The blocks of the stiffness between the two features of a pair are the
// coupling. Its term of the ledger is `contact`.
#pragma once

#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/potentials/potential.h"
#include "core/deform/potentials/surface_pairs.h"

namespace hepatica {

// Keeps a reference to the body, which must have a self_pad. Caches the last search: not
// thread-safe.
class SelfContact final : public Potential {
  public:
    explicit SelfContact(const Body& body);

    // Vertices and triangles first, then edges, each in the order of the features.
    const std::vector<SurfaceContact>& contacts(std::span<const Vec3> positions_mm) const {
        return pairs_.contacts(positions_mm);
    }
    // Remembers which pairs touch at these positions, for join_pieces.
    void note_meeting(std::span<const Vec3> positions_mm) const;
    // Overlaps and costs of the search.
    SurfacePairs& pairs() { return pairs_; }
    const SurfacePairs& pairs() const { return pairs_; }

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
    bool coupled(std::span<const Vec3> positions_mm) const override {
        return !contacts(positions_mm).empty();
    }
    void add_coupling(std::span<const Vec3> positions_mm, double factor, std::span<const Vec3> d,
                      std::span<Vec3> product) const override;
    void append_coupling(std::span<const Vec3> positions_mm, double factor,
                         CouplingBlocks& blocks) const override;
    // Unites pieces that touched at the beginning of the step, touched where one of its matrices
    // was assembled, or touch at the positions of the last search.
    void join_pieces(std::span<const int> piece_of_node, DisjointSets& pieces) const override;
    void begin_step(const BodyState& start, double dt_s,
                    std::span<const std::uint8_t> held) override;
    void end_step() override;
    void book(double energy_nj, EnergyLedger& ledger) const override {
        ledger.contact += energy_nj;
    }
    double free_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const override {
        return pairs_.free_share(from_mm, to_mm);
    }
    double share_until_touch(std::span<const Vec3> from_mm,
                             std::span<const Vec3> to_mm) const override {
        return pairs_.share_until_touch(from_mm, to_mm);
    }

  private:
    SurfacePairs pairs_;
    std::span<const std::uint8_t> held_;
    mutable std::vector<std::array<int, 2>> met_;  // nodes of pairs that touched during the step
};

}  // namespace hepatica
