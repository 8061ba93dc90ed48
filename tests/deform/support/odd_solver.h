// SPDX-License-Identifier: GPL-3.0-or-later
// A linear solver that counts what it is asked for, and whose first answers can be made to point
// uphill, so that no step length along them lowers the potential of a step; and that tells of each.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/deform/solvers/linear_solver.h"

namespace hepatica::test {

class OddSolver final : public LinearSolver {
  public:
    std::vector<int> worn;  // iterations of each solve that was reported to wear()
    int drops = 0;          // pivots that the next solve reports as dropped

    // Counts its solves in `count`; the first `uphill` of them give the answer with its sign
    // turned. `told` is called behind each solve.
    explicit OddSolver(int& count, int uphill = 0, std::function<void()> told = {})
        : count_(count), uphill_(uphill), told_(std::move(told)) {}

    void update(const BlockMatrix& matrix, std::span<const Vec3> positions_mm,
                std::span<const int> changed_rows) override {
        solver_->update(matrix, positions_mm, changed_rows);
    }
    SolveReport solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                      const SolveLimits& limits) override {
        ++count_;
        SolveReport report = solver_->solve(rhs, x, limits);
        report.dropped_pivots = std::exchange(drops, 0);
        if (uphill_ > 0) {
            --uphill_;
            for (Vec3& value : x) value *= -1.0;
        }
        if (told_) told_();
        return report;
    }
    void precondition(const std::vector<Vec3>& r, std::vector<Vec3>& z) override {
        solver_->precondition(r, z);
    }
    void wear(const SolveReport& solved) override { worn.push_back(solved.iterations); }
    std::string_view name() const override { return "odd"; }
    bool made_from_latest() const override { return false; }
    std::vector<double> memory() const override { return {}; }
    void restore(const BlockMatrix&, bool, std::span<const Vec3>,
                 std::span<const double>) override {}

  private:
    int& count_;
    int uphill_;
    std::function<void()> told_;
    std::unique_ptr<LinearSolver> solver_ = make_block_jacobi_solver();
};

}  // namespace hepatica::test
