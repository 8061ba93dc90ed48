// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/device_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/stop.h"
#include "core/deform/solvers/error_bound.h"

namespace hepatica::gpu {

template <class Real>
DeviceSolver<Real>::DeviceSolver(Machine& machine, const Partition& nodes, std::size_t node_count)
    : machine_(machine),
      nodes_(nodes),
      x_(machine, node_count),
      r_(machine, node_count),
      z_(machine, node_count),
      p_(machine, node_count),
      product_(machine, node_count),
      inverse_(machine, node_count),
      scalars_(machine, 1),
      record_(machine, batch) {}

template <class Real>
SolveScalars DeviceSolver<Real>::scalars() const {
    SolveScalars now;
    scalars_.download({&now, 1});
    return now;
}

// After a term that leaves r and z = D^-1 r.
template <class Real>
template <class Term, class Then>
void DeviceSolver<Real>::precondition(const Term& term, const Then& then,
                                      const DeviceSkeleton<Real>* skeleton) {
    if (skeleton == nullptr) return nodes_.sum(term, then);
    nodes_.apply(term);
    skeleton->correct(nodes_, r_.read(), z_.view(), then);
}

template <class Real>
void DeviceSolver<Real>::begin(const SystemView<Real>& system, View<const Vector3<Real>> b,
                               const DeviceSkeleton<Real>* skeleton) {
    machine_.for_each(InvertDiagonal<Real>{system, inverse_.view()});
    precondition(BeginSolve<Real>{b, inverse_.read(), x_.view(), r_.view(), z_.view()},
                 StartIteration{scalars_.view()}, skeleton);
}

template <class Real>
void DeviceSolver<Real>::iterate(const SystemView<Real>& system,
                                 const DeviceSkeleton<Real>* skeleton) {
    machine_.for_each(TurnDirection<Real>{scalars_.read(), z_.read(), p_.view()});
    nodes_.sum(Product<Real>{system, p_.read(), product_.view()}, ChooseStep{scalars_.view()});
    precondition(TakeStep<Real>{scalars_.read(), p_.read(), product_.read(), inverse_.read(),
                                x_.view(), r_.view(), z_.view()},
                 EndIteration{scalars_.view(), record_.view()}, skeleton);
}

template <class Real>
SolveReport DeviceSolver<Real>::solve(const SystemView<Real>& system, View<const Vector3<Real>> b,
                                      const DeviceSkeleton<Real>* skeleton,
                                      const SolveLimits& limits, const std::stop_token& stop) {
    SolveReport report;
    report.method = skeleton != nullptr ? "skeleton" : "block-jacobi";
    begin(system, b, skeleton);
    SolveScalars now = scalars();
    const double rhs_squared = now.residual_squared;
    if (!(rhs_squared > 0.0) || !std::isfinite(rhs_squared)) {
        report.converged = rhs_squared == 0.0;
        report.relative_residual = report.energy_error = report.converged ? 0.0 : 1.0;
        return report;
    }
    // What touches changes the spectrum from step to step: nothing is known of it from others.
    const bool touches = system.factors.touch != 0.0 && !system.touches.row.empty();
    ErrorBound bound(touches ? 0.0 : ErrorBound::relaxation * smallest_ritz_);
    double work = now.work, solution_energy = 0.0, error_squared = bound.before() * work;
    const double energy_limit = limits.energy_tolerance * limits.energy_tolerance;
    const double residual_limit = limits.residual_tolerance * limits.residual_tolerance;
    const auto finished = [&] {
        report.converged = (1.0 - energy_limit) * error_squared <= energy_limit * solution_energy ||
                           now.residual_squared <= residual_limit * rhs_squared ||
                           now.residual_squared == 0.0;
        return report.converged || now.broken != 0 || report.iterations >= limits.max_iterations;
    };
    std::array<IterationRecord, batch> records;
    while (!finished()) {
        throw_if_stopped(stop);
        const int more = std::min(batch, limits.max_iterations - report.iterations);
        for (int k = 0; k < more; ++k) iterate(system, skeleton);
        now = scalars();
        record_.download(records);
        for (; report.iterations < now.iterations; ++report.iterations) {
            const IterationRecord& done = records[report.iterations % batch];
            solution_energy += done.step * work;
            work = done.work;
            error_squared = bound.after(done.step, done.ratio) * work;
        }
    }
    if (report.iterations > 0 && !touches) smallest_ritz_ = bound.smallest();
    report.relative_residual = std::sqrt(now.residual_squared / rhs_squared);
    report.energy_error =
        std::isfinite(error_squared)
            ? std::sqrt(error_squared / (std::max(solution_energy, 0.0) + error_squared))
            : 1.0;
    return report;
}

template class DeviceSolver<float>;
template class DeviceSolver<double>;

}  // namespace hepatica::gpu
