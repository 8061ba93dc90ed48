// SPDX-License-Identifier: GPL-3.0-or-later
// E of eq. (11) in the system of a step's first iterate: dt E in the matrix and dt E v_n on the
// right-hand side, so that E meets the change of velocity alone. See StepperOptions.
#pragma once

#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/step/incremental_potential.h"

namespace hepatica {

class VelocityError {
  public:
    void set(const RayleighDamping& error) { error_ = error; }
    bool any() const { return error_.alpha_per_s != 0.0 || error_.beta_s != 0.0; }

    // Adds dt E to the potential's matrix and dt E v_n to the residual. E may be negative: a tenth
    // of inertia and of stiffness stay in the matrix.
    void add_to(IncrementalPotential& potential, const Body& body, const StepUnderway& step,
                std::vector<Vec3>& residual);

    // dt E of the last step.
    const BlockMatrix& matrix() const { return matrix_; }

  private:
    RayleighDamping error_{};
    BlockMatrix matrix_;
    std::vector<Vec3> product_;
};

}  // namespace hepatica
