// SPDX-License-Identifier: GPL-3.0-or-later
// The trade-off of a body of one's own: a small clamped bar with a centreline.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/study/pull_trial.h"
#include "core/study/tradeoff.h"
#include "core/study/vessel_body.h"

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

TEST(BodyTradeoff, EndsWhenItIsCancelled) {
    Job job;
    job.cancel();
    EXPECT_THROW(measure_body_tradeoff({bar()}, {}, job), Cancelled);
}

}  // namespace
}  // namespace hepatica
