// SPDX-License-Identifier: GPL-3.0-or-later
// The implicit body of vessels against closed forms: cylinders, cones, balls and their blend.
#include "core/mesh/tube_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/mesh/random_tree.h"

namespace hepatica {
namespace {

int add_straight(VesselTree& tree, int from, int to, double radius_from_mm, double radius_to_mm) {
    VesselSegment segment;
    segment.proximal_node = from;
    segment.distal_node = to;
    segment.points_mm = {tree.nodes[from].position_mm, tree.nodes[to].position_mm};
    segment.radii_mm = {radius_from_mm, radius_to_mm};
    tree.segments.push_back(segment);
    return static_cast<int>(tree.segments.size()) - 1;
}

// One vessel along x from the origin.
VesselTree straight_vessel(double length_mm, double radius_from_mm, double radius_to_mm) {
    VesselTree tree;
    test::add_node(tree, Vec3::Zero(), radius_from_mm);
    test::add_node(tree, Vec3(length_mm, 0, 0), radius_to_mm);
    add_straight(tree, 0, 1, radius_from_mm, radius_to_mm);
    return tree;
}

TubeField field_of(const VesselTree& tree, const TubeFieldOptions& options = {}) {
    std::vector<int> all(tree.segments.size());
    std::iota(all.begin(), all.end(), 0);
    return {tree, all, options};
}

// The distance to the hull of two balls is the least, over the balls between them, of the distance
// to a ball: here by trying very many of them.
double distance_to_hull_mm(const Vec3& a, double radius_a, const Vec3& b, double radius_b,
                           const Vec3& point) {
    double least = std::numeric_limits<double>::infinity();
    constexpr int balls = 20000;
    for (int i = 0; i <= balls; ++i) {
        const double share = static_cast<double>(i) / balls;
        least = std::min(least, (point - ((1.0 - share) * a + share * b)).norm() -
                                    ((1.0 - share) * radius_a + share * radius_b));
    }
    return least;
}

TEST(TubeField, MeasuresTheDistanceToARoundCone) {
    const VesselTree tree = straight_vessel(20.0, 4.0, 2.0);
    const TubeField field = field_of(tree);
    for (const double x : {-3.9, -1.0, 0.0, 0.5, 3.0, 10.0, 17.0, 19.9, 20.0, 21.8})
        for (const double y : {-3.0, -1.2, 0.0, 0.4, 2.0, 3.9})
            for (const double z : {-2.0, 0.0, 1.5}) {
                const double exact =
                    distance_to_hull_mm(Vec3::Zero(), 4.0, Vec3(20, 0, 0), 2.0, Vec3(x, y, z));
                if (exact > 0.4) continue;  // outside the reach
                EXPECT_NEAR(field.distance_mm({x, y, z}), exact, 1e-6) << x << " " << y << " " << z;
            }
}

// Where one ball holds the other, the hull is the larger ball.
TEST(TubeField, TakesTheLargerBallWhereItHoldsTheOther) {
    for (const bool larger_first : {true, false}) {
        const VesselTree tree =
            larger_first ? straight_vessel(2.0, 5.0, 2.0) : straight_vessel(2.0, 2.0, 5.0);
        const Vec3 centre(larger_first ? 0.0 : 2.0, 0.0, 0.0);
        const TubeField field = field_of(tree);
        for (const Vec3& point : {Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(4, 1, 0), Vec3(-2.5, 0, 1)})
            EXPECT_NEAR(field.distance_mm(point), (point - centre).norm() - 5.0, 1e-12);
    }
}

TEST(TubeField, IsBoundedByItsBallsAndItsReach) {
    const TubeField field = field_of(straight_vessel(20.0, 4.0, 2.0));
    EXPECT_EQ(field.smallest_radius_mm(), 2.0);
    // The field is looked at as far outside as the widest blend: 0.3 of the wider end's radius.
    const double reach = 0.3 * 4.0;
    EXPECT_LT((field.lower_mm() - Vec3(-4.0 - reach, -4.0 - reach, -4.0 - reach)).norm(), 1e-12);
    EXPECT_LT((field.upper_mm() - Vec3(22.0, 4.0, 4.0) - Vec3::Constant(reach)).norm(), 1e-12);
    EXPECT_TRUE(std::isinf(field.distance_mm({10.0, 60.0, 0.0})));
    EXPECT_TRUE(std::isinf(field.distance_mm({-60.0, 0.0, 0.0})));
    EXPECT_EQ(field.radius_mm({10.0, 60.0, 0.0}), 2.0);
    EXPECT_EQ(field.position_along({10.0, 60.0, 0.0}), 0.0);
}

TEST(TubeField, KnowsTheRadiusAndThePlaceAlongTheVessel) {
    const TubeField field = field_of(straight_vessel(20.0, 4.0, 2.0));
    for (const double x : {0.0, 5.0, 12.0, 20.0}) {
        EXPECT_NEAR(field.radius_mm({x, 1.0, 0.0}), 4.0 - 0.1 * x, 1e-12);
        EXPECT_NEAR(field.position_along({x, 0.0, -1.0}), x / 20.0, 1e-12);
    }
    EXPECT_EQ(field.radius_mm({-2.0, 0.0, 0.0}), 4.0);
    EXPECT_EQ(field.radius_mm({21.0, 0.0, 0.0}), 2.0);
}

// A centreline that turns back within half a radius and ends where it began, and one whose end
// stands twice: both have a piece without length, which is a ball.
TEST(TubeField, TakesAPieceWithoutLengthAsABall) {
    VesselTree turned = straight_vessel(0.0, 4.0, 3.0);
    turned.segments[0].points_mm = {Vec3::Zero(), Vec3(1, 0, 0), Vec3::Zero()};
    turned.segments[0].radii_mm = {4.0, 3.0, 3.0};
    const TubeField ball = field_of(turned);
    EXPECT_EQ(ball.radius_mm({3.5, 0, 0}), 4.0);
    EXPECT_EQ(ball.position_along({3.5, 0, 0}), 0.0);
    EXPECT_NEAR(ball.distance_mm({0, 3.5, 0}), -0.5, 1e-12);
    const std::vector<Vec3> on_ball = ball.surface_points_mm();
    ASSERT_FALSE(on_ball.empty());
    for (const Vec3& point : on_ball) EXPECT_NEAR(point.norm(), 4.0, 1e-12);

    VesselTree doubled = straight_vessel(20.0, 2.0, 2.0);
    doubled.segments[0].points_mm.emplace_back(20.0, 0.0, 0.0);
    doubled.segments[0].radii_mm = {2.0, 2.0, 3.0};
    const TubeField field = field_of(doubled);
    EXPECT_EQ(field.radius_mm({22.5, 0, 0}), 3.0);
    EXPECT_EQ(field.position_along({22.5, 0, 0}), 2.0);
    const std::vector<Vec3> points = field.surface_points_mm();
    EXPECT_TRUE(std::ranges::any_of(
        points, [](const Vec3& point) { return (point - Vec3(23, 0, 0)).norm() < 1e-12; }));
}

TEST(TubeField, WidensThinVesselsAndThenMultiplies) {
    TubeFieldOptions options;
    options.radius_factor = 1.5;
    options.minimum_radius_mm = 3.0;
    const TubeField field = field_of(straight_vessel(20.0, 4.0, 2.0), options);
    EXPECT_NEAR(field.radius_mm({0, 0, 0}), 6.0, 1e-12);
    EXPECT_NEAR(field.radius_mm({20, 0, 0}), 4.5, 1e-12);
    EXPECT_EQ(field.smallest_radius_mm(), 4.5);
}

// Two vessels of radius 2 that leave a node at a right angle. Where both are as near, the
// polynomial smooth minimum of width w lies w/4 below either distance (Quilez 2013).
VesselTree corner(double arm_radius_mm) {
    VesselTree tree;
    test::add_node(tree, Vec3::Zero(), 2.0);
    test::add_node(tree, Vec3(30, 0, 0), 2.0);
    test::add_node(tree, Vec3(0, 30, 0), 2.0);
    add_straight(tree, 0, 1, 2.0, 2.0);
    add_straight(tree, 0, 2, arm_radius_mm, arm_radius_mm);
    tree.segments[1].parent = 0;
    return tree;
}

TEST(TubeField, RoundsTheCrotchByAQuarterOfTheBlend) {
    const TubeField field = field_of(corner(2.0));
    const double width = 0.3 * 2.0;
    for (const double along : {1.0, 1.5, 2.0, 2.2}) {
        const Vec3 point(along, along, 0.0);  // as near to either
        EXPECT_NEAR(field.distance_mm(point), along - 2.0 - width / 4.0, 1e-12) << along;
    }
    // Differing by half the width: a sixteenth of it. By more than the width: no blend.
    EXPECT_NEAR(field.distance_mm({2.0 + width / 2.0, 2.0, 0.0}), -width / 16.0, 1e-12);
    EXPECT_NEAR(field.distance_mm({2.0, 2.0 + width / 2.0, 0.0}), -width / 16.0, 1e-12);
    EXPECT_NEAR(field.distance_mm({3.0, 2.0, 0.0}), 0.0, 1e-12);
    EXPECT_NEAR(field.distance_mm({20.0, 1.0, 0.0}), -1.0, 1e-12);
}

TEST(TubeField, BlendsAsWideAsTheThinnerVesselOfANodeAsks) {
    const TubeField field = field_of(corner(1.0));
    const double width = 0.3 * 1.0;
    EXPECT_NEAR(field.distance_mm({1.0, 2.0, 0.0}), -width / 4.0, 1e-12);
}

TEST(TubeField, DoesNotBlendVesselsThatMerelyPass) {
    VesselTree tree;
    for (const double y : {0.0, 4.2}) {
        test::add_node(tree, Vec3(0, y, 0), 2.0);
        test::add_node(tree, Vec3(30, y, 0), 2.0);
    }
    add_straight(tree, 0, 1, 2.0, 2.0);
    add_straight(tree, 2, 3, 2.0, 2.0);
    const TubeField field = field_of(tree);
    EXPECT_NEAR(field.distance_mm({15.0, 2.1, 0.0}), 0.1, 1e-12);
    EXPECT_NEAR(field.distance_mm({15.0, 2.0, 0.0}), 0.0, 1e-12);
    EXPECT_NEAR(field.distance_mm({15.0, 2.3, 0.0}), -0.1, 1e-12);
}

// The grid only finds which cones are near: it must not change what comes out.
TEST(TubeField, FindsEveryConeThatIsNear) {
    const VesselTree tree = test::random_tree(4, 5);
    TubeFieldOptions options;
    options.blend_in_radii = 0.0;
    const TubeField field = field_of(tree, options);
    std::mt19937_64 random(5);
    int near = 0;
    for (int i = 0; i < 3000; ++i) {
        // Beside a random point of a random vessel.
        const VesselSegment& vessel = tree.segments[random() % tree.segments.size()];
        const std::size_t k = random() % vessel.points_mm.size();
        const Vec3 direction(test::uniform(random, -1, 1), test::uniform(random, -1, 1),
                             test::uniform(random, -1, 1));
        const Vec3 point = vessel.points_mm[k] + 1.2 * vessel.radii_mm[k] * direction;
        double exact = std::numeric_limits<double>::infinity();
        // Only points of the centreline half a radius apart are kept, so balls are compared where
        // all are: inside the nearest of them the field is negative.
        for (const VesselSegment& other : tree.segments)
            for (const std::size_t p : {std::size_t{0}, other.points_mm.size() - 1})
                exact = std::min(exact, (point - other.points_mm[p]).norm() - other.radii_mm[p]);
        if (exact > 0.0) continue;
        ++near;
        EXPECT_LE(field.distance_mm(point), exact + 1e-9);
    }
    EXPECT_GT(near, 100);
}

TEST(TubeField, StartsAMesherOnTheSurfaceOfEveryStretch) {
    const VesselTree tree = straight_vessel(40.0, 3.0, 2.0);
    const TubeField field = field_of(tree);
    const std::vector<Vec3> points = field.surface_points_mm();
    for (const Vec3& point : points) EXPECT_LT(std::abs(field.distance_mm(point)), 0.05 * 3.0);
    const auto holds = [&](const Vec3& place) {
        return std::ranges::any_of(points,
                                   [&](const Vec3& p) { return (p - place).norm() < 1e-9; });
    };
    EXPECT_TRUE(holds({-3.0, 0.0, 0.0}));  // both ends
    EXPECT_TRUE(holds({42.0, 0.0, 0.0}));
    // Rings of three points, no further apart than two radii, around all sides.
    std::vector<double> along;
    Vec3 sum = Vec3::Zero();
    for (const Vec3& point : points) {
        if (point.x() < -2.0 || point.x() > 41.0) continue;
        along.push_back(point.x());
        sum += point;
    }
    std::ranges::sort(along);
    ASSERT_GE(along.size(), 30u);
    EXPECT_EQ(along.size() % 3, 0u);
    for (std::size_t i = 1; i < along.size(); ++i) EXPECT_LT(along[i] - along[i - 1], 2.0 * 3.0);
    EXPECT_LT(along.front(), 1.0);
    EXPECT_GT(along.back(), 36.0);
    EXPECT_NEAR(sum.y(), 0.0, 1e-9);
    EXPECT_NEAR(sum.z(), 0.0, 1e-9);
}

// A wide vessel swallows the ring of a thin one that begins inside it: no point lies inside.
TEST(TubeField, LeavesOutPointsInsideAnotherVessel) {
    VesselTree tree;
    test::add_node(tree, Vec3(-20, 0, 0), 5.0);
    test::add_node(tree, Vec3::Zero(), 5.0);
    test::add_node(tree, Vec3(20, 0, 0), 5.0);
    test::add_node(tree, Vec3(0, 20, 0), 1.0);
    add_straight(tree, 0, 1, 5.0, 5.0);
    add_straight(tree, 1, 2, 5.0, 5.0);
    add_straight(tree, 1, 3, 1.0, 1.0);
    const TubeField field = field_of(tree);
    const std::vector<Vec3> points = field.surface_points_mm();
    EXPECT_GT(points.size(), 20u);
    for (const Vec3& point : points) EXPECT_GT(field.distance_mm(point), -0.05 * 5.0);
}

}  // namespace
}  // namespace hepatica
