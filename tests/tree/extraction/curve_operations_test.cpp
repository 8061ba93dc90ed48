// SPDX-License-Identifier: GPL-3.0-or-later
// Operations on curves against sums written out here, and against what a straight line must stay.
#include "core/tree/extraction/centreline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hepatica {
namespace {

// A bent curve with uneven gaps.
std::vector<Vec3> uneven_curve() {
    std::vector<Vec3> points;
    double along = 0.0;
    for (int i = 0; i < 24; ++i) {
        points.emplace_back(along, 3.0 * std::sin(0.4 * along), 0.2 * along);
        along += 0.5 + 0.25 * (i % 3);
    }
    return points;
}

TEST(Centreline, ArclengthsAddUp) {
    EXPECT_EQ(arclengths_mm({{0, 0, 0}, {3, 4, 0}, {3, 4, 2}}), (std::vector<double>{0, 5, 7}));
}

TEST(SmoothCurve, IsTheGaussianMeanOverAWindowThatShrinksTowardsTheEnds) {
    const std::vector<Vec3> points = uneven_curve();
    const std::vector<double> at = arclengths_mm(points);
    const double deviation = 1.1;
    const std::vector<Vec3> smooth = smooth_curve(points, deviation, false);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double reach = std::min({3.0 * deviation, at[i], at.back() - at[i]});
        Vec3 sum = Vec3::Zero();
        double weights = 0.0;
        for (std::size_t j = 0; j < points.size(); ++j) {
            const double away = std::abs(at[j] - at[i]);
            if (away > reach + 1e-9) continue;
            const double weight = std::exp(-away * away / (2.0 * deviation * deviation));
            sum += weight * points[j];
            weights += weight;
        }
        EXPECT_LT((smooth[i] - sum / weights).norm(), 1e-12) << i;
    }
    EXPECT_EQ(smooth.front(), points.front());
    EXPECT_EQ(smooth.back(), points.back());
}

TEST(SmoothCurve, LeavesShortCurvesAndNoDeviationAlone) {
    const std::vector<Vec3> two{{0, 0, 0}, {1, 2, 3}}, points = uneven_curve();
    EXPECT_EQ(smooth_curve(two, 1.0, false), two);
    EXPECT_EQ(smooth_curve(points, 0.0, false), points);
    const std::vector<Vec3> three{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}};
    const std::vector<Vec3> smooth = smooth_curve(three, 2.0, true);
    EXPECT_EQ(smooth.front(), three.front());
    EXPECT_EQ(smooth.back(), three.back());
    EXPECT_LT(smooth[1].y(), 0.9);
}

TEST(SmoothValues, AreWeightedGaussianMeans) {
    const std::vector<Vec3> points = uneven_curve();
    const std::vector<double> at = arclengths_mm(points);
    std::vector<double> values, weights;
    for (std::size_t i = 0; i < points.size(); ++i) {
        values.push_back(static_cast<double>(i * i % 7));
        weights.push_back(static_cast<double>(i % 4));
    }
    const double deviation = 0.9;
    for (const bool weighted : {false, true}) {
        const std::vector<double> smooth =
            smooth_values(points, values, weighted ? weights : std::vector<double>{}, deviation);
        for (std::size_t i = 0; i < points.size(); ++i) {
            double sum = 0.0, total = 0.0;
            for (std::size_t j = 0; j < points.size(); ++j) {
                const double t = (at[j] - at[i]) / deviation;
                if (std::abs(t) > 3.0) continue;
                const double weight = (weighted ? weights[j] : 1.0) * std::exp(-0.5 * t * t);
                sum += weight * values[j];
                total += weight;
            }
            EXPECT_NEAR(smooth[i], sum / total, 1e-12) << i;
        }
    }
    // Where nothing counts, the value stays.
    EXPECT_EQ(smooth_values(points, values, std::vector<double>(values.size(), 0.0), deviation),
              values);
}

TEST(MedianValues, AreWeightedMediansWithinTheReach) {
    std::vector<Vec3> points;
    for (int i = 0; i < 7; ++i) points.emplace_back(i, 0, 0);
    const std::vector<double> values{1, 9, 2, 100, 4, 3, 5};
    const std::vector<double> even(7, 1.0);
    // Two to each side, fewer at the ends: the value at which half of the weight is reached.
    EXPECT_EQ(median_values(points, values, even, 2.0), (std::vector<double>{2, 2, 4, 4, 4, 4, 4}));
    EXPECT_EQ(median_values(points, values, even, 0.5), values);
    // A weight of three counts like three points.
    EXPECT_EQ(median_values(points, values, {1, 1, 1, 3, 1, 1, 1}, 1.0),
              (std::vector<double>{1, 2, 100, 100, 100, 4, 3}));
}

TEST(Resampled, HasEvenStepsAndInterpolatesRadii) {
    const Centreline line{{{0, 0, 0}, {1, 0, 0}, {7, 0, 0}, {10, 0, 0}}, {1, 2, 8, 5}};
    const Centreline even = resampled(line, 0.99);  // ten pieces
    ASSERT_EQ(even.points_mm.size(), 11u);
    ASSERT_EQ(even.radii_mm.size(), 11u);
    for (int k = 0; k <= 10; ++k) {
        EXPECT_NEAR(even.points_mm[k].x(), k, 1e-12);
        EXPECT_NEAR(even.radii_mm[k], k <= 1 ? 1.0 + k : k <= 7 ? 1.0 + k : 15.0 - k, 1e-12) << k;
    }
    const Centreline coarse = resampled(line, 40.0);
    EXPECT_EQ(coarse.points_mm, (std::vector<Vec3>{{0, 0, 0}, {10, 0, 0}}));
    EXPECT_EQ(coarse.radii_mm, (std::vector<double>{1, 5}));
    EXPECT_EQ(resampled(line, 4.1).points_mm.size(), 3u);  // 2.4 pieces: two
}

// There and back along one line: an odd number of pieces has its middle one from a point to itself.
TEST(Resampled, ACurveThatTurnsBackOnItselfHasNoPointTwiceInARow) {
    const Centreline hairpin{{{0, 0, 0}, {3.5, 0, 0}, {0, 0, 0}}, {1.0, 2.0, 1.0}};
    for (const double step : {0.5, 1.0, 7.0 / 3.0, 7.0}) {
        const Centreline even = resampled(hairpin, step);
        ASSERT_EQ(even.points_mm.size(), even.radii_mm.size());
        EXPECT_EQ(even.points_mm.front(), hairpin.points_mm.front());
        EXPECT_EQ(even.points_mm.back(), hairpin.points_mm.back());
        if (step == 7.0) {
            EXPECT_EQ(even.points_mm.size(), 2u);  // ends stay, though they are one place
            continue;
        }
        for (std::size_t i = 1; i < even.points_mm.size(); ++i)
            EXPECT_NE(even.points_mm[i], even.points_mm[i - 1]) << "step " << step << ", " << i;
    }
}

TEST(Resampled, ACurveThatTurnsBackWithinItsLastStepHasNoPointTwiceInARow) {
    const Centreline hook{{{0, 0, 0}, {3, 0, 0}, {3.25, 0, 0}, {3, 0, 0}}, {1.0, 1.0, 1.5, 2.0}};
    const Centreline even = resampled(hook, 0.5);  // seven pieces, of which the last is no way
    ASSERT_EQ(even.points_mm.size(), 7u);
    ASSERT_EQ(even.radii_mm.size(), 7u);
    EXPECT_EQ(even.points_mm.back(), hook.points_mm.back());
    EXPECT_EQ(even.radii_mm.back(), 2.0);
    for (std::size_t i = 1; i < even.points_mm.size(); ++i)
        EXPECT_NE(even.points_mm[i], even.points_mm[i - 1]) << i;
}

TEST(Resampled, KeepsTheCurveAndItsEnds) {
    const std::vector<Vec3> points = uneven_curve();
    const Centreline even = resampled({points, std::vector<double>(points.size(), 1.0)}, 0.3);
    EXPECT_EQ(even.points_mm.front(), points.front());
    EXPECT_EQ(even.points_mm.back(), points.back());
    for (const Vec3& p : even.points_mm) {
        double nearest = 1e9;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Vec3 edge = points[i] - points[i - 1];
            const double share =
                std::clamp((p - points[i - 1]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (points[i - 1] + share * edge - p).norm());
        }
        EXPECT_LT(nearest, 1e-9);
    }
}

TEST(Tangents, AreChordsOfTheReachOnBothSides) {
    std::vector<Vec3> circle;
    for (int i = 0; i <= 60; ++i)
        circle.emplace_back(10.0 * std::cos(0.05 * i), 10.0 * std::sin(0.05 * i), 0.0);
    const std::vector<Vec3> found = tangents(circle, 1.4);
    for (int i = 0; i <= 60; ++i) {
        // Three points of half a millimetre to each side reach 1.4 mm.
        const int first = std::max(0, i - 3), last = std::min(60, i + 3);
        EXPECT_LT((found[i] - (circle[last] - circle[first]).normalized()).norm(), 1e-12) << i;
    }
    EXPECT_EQ(tangents({{1, 1, 1}, {1, 1, 1}}, 1.0)[0], Vec3(0, 0, 1));
}

}  // namespace
}  // namespace hepatica
