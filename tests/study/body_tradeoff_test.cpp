// SPDX-License-Identifier: GPL-3.0-or-later
// The trade-off of a body of one's own: a small clamped bar with a centreline.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>
#include <string>

#include "core/base/error.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/scene/setting_json.h"
#include "core/study/frame_meter.h"
#include "core/study/pull_trial.h"
#include "core/study/timing.h"
#include "core/study/tradeoff.h"
#include "core/study/vessel_body.h"
#include "tests/session/failing_stepper.h"
#include "tests/support/emulated_back_end.h"

namespace hepatica {
namespace {

const BodyDescription& bar() {
    static const BodyDescription body = [] {
        BodyDescription soft = study_bar(12.0, 1);
        soft.material.young_modulus_pa = 2e4;  // swings within the half second
        return soft;
    }();
    return body;
}

TEST(Pull, TakesTheBodyThreeFifthsAlongMovesThirtyMillimetresAndBack) {
    const Pull pull(bar());
    EXPECT_NEAR(pull.place_mm().x(), 0.6 * 72.0, 4.0);
    double stiffness = 0.0;
    for (const auto& [frame, moved_mm] :
         {std::pair{0, 1.0}, {29, 30.0}, {30, 29.0}, {Pull::frames - 1, 0.0}}) {
        const auto grabs = pull.grabs(bar(), frame);
        ASSERT_FALSE(grabs.empty());
        stiffness = 0.0;
        for (const Grab& grab : grabs) {
            const Vec3 moved = grab.target_mm - bar().mesh.vertices_mm[grab.vertices[0]];
            EXPECT_NEAR(moved.norm(), moved_mm, 1e-9) << frame;
            EXPECT_NEAR(moved.x(), 0.0, 1e-12);  // sideways
            stiffness += grab.stiffness_un_per_mm;
        }
    }
    constexpr double bar_radius_mm = 3.0;
    EXPECT_NEAR(stiffness, bar().material.young_modulus_pa * M_PI * bar_radius_mm, 0.2 * stiffness);
    BodyDescription loose = bar();
    loose.fixed.clear();
    EXPECT_THROW(Pull{loose}, InputError);
    loose.skeleton = {};
    EXPECT_THROW(Pull{loose}, InputError);
}

// An affine motion is seen exactly, by any mesh.
TEST(CentrelineProbes, SeeAnAffineMotionExactly) {
    Mat3 affine;
    affine << 1.1, 0.2, 0.0, -0.3, 0.9, 0.1, 0.0, 0.4, 1.2;
    const auto moved = [&](const Vec3& x) -> Vec3 { return affine * x + Vec3(1, 2, 3); };
    const std::vector<Vec3>& points = bar().skeleton.positions_mm;
    const BodyDescription finer = study_bar(12.0, 2);
    for (const BodyDescription* body : {&bar(), &finer}) {
        std::vector<Vec3> vertices;
        for (const Vec3& x : body->mesh.vertices_mm) vertices.push_back(moved(x));
        const auto places = CentrelineProbes(points, body->mesh).places_mm(vertices);
        for (std::size_t p = 0; p < points.size(); ++p)
            EXPECT_LT((places[p] - moved(points[p])).norm(), 1e-9);
    }
}

TEST(BodyTradeoff, FindsThatShorterStepsMissLess) {
    Job job;
    TradeoffOptions options;
    options.budget_s = 8.0;
    const Tradeoff found = measure_body_tradeoff({bar(), study_bar(12.0, 2)}, options, job);
    EXPECT_NE(found.reference.find("corotated-10"), std::string::npos) << found.reference;
    double one = 0.0, four = 0.0, few_iterations = 0.0;
    std::set<std::string> elements, solvers, regions;
    for (const TradeoffPoint& p : found.points) {
        EXPECT_EQ(p.not_measured.empty(), std::isfinite(p.error_relative));
        elements.insert(p.element);
        regions.insert(p.region);
        solvers.insert(std::string(name_of(p.options.solver)));
        if (!p.own_mesh || p.region == "live" || p.options.newton_iterations > 1) continue;
        if (p.options.solver == LinearSolverKind::block_jacobi &&
            p.options.linear.max_iterations == 5)
            few_iterations = p.error_relative;
        if (p.options.solver != LinearSolverKind::automatic || p.element != "corotated-10")
            continue;
        if (p.options.substeps == 1) one = p.error_relative;
        if (p.options.substeps == 4) four = p.error_relative;
    }
    EXPECT_EQ(elements.size(), 5u);
    EXPECT_EQ(solvers.size(), 4u);
    EXPECT_EQ(regions.size(), 2u);
    EXPECT_GT(one, 0.0);
    EXPECT_GT(four, 0.0);
    EXPECT_LT(four, 0.5 * one);
    EXPECT_GT(few_iterations, one);
}

// After the last frame nothing is left to do, and what was measured counts, however late it is.
TEST(Budget, LeavesOutOnlyWhatIsStillToBeDone) {
    EXPECT_EQ(why_no_time(0.0, -0.5), "");
    EXPECT_EQ(why_no_time(1.0, 1.0), "");
    EXPECT_EQ(why_no_time(1.0, 0.5), "needs 1 s more, 0.5 s were left");
    EXPECT_EQ(why_no_time(1.0, -0.5), "needs 1 s more, 0 s were left");
}

// A body falls asleep before it is pulled where only what moves is computed, within the budget.
TEST(Budget, HoldsWhileABodyFallsAsleep) {
    Job job;
    int steps = 0;
    const auto count = std::make_shared<test::Fault>(
        [&](const std::string& call) { steps += call == "begin step" ? 1 : 0; });
    test::FailingStepper stepper(make_live_stepper(bar(), {.sleeping = false}), count);
    EXPECT_FALSE(let_fall_asleep(stepper, 90, BudgetClock(0.0), job));
    EXPECT_EQ(steps, 0);
    EXPECT_TRUE(let_fall_asleep(stepper, 90, BudgetClock(1e9), job));
    EXPECT_LT(steps, 90);
    EXPECT_TRUE(stepper.step(1.0 / 60.0, {}).asleep);
}

// What the budget does not allow is named, with the reason; nothing runs on.
TEST(BodyTradeoff, NamesWhatTheBudgetLeftOut) {
    Job job;
    TradeoffOptions options;
    options.budget_s = 1e-3;
    const Tradeoff found = measure_body_tradeoff({bar()}, options, job);
    int left_out = 0;
    for (const TradeoffPoint& p : found.points) left_out += p.not_measured.empty() ? 0 : 1;
    EXPECT_GT(left_out, 0);
    EXPECT_GT(found.points.size(), 20u);
}

// No error is relative to a motion that is none.
TEST(BodyTradeoff, RefusesABodyThatDoesNotMove) {
    BodyDescription rigid = bar();
    rigid.fixed.assign(rigid.mesh.vertices_mm.size(), 1);
    Job job;
    EXPECT_THROW(measure_body_tradeoff({rigid}, {}, job), InputError);
}

TEST(BodyTradeoff, EndsWhenItIsCancelled) {
    Job job;
    job.cancel();
    EXPECT_THROW(measure_body_tradeoff({bar()}, {}, job), Cancelled);
}

// The same settings on a device: there they miss as much, and what it leaves to the processor is no
// setting of it.
TEST(BodyTradeoff, ListsTheSettingsOfADeviceBesideTheProcessors) {
    const test::EmulatedBackEnd device = test::emulated_back_end();
    Job job;
    TradeoffOptions options;
    options.budget_s = 20.0;
    options.device = device.back_end;
    const Tradeoff found = measure_body_tradeoff({bar()}, options, job);
    int measured = 0, left = 0;
    for (std::size_t i = 0; i + 1 < found.points.size(); i += 2) {
        const TradeoffPoint &here = found.points[i], &there = found.points[i + 1];
        EXPECT_EQ(here.back_end, "cpu");
        EXPECT_EQ(here.device, "");
        EXPECT_EQ(there.back_end, "cuda-emulated");
        EXPECT_EQ(there.device, device.back_end.device);
        EXPECT_EQ(there.element, here.element);
        EXPECT_EQ(there.region, here.region);
        EXPECT_TRUE(same_setting(there.options, here.options));
        const bool no_kernels = here.options.newton_iterations > 1 ||
                                here.options.solver == LinearSolverKind::cholesky ||
                                here.element == "neohookean-10";
        if (no_kernels && there.not_measured != "no time was left") {
            ++left;
            EXPECT_EQ(there.not_measured, "the device leaves such steps to the processor");
        }
        if (!here.not_measured.empty() || !there.not_measured.empty()) continue;
        ++measured;
        EXPECT_FALSE(no_kernels);
        // Five iterations from another preconditioner are another answer.
        if (here.options.linear.energy_tolerance > 0.0 &&
            here.options.linear.energy_tolerance < 0.1) {
            EXPECT_NEAR(there.error_relative, here.error_relative, 0.02 + 0.2 * here.error_relative)
                << words_of(here.options);
        }
    }
    EXPECT_GE(measured, 5);
    EXPECT_GE(left, 1);
    EXPECT_GT(device.device_steps(), 100);
}

}  // namespace
}  // namespace hepatica
