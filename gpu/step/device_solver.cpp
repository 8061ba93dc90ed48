// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/device_solver.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "core/base/stop.h"
#include "core/deform/solvers/error_bound.h"

namespace hepatica::gpu {
namespace {

constexpr int most_rounds = 8;
// A round ends once its residual has fallen to this share of its initial value; Real allows no
// more.
template <class Real>
constexpr double least_residual = 1e-5;
template <>
constexpr double least_residual<double> = 1e-14;
// Another round is made while rounds reduce the residual at least by this factor.
constexpr double worth_a_round = 0.5;

double squared(double a) {
    return a * a;
}

// Number of further iterations if the error continues to fall at its mean rate so far, so that few
// are wasted; a large number where no rate is known.
int expected_iterations(double first_error, double error, int done, const SolveLimits& limits,
                        double solution) {
    constexpr int many = 1 << 20;
    const double wanted = squared(limits.energy_tolerance) * solution;
    const double fall = std::log(first_error / error) / done;
    if (done == 0 || !(wanted > 0.0) || !(fall > 0.0) || !std::isfinite(fall)) return many;
    return static_cast<int>(
        std::clamp(std::ceil(std::log(error / wanted) / fall), 1.0, static_cast<double>(many)));
}

}  // namespace

template <class Real>
DeviceSolver<Real>::DeviceSolver(Machine& machine, const WholeSum& nodes)
    : machine_(machine),
      nodes_(nodes),
      solution_(machine),
      residual_(machine),
      x_(machine),
      r_(machine),
      z_(machine),
      product_(machine),
      p_(machine),
      inverse_(machine),
      scalars_(machine, 1),
      record_(machine, batch) {}

template <class Real>
void DeviceSolver<Real>::resize(std::size_t nodes) {
    for (auto* vector : {&x_, &r_, &z_, &product_}) vector->resize(nodes);
    p_.resize(nodes);
    for (auto* vector : {&solution_, &residual_}) vector->resize(nodes);
    inverse_.resize(9 * nodes);
}

template <class Real>
SolveScalars DeviceSolver<Real>::scalars() const {
    SolveScalars now;
    scalars_.download({&now, 1});
    return now;
}

// Applies the preconditioner after a term that leaves r and z = D^-1 r.
template <class Real>
template <class Term, class Then>
void DeviceSolver<Real>::precondition(const Term& term, const Then& then,
                                      const DeviceSkeleton<Real>* skeleton) {
    if (skeleton == nullptr) return nodes_.sum(term, then);
    nodes_.apply(term);
    skeleton->correct(nodes_, r_.read(), z_.view(), then);
}

template <class Real>
void DeviceSolver<Real>::iterate(const SystemView<Real>& system,
                                 const DeviceSkeleton<Real>* skeleton) {
    machine_.for_each(TurnDirection<Real>{scalars_.read(), z_.read(), p_.view()});
    nodes_.rows(system, p_.read(), KeepProduct<Real>{product_.view()}, ChooseStep{scalars_.view()});
    precondition(
        TakeStep<Real>{scalars_.read(), p_.read(), product_.read(),
                       MatrixPlanes<Real>(inverse_.read()), x_.view(), r_.view(), z_.view()},
        EndIteration{scalars_.view(), record_.view()}, skeleton);
}

template <class Real>
bool DeviceSolver<Real>::Energies::suffice(const SolveLimits& limits) const {
    const double limit = squared(limits.energy_tolerance);
    return (1.0 - limit) * error <= limit * solution;
}

// Conjugate gradients on A x_ = residual_ from 0, until the squared residual is below the limit.
template <class Real>
typename DeviceSolver<Real>::End DeviceSolver<Real>::run_round(
    const SystemView<Real>& system, const DeviceSkeleton<Real>* skeleton, const SolveLimits& limits,
    double residual_limit, Energies& energies, SolveReport& report, const std::stop_token& stop) {
    precondition(BeginRound<Real>{residual_.read(), MatrixPlanes<Real>(inverse_.read()), x_.view(),
                                  r_.view(), z_.view()},
                 StartIteration{scalars_.view()}, skeleton);
    SolveScalars now = scalars();
    // Contacts change the spectrum from step to step, so no bound is carried over.
    const bool touches = system.factors.touch != 0.0 && !system.touches.row.empty();
    ErrorBound bound(touches ? 0.0 : ErrorBound::relaxation * smallest_ritz_);
    double work = now.work;
    energies.error = bound.before() * work;
    const double first_error = energies.error;
    int done = 0;
    std::array<IterationRecord, batch> records;
    const auto met = [&] { return now.residual_squared <= residual_limit; };
    while (!energies.suffice(limits) && !met() && now.broken == 0 &&
           report.iterations < limits.max_iterations) {
        throw_if_stopped(stop);
        const int more = std::min(
            {batch,
             expected_iterations(first_error, energies.error, done, limits, energies.solution),
             limits.max_iterations - report.iterations});
        for (int k = 0; k < more; ++k) iterate(system, skeleton);
        now = scalars();
        record_.download(records);
        for (; done < now.iterations; ++done, ++report.iterations) {
            const IterationRecord& one = records[done % batch];
            energies.solution += one.step * work;
            work = one.work;
            energies.error = bound.after(one.step, one.ratio) * work;
        }
    }
    if (done > 0 && !touches) smallest_ritz_ = bound.smallest();
    if (energies.suffice(limits)) return End::energies;
    return met() ? End::residual : End::early;
}

template <class Real>
SolveReport DeviceSolver<Real>::solve(const SystemView<Real>& system, View<const Vector3<double>> b,
                                      const DeviceSkeleton<Real>* skeleton,
                                      const SolveLimits& limits, const std::stop_token& stop) {
    cost_ = {};
    SolveReport report;
    report.method = skeleton != nullptr ? "skeleton" : "block-jacobi";
    const double rhs_squared = nodes_.read(BeginSolve{b, solution_.view(), residual_.view()})[0];
    if (!(rhs_squared > 0.0) || !std::isfinite(rhs_squared)) {
        report.converged = rhs_squared == 0.0;
        report.relative_residual = report.energy_error = report.converged ? 0.0 : 1.0;
        return report;
    }
    using Clock = std::chrono::steady_clock;
    // The sum above and the last residual wait for the machine, so that the clock measures its
    // work.
    const auto start = Clock::now();
    const std::size_t bytes_before = machine_.traffic().kernel_bytes;
    machine_.for_each(InvertDiagonal<Real>{system, Planes<Matrix3<Real>, Real>(inverse_.view())});
    const double wanted = squared(limits.residual_tolerance) * rhs_squared;
    double left = rhs_squared, before = 0.0;  // squared residual
    Energies energies;
    End end = End::residual;
    for (int round = 0; round < most_rounds; ++round) {
        end = run_round(system, skeleton, limits,
                        std::max(wanted, squared(least_residual<Real>) * left), energies, report,
                        stop);
        machine_.for_each(AddCorrection<Real>{x_.read(), solution_.view()});
        before = left;
        left = nodes_.read_rows(system, solution_.read(), KeepResidual{b, residual_.view()})[0];
        if (end != End::residual || left <= wanted || !(left < squared(worth_a_round) * before))
            break;
    }
    cost_ = {std::chrono::duration<double>(Clock::now() - start).count(),
             machine_.traffic().kernel_bytes - bytes_before};
    report.converged = end != End::early;
    report.relative_residual = std::sqrt(left / rhs_squared);
    report.energy_error =
        std::isfinite(energies.error)
            ? std::sqrt(energies.error / (std::max(energies.solution, 0.0) + energies.error))
            : 1.0;
    return report;
}

template class DeviceSolver<float>;
template class DeviceSolver<double>;

}  // namespace hepatica::gpu
