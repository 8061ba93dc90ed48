// SPDX-License-Identifier: GPL-3.0-or-later
// Force and work to tear over settings and meshes, beside those of the tight solution.
#include "core/study/tear_tradeoff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hepatica {
namespace {

// Small bars; the mesh of the tight solution is among the rows.
TEST(TearTradeoff, ShowsForceAndWorkToTearOverSettingsAndMeshes) {
    Job job;
    const TearTradeoff tradeoff =
        measure_tear_tradeoff({.edge_mm = 2.0, .other_edges_mm = {1.0}, .tight_edge_mm = 1.0}, job);
    const auto row = [&](const std::string& name) {
        const auto found = std::ranges::find(tradeoff.points, name, &TearPoint::name);
        EXPECT_NE(found, tradeoff.points.end()) << name;
        return found == tradeoff.points.end() ? TearPoint{} : *found;
    };
    // 12 mm2 are left beside the notch, at 20 J/m2; the force is below the strength times them.
    EXPECT_NEAR(tradeoff.reference_work_nj, 12.0 * 20.0e3, 0.1 * 12.0 * 20.0e3);
    EXPECT_LT(tradeoff.reference_force_max_un, 1.5 * 12.0 * 2e4);
    const TearPoint scene = row("as in a scene"), fine = row("edges of 1 mm");
    EXPECT_GT(scene.force_error, fine.force_error);
    EXPECT_GT(scene.point.error_relative, fine.point.error_relative);
    EXPECT_LT(scene.work_error, 0.1);
    EXPECT_LT(fine.work_error, 0.1);
    EXPECT_FALSE(fine.point.own_mesh);
    EXPECT_EQ(fine.point.elements, 8 * scene.point.elements);
    EXPECT_EQ(row("4 substeps").point.options.substeps, 4);
    EXPECT_EQ(row("spring").point.options.model, ElementModel::spring);
    for (const TearPoint& point : tradeoff.points) {
        EXPECT_NEAR(point.force_error,
                    std::abs(point.force_max_un / tradeoff.reference_force_max_un - 1.0), 1e-12)
            << point.name;
        EXPECT_NEAR(point.work_error, std::abs(point.work_nj / tradeoff.reference_work_nj - 1.0),
                    1e-12)
            << point.name;
        EXPECT_GT(point.force_max_un, 0.0) << point.name;
        EXPECT_GT(point.point.frame_ms, 0.0) << point.name;
        EXPECT_TRUE(std::isfinite(point.point.error_relative)) << point.name;
    }
    EXPECT_TRUE(
        std::ranges::any_of(tradeoff.points, [](const TearPoint& p) { return p.point.on_front; }));
    EXPECT_EQ(as_tradeoff(tradeoff).points.at(1).element, "edges of 1 mm");
}

}  // namespace
}  // namespace hepatica
