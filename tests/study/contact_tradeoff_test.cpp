// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/contact_tradeoff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hepatica {
namespace {

// Small blocks: what is nearer to the tight solution is less wrong, and leaving friction out is
// another play, not a rounding of this one.
TEST(ContactTradeoff, WhatIsNearerToTheTightSolutionIsLessWrong) {
    Job job;
    const ContactTradeoff tradeoff =
        measure_contact_tradeoff({.slab_cells = 7, .block_cells = 2, .frames = 18}, job);
    const auto error = [&](const std::string& name) {
        const auto found = std::ranges::find(tradeoff.points, name, &ContactPoint::name);
        EXPECT_NE(found, tradeoff.points.end()) << name;
        return found == tradeoff.points.end() ? NAN : found->point.error_relative;
    };
    EXPECT_LT(error("pad of 0.02 edges"), error("as in a scene"));
    EXPECT_LT(error("as in a scene"), error("pad of 0.4 edges"));
    EXPECT_LT(error("4 substeps"), error("as in a scene"));
    EXPECT_GT(error("no friction"), 3.0 * error("as in a scene"));
    EXPECT_NEAR(error("solved to 1e-05"), error("as in a scene"), 0.1 * error("as in a scene"));
    for (const ContactPoint& point : tradeoff.points) {
        EXPECT_GT(point.point.frame_ms, 0.0) << point.name;
        EXPECT_TRUE(std::isfinite(point.point.error_relative)) << point.name;
    }
    EXPECT_TRUE(std::ranges::any_of(tradeoff.points,
                                    [](const ContactPoint& p) { return p.point.on_front; }));
    EXPECT_EQ(as_tradeoff(tradeoff).points.size(), tradeoff.points.size());
}

}  // namespace
}  // namespace hepatica
