// SPDX-License-Identifier: GPL-3.0-or-later
// The function that a step of backward Euler minimises over the velocity w, with x = x_n + dt w:
//   |w - v_n|_M^2 / 2 + U(x) + potentials(x) + dt |w|_B^2 / 2,   B = alpha M + beta K_0,
// where K_0 is that of the first iterate throughout the step; its gradient; and the matrix of eq.
// (12),
//   A = (1 + dt alpha) M + dt beta K_0 + dt^2 K + dt^2 K_potentials.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/solvers/block_matrix.h"
#include "core/deform/step/assembly.h"
#include "core/deform/step/collapse_stiffness.h"
#include "core/deform/step/step_underway.h"
#include "core/deform/step/tension_stiffness.h"

namespace hepatica {

// Keeps a reference to the body. Not thread-safe. Held nodes are eliminated from gradient and
// matrix: their unknowns are 0 and coupled to no other node.
class IncrementalPotential {
  public:
    IncrementalPotential(const Body& body, small::Tangent tangent);
    // To be called after the body's nodes were split; `before` is the body until then. The result
    // is that of a new object, except for the slots: all elements must be evaluated before the next
    // step.
    void follow_split(const Body& before);

    // The rows that are computed. All others have a unit block on the diagonal.
    const LiveSet& live() const { return live_; }
    bool held(std::size_t node) const { return live_.held()[node] != 0; }
    // Freezes exactly these nodes; the rest continues from its present state.
    void freeze(std::span<const std::uint8_t> frozen);

    // Evaluates the elements at the positions: elastic energy and forces, and in evaluate() the
    // stiffness too. The functions below refer to these positions; assemble() evaluates the
    // stiffness where it is missing.
    void evaluate(std::span<const Vec3> positions_mm);
    void evaluate_forces(std::span<const Vec3> positions_mm);
    // Evaluates every element, live or not: needed after the state was changed from outside.
    void evaluate_all_forces(std::span<const Vec3> positions_mm);
    double elastic_energy() const { return elastic_; }
    const std::vector<Vec3>& elastic_force() const { return elastic_force_; }
    const Assembly& assembly() const { return assembly_; }

    double value(const StepUnderway& step) const;
    // -dt times the gradient: M (v_n - w) + dt f(x) - dt B w, with the step's damping_force.
    void descent(const StepUnderway& step, std::vector<Vec3>& residual);
    // The sum of elastic forces and those of the potentials [uN], which descent() and assemble()
    // use. Both find_force() and descent() compute it.
    void find_force(const StepUnderway& step);
    const std::vector<Vec3>& force() const { return force_; }

    // Assembles A at the present iterate; force() must be that of the iterate. Collapsed elements
    // contribute if count_collapse() is on, but not to the value, the gradient, damping_from() or
    // keep_damping().
    void assemble(const StepUnderway& step);
    void count_collapse(bool on) { collapse_counts_ = on; }
    bool collapse_counts() const { return collapse_counts_; }
    bool collapsed() const { return collapse_.any(); }
    BlockMatrix& matrix() { return matrix_; }
    // Builds what find_tension() needs, for which its first call would else take time.
    void plan_tension() {
        if (!tension_) tension_.emplace(body_, assembly_.plan(), live_);
    }
    // Finds the taut elements at the positions of the last evaluation; taut(): whether there are
    // any.
    void find_tension() {
        plan_tension();
        tension_->find(assembly_.slots());
    }
    bool taut() const { return tension_ && tension_->any(); }
    // Adds their rotational stiffness to A, in the frames of the present iterate. The value, the
    // gradient, damping_from() and keep_damping() do not contain it.
    void add_tension(double dt_s);
    // The rows that the last assemble() may have changed.
    std::span<const int> assembled_rows() const { return assembled_rows_; }
    // To be called where the matrix was used for anything but the current step.
    void forget_matrix();
    // Zeroes the off-diagonal blocks in rows and columns of held nodes.
    void cut_held(BlockMatrix& matrix) const;

    // beta K_0 d from `product` = A d, where A is the matrix of the first iterate at `first_mm`.
    void damping_from(const StepUnderway& step, std::span<const Vec3> first_mm,
                      const std::vector<Vec3>& d, const std::vector<Vec3>& product,
                      std::vector<Vec3>& damping) const;
    // Saves beta K_0 before the first iterate's matrix, which contains it together with `beside`
    // (may be null), is overwritten. Only live rows are saved, because nothing else moves.
    // `first_mm` are the positions of that iterate.
    void keep_damping(const StepUnderway& step, std::span<const Vec3> first_mm,
                      const BlockMatrix* beside);
    // beta K_0 w, from the saved matrix.
    void damping_of(const std::vector<Vec3>& velocity, std::vector<Vec3>& damping) const {
        multiply(damping_, velocity, damping);
    }

  private:
    template <class Visit>
    void for_each_live_row(const Visit& visit) const;
    void lay_out();
    void find_cut_blocks();

    const Body& body_;
    LiveSet live_;
    Assembly assembly_;
    std::optional<TensionStiffness> tension_;  // created once a setting needs it
    bool tension_added_ = false;               // to the matrix
    CollapseStiffness collapse_;               // of the matrix
    bool collapse_counts_ = false;
    std::vector<int> cut_blocks_;  // off-diagonal, with a held node
    bool cut_is_wide_ = false;     // some are in rows that are no longer written
    std::vector<int> assembled_rows_;
    BlockMatrix matrix_;
    BlockMatrix damping_;           // beta K_0
    bool stiffness_known_ = false;  // the slots hold the stiffness at the present positions
    double elastic_ = 0.0;
    std::vector<Vec3> elastic_force_, force_;
};

}  // namespace hepatica
