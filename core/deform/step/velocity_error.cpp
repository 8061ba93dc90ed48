// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/velocity_error.h"

#include <algorithm>

namespace hepatica {
namespace {

RayleighDamping bounded_below(const RayleighDamping& error, const RayleighDamping& damping,
                              double dt_s) {
    constexpr double least = VelocityError::least_share;
    return {std::max(error.alpha_per_s, (least - 1.0) / dt_s - damping.alpha_per_s),
            std::max(error.beta_s, (least - 1.0) * dt_s - damping.beta_s)};
}

}  // namespace

void VelocityError::add_to(IncrementalPotential& potential, const Body& body, double dt_s) {
    const RayleighDamping error = bounded_below(error_, body.damping, dt_s);
    potential.assembly().gather_stiffness(dt_s * error.beta_s, matrix_);
    potential.cut_held(matrix_);
    // The rows that are not live keep what they held when they were.
    for (const int i : potential.live().rows()) {
        Mat3& own = matrix_.block[matrix_.diagonal[i]];
        if (potential.held(i))
            own.setZero();  // a negative E would outweigh the unit block of a held node
        else
            own.diagonal().array() += dt_s * error.alpha_per_s * body.mass_g[i];
    }
    for (const int i : potential.live().rows())
        for (int k = matrix_.row_begin[i]; k < matrix_.row_begin[i + 1]; ++k)
            potential.matrix().block[k] += matrix_.block[k];
}

}  // namespace hepatica
