// SPDX-License-Identifier: GPL-3.0-or-later
// Centrelines keep clear of the vessels of other systems, wherever these lie beside them.
#include "core/phantom/phantom_centrelines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace hepatica {
namespace {

constexpr double free_mm = 0.8;  // between walls

// Short thin vessels in a ring around the x axis.
std::vector<StraightVessel> ring_at(double x_mm, double distance_mm) {
    std::vector<StraightVessel> ring;
    for (int k = 0; k < 12; ++k) {
        const double angle = k * std::numbers::pi / 6.0;
        const Vec3 at(x_mm, distance_mm * std::cos(angle), distance_mm * std::sin(angle));
        ring.push_back({at - Vec3(0.05, 0, 0), at + Vec3(0.05, 0, 0), 0.2});
    }
    return ring;
}

// One branch of 40 mm along the x axis through the origin, with these vessels beside it.
VesselSegment drawn_beside(const std::vector<StraightVessel>& obstacles, std::uint64_t seed) {
    GrownBranch branch;
    branch.begin = Vec3(-20, 0, 0);
    branch.end = Vec3(20, 0, 0);
    CentrelineRequest request;
    request.root_radius_mm = 0.5;
    request.obstacles = obstacles;
    VesselTree tree;
    PhantomRandom random(seed);
    append_system(tree, {&branch, 1}, request, random);
    return tree.segments.at(0);
}

// The least distance between the walls at its points.
double least_gap_mm(const VesselSegment& segment, const std::vector<StraightVessel>& others) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < segment.points_mm.size(); ++i)
        for (const StraightVessel& other : others) {
            const Vec3& p = segment.points_mm[i];
            least = std::min(least, distance_between(p, p, other.begin, other.end) -
                                        segment.radii_mm[i] - other.radius);
        }
    return least;
}

TEST(PhantomCentrelines, AreStraightenedWhereTheyWouldTouchAVesselBesideThem) {
    for (const double x_mm : {-12.0, -8.0, 0.0, 8.0, 12.0}) {
        const std::vector<StraightVessel> ring = ring_at(x_mm, 1.6);
        int straightened = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            EXPECT_GE(least_gap_mm(drawn_beside(ring, seed), ring), free_mm - 1e-9)
                << "seed " << seed << ", at " << x_mm << " mm";
            straightened += least_gap_mm(drawn_beside({}, seed), ring) < free_mm;
        }
        EXPECT_GT(straightened, 5) << "at " << x_mm << " mm";
    }
}

}  // namespace
}  // namespace hepatica
