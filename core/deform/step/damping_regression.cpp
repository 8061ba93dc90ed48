// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/damping_regression.h"

#include <algorithm>
#include <cmath>

#include "core/deform/solvers/node_loops.h"
#include "core/deform/step/assembly.h"

namespace hepatica {
namespace {

std::vector<Vec3> difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    std::vector<Vec3> d(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) d[i] = a[i] - b[i];
    return d;
}

}  // namespace

void DampingRegression::add(std::span<const Vec3> residual_un, std::span<const Vec3> mass_times_dv,
                            std::span<const Vec3> stiffness_times_dv) {
    mm_ += dot(mass_times_dv, mass_times_dv);
    mk_ += dot(mass_times_dv, stiffness_times_dv);
    kk_ += dot(stiffness_times_dv, stiffness_times_dv);
    rm_ -= dot(residual_un, mass_times_dv);
    rk_ -= dot(residual_un, stiffness_times_dv);
    rr_ += dot(residual_un, residual_un);
    ++steps_;
}

DampingFit DampingRegression::fit(double threshold) const {
    DampingFit fit;
    fit.steps = steps_;
    const double determinant = mm_ * kk_ - mk_ * mk_;
    // Where the two regressors are parallel, only stiffness is used, which fits stiff bodies
    // better.
    double e_m = 0.0, e_k = kk_ > 0.0 ? rk_ / kk_ : 0.0;
    if (determinant > 1e-10 * mm_ * kk_) {
        e_m = (rm_ * kk_ - rk_ * mk_) / determinant;
        e_k = (rk_ * mm_ - rm_ * mk_) / determinant;
    }
    if (rr_ > 0.0) fit.r_squared = std::clamp((e_m * rm_ + e_k * rk_) / rr_, 0.0, 1.0);
    fit.used = fit.r_squared >= threshold;
    if (fit.used) fit.error = {e_m, e_k};
    return fit;
}

DampingFit fit_damping(const Body& body, std::span<const BodyState> recorded, double threshold) {
    Assembly assembly(body);
    BlockMatrix stiffness;
    const std::size_t nodes = body.mass_g.size();
    std::vector<Vec3> before(nodes), after(nodes), product(nodes), k_dx(nodes), k_dv(nodes),
        m_dv(nodes), residual(nodes);
    DampingRegression regression;
    const RayleighDamping& damping = body.damping;
    const auto damped_force = [&](const BodyState& state, std::vector<Vec3>& force) {
        assembly.evaluate(state.positions_mm);
        assembly.gather_forces(force);
        assembly.gather_stiffness(1.0, stiffness);
        multiply(stiffness, state.velocities_mm_per_s, product);
        for (std::size_t i = 0; i < nodes; ++i)
            force[i] -= damping.alpha_per_s * body.mass_g[i] * state.velocities_mm_per_s[i] +
                        damping.beta_s * product[i];
    };
    for (std::size_t s = 0; s + 1 < recorded.size(); ++s) {
        damped_force(recorded[s + 1], after);
        damped_force(recorded[s], before);  // last, so that the slots keep the earlier stiffness
        const auto dx = difference(recorded[s + 1].positions_mm, recorded[s].positions_mm);
        const auto dv =
            difference(recorded[s + 1].velocities_mm_per_s, recorded[s].velocities_mm_per_s);
        multiply(stiffness, dx, k_dx);
        multiply(stiffness, dv, k_dv);
        for (std::size_t i = 0; i < nodes; ++i) {
            m_dv[i] = body.fixed[i] ? Vec3(Vec3::Zero()) : Vec3(body.mass_g[i] * dv[i]);
            residual[i] = after[i] - before[i] + damping.alpha_per_s * body.mass_g[i] * dv[i] +
                          damping.beta_s * k_dv[i] + k_dx[i];
            if (!body.fixed[i]) continue;
            residual[i].setZero();
            k_dv[i].setZero();
        }
        regression.add(residual, m_dv, k_dv);
    }
    return regression.fit(threshold);
}

}  // namespace hepatica
