// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/attempt_sizes.h"

#include <gtest/gtest.h>

#include "core/mesh/manifold_attempts.h"

namespace hepatica {
namespace {

TEST(AttemptSizes, BeginWithThoseAskedFor) {
    for (const double facet : {0.3, 0.37, 0.4, 0.9, 1.0})
        for (const double cell : {0.3, 0.5, 1.0}) {
            const AttemptSizes first = attempt_sizes(facet, cell, 1.0);
            EXPECT_EQ(first.facet_in_radii, facet);
            EXPECT_EQ(first.cell_in_radii, cell);
        }
}

// The factor was that of the size asked for: at the last attempt for 0.8 radii 1.099 in place of
// 1.052, which is 9 % too much volume.
TEST(AttemptSizes, WidenTheTubesAsTheSizeOfTheAttemptAsks) {
    for (const double facet : {0.3, 0.5, 0.8, 0.9, 1.0})
        for (const double scale : attempt_scales) {
            const AttemptSizes later = attempt_sizes(facet, 1.0, scale);
            const AttemptSizes same = attempt_sizes(later.facet_in_radii, 1.0, 1.0);
            EXPECT_EQ(later.radius_factor, same.radius_factor) << facet << " " << scale;
        }
    EXPECT_LT(attempt_sizes(0.8, 0.9, attempt_scales.back()).radius_factor, 1.06);
    EXPECT_GT(attempt_sizes(0.8, 0.9, 1.0).radius_factor, 1.09);
}

// At the finest size all attempts made the same mesh.
TEST(AttemptSizes, DifferFromAttemptToAttemptWithinTheRange) {
    for (const double facet : {0.3, 0.31, 0.37, 0.375, 0.6, 1.0}) {
        double before = 0.0;
        for (const double scale : attempt_scales) {
            const AttemptSizes sizes = attempt_sizes(facet, facet, scale);
            EXPECT_NE(sizes.facet_in_radii, before) << facet << " " << scale;
            before = sizes.facet_in_radii;
            for (const double size : {sizes.facet_in_radii, sizes.cell_in_radii}) {
                EXPECT_GE(size, finest_in_radii);
                EXPECT_LE(size, coarsest_in_radii);
            }
        }
    }
}

}  // namespace
}  // namespace hepatica
