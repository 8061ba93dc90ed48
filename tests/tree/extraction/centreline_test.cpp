// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/centreline.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
#include "core/tree/extraction/lumen_measurement.h"

namespace hepatica {
namespace {

// The definition, point by point: from the nearest points that lie `reach_mm` away on both sides.
std::vector<Vec3> tangents_by_definition(const std::vector<Vec3>& points, double reach_mm) {
    const std::vector<double> at = arclengths_mm(points);
    std::vector<Vec3> found;
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::size_t first = i, last = i;
        while (first > 0 && at[i] - at[first] < reach_mm) --first;
        while (last + 1 < at.size() && at[last] - at[i] < reach_mm) ++last;
        const Vec3 chord = points[last] - points[first];
        found.push_back(chord.norm() > 0.0 ? Vec3(chord.normalized()) : Vec3(0, 0, 1));
    }
    return found;
}

TEST(Tangents, AreThoseOfTheDefinition) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> move(-1.0, 1.0);
    std::vector<Vec3> points{Vec3::Zero()};
    for (int i = 0; i < 300; ++i) {
        // Some points stand twice.
        const Vec3 step(move(engine), move(engine), move(engine));
        points.push_back(points.back() + (i % 7 == 0 ? Vec3(Vec3::Zero()) : step));
    }
    for (const double reach_mm : {1e-9, 0.4, 2.5, 20.0, 1e6})
        EXPECT_EQ(tangents(points, reach_mm), tangents_by_definition(points, reach_mm)) << reach_mm;
}

// Every pair of points was visited before: 1e12 steps for these, as good as for ever.
TEST(Tangents, OfAMillionPointsInOnePlaceTakeNoTime) {
    const std::vector<Vec3> points(1'000'000, Vec3(1e21, 0, 0));
    EXPECT_EQ(tangents(points, 2.5).back(), Vec3(0, 0, 1));
}

TEST(Resampled, RefusesACurveOfTooManySteps) {
    const Centreline curve{{Vec3::Zero(), Vec3(1e21, 0, 0)}, {1.0, 1.0}};
    try {
        resampled(curve, 0.5);
        FAIL() << "a curve of 2e21 steps was made";
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("1e+21 mm long"), std::string::npos) << error.what();
    }
}

// One vessel may take long: it asks on its way whether to stop.
TEST(LumenMeasurement, AsksWhetherToStopWithinAVessel) {
    Grid grid;
    grid.dims = {401, 9, 9};
    const Mask mask(grid, 1);
    VesselGraph graph;
    graph.nodes = {{Vec3(0, 4, 4), 2.0}, {Vec3(400, 4, 4), 2.0}};
    VesselLink link;
    link.from = 0;
    link.to = 1;
    for (int x = 0; x <= 400; ++x) {
        link.points_mm.emplace_back(x, 4, 4);
        link.radii_mm.push_back(2.0);
    }
    graph.links = {link};
    int asked = 0;
    measure_lumen(graph, mask, nullptr, [&](double) { ++asked; });
    EXPECT_GE(asked, 12);
}

}  // namespace
}  // namespace hepatica
