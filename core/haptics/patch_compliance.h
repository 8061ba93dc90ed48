// SPDX-License-Identifier: GPL-3.0-or-later
// How a touched patch of a body gives way within one step: the block dt^2 J A^-1 J^T of the step's
// matrix A = (1 + dt alpha) M + dt beta K + dt^2 K of eq. (12), with tether and without any tool.
// It has a factor of its own, not the step's: that one holds the pad of the tool as well, at
// whatever iterate it was made, and belongs to the solver. So the play's bits cannot depend on who
// feels it.
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
    // Throws InputError where no body can be built. Edges are straight: of a quadratic body it is
    // that of its vertices.
    explicit PatchCompliance(const BodyDescription& body, ElementModel model);

    const Body& body() const { return body_; }

    // Factors A anew at these positions, one per vertex, where a vertex that is loaded has moved
    // against the others by more than a tenth of the patch since the last factor: less is a turn or
    // a stretch of a few degrees or per cent. Returns whether it did.
    bool follow(std::span<const Vec3> positions_mm, double dt_s, std::span<const SparseLoad> loads);
    // The displacement of each load's place along it, under each other load [mm/uN]. Forces on held
    // vertices do nothing.
    Eigen::MatrixXd block(std::span<const SparseLoad> loads, double dt_s) const;

    // A at these positions.
    void assemble(std::span<const Vec3> positions_mm, double dt_s);
    const BlockMatrix& matrix() const { return matrix_; }

  private:
    Body body_;
    Assembly assembly_;
    BlockMatrix matrix_;
    std::optional<TreeCholesky> factor_;
    std::vector<Vec3> factored_mm_;  // where the factor was made
    double factored_dt_s_ = 0.0;
};

}  // namespace hepatica
