// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/round_lumen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace hepatica {
namespace {

// A straight vessel along x from 5 to 35 mm whose radius grows evenly.
VesselTree straight_vessel(double begin_radius_mm, double end_radius_mm) {
    VesselTree tree;
    VesselSegment segment;
    for (int i = 0; i <= 30; ++i) {
        segment.points_mm.emplace_back(5.0 + i, 10.0, 10.0);
        segment.radii_mm.push_back(begin_radius_mm + (end_radius_mm - begin_radius_mm) * i / 30.0);
    }
    tree.segments.push_back(segment);
    return tree;
}

Grid cubes() {
    Grid grid;
    grid.dims = {80, 40, 40};
    grid.spacing_mm = Vec3::Constant(0.5);
    return grid;
}

// Every voxel within 1 mm outside or inside of the wall is object or not by the toss of a coin.
Mask ragged(const VesselTree& tree, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    Mask mask(cubes());
    const VesselSegment& segment = tree.segments[0];
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const Index3 at = mask.grid.index_of(i);
        const Vec3 p = mask.grid.to_mm(at[0], at[1], at[2]);
        if (p[0] < 5.0 || p[0] > 35.0) continue;
        const double t = (p[0] - 5.0) / 30.0;
        const double radius = (1.0 - t) * segment.radii_mm.front() + t * segment.radii_mm.back();
        const double outside = std::hypot(p[1] - 10.0, p[2] - 10.0) - radius;
        mask.voxels[i] = outside < -1.0 || (outside < 1.0 && (engine() >> 63) != 0);
    }
    return mask;
}

TEST(RoundLumen, AThinVesselBecomesItsTube) {
    const VesselTree tree = straight_vessel(1.3, 1.3);
    Job job;
    const Mask round = round_thin_lumens(ragged(tree, 7), tree, 1.6, job);
    double volume = 0.0;
    for (std::size_t i = 0; i < round.voxels.size(); ++i) {
        const Index3 at = round.grid.index_of(i);
        const Vec3 p = round.grid.to_mm(at[0], at[1], at[2]);
        if (p[0] < 7.0 || p[0] > 33.0) continue;  // the ends are round
        EXPECT_EQ(round.voxels[i] != 0, std::hypot(p[1] - 10.0, p[2] - 10.0) <= 1.3);
        volume += round.voxels[i] * 0.125;
    }
    EXPECT_NEAR(volume / (53 * 0.5), std::numbers::pi * 1.3 * 1.3, 0.15);
}

TEST(RoundLumen, AWideVesselAndWhatIsFarAwayStay) {
    const VesselTree tree = straight_vessel(3.0, 3.0);
    Mask vessels = ragged(tree, 8);
    vessels.at(2, 2, 2) = 1;
    Job job;
    EXPECT_EQ(round_thin_lumens(vessels, tree, 1.6, job).voxels, vessels.voxels);
}

TEST(RoundLumen, WhereARadiusPassesTheLimitOnlyTheThinSideChanges) {
    const VesselTree tree = straight_vessel(1.0, 2.2);  // 1.6 at x = 20 mm
    const Mask vessels = ragged(tree, 9);
    Job job;
    const Mask round = round_thin_lumens(vessels, tree, 1.6, job);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < round.voxels.size(); ++i) {
        const Index3 at = round.grid.index_of(i);
        const Vec3 p = round.grid.to_mm(at[0], at[1], at[2]);
        changed += round.voxels[i] != vessels.voxels[i];
        if (p[0] > 20.5) {
            EXPECT_EQ(round.voxels[i], vessels.voxels[i]);
        }
        if (p[0] > 7.0 && p[0] < 19.5) {
            const double radius = 1.0 + 1.2 * (p[0] - 5.0) / 30.0;
            const double off = std::hypot(p[1] - 10.0, p[2] - 10.0);
            if (std::abs(off - radius) > 0.1) {
                EXPECT_EQ(round.voxels[i] != 0, off < radius);
            }
        }
    }
    EXPECT_GT(changed, 100u);
}

}  // namespace
}  // namespace hepatica
