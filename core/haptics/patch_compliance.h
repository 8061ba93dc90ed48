// SPDX-License-Identifier: GPL-3.0-or-later
// The compliance of a touched patch of a body within one step: the block dt^2 J A^-1 J^T of the
// step's matrix A = (1 + dt alpha) M + dt beta K + dt^2 K of eq. (12), with tether and without any
// tool. It has its own factor, because the step's factor contains the tool's pad at some iterate
// and belongs to the solver. So the bits of the play cannot depend on a device.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/solvers/tree_cholesky.h"
#include "core/deform/step/assembly.h"

namespace hepatica {

// Not thread-safe.
class PatchCompliance {
  public:
    // Throws InputError where the body cannot be built. Uses linear elements, for a quadratic body
    // on its vertices.
    explicit PatchCompliance(const BodyDescription& body, ElementModel model);

    const Body& body() const { return body_; }

    // Factors A again at these positions, one per vertex, if dt_s changed or a loaded vertex has
    // moved relative to the others by more than a tenth of the patch, which is a rotation of a few
    // degrees or a stretch of some per cent. Returns whether it did.
    bool follow(std::span<const Vec3> positions_mm, double dt_s, std::span<const SparseLoad> loads);
    // The displacement of each load's place along the load, under each of the loads [mm/uN]. Forces
    // on fixed vertices have no effect.
    Eigen::MatrixXd block(std::span<const SparseLoad> loads, double dt_s) const;

    // Assembles A at these positions.
    void assemble(std::span<const Vec3> positions_mm, double dt_s);
    const BlockMatrix& matrix() const { return matrix_; }

  private:
    Body body_;
    Assembly assembly_;
    BlockMatrix matrix_;
    std::optional<TreeCholesky> factor_;
    std::vector<Vec3> factored_mm_;  // positions at the last factor
    double factored_dt_s_ = 0.0;
};

}  // namespace hepatica
