// SPDX-License-Identifier: GPL-3.0-or-later
// Conjugate gradients on a machine, preconditioned by the inverse diagonal blocks and, where there
// is a skeleton, the additive correction of its coarse space. Iterations run
// there in batches; after each the host reads what they did and stops by the rules of
// ConjugateGradient, so that a solve may do a few iterations more than it needs. Where a residual
// is asked for that Real cannot hold, what is left is found in double and solved for again
// (iterative refinement, Wilkinson 1963).
#pragma once

#include <cmath>
#include <stop_token>

#include "core/deform/solvers/linear_solver.h"
#include "gpu/kernels/solve_kernels.h"
#include "gpu/step/device_skeleton.h"
#include "gpu/step/whole_sum.h"

namespace hepatica::gpu {

// Keeps references. Not thread-safe.
// Of one solve, with its products and sums, without what is prepared for it.
struct SolveCost {
    double seconds = 0.0;
    std::size_t kernel_bytes = 0;  // see bytes_of
};

template <class Real>
class DeviceSolver {
  public:
    DeviceSolver(Machine& machine, const WholeSum& nodes);
    void resize(std::size_t nodes);

    // `skeleton`, prepared for this matrix, may be null.
    // Solves A x = b from x = 0. Not converged where it broke down or ran out of iterations. Throws
    // Cancelled within a batch of iterations after a stop was asked for.
    SolveReport solve(const SystemView<Real>& system, View<const Vector3<double>> b,
                      const DeviceSkeleton<Real>* skeleton, const SolveLimits& limits,
                      const std::stop_token& stop = {});

    View<const Vector3<double>> solution() const { return solution_.read(); }
    View<const Vector3<double>> residual() const { return residual_.read(); }  // b - A x

    const SolveCost& cost() const { return cost_; }  // of the last solve

    // What it carries from one solve to the next, see ConjugateGradient.
    double smallest_ritz() const { return smallest_ritz_; }
    void remember(double smallest_ritz) { smallest_ritz_ = smallest_ritz; }

  private:
    static constexpr int batch = 8;

    // Of the solve so far: |x|_A squared, and the bound of the error in that norm, squared.
    struct Energies {
        double solution = 0.0, error = INFINITY;
        bool suffice(const SolveLimits& limits) const;
    };
    // Where a round ended: by the energies, by its residual, or not where it should.
    enum class End { energies, residual, early };

    End run_round(const SystemView<Real>& system, const DeviceSkeleton<Real>* skeleton,
                  const SolveLimits& limits, double residual_limit, Energies& energies,
                  SolveReport& report, const std::stop_token& stop);
    void iterate(const SystemView<Real>& system, const DeviceSkeleton<Real>* skeleton);
    template <class Term, class Then>
    void precondition(const Term& term, const Then& then, const DeviceSkeleton<Real>* skeleton);
    SolveScalars scalars() const;

    Machine& machine_;
    const WholeSum& nodes_;
    GrowingArray<Vector3<double>> solution_, residual_;
    GrowingArray<Vector3<Real>> x_, r_, z_, product_;  // of a round
    GrowingArray<Quad<Real>> p_;                       // its direction
    GrowingArray<Real> inverse_;                       // of the diagonal blocks, in planes
    Array<SolveScalars> scalars_;
    Array<IterationRecord> record_;
    SolveCost cost_;
    double smallest_ritz_ = 0.0;
};

extern template class DeviceSolver<float>;
extern template class DeviceSolver<double>;

}  // namespace hepatica::gpu
