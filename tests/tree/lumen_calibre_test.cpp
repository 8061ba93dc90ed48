// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/lumen_calibre.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "core/tree/station.h"

namespace hepatica {
namespace {

// A segment along x whose diameter is `wide` less a dent of the given depth (share) about `at`.
VesselTree dented(double from_mm, double to_mm, double depth, double at_mm) {
    VesselTree tree;
    VesselSegment segment;
    for (double x = 0.0; x <= 60.0; x += 0.25) {
        const double healthy = from_mm + x / 60.0 * (to_mm - from_mm);
        const double dent = depth * std::exp(-std::pow((x - at_mm) / 1.5, 2));
        segment.points_mm.push_back(Vec3(x, 3.0, -2.0));
        segment.radii_mm.push_back(0.5 * healthy * (1.0 - dent));
    }
    tree.segments.push_back(segment);
    return tree;
}

TEST(Station, LiesBetweenThePointsAndStaysOnTheSegment) {
    VesselSegment segment;
    segment.points_mm = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 4, 0)};
    segment.radii_mm = {1.0, 2.0, 4.0};
    EXPECT_EQ(station_at(segment, 3.0).position_mm, Vec3(2, 1, 0));
    EXPECT_EQ(station_at(segment, 3.0).radius_mm, 2.5);
    EXPECT_EQ(station_at(segment, 2.0).position_mm, Vec3(2, 0, 0));
    EXPECT_EQ(station_at(segment, 2.0).radius_mm, 2.0);
    EXPECT_EQ(station_at(segment, -1.0).position_mm, segment.points_mm.front());
    EXPECT_EQ(station_at(segment, 0.0).radius_mm, 1.0);
    EXPECT_EQ(station_at(segment, 99.0).position_mm, segment.points_mm.back());
    EXPECT_EQ(station_at(segment, 99.0).radius_mm, 4.0);
}

TEST(LumenCalibre, OfAVesselThatTapersHasNoStenosis) {
    const VesselTree tree = dented(10.0, 4.0, 0.0, 30.0);
    for (const double x : {20.0, 30.0, 41.5}) {
        const auto found = calibre_at(tree, Vec3(x, 3.0, -2.0));
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->diameter_mm, 10.0 - 0.1 * x, 1e-9);
        ASSERT_TRUE(found->stenosis);
        EXPECT_NEAR(*found->stenosis, 0.0, 1e-9);
    }
}

TEST(LumenCalibre, FindsAStenosisAndAnAneurysmOfKnownSize) {
    for (const double depth : {0.5, 0.7, -0.4}) {
        const VesselTree tree = dented(8.0, 6.0, depth, 30.0);
        const auto found = calibre_at(tree, Vec3(30.0, 3.0, -2.0));
        ASSERT_TRUE(found && found->stenosis);
        EXPECT_NEAR(*found->stenosis, depth, 1e-3);
        EXPECT_NEAR(*found->reference_mm, 7.0, 0.01);
        EXPECT_NEAR(found->diameter_mm, 7.0 * (1.0 - depth), 0.01);
    }
}

TEST(LumenCalibre, MeasuresAtTheCentrelineOfTheVesselThatWasMeant) {
    const VesselTree tree = dented(8.0, 8.0, 0.0, 30.0);
    const auto beside = calibre_at(tree, Vec3(30.1, 7.0, -2.0));  // on the wall
    ASSERT_TRUE(beside);
    EXPECT_EQ(beside->segment, 0);
    EXPECT_LT((beside->position_mm - Vec3(30.1, 3.0, -2.0)).norm(), 1e-9);
    EXPECT_TRUE(calibre_at(tree, Vec3(30.0, 8.99, -2.0)));
    EXPECT_FALSE(calibre_at(tree, Vec3(30.0, 9.01, -2.0)));
    EXPECT_FALSE(calibre_at(VesselTree{}, Vec3::Zero()));
}

// The wide vessel's axis is farther away than the thin one's, and yet its lumen is clicked.
TEST(LumenCalibre, IsThatOfTheLumenAndNotOfTheNearestAxis) {
    VesselTree tree;
    for (const auto& [y, radius] : {std::pair{0.0, 7.0}, std::pair{9.0, 1.0}}) {
        VesselSegment segment;
        segment.points_mm = {Vec3(0, y, 0), Vec3(60, y, 0)};
        segment.radii_mm = {radius, radius};
        tree.segments.push_back(segment);
    }
    const auto measured = [&](double y) { return calibre_at(tree, Vec3(30, y, 0)); };
    EXPECT_EQ(measured(5.0)->segment, 0);
    EXPECT_EQ(measured(6.9)->segment, 0);
    EXPECT_EQ(measured(7.3)->segment, 0) << "outside of both: the nearer wall";
    EXPECT_EQ(measured(7.7)->segment, 1);
    EXPECT_EQ(measured(8.5)->segment, 1);
    EXPECT_EQ(measured(5.0)->diameter_mm, 14.0);
    EXPECT_NEAR(measured(5.0)->arclength_mm, 30.0, 1e-12);
    tree.segments[1].points_mm = {Vec3(0, 4, 0), Vec3(60, 4, 0)};  // one within the other
    EXPECT_EQ(measured(3.7)->segment, 1);
    EXPECT_EQ(measured(2.0)->segment, 0);
    EXPECT_FALSE(measured(-9.1));
}

// Half of the 5 to 15 mm must be there on either side.
TEST(LumenCalibre, SaysNothingOfAStenosisNearAnEnd) {
    const VesselTree tree = dented(8.0, 6.0, 0.0, 30.0);
    EXPECT_FALSE(calibre_at(tree, Vec3(9.5, 3.0, -2.0))->stenosis);
    EXPECT_TRUE(calibre_at(tree, Vec3(10.5, 3.0, -2.0))->stenosis);
    EXPECT_TRUE(calibre_at(tree, Vec3(49.5, 3.0, -2.0))->stenosis);
    EXPECT_FALSE(calibre_at(tree, Vec3(50.5, 3.0, -2.0))->stenosis);
    EXPECT_NEAR(calibre_at(tree, Vec3(0.0, 3.0, -2.0))->diameter_mm, 8.0, 1e-9);
}

// The trunk is cut into short segments by its side branches; where it parts in two, it ends.
TEST(LumenCalibre, GoesOnPastSideBranches) {
    const VesselTree whole = dented(8.0, 8.0, 0.5, 30.0);
    const auto& points = whole.segments[0].points_mm;
    const auto& radii = whole.segments[0].radii_mm;
    VesselTree parts;
    for (const auto& [from, to] : {std::pair{0, 96}, std::pair{96, 144}, std::pair{144, 240}}) {
        VesselSegment segment;
        segment.parent = static_cast<int>(parts.segments.size()) - 1;
        segment.points_mm.assign(points.begin() + from, points.begin() + to + 1);
        segment.radii_mm.assign(radii.begin() + from, radii.begin() + to + 1);
        parts.segments.push_back(segment);
    }
    VesselSegment side;
    side.parent = 0;
    side.points_mm = {points[96], points[96] + Vec3(0, 30, 0)};
    side.radii_mm = {1.0, 1.0};
    parts.segments.push_back(side);
    const Vec3 dent(30.0, 3.0, -2.0);
    const auto found = calibre_at(parts, dent);
    ASSERT_TRUE(found && found->stenosis);
    EXPECT_EQ(found->segment, 1);
    EXPECT_NEAR(found->arclength_mm, 6.0, 1e-9);
    EXPECT_NEAR(*found->stenosis, *calibre_at(whole, dent)->stenosis, 1e-9);
    for (double& radius : parts.segments[2].radii_mm) radius *= 0.75;
    EXPECT_FALSE(calibre_at(parts, dent)->stenosis);
}

}  // namespace
}  // namespace hepatica
