// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/iteration_study.h"

#include <gtest/gtest.h>

#include "core/study/vessel_body.h"

namespace hepatica {
namespace {

TEST(IterationStudy, TheSkeletonNeedsFewIterationsWhereBlockJacobiNeedsMany) {
    const BodyDescription body = study_bar(30.0, 2);
    const StudySystem system = study_system(body, 2.0);
    const IterationRow skeleton =
        measure_iterations("bar", body, system, 30.0, LinearSolverKind::skeleton);
    const IterationRow jacobi =
        measure_iterations("bar", body, system, 30.0, LinearSolverKind::block_jacobi);
    const IterationRow direct =
        measure_iterations("bar", body, system, 30.0, LinearSolverKind::cholesky);
    EXPECT_LE(skeleton.iterations_1pct, 15);
    EXPECT_GT(skeleton.iterations_1pct, 0);
    EXPECT_LE(skeleton.iterations_10pct, skeleton.iterations_1pct);
    EXPECT_LE(skeleton.error, skeleton.estimate);
    EXPECT_LE(skeleton.iterations_1pct, skeleton.iterations_stopped);
    EXPECT_GT(jacobi.iterations_1pct, 20 * skeleton.iterations_1pct);
    EXPECT_EQ(direct.iterations_1pct, 0);
    // A factor in single precision, on a slender bar.
    EXPECT_LT(direct.error, 1e-2);
    EXPECT_NEAR(direct.error, direct.estimate, 0.1 * direct.estimate);
}

TEST(VesselBody, ATreeIsClampedAtItsRootAlone) {
    Job job;
    const VesselTree tree = study_tree(3, 4.0);
    const BodyDescription body = body_of(tree, 2000, job);
    ASSERT_EQ(body.fixed.size(), body.mesh.vertices_mm.size());
    int fixed = 0;
    for (std::size_t v = 0; v < body.fixed.size(); ++v) {
        if (!body.fixed[v]) continue;
        ++fixed;
        EXPECT_LT(body.mesh.vertices_mm[v].norm(), 8.0);
    }
    EXPECT_GE(fixed, 4);
    EXPECT_GT(body.mesh.tetrahedra.size(), 1000u);
    const StudySystem system = study_system(body, 0.5);
    const IterationRow row =
        measure_iterations("tree", body, system, 10.0, LinearSolverKind::skeleton);
    EXPECT_LE(row.iterations_1pct, 25);
}

}  // namespace
}  // namespace hepatica
