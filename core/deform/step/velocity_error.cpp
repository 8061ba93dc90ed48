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
    for (int i = 0; i < matrix_.rows(); ++i)
        matrix_.block[matrix_.diagonal[i]].diagonal().array() +=
            dt_s * error.alpha_per_s * body.mass_g[i];
    potential.cut_held(matrix_);
    for (std::size_t k = 0; k < matrix_.block.size(); ++k)
        potential.matrix().block[k] += matrix_.block[k];
}

}  // namespace hepatica
