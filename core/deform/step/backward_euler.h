// SPDX-License-Identifier: GPL-3.0-or-later
// One step of backward Euler. The published step, eq. (12), is one Newton iterate from the state at
// hand:  (M + dt B + dt^2 K) dv = dt f - dt B v - dt^2 K v,  v += dv,  x += dt v.  More iterates
// minimise the incremental potential
//   |x - x_n - dt v_n|_M^2 / (2 dt^2) + U(x) - work of gravity + |x - x_n|_B^2 / (2 dt)
// with a line search that never accepts an increase. B is held at the start of the step. The first
// iterate's matrix may hold E of eq. (11) beside B; E meets dv only.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/body/body_state.h"
#include "core/deform/potentials/external_forces.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/deform/step/assembly.h"
#include "core/deform/step/energy_ledger.h"
#include "core/deform/stepper/stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"

namespace hepatica {

struct NewtonSettings {
    int iterations = 1;  // at most; 1 is the linearly implicit step
    // Iterates stop when no node moves further than this share of the mean edge length at rest.
    double tolerance = 1e-6;
    // Without it a single iterate is taken whole, as published, whatever it does to the energy.
    bool line_search = true;
    RayleighDamping velocity_error{};  // E of eq. (11), see StepperOptions
    SolveLimits linear{};
};

// Of all nodes [nJ].
double kinetic_energy(const Body& body, const std::vector<Vec3>& velocities_mm_per_s);

// Advances one body. Keeps a reference to the body. Not thread-safe.
class BackwardEuler {
  public:
    BackwardEuler(const Body& body, const NewtonSettings& settings,
                  std::unique_ptr<LinearSolver> solver);

    // Advances `state` by dt_s > 0 under `forces`; fills everything in the report but tool_work,
    // which only the caller knows. A step that cannot be made without an increase of the potential
    // is tried again in halves, and the report says so. A state that would not be finite is left as
    // it was, without velocity.
    StepReport advance(BodyState& state, double dt_s, const ExternalForces& forces);

    // From the next step on. One iterate and more of them need another tangent each: another
    // object.
    void set_settings(const NewtonSettings& settings);

    // Energy of elements, springs and weight at any positions [nJ].
    double potential_energy(std::span<const Vec3> positions_mm, const ExternalForces& forces) const;

    // That of the elements alone [nJ].
    double elastic_energy(std::span<const Vec3> positions_mm) const {
        return assembly_.energy(positions_mm);
    }

    // To be called after the state was changed from outside.
    void forget() { current_ = false; }

    // What the linear solver carries from step to step. restore() makes its factor anew to the bit;
    // it throws InputError where the checkpoint does not fit the body or the solver, and then
    // changes nothing.
    SolverCheckpoint checkpoint() const { return {made_from_, solver_->memory()}; }
    void restore(const SolverCheckpoint& checkpoint);

  private:
    struct Step;

    StepReport advance_in_parts(BodyState& state, double dt_s, const ExternalForces& forces,
                                int halvings_left);
    void evaluate(const std::vector<Vec3>& positions_mm);
    void assemble_again(const MatrixOrigin& origin);
    MatrixOrigin origin_of(const Step& step) const;
    void add_velocity_error(const Step& step);
    void assemble(const Step& step);
    void right_hand_side(const Step& step);
    void solve(const Step& step, StepReport& report);
    bool iterate(Step& step, StepReport& report);
    bool search_line(Step& step);
    bool find_velocity(Step& step, StepReport& report);
    void keep_damping(const Step& step);
    bool try_share(Step& step, double share, double slope);
    double potential(const Step& step) const;
    void limit_energy(Step& step, StepReport& report) const;
    void book_linearised(Step& step);
    void book(const Step& step, StepReport& report);

    const Body& body_;
    NewtonSettings settings_;
    bool has_error_ = false;
    std::unique_ptr<LinearSolver> solver_;
    Assembly assembly_;
    std::vector<int> cut_blocks_;  // of the matrix: beside the diagonal, with a fixed vertex
    BlockMatrix matrix_;
    BlockMatrix damping_;   // beta K at the start of the step; for further iterates
    bool current_ = false;  // slots, elastic_ and elastic_force_ belong to the state
    double elastic_ = 0.0;
    std::optional<MatrixOrigin> made_from_;  // see LinearSolver::made_from_latest
    BlockMatrix error_matrix_;               // dt E of this step, where there is any
    std::vector<Vec3> elastic_force_, force_, residual_, steepest_, change_, product_;
};

}  // namespace hepatica
