// SPDX-License-Identifier: GPL-3.0-or-later
// The potentials that act on one body: weight, the surrounding tissue and the tools' grabs; each
// function is the sum over them in this order.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body.h"
#include "core/deform/potentials/grab.h"
#include "core/deform/potentials/potential.h"

namespace hepatica {

class Gravity;
class GrabSprings;

// Keeps a reference to the body. Not thread-safe.
class PotentialList {
  public:
    explicit PotentialList(const Body& body);
    ~PotentialList();
    PotentialList(const PotentialList&) = delete;
    PotentialList& operator=(const PotentialList&) = delete;

    // Both throw as stepper_input.h says, and then keep what they had.
    void set_grabs(std::span<const Grab> grabs);
    void set_gravity(const Vec3& gravity_mm_per_s2);
    const std::vector<Grab>& grabs() const;
    const Vec3& gravity_mm_per_s2() const;

    std::span<const std::unique_ptr<Potential>> all() const { return all_; }

    // Sums over all, as in Potential.
    double energy(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm) const;
    void add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const;
    void add_stiffness(std::span<const Vec3> positions_mm, double factor,
                       BlockMatrix& matrix) const;
    void add_product(std::span<const Vec3> positions_mm, double factor, std::span<const Vec3> d,
                     const BlockMatrix& pattern, std::span<Vec3> product) const;
    // Every term of the ledger that a potential has; returns the sum of their energies.
    double book(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                EnergyLedger& ledger) const;

  private:
    std::vector<std::unique_ptr<Potential>> all_;
    Gravity* gravity_;
    GrabSprings* grabs_;
    std::size_t nodes_;
};

}  // namespace hepatica
