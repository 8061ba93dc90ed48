// SPDX-License-Identifier: GPL-3.0-or-later
// Conjugate gradients on a machine, preconditioned by the inverse diagonal blocks and, with a
// skeleton, additively by its coarse space. Iterations run in batches; after each the host reads
// their records and stops by the rules of ConjugateGradient, so a solve may do a few iterations
// more than needed. Where the wanted residual is beyond the precision of Real, the residual is
// computed in double and solved for again (iterative refinement, Wilkinson 1963).
#pragma once

#include <cmath>
#include <stop_token>

#include "core/deform/solvers/linear_solver.h"
#include "gpu/kernels/solve_kernels.h"
#include "gpu/step/device_skeleton.h"
#include "gpu/step/whole_sum.h"

namespace hepatica::gpu {

// Cost of one solve with its products and sums, without the preparation of the skeleton.
struct SolveCost {
    double seconds = 0.0;
    std::size_t kernel_bytes = 0;  // see bytes_of

    SolveCost& operator+=(const SolveCost& more) {
        seconds += more.seconds;
        kernel_bytes += more.kernel_bytes;
        return *this;
    }
};

template <class Real>
class DeviceSolver {
  public:
    DeviceSolver(Machine& machine, const WholeSum& nodes);
    void resize(std::size_t nodes);

    // Solves A x = b from x = 0. `skeleton` must be prepared for this matrix, or null. Not
    // converged where it broke down or ran out of iterations. Throws Cancelled within one batch of
    // iterations after a stop was requested.
    SolveReport solve(const SystemView<Real>& system, View<const Vector3<double>> b,
                      const DeviceSkeleton<Real>* skeleton, const SolveLimits& limits,
                      const std::stop_token& stop = {});

    View<const Vector3<double>> solution() const { return solution_.read(); }
    View<const Vector3<double>> residual() const { return residual_.read(); }  // b - A x

    // Of the last solve; none where its right-hand side was zero.
    const SolveCost& cost() const { return cost_; }

    // The value carried from one solve to the next, see ConjugateGradient.
    double smallest_ritz() const { return smallest_ritz_; }
    void remember(double smallest_ritz) { smallest_ritz_ = smallest_ritz; }

  private:
    static constexpr int batch = 8;

    // Of the solve so far: |x|_A squared, and the bound of the squared error in that norm.
    struct Energies {
        double solution = 0.0, error = INFINITY;
        bool suffice(const SolveLimits& limits) const;
    };
    // Why a round ended: the energy criterion, the residual, or early without either.
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
