// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/nearest_in_hull.h"

#include <gtest/gtest.h>

#include <vector>

namespace hepatica {
namespace {

// The corners of a cube from -1 to 1.
std::vector<Vec3> corners() {
    std::vector<Vec3> all;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) all.emplace_back(x, y, z);
    return all;
}

TEST(NearestInHull, IsThePlaceItselfInsideTheHull) {
    for (const Vec3& place : {Vec3(0, 0, 0), Vec3(0.3, -0.9, 0.2), Vec3(0.95, 0.95, -0.95)})
        EXPECT_EQ(nearest_in_hull(corners(), place), place) << place.transpose();
}

// As in a cube each coordinate is cut off by itself, the nearest point is known.
TEST(NearestInHull, LiesOnTheSideTheEdgeOrTheCornerThatIsNearest) {
    for (const Vec3& place : {Vec3(3, 0.2, -0.4), Vec3(-2, 5, 0.1), Vec3(4, -3, -2)}) {
        const Vec3 nearest = place.cwiseMax(-1.0).cwiseMin(1.0);
        EXPECT_LT((nearest_in_hull(corners(), place) - nearest).norm(), 2e-3) << place.transpose();
    }
}

TEST(NearestInHull, OfOnePointIsThat) {
    const std::vector<Vec3> one{Vec3(1, 2, 3)};
    EXPECT_EQ(nearest_in_hull(one, Vec3(9, 9, 9)), one.front());
}

TEST(NearestInHull, OfPointsThatLieOnEachOtherIsOneOfThem) {
    const std::vector<Vec3> same(3, Vec3(1, 2, 3));
    EXPECT_EQ(nearest_in_hull(same, Vec3(9, 9, 9)), same.front());
}

}  // namespace
}  // namespace hepatica
