// SPDX-License-Identifier: GPL-3.0-or-later
// Solves the linear system of a Newton iterate, eq. (12): the potential's matrix A and the
// couplings between touching surfaces. Few couplings are left to iterations around the solver of A;
// for many a factor that includes them is worthwhile.
#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/solvers/coupled_factor.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/deform/step/incremental_potential.h"
#include "core/deform/step/solver_checkpoint.h"
#include "core/deform/step/step_underway.h"

namespace hepatica {

// Keeps references to the body and to the potential. Not thread-safe.
class StepSystem {
  public:
    StepSystem(const Body& body, IncrementalPotential& potential,
               std::unique_ptr<LinearSolver> solver)
        : body_(body), potential_(potential), solver_(std::move(solver)) {
        solver_->plan_ahead(potential_.matrix());  // while the body is built, not in its first step
    }

    // Makes solve() throw Cancelled soon after a stop is requested; then only restore() may be
    // called.
    void heed(const std::stop_token& stop);

    // x = (A + couplings)^-1 rhs within the limits, for the potential's present matrix, which must
    // be at least share * mass (see LinearSolver::bound_below).
    SolveReport solve(const StepUnderway& step, const CouplingBlocks& coupling, double share,
                      std::span<const Vec3> rhs, std::vector<Vec3>& x, const SolveLimits& limits);

    // A x of the last solution if the system had no couplings and the solve computed it, else null.
    // The matrix must not have changed since.
    const std::vector<Vec3>* product() const {
        return coupled_last_ ? nullptr : solver_->product();
    }

    // Whether the solver's factor is that of the last matrix. The inputs of that matrix must then
    // be passed to keep_origin() for later checkpoints.
    bool factor_is_latest() const { return !solver_unaware_ && solver_->made_from_latest(); }
    void keep_origin(SolverCheckpoint origin) { made_ = std::move(origin); }

    // The state carried from step to step. restore() recomputes the factor to the same bits and
    // leaves the potential at other positions; it throws InputError where the checkpoint does not
    // fit the body or the solver.
    SolverCheckpoint checkpoint() const;
    void restore(const SolverCheckpoint& checkpoint);

    std::unique_ptr<LinearSolver> release_solver() { return std::move(solver_); }

  private:
    const Body& body_;
    IncrementalPotential& potential_;
    std::unique_ptr<LinearSolver> solver_;
    CoupledFactor coupled_;        // replaces the solver where many surfaces touch
    bool coupled_last_ = false;    // the last system had couplings
    bool solver_unaware_ = false;  // solver_ has not seen the latest matrices
    SolverCheckpoint made_;        // without the solvers' memory, which checkpoint() adds
};

}  // namespace hepatica
