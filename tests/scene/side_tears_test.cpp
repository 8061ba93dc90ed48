// SPDX-License-Identifier: GPL-3.0-or-later
// How far the side of a vessel counts as open: a bar of 4 x 4 cubes of 1 mm along x, mostly cut at
// x = 10 from its top downwards. Areas by hand.
#include "core/scene/side_tears.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "core/scene/bleeding.h"
#include "core/scene/origins_of.h"
#include "tests/scene/cube_body.h"

namespace hepatica {
namespace {

using test::CubeBody;
using test::tree_of;

constexpr double bar_stretch_mm = 2.0;
constexpr double section_mm2 = 16.0;

struct CutBar {
    explicit CutBar(int wide = 4) {
        for (int x = 0; x < 20; ++x)
            for (int y = 0; y < wide; ++y)
                for (int z = 0; z < wide; ++z) body.add(x, y, 0, x + 0.5, z);
        tree.segments[0].radii_mm.assign(2, std::sqrt(section_mm2 / std::numbers::pi));
    }

    // A rectangle in the plane x = 10, from this corner.
    void cut(double y, double z, double high, double deep) {
        const std::vector<int> joints = tearing().crossing(Vec3(10, y, z), Vec3(0, high, 0),
                                                           Vec3(0, 0, deep), positions(0.0, 0.0));
        ASSERT_FALSE(joints.empty());
        tearing().cut(joints);
    }
    void cut_from_top(double depth) { cut(4.0 - depth, -1.0, depth + 1.0, 6.0); }

    // What lies beyond the cut is turned away, by `wide` at the top and not at all at the bottom of
    // a cut of this depth.
    std::vector<Vec3> positions(double depth, double wide_mm) {
        const TornTopology& topology = tearing().topology();
        const std::vector<int> origins = origins_of(topology);
        std::vector<Vec3> at = body.rest_of(tearing());
        for (std::size_t t = 0; t < body.places.size(); ++t) {
            if (body.places[t].on_tree.arclength_mm < 10.0) continue;
            for (const int v : topology.tetrahedra()[t]) {
                const Vec3& rest = body.mesh.vertices_mm[std::size_t(origins[std::size_t(v)])];
                const double above = rest.y() - (4.0 - depth);
                if (rest.x() == 10.0 && above > 0.0)
                    at[std::size_t(v)] = rest + Vec3(wide_mm * above / depth, 0, 0);
            }
        }
        return at;
    }

    TornPlaces torn() {
        TornPlaces places{through_tears(tree, tearing(), body.places, bar_stretch_mm), {}};
        places.sides = side_tears(tree, tearing(), body.places, bar_stretch_mm, places.through);
        return places;
    }

    Tearing& tearing() {
        if (!tearing_) tearing_.emplace(body.mesh, TearLaw{}, std::span<const double>{});
        return *tearing_;
    }

    CubeBody body;
    VesselTree tree = tree_of({-1});
    std::optional<Tearing> tearing_;
};

// Rows of the section whose corners all came apart count wholly, the last one by half.
TEST(SideTears, ShareOfTheSectionAndGape) {
    for (const int depth : {2, 3}) {
        CutBar bar;
        bar.cut_from_top(depth);
        const TornPlaces torn = bar.torn();
        EXPECT_TRUE(torn.through.empty());
        ASSERT_EQ(torn.sides.size(), 1u) << depth;
        const SideTear& side = torn.sides[0];
        EXPECT_EQ(side.at.segment, 0);
        EXPECT_NEAR(side.at.arclength_mm, 10.0, 1.0);
        const double parted_mm2 = 4.0 * (depth - 1) + 2.0;
        EXPECT_NEAR(side.most_mm2, 2.0 * parted_mm2, 1e-12) << depth;
        const double wide_mm = 0.1;
        // Over the top's 4 mm, and a triangle on both sides.
        const double gape = 4.0 * wide_mm + depth * wide_mm;
        EXPECT_NEAR(gape_mm2(side, bar.positions(depth, wide_mm)), gape, 1e-12) << depth;
        const double opening = opening_mm2(side, bar.positions(depth, wide_mm));
        EXPECT_NEAR(std::log2(opening / gape), 0.0, 0.125 + 1e-9) << depth;
        EXPECT_EQ(opening_mm2(side, bar.positions(depth, 10.0)), side.most_mm2);
        EXPECT_EQ(opening_mm2(side, bar.positions(depth, 0.0)), 0.0) << "it is closed";
    }
}

// As for the body to count as torn.
TEST(SideTears, BeginWithAJointThatHasComeApartWholly) {
    CutBar bar;
    bar.cut_from_top(1);
    ASSERT_FALSE(bar.tearing().open_joints().empty());
    ASSERT_EQ(bar.tearing().report().joints_broken, 0);
    EXPECT_TRUE(bar.torn().sides.empty());
}

// A tie of one joint binds its vertices for its neighbours, too.
TEST(SideTears, AreNotWhereTiesHold) {
    const auto open_corners = [](CutBar& bar) {
        int count = 0;
        for (const OpenJoint& open : bar.tearing().open_joints())
            count += static_cast<int>(std::ranges::count(open.corners, true));
        return count;
    };
    CutBar bar;
    bar.cut_from_top(2);
    const int before = open_corners(bar);
    const double half_mm = 0.5 * TearLaw{}.softening().opening_mm;
    TearState tied = bar.tearing().state();
    const std::vector<OpenJoint> open = bar.tearing().open_joints();
    const auto whole =
        std::ranges::find(open, std::array<bool, 3>{true, true, true}, &OpenJoint::corners);
    ASSERT_NE(whole, open.end());
    const auto at = std::ranges::find(tied.parted, whole->joint) - tied.parted.begin();
    std::fill_n(tied.most_mm.begin() + 3 * at, 3, half_mm);
    bar.tearing().restore(tied);
    EXPECT_GT(open_corners(bar), 0);
    EXPECT_LT(open_corners(bar), before - 3);
    std::ranges::fill(tied.most_mm, half_mm);
    bar.tearing().restore(tied);
    EXPECT_EQ(open_corners(bar), 0);
    EXPECT_TRUE(bar.torn().sides.empty());
}

TEST(SideTears, AreNoMoreThanTheLumen) {
    CutBar bar;
    bar.tree.segments[0].radii_mm.assign(2, 1.0);
    bar.cut_from_top(2);
    const TornPlaces torn = bar.torn();
    ASSERT_EQ(torn.sides.size(), 1u);
    EXPECT_NEAR(torn.sides[0].most_mm2, 2.0 * std::numbers::pi, 1e-12);
}

TEST(SideTears, OpenWiderTheWiderTheyGape) {
    CutBar bar;
    bar.cut_from_top(3);
    const TornPlaces torn = bar.torn();
    ASSERT_EQ(torn.sides.size(), 1u);
    double last = 0.0;
    int changes = 0;
    for (int k = 0; k <= 400; ++k) {
        const double now = opening_mm2(torn.sides[0], bar.positions(3, 0.01 * k));
        EXPECT_GE(now, last) << k;
        changes += now != last ? 1 : 0;
        last = now;
    }
    EXPECT_EQ(last, torn.sides[0].most_mm2);
    EXPECT_GT(changes, 10);
    EXPECT_LT(changes, 45) << "each is a solution of the flow";
}

// Lips that lie on each other are held open by the blood within, up to what has parted.
TEST(SideTears, AreHeldOpenByTheBloodWithin) {
    CutBar bar;
    bar.cut_from_top(3);
    const TornPlaces torn = bar.torn();
    ASSERT_EQ(torn.sides.size(), 1u);
    const SideTear& side = torn.sides[0];
    const std::vector<Vec3> closed = bar.positions(3, 0.0);
    EXPECT_EQ(opening_mm2(side, closed), 0.0);
    EXPECT_NEAR(opening_mm2(side, closed, 0.7), 0.7, 0.1) << "in steps";
    EXPECT_EQ(opening_mm2(side, closed, 1e6), side.most_mm2);
    const double length = slit_length_mm(side, closed);
    EXPECT_NEAR(length, 4.0 + 2.0 * 3.0, 1e-12) << "across the top and down both sides";
    const std::vector<ThroughTear> open = open_tears(torn, closed, [&](int, double length_mm) {
        EXPECT_EQ(length_mm, length);
        return 0.7;
    });
    ASSERT_EQ(open.size(), 1u);
    EXPECT_TRUE(open[0].side);
    EXPECT_TRUE(open_tears(torn, closed).empty());
}

// Pulled open, let go, and pulled open again.
TEST(SideTears, ThatCloseKeepTheBloodThatTheyHaveLost) {
    CutBar bar;
    bar.cut_from_top(3);
    const TornPlaces torn = bar.torn();
    bar.tree.nodes = {{Vec3(0, 0, 0)}, {Vec3(30, 0, 0)}};
    VesselSegment& vessel = bar.tree.segments[0];
    vessel.proximal_node = 0;
    vessel.distal_node = 1;
    vessel.system = VascularSystem::portal;
    Bleeding bleeding(bar.tree);
    double last_g = 0.0;
    for (const double wide_mm : {0.0, 0.05, 0.2, 0.05, 0.0, 0.0, 0.1}) {
        bleeding.set_tears(open_tears(torn, bar.positions(3, wide_mm)));
        EXPECT_EQ(bleeding.leak_g_s() > 0.0, wide_mm > 0.0) << wide_mm;
        bleeding.step(0.1);
        if (wide_mm > 0.0)
            EXPECT_GT(bleeding.leaked_g(), last_g) << wide_mm;
        else
            EXPECT_EQ(bleeding.leaked_g(), last_g);
        last_g = bleeding.leaked_g();
        ASSERT_EQ(bleeding.pools().size(), last_g > 0.0 ? 1u : 0u) << wide_mm;
        for (const BloodPool& pool : bleeding.pools()) EXPECT_NEAR(pool.lost_g, last_g, 1e-12);
    }
}

TEST(SideTears, ThatGoOnToTheEndAreThroughTears) {
    CutBar bar;
    bar.cut_from_top(2);
    ASSERT_EQ(bar.torn().sides.size(), 1u);
    bar.cut_from_top(4);
    const TornPlaces torn = bar.torn();
    EXPECT_EQ(torn.through.size(), 1u);
    EXPECT_TRUE(torn.sides.empty());
    const std::vector<ThroughTear> open = open_tears(torn, bar.positions(4, 1.0));
    ASSERT_EQ(open.size(), 1u);
    EXPECT_FALSE(open[0].side);
    EXPECT_NEAR(open[0].area_mm2, section_mm2, 1e-9);
}

TEST(SideTears, AreThereAgainAfterARestore) {
    CutBar bar;
    const TearState whole = bar.tearing().state();
    bar.cut_from_top(2);
    const TearState cut = bar.tearing().state();
    const std::vector<Vec3> open = bar.positions(2, 0.3);
    const TornPlaces before = bar.torn();
    const std::vector<ThroughTear> tears = open_tears(before, open);
    ASSERT_EQ(tears.size(), 1u);
    EXPECT_TRUE(tears[0].side);
    bar.tearing().restore(whole);
    EXPECT_TRUE(bar.torn().sides.empty());
    bar.tearing().restore(cut);
    EXPECT_EQ(open_tears(bar.torn(), open), tears);
    EXPECT_EQ(open_tears(bar.torn(), open)[0].area_mm2, tears[0].area_mm2);
}

// Nothing comes out of a crack that does not reach the surface.
TEST(SideTears, AreNotInside) {
    CutBar bar(6);
    bar.cut(1.0, 1.0, 4.0, 4.0);
    ASSERT_GT(bar.tearing().report().joints_broken, 0);
    EXPECT_TRUE(bar.torn().sides.empty());
}

// What is cut lies within the wall, a tenth of the radius, or does not.
TEST(SideTears, AreNotInTheWallAlone) {
    for (const double share : {0.5, 0.95}) {
        CutBar bar;
        for (VertexPlace& place : bar.body.places)
            place.on_tree.distance_mm = share * place.radius_mm;
        bar.cut_from_top(2);
        EXPECT_EQ(bar.torn().sides.size(), share < 0.9 ? 1u : 0u) << share;
    }
}

// Along the vessel: the same law, by the plane that the cut lies in.
TEST(SideTears, AreSlitsAlongTheVessel) {
    CutBar bar;
    const std::vector<int> joints = bar.tearing().crossing(
        Vec3(7, 2, 2), Vec3(6, 0, 0), Vec3(0, 3, 0), bar.body.mesh.vertices_mm);
    ASSERT_FALSE(joints.empty());
    bar.tearing().cut(joints);
    const TornPlaces torn = bar.torn();
    ASSERT_EQ(torn.sides.size(), 1u);
    // A sixth of a square millimetre for each triangle of a vertex that came apart: five on the
    // surface with three triangles, and five below with six.
    EXPECT_NEAR(torn.sides[0].most_mm2, 2.0 * (5 * 3 + 5 * 6) / 6.0, 1e-12);
    EXPECT_EQ(torn.sides[0].gaps.size(), 6u);
}

}  // namespace
}  // namespace hepatica
