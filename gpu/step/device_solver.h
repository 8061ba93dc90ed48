// SPDX-License-Identifier: GPL-3.0-or-later
// Conjugate gradients on a machine, preconditioned by the inverse diagonal blocks and, where there
// is a skeleton, the additive correction of its coarse space. Iterations run
// there in batches; after each the host reads what they did and stops by the rules of
// ConjugateGradient, so that a solve may do a few iterations more than it needs.
#pragma once

#include <stop_token>

#include "core/deform/solvers/linear_solver.h"
#include "gpu/kernels/solve_kernels.h"
#include "gpu/step/device_skeleton.h"
#include "gpu/step/partition.h"

namespace hepatica::gpu {

// Keeps references. Not thread-safe.
template <class Real>
class DeviceSolver {
  public:
    DeviceSolver(Machine& machine, const Partition& nodes, std::size_t node_count);

    // `skeleton`, prepared for this matrix, may be null.
    // Solves A x = b from x = 0. Not converged where it broke down or ran out of iterations. Throws
    // Cancelled within a batch of iterations after a stop was asked for.
    SolveReport solve(const SystemView<Real>& system, View<const Vector3<Real>> b,
                      const DeviceSkeleton<Real>* skeleton, const SolveLimits& limits,
                      const std::stop_token& stop = {});

    View<const Vector3<Real>> solution() const { return x_.read(); }
    View<const Vector3<Real>> residual() const { return r_.read(); }  // b - A x

    // What it carries from one solve to the next, see ConjugateGradient.
    double smallest_ritz() const { return smallest_ritz_; }
    void remember(double smallest_ritz) { smallest_ritz_ = smallest_ritz; }

  private:
    static constexpr int batch = 8;

    void begin(const SystemView<Real>& system, View<const Vector3<Real>> b,
               const DeviceSkeleton<Real>* skeleton);
    void iterate(const SystemView<Real>& system, const DeviceSkeleton<Real>* skeleton);
    template <class Term, class Then>
    void precondition(const Term& term, const Then& then, const DeviceSkeleton<Real>* skeleton);
    SolveScalars scalars() const;

    Machine& machine_;
    const Partition& nodes_;
    Array<Vector3<Real>> x_, r_, z_, p_, product_;
    Array<Matrix3<Real>> inverse_;
    Array<SolveScalars> scalars_;
    Array<IterationRecord> record_;
    double smallest_ritz_ = 0.0;
};

extern template class DeviceSolver<float>;
extern template class DeviceSolver<double>;

}  // namespace hepatica::gpu
