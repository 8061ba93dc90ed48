// SPDX-License-Identifier: GPL-3.0-or-later
// E of eq. (11) in the matrix of a step's first iterate. The unknown there is the change of
// velocity, so that E multiplies nothing else. See StepperOptions.
#pragma once

#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/step/incremental_potential.h"

namespace hepatica {

class VelocityError {
  public:
    // The share of inertia and of stiffness that always remains, whatever E is.
    static constexpr double least_share = 0.1;

    void set(const RayleighDamping& error) {
        error_ = error;
        matrix_ = {};
    }
    bool any() const { return error_.alpha_per_s != 0.0 || error_.beta_s != 0.0; }

    // Adds dt E to the live rows of the potential's matrix, and nothing to the unit blocks of held
    // nodes. A negative E is limited so that the least share of inertia and of stiffness remains in
    // the matrix.
    void add_to(IncrementalPotential& potential, const Body& body, double dt_s);

    // dt E of the last step; rows that are not live are meaningless.
    const BlockMatrix& matrix() const { return matrix_; }

  private:
    RayleighDamping error_{};
    BlockMatrix matrix_;
};

}  // namespace hepatica
