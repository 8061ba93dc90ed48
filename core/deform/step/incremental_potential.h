// SPDX-License-Identifier: GPL-3.0-or-later
// The function that a step of backward Euler minimises, over the velocity w with x = x_n + dt w:
//   |w - v_n|_M^2 / 2 + U(x) + potentials(x) + dt |w|_B^2 / 2,   B = alpha M + beta K_n,
// with K_n held at the start of the step; its gradient, and the matrix of eq. (12),
//   A = (1 + dt alpha) M + dt beta K_n + dt^2 K + dt^2 K_potentials.
#pragma once

#include <span>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/solvers/block_matrix.h"
#include "core/deform/step/assembly.h"
#include "core/deform/step/step_underway.h"

namespace hepatica {

// Keeps a reference to the body. Not thread-safe. Fixed vertices are cut out of gradient and
// matrix: their change is 0 and nobody feels it.
class IncrementalPotential {
  public:
    IncrementalPotential(const Body& body, small::Tangent tangent);

    // Elements at the positions: elastic energy, forces, stiffness. What follows is at these.
    void evaluate(std::span<const Vec3> positions_mm);
    double elastic_energy() const { return elastic_; }
    const std::vector<Vec3>& elastic_force() const { return elastic_force_; }
    const Assembly& assembly() const { return assembly_; }

    double value(const StepUnderway& step) const;
    // -dt times the gradient: M (v_n - w) + dt f(x) - dt B w. Without beta K_n w in the first
    // iterate, where the matrix holds beta K and w is 0.
    void descent(const StepUnderway& step, std::vector<Vec3>& residual);
    // Elastic and of the potentials, at the last descent [uN].
    const std::vector<Vec3>& force() const { return force_; }

    // A at the present iterate.
    void assemble(const StepUnderway& step);
    BlockMatrix& matrix() { return matrix_; }
    // Sets the blocks beside the diagonal in rows and columns of fixed vertices to zero.
    void cut_fixed(BlockMatrix& matrix) const;

    // Keeps beta K_n, which the first iterate's matrix holds together with `beside` (may be null),
    // before that is overwritten.
    void keep_damping(const StepUnderway& step, const BlockMatrix* beside);
    // w^T beta K_n w, from what was kept.
    double damping_form(const std::vector<Vec3>& velocity);

  private:
    const Body& body_;
    Assembly assembly_;
    std::vector<int> cut_blocks_;  // beside the diagonal, with a fixed vertex
    BlockMatrix matrix_;
    BlockMatrix damping_;  // beta K_n
    double elastic_ = 0.0;
    std::vector<Vec3> elastic_force_, force_, product_;
};

}  // namespace hepatica
