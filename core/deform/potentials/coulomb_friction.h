// SPDX-License-Identifier: GPL-3.0-or-later
// Coulomb friction on points of a body's surface, as the potential of one step: SlipLaw with the
// normals, weights and normal forces of the step's beginning. Slip is the motion of the touching
// point along the surface relative to what it touches. Sticking points creep slower than 1e-5 mean
// edges per second, slow enough for the body to fall asleep. Its term of the ledger is
// `friction_loss`.
#pragma once

#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/potentials/potential.h"
#include "core/deform/potentials/slip_law.h"
#include "core/deform/potentials/touch_list.h"

namespace hepatica {

// A point of the body's surface that touched something when the step began.
struct Grip {
    // Three corners of a triangle; for an edge or a vertex a node is repeated with weight 0.
    std::array<int, 3> nodes;
    std::array<double, 3> weights;
    Vec3 normal;
    double limit_un;     // mu N: friction of full slip
    Vec3 anchor_mm;      // where the touched thing would carry the point
    bool slows = false;  // slips, but is about to stick

    Vec3 point(std::span<const Vec3> positions_mm) const;
};

// Points per task of a parallel loop.
constexpr std::size_t grips_per_block = 256;

// How far a sticking point may creep in a step of dt_s > 0.
double creep_mm(const Body& body, double dt_s);

// Keeps a reference to the body. Derived classes say what touches (grips_of).
class CoulombFriction : public Potential {
  public:
    explicit CoulombFriction(const Body& body) : body_(body) {}

    void begin_step(const BodyState& start, double dt_s,
                    std::span<const std::uint8_t> held) override;
    void end_step() override {
        grips_.clear();
        held_ = {};
    }

    // Appends the contacts of this step, marked as friction of this `kind`.
    void list_rubs(int kind, std::vector<RubPoint>& rubs) const;

    // The friction force on a point of the body.
    struct PointForce {
        Vec3 at_mm;
        Vec3 force_un;
    };
    std::vector<PointForce> point_forces(std::span<const Vec3> positions_mm) const;

    double energy(std::span<const Vec3> positions_mm,
                  std::span<const Vec3> reference_mm) const override;
    void foresee(std::span<const Vec3> positions_mm, std::span<const Vec3> forces_un) override;
    void add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                             std::span<const int> piece_of_node,
                             std::span<double> energy_nj) const override;
    void add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const override;
    void add_stiffness(std::span<const Vec3> positions_mm, double factor,
                       BlockMatrix& matrix) const override;
    void add_product(std::span<const Vec3> positions_mm, double factor, std::span<const Vec3> d,
                     const BlockMatrix& pattern, std::span<Vec3> product) const override;
    void book(double energy_nj, EnergyLedger& ledger) const override {
        ledger.friction_loss += energy_nj;
    }

  private:
    // The contacts at the beginning of the step.
    virtual std::vector<Grip> grips_of(std::span<const Vec3> start_mm, double dt_s) const = 0;
    static Vec3 slip_of(const Grip& grip, std::span<const Vec3> positions_mm);
    SlipLaw law_of(const Grip& grip) const { return {grip.limit_un, creep_mm_}; }
    double energy_of(const Grip& grip, std::span<const Vec3> positions_mm) const;
    Vec3 force_of(const Grip& grip, std::span<const Vec3> positions_mm) const;
    Mat3 stiffness_of(const Grip& grip, std::span<const Vec3> positions_mm) const;

    const Body& body_;
    std::vector<Grip> grips_;
    double creep_mm_ = 0.0;  // e of SlipLaw
    std::span<const std::uint8_t> held_;
};

}  // namespace hepatica
