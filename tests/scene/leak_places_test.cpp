// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertex of a torn body bleeds.
#include "core/scene/leak_places.h"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>

namespace hepatica {
namespace {

// A vessel of 2 mm radius along x from the root at 0, and triangles across it at these places.
struct TornTube {
    explicit TornTube(const std::vector<double>& at_mm) {
        VesselSegment segment;
        for (int k = 0; k <= 40; ++k) {
            segment.points_mm.push_back(Vec3(k, 0, 0));
            segment.radii_mm.push_back(2.0);
        }
        tree.nodes = {{Vec3(0, 0, 0)}, {Vec3(40, 0, 0)}};
        tree.segments = {segment};
        for (const double x : at_mm) {
            const int first = static_cast<int>(rest_mm.size());
            for (const Vec3& corner : {Vec3(x, 2, 0), Vec3(x, -1, 1.7), Vec3(x, -1, -1.7)})
                rest_mm.push_back(corner);
            triangles.push_back({first, first + 1, first + 2});
        }
        std::vector<int> origins(rest_mm.size());
        std::iota(origins.begin(), origins.end(), 0);
        view.origins = std::make_shared<const std::vector<int>>(origins);
    }

    // The triangles with these numbers are rims; the vessel is torn through at 20 mm.
    int leaking(const std::vector<int>& rims) {
        std::vector<std::uint8_t> marks(rest_mm.size(), 0);
        for (const int t : rims)
            for (const int v : triangles[static_cast<std::size_t>(t)])
                marks[static_cast<std::size_t>(v)] = 1;
        view.rims = std::make_shared<const std::vector<std::uint8_t>>(marks);
        ThroughTear torn;
        torn.at = {0, 20.0};
        torn.area_mm2 = 4.0 * 3.14159;
        const std::vector<int> found = leaking_vertices(tree, {torn}, view, rest_mm, triangles);
        EXPECT_EQ(found.size(), 1u);
        return found.front() < 0 ? -1 : found.front() / 3;
    }

    VesselTree tree;
    TearView view;
    std::vector<Vec3> rest_mm;
    std::vector<std::array<int, 3>> triangles;
};

TEST(LeakPlaces, AreOnTheRootsSideOfTheTear) {
    TornTube tube({19.0, 21.0, 10.0});
    EXPECT_EQ(tube.leaking({0, 1}), 0);
    EXPECT_EQ(tube.leaking({1}), 1) << "the only rim";
    EXPECT_EQ(tube.leaking({0, 1, 2}), 0) << "not far away";
}

// A tear that ran along the vessel has its rim elsewhere: blood is shown there, not nowhere.
TEST(LeakPlaces, AreOnTheNearestRimWhereNoneIsNear) {
    TornTube tube({8.0, 30.0});
    EXPECT_EQ(tube.leaking({0, 1}), 1);
    EXPECT_EQ(tube.leaking({0}), 0);
    EXPECT_EQ(tube.leaking({}), -1);
}

// Several are looked for at once; each has what it has alone.
TEST(LeakPlaces, OfSeveralTearsAreThoseOfEach) {
    TornTube tube({5.0, 9.0, 11.0, 20.0, 29.0, 31.0});
    std::vector<std::uint8_t> marks(tube.rest_mm.size(), 0);
    for (const std::size_t corner : {3u, 8u, 13u, 14u, 15u}) marks[corner] = 1;
    tube.view.rims = std::make_shared<const std::vector<std::uint8_t>>(marks);
    std::vector<ThroughTear> tears;
    for (const double at_mm : {10.0, 30.0, 21.0, 39.0})
        tears.push_back({{0, at_mm, 0.0}, 4.0 * 3.14159});
    const std::vector<int> all =
        leaking_vertices(tube.tree, tears, tube.view, tube.rest_mm, tube.triangles);
    EXPECT_EQ(all, (std::vector<int>{3, 13, 13, 15})) << "corners that are on a rim, and no others";
    for (std::size_t i = 0; i < tears.size(); ++i)
        EXPECT_EQ(leaking_vertices(tube.tree, {tears[i]}, tube.view, tube.rest_mm, tube.triangles),
                  std::vector<int>{all[i]});
}

}  // namespace
}  // namespace hepatica
