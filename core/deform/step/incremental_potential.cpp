// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/incremental_potential.h"

#include "core/deform/solvers/node_loops.h"

namespace hepatica {

IncrementalPotential::IncrementalPotential(const Body& body, small::Tangent tangent)
    : body_(body),
      assembly_(body, tangent),
      elastic_force_(body.node_count()),
      force_(body.node_count()),
      product_(body.node_count()) {
    const AssemblyPlan& plan = assembly_.plan();
    for (int i = 0; i < body.node_count(); ++i)
        for (int k = plan.row_begin[i]; k < plan.row_begin[i + 1]; ++k) {
            const int j = plan.column[k];
            if (i != j && (body.fixed[i] || body.fixed[j])) cut_blocks_.push_back(k);
        }
}

void IncrementalPotential::evaluate(std::span<const Vec3> positions_mm) {
    elastic_ = assembly_.evaluate(positions_mm);
    assembly_.gather_forces(elastic_force_);
}

double IncrementalPotential::value(const StepUnderway& step) const {
    const double dt = step.dt_s, alpha = body_.damping.alpha_per_s;
    const double inertia = sum_over_nodes(step.velocity.size(), [&](std::size_t i) {
        const Vec3 change = step.velocity[i] - step.start.velocities_mm_per_s[i];
        return 0.5 * body_.mass_g[i] *
               (change.squaredNorm() + dt * alpha * step.velocity[i].squaredNorm());
    });
    return inertia + 0.5 * dt * step.damping_form + elastic_ +
           step.potentials.energy(step.positions, step.start.positions_mm);
}

void IncrementalPotential::descent(const StepUnderway& step, std::vector<Vec3>& residual) {
    const double dt = step.dt_s, alpha = body_.damping.alpha_per_s;
    force_ = elastic_force_;
    step.potentials.add_forces(step.positions, force_);
    const bool damped = step.iterate > 0 && body_.damping.beta_s > 0.0;
    if (damped) multiply(damping_, step.velocity, product_);
    residual.resize(force_.size());
    for_each_node(residual.size(), [&](std::size_t i) {
        residual[i] = body_.mass_g[i] * (step.start.velocities_mm_per_s[i] -
                                         (1.0 + dt * alpha) * step.velocity[i]) +
                      dt * force_[i];
        if (damped) residual[i] -= dt * product_[i];
        if (body_.fixed[i]) residual[i].setZero();
    });
}

void IncrementalPotential::cut_fixed(BlockMatrix& matrix) const {
    for (const int k : cut_blocks_) matrix.block[k].setZero();
}

void IncrementalPotential::assemble(const StepUnderway& step) {
    const double dt = step.dt_s, beta = body_.damping.beta_s;
    assembly_.gather_stiffness(step.iterate == 0 ? dt * dt + dt * beta : dt * dt, matrix_);
    if (step.iterate > 0 && beta > 0.0)
        for_each_node(matrix_.block.size(),
                      [&](std::size_t k) { matrix_.block[k] += dt * damping_.block[k]; });
    const double inertia = 1.0 + dt * body_.damping.alpha_per_s;
    for_each_node(step.positions.size(), [&](std::size_t i) {
        matrix_.block[matrix_.diagonal[i]].diagonal().array() += inertia * body_.mass_g[i];
    });
    step.potentials.add_stiffness(step.positions, dt * dt, matrix_);
    cut_fixed(matrix_);
    for (int i = 0; i < matrix_.rows(); ++i)
        if (body_.fixed[i]) {
            Mat3& block = matrix_.block[matrix_.diagonal[i]];
            block = (block.trace() / 3.0) * Mat3::Identity();
        }
}

// Fixed vertices do not move, so that it does not matter that they were cut out of the matrix.
void IncrementalPotential::keep_damping(const StepUnderway& step, const BlockMatrix* beside) {
    const double dt = step.dt_s, beta = body_.damping.beta_s;
    damping_ = matrix_;
    for (std::size_t k = 0; beside && k < damping_.block.size(); ++k)
        damping_.block[k] -= beside->block[k];
    const double inertia = 1.0 + dt * body_.damping.alpha_per_s;
    for_each_node(body_.mass_g.size(), [&](std::size_t i) {
        damping_.block[damping_.diagonal[i]].diagonal().array() -= inertia * body_.mass_g[i];
    });
    step.potentials.add_stiffness(step.start.positions_mm, -dt * dt, damping_);
    const double scale = beta / (dt * dt + dt * beta);
    for_each_node(damping_.block.size(), [&](std::size_t k) { damping_.block[k] *= scale; });
}

double IncrementalPotential::damping_form(const std::vector<Vec3>& velocity) {
    multiply(damping_, velocity, product_);
    return dot(velocity, product_);
}

}  // namespace hepatica
