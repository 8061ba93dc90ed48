// SPDX-License-Identifier: GPL-3.0-or-later
// What pulls at a body from outside, as potentials that enter the implicit matrix: grabs (springs
// of limited force) and the tether to the surrounding tissue. Gravity is a constant force beside
// them.
#pragma once

#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/body.h"
#include "core/deform/solvers/block_matrix.h"
#include "core/deform/stepper/stepper.h"

namespace hepatica {

class ExternalForces {
  public:
    explicit ExternalForces(const Body& body) : body_(body) {}

    // Both throw as stepper_input.h says, and then keep what they had.
    void set_grabs(std::span<const Grab> grabs);
    void set_gravity(const Vec3& gravity_mm_per_s2);
    const std::vector<Grab>& grabs() const { return grabs_; }
    const Vec3& gravity_mm_per_s2() const { return gravity_; }

    // Energy stored in grabs and tethers [nJ]. A grab stretched beyond its force limit stores
    // limit * stretch - limit^2 / (2 stiffness), whose force is the limit.
    double energy(std::span<const Vec3> positions_mm) const;
    // Adds the forces of grabs, tethers and gravity [uN].
    void add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const;
    // Adds factor * stiffness. Pairs of held vertices that share no element, and so have no block
    // in the matrix, are lumped on the diagonal: stiffer in the step, the same at rest.
    void add_stiffness(std::span<const Vec3> positions_mm, double factor,
                       BlockMatrix& matrix) const;
    // d^T (stiffness at positions) d, lumped like the matrix.
    double quadratic_form(std::span<const Vec3> positions_mm, std::span<const Vec3> d,
                          const BlockMatrix& matrix) const;

  private:
    // Calls visit(i, j, block) for every nonzero block of the stiffness of one grab, i <= j first.
    template <class Visit>
    void for_each_grab_block(const Grab& grab, std::span<const Vec3> positions_mm,
                             const BlockMatrix& matrix, const Visit& visit) const;

    const Body& body_;
    std::vector<Grab> grabs_;
    Vec3 gravity_ = Vec3::Zero();
};

}  // namespace hepatica
