// SPDX-License-Identifier: GPL-3.0-or-later
// A stop that is asked for within a step ends it before the next solve, evaluation or substep.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/stop.h"
#include "core/deform/step/backward_euler.h"
#include "core/deform/step/path_work.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "tests/deform/support/odd_solver.h"
#include "tests/deform/support/test_bodies.h"
#include "tests/support/asked_to_stop.h"

namespace hepatica {
namespace {

BodyDescription bar_to_stop() {
    return test::description_of(test::make_bar(12.0, 3.0, 8, 2));
}

BodyState at_rest(const Body& body) {
    return {body.rest_positions_mm, std::vector<Vec3>(body.node_count(), Vec3::Zero())};
}

class StoppedStep : public testing::Test {
  protected:
    StoppedStep() { potentials_.set_gravity(Vec3(0, -98100, 0)); }

    // Steps with Newton's method, and asks for a stop within the n-th solve.
    void step_until_solve(int n, int iterations) {
        NewtonSettings settings{.iterations = iterations, .tolerance = 1e-14};
        BackwardEuler integrator(body_, settings,
                                 std::make_unique<test::OddSolver>(solves_, 0, [this, n] {
                                     if (solves_ == n) source_.request_stop();
                                 }));
        integrator.advance(state_, 1.0 / 60.0, potentials_, source_.get_token());
    }

    Body body_ = build_body(bar_to_stop(), ElementModel::corotated, ElementOrder::linear);
    PotentialList potentials_{body_};
    BodyState state_ = at_rest(body_);
    std::stop_source source_;
    int solves_ = 0;
};

TEST_F(StoppedStep, MakesNoFurtherIterate) {
    EXPECT_THROW(step_until_solve(3, 20), Cancelled);
    EXPECT_EQ(solves_, 3);
    EXPECT_EQ(state_.positions_mm, body_.rest_positions_mm);
}

TEST_F(StoppedStep, SolvesNothingWhereItWasAskedBefore) {
    source_.request_stop();
    EXPECT_THROW(step_until_solve(0, 20), Cancelled);
    EXPECT_EQ(solves_, 0);
}

// Answers nothing: it asks for a stop, and listens as every solver does between its iterations.
class ListeningSolver final : public LinearSolver {
  public:
    ListeningSolver(std::stop_source source, bool& deaf)
        : source_(std::move(source)), deaf_(deaf) {}

    void update(const BlockMatrix&, std::span<const Vec3>, std::span<const int>) override {}
    SolveReport solve(std::span<const Vec3>, std::span<Vec3>, const SolveLimits&) override {
        source_.request_stop();
        throw_if_stopped(stop());
        deaf_ = true;
        return {};
    }
    void precondition(const std::vector<Vec3>& r, std::vector<Vec3>& z) override { z = r; }
    std::string_view name() const override { return "listening"; }
    bool made_from_latest() const override { return false; }
    std::vector<double> memory() const override { return {}; }
    void restore(const BlockMatrix&, bool, std::span<const Vec3>,
                 std::span<const double>) override {}

  private:
    std::stop_source source_;
    bool& deaf_;
};

TEST_F(StoppedStep, ItsSolverIsTold) {
    bool deaf = false;
    BackwardEuler integrator(body_, {}, std::make_unique<ListeningSolver>(source_, deaf));
    EXPECT_THROW(integrator.advance(state_, 1.0 / 60.0, potentials_, source_.get_token()),
                 Cancelled);
    EXPECT_FALSE(deaf);
}

TEST_F(StoppedStep, GoesNowhereAlongTheDirectionThatItHas) {
    EXPECT_THROW(step_until_solve(1, 1), Cancelled);
    EXPECT_EQ(state_.positions_mm, body_.rest_positions_mm);
}

TEST_F(StoppedStep, IsMadeWholeWhereNobodyAsks) {
    EXPECT_NO_THROW(step_until_solve(0, 20));
    EXPECT_GT(solves_, 3);
    EXPECT_NE(state_.positions_mm, body_.rest_positions_mm);
}

TEST_F(StoppedStep, AnAuditHearsIt) {
    Assembly assembly(body_);
    PathWork work(assembly);
    EXPECT_THROW(work.along(body_.rest_positions_mm, body_.rest_positions_mm, potentials_, 0.0,
                            test::asked_to_stop()),
                 Cancelled);
}

// The bits of a stepper that was restored after a stop are those of one that was never stopped.
TEST(StoppedStepper, IsRestoredToWhatItWas) {
    for (const LinearSolverKind kind :
         {LinearSolverKind::block_jacobi, LinearSolverKind::skeleton, LinearSolverKind::cholesky}) {
        SCOPED_TRACE(name_of(kind));
        const StepperOptions options{.solver = kind, .newton_iterations = 3, .substeps = 4};
        const auto stopped = make_cpu_stepper(bar_to_stop(), options);
        const auto plain = make_cpu_stepper(bar_to_stop(), options);
        for (const auto& stepper : {stopped.get(), plain.get()}) {
            stepper->set_gravity(Vec3(0, -9810, 0));
            for (int k = 0; k < 5; ++k) stepper->step(1.0 / 60.0);
        }
        const StepperCheckpoint before = stopped->checkpoint();
        EXPECT_THROW(stopped->step(1.0 / 60.0, test::asked_to_stop()), Cancelled);
        stopped->restore(before);
        for (int k = 0; k < 5; ++k) {
            stopped->step(1.0 / 60.0);
            plain->step(1.0 / 60.0);
            EXPECT_EQ(stopped->state_hash(), plain->state_hash());
        }
    }
}

}  // namespace
}  // namespace hepatica
