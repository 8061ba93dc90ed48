// SPDX-License-Identifier: GPL-3.0-or-later
// Friction between the body's own surfaces: SlipLaw for each pair of features in its pad, with the
// weights, normals and normal forces of the step's beginning. Slip is the relative motion of the
// two points along the surface; they are pulled with opposite forces. Blocks between the two
// features are coupling, as in SelfContact.
#pragma once

#include <vector>

#include "core/deform/potentials/coulomb_friction.h"
#include "core/deform/potentials/self_contact.h"
#include "core/deform/potentials/slip_law.h"
#include "core/deform/potentials/touch_list.h"

namespace hepatica {

// Keeps references to the body and the contact; the body's pad must have a friction above 0.
class SelfFriction final : public Potential {
  public:
    SelfFriction(const Body& body, const SelfContact& contact) : body_(body), contact_(contact) {}

    // See CoulombFriction.
    void list_rubs(int kind, std::vector<RubPoint>& rubs) const;

    double energy(std::span<const Vec3> positions_mm,
                  std::span<const Vec3> reference_mm) const override;
    void add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                             std::span<const int> piece_of_node,
                             std::span<double> energy_nj) const override;
    void add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const override;
    void foresee(std::span<const Vec3> positions_mm, std::span<const Vec3> forces_un) override;
    void add_stiffness(std::span<const Vec3> positions_mm, double factor,
                       BlockMatrix& matrix) const override;
    void add_product(std::span<const Vec3> positions_mm, double factor, std::span<const Vec3> d,
                     const BlockMatrix& pattern, std::span<Vec3> product) const override;
    bool coupled(std::span<const Vec3>) const override { return !grips_.empty(); }
    void add_coupling(std::span<const Vec3> positions_mm, double factor, std::span<const Vec3> d,
                      std::span<Vec3> product) const override;
    void append_coupling(std::span<const Vec3> positions_mm, double factor,
                         CouplingBlocks& blocks) const override;
    void begin_step(const BodyState& start, double dt_s,
                    std::span<const std::uint8_t> held) override;
    void end_step() override {
        grips_.clear();
        held_ = {};
    }
    void book(double energy_nj, EnergyLedger& ledger) const override {
        ledger.friction_loss += energy_nj;
    }

  private:
    // Two points that touched when the step began.
    struct Grip {
        PointPair at;
        Vec3 normal;
        Vec3 apart_mm;  // from the second point to the first, at that time
        SlipLaw law;
        bool slows = false;

        Vec3 slip(std::span<const Vec3> positions_mm) const;
        double energy_nj(std::span<const Vec3> positions_mm) const;
        Vec3 force_un(std::span<const Vec3> positions_mm) const;
        Mat3 stiffness(std::span<const Vec3> positions_mm) const;
    };

    const Body& body_;
    const SelfContact& contact_;
    std::vector<Grip> grips_;
    std::span<const std::uint8_t> held_;
};

}  // namespace hepatica
