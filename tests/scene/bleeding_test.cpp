// SPDX-License-Identifier: GPL-3.0-or-later
// What torn vessels lose, against what can be worked out by hand.
#include "core/scene/bleeding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hepatica {
namespace {

double least_open_share(const Bleeding& bleeding) {
    return std::min(bleeding.most_pressed(true).open_share,
                    bleeding.most_pressed(false).open_share);
}

constexpr double density_g_mm3 = 1.06e-3;  // of blood

VesselSegment tube(const Vec3& from, const Vec3& to, double radius_mm, int first, int last,
                   VascularSystem system) {
    VesselSegment segment;
    segment.system = system;
    segment.proximal_node = first;
    segment.distal_node = last;
    for (int k = 0; k <= 10; ++k) {
        segment.points_mm.push_back(from + 0.1 * k * (to - from));
        segment.radii_mm.push_back(radius_mm);
    }
    return segment;
}

// A short wide vessel along x.
VesselTree one_tube(VascularSystem system) {
    VesselTree tree;
    tree.nodes = {{Vec3(0, 0, 0)}, {Vec3(20, 0, 0)}};
    tree.segments = {tube(Vec3(0, 0, 0), Vec3(20, 0, 0), 4.0, 0, 1, system)};
    return tree;
}

ThroughTear half_way(int segment, double area_mm2) {
    ThroughTear torn;
    torn.at.segment = segment;
    torn.at.arclength_mm = 10.0;
    torn.area_mm2 = area_mm2;
    return torn;
}

double leak_of(const VesselTree& tree, const std::vector<ThroughTear>& tears) {
    Bleeding bleeding(tree);
    bleeding.set_tears(tears);
    return bleeding.leak_g_s();
}

// What flows in has no other way out.
TEST(Bleeding, OfTheOnlyVesselIsAllThatFlowsIn) {
    const RestingFlow rest;
    const double lumen_mm2 = std::numbers::pi * 16.0;
    EXPECT_NEAR(leak_of(one_tube(VascularSystem::portal), {half_way(0, lumen_mm2)}),
                rest.portal_g_s, 1e-6 * rest.portal_g_s);
    EXPECT_NEAR(leak_of(one_tube(VascularSystem::artery), {half_way(0, lumen_mm2)}),
                rest.artery_g_s, 1e-6 * rest.artery_g_s);
    EXPECT_EQ(leak_of(one_tube(VascularSystem::portal), {}), 0.0);
}

// The bed behind an end vessel is gone with its end.
TEST(Bleeding, AtTheEndOfAnEndVesselIsAllThatFlowsIn) {
    const RestingFlow rest;
    ThroughTear at_end = half_way(0, std::numbers::pi * 16.0);
    at_end.at.arclength_mm = 20.0;
    EXPECT_NEAR(leak_of(one_tube(VascularSystem::portal), {at_end}), rest.portal_g_s,
                1e-6 * rest.portal_g_s);
}

// Of a short wide vessel without friction Bernoulli's law is left: the cava's pressure drives blood
// out of an opening of this area, of which 0.6 counts.
TEST(Bleeding, OfAHepaticVeinIsWhatItsOpeningLetsOut) {
    const RestingFlow rest;
    const double area_mm2 = 2.0;
    const double speed_mm_s = std::sqrt(2.0 * rest.cava_pa / density_g_mm3);  // Pa = g/(mm s^2)
    const double leak = leak_of(one_tube(VascularSystem::hepatic), {half_way(0, area_mm2)});
    EXPECT_NEAR(leak, 0.6 * area_mm2 * speed_mm_s * density_g_mm3, 0.03 * leak);
}

// Short wide vessels: one pressure everywhere.
VesselTree fork_of_two() {
    VesselTree tree;
    const std::array<Vec3, 4> nodes{Vec3(0, 0, 0), Vec3(20, 0, 0), Vec3(40, 5, 0), Vec3(40, -5, 0)};
    for (const Vec3& node : nodes) tree.nodes.push_back({node});
    const auto add = [&](std::size_t from, std::size_t to, int parent) {
        tree.segments.push_back(
            tube(nodes[from], nodes[to], 4.0, int(from), int(to), VascularSystem::portal));
        tree.segments.back().parent = parent;
    };
    add(0, 1, -1);
    add(1, 2, 0);
    add(1, 3, 0);
    return tree;
}

// The opening and the bed behind the whole branch share the inflow. Two branches alike have half of
// the resting flow each.
TEST(Bleeding, OfOneOfTwoBranchesIsSharedWithTheBedOfTheOther) {
    const VesselTree tree = fork_of_two();
    const RestingFlow rest;
    const double area_mm2 = 3.0;
    const double bed_pa_s_g = rest.portal_pa / (0.5 * rest.portal_g_s);
    double low_pa = 0.0, high_pa = 10.0 * rest.portal_pa;
    const auto leak_at = [&](double pressure_pa) {
        return 0.6 * area_mm2 * std::sqrt(2.0 * pressure_pa / density_g_mm3) * density_g_mm3;
    };
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low_pa + high_pa);
        const bool enough = leak_at(middle) + middle / bed_pa_s_g > rest.portal_g_s;
        (enough ? high_pa : low_pa) = middle;
    }
    const double leak = leak_of(tree, {half_way(1, area_mm2)});
    EXPECT_NEAR(leak, leak_at(low_pa), 0.03 * leak);
    EXPECT_GT(leak_of(tree, {half_way(1, area_mm2), half_way(2, area_mm2)}), leak);
}

// The other one keeps its supply, and the fork bleeds by the hole.
TEST(Bleeding, OfABranchThatIsTornOffIsThatOfItsStump) {
    const VesselTree tree = fork_of_two();
    const auto torn_off = [](int segment, double area_mm2) {
        ThroughTear torn = half_way(segment, area_mm2);
        torn.at.arclength_mm = 0.0;
        return torn;
    };
    const double of_stump = leak_of(tree, {half_way(1, 3.0)});
    EXPECT_LT(of_stump, 0.9 * RestingFlow{}.portal_g_s) << "the other branch gets some";
    EXPECT_NEAR(leak_of(tree, {torn_off(1, 3.0)}), of_stump, 0.03 * of_stump);
    Bleeding both(tree);
    both.set_tears({torn_off(1, 3.0), torn_off(2, 1.0)});
    EXPECT_NEAR(both.leak_g_s(), RestingFlow{}.portal_g_s, 1e-5) << "nothing else is left";
    EXPECT_NEAR(both.leaks_g_s()[0], 3.0 * both.leaks_g_s()[1], 1e-6) << "as the openings";
    EXPECT_NEAR(both.leaks_g_s()[0] + both.leaks_g_s()[1], both.leak_g_s(), 1e-9);
}

ThroughTear open_side_of(int segment, double area_mm2) {
    ThroughTear torn = half_way(segment, area_mm2);
    torn.side = true;
    return torn;
}

// The vessel goes on behind the hole. With one pressure p everywhere, the loss c sqrt(p) and what
// goes on, p over the bed's resistance, add up to what flows in: a quadratic for sqrt(p).
TEST(Bleeding, OfAnOpenSideIsSharedWithTheBedBehindIt) {
    const VesselTree tree = one_tube(VascularSystem::portal);
    const RestingFlow rest;
    const double bed_pa_s_g = rest.portal_pa / rest.portal_g_s;
    double last = 0.0;
    for (const double area_mm2 : {0.01, 0.3, 3.0, 10.0, 30.0}) {
        const double c = 0.6 * area_mm2 * std::sqrt(2.0 * density_g_mm3);
        const double root =
            0.5 * bed_pa_s_g * (std::sqrt(c * c + 4.0 * rest.portal_g_s / bed_pa_s_g) - c);
        const double leak = leak_of(tree, {open_side_of(0, area_mm2)});
        EXPECT_NEAR(leak, c * root, 0.02 * c * root) << area_mm2;
        EXPECT_GT(leak, last) << "monotone";
        last = leak;
    }
    EXPECT_LT(last, 0.9 * rest.portal_g_s);
}

TEST(Bleeding, OfAnOpenSideFollowsItsOpening) {
    Bleeding bleeding(fork_of_two());
    bleeding.set_tears({open_side_of(1, 1.0)});
    const double narrow = bleeding.leak_g_s();
    bleeding.step(1.0);
    bleeding.set_tears({open_side_of(1, 2.0)});
    EXPECT_GT(bleeding.leak_g_s(), 1.5 * narrow);
    EXPECT_EQ(bleeding.shares_of_loss(), std::vector<double>{1.0}) << "it is the same tear";
    bleeding.set_tears({open_side_of(1, 1.0)});
    EXPECT_EQ(bleeding.leak_g_s(), narrow) << "the same bits whatever was before";
    bleeding.set_tears({});
    EXPECT_EQ(bleeding.leak_g_s(), 0.0);
}

// A side that tears on until the vessel is cut through.
TEST(Bleeding, OfASideThatTearsOnIsInTheEndThatOfTheStumps) {
    const VesselTree tree = fork_of_two();
    Bleeding bleeding(tree);
    bleeding.set_tears({open_side_of(1, 3.0)});
    EXPECT_LT(bleeding.leak_g_s(), leak_of(tree, {half_way(1, 3.0)}))
        << "as wide, but the vessel goes on";
    bleeding.step(1.0);
    bleeding.set_tears({half_way(1, 30.0)});
    EXPECT_EQ(bleeding.leak_g_s(), leak_of(tree, {half_way(1, 30.0)}));
    EXPECT_EQ(bleeding.shares_of_loss(), std::vector<double>{1.0}) << "what was lost counts there";
}

// Nothing bleeds at the side of a branch that was torn off before it.
TEST(Bleeding, OfAnOpenSideBehindATearIsNone) {
    const VesselTree tree = fork_of_two();
    ThroughTear off = half_way(1, 3.0);
    off.at.arclength_mm = 2.0;
    Bleeding bleeding(tree);
    bleeding.set_tears({off, open_side_of(1, 3.0)});
    EXPECT_NEAR(bleeding.leaks_g_s()[1], 0.0, 1e-9);
    EXPECT_NEAR(bleeding.leak_g_s(), leak_of(tree, {off}), 1e-9);
}

// Held between the fork and the stump: what presses less than the blood does changes nothing, and
// the harder it is held, the less is lost.
TEST(Bleeding, FallsWhereTheVesselIsHeldBeforeItsStump) {
    const RestingFlow rest;
    Bleeding bleeding(fork_of_two());
    bleeding.set_tears({half_way(1, 30.0)});
    const double free = bleeding.leak_g_s();
    const auto held = [&](int segment, double pressure_pa) {
        bleeding.set_pressed({{segment, 3.0, 7.0, pressure_pa}}, {});
        return bleeding.leak_g_s();
    };
    EXPECT_EQ(held(1, 0.99 * rest.portal_pa), free);
    EXPECT_EQ(least_open_share(bleeding), 1.0);
    double last = free;
    for (const double excess_pa : {300.0, 1e3, 3e3, 1e4, 1e5}) {
        const double now = held(1, rest.portal_pa + excess_pa);
        EXPECT_LT(now, last) << excess_pa;
        last = now;
    }
    EXPECT_LT(last, 0.03 * free);
    EXPECT_LT(least_open_share(bleeding), 0.02);
    EXPECT_GT(held(2, rest.portal_pa + 1e5), free) << "the other branch: more comes here";
    bleeding.set_pressed({}, {});
    EXPECT_EQ(bleeding.leak_g_s(), free);
}

// Forceps may hold another vessel than the one that bleeds, or what lies behind its stump.
TEST(Bleeding, TellsWhatIsPressedBeforeATearFromAllElse) {
    const double hard_pa = RestingFlow{}.portal_pa + 1e5;
    Bleeding bleeding(fork_of_two());
    const auto pressed = [&](int segment, double from_mm, double to_mm) {
        bleeding.set_pressed({{segment, from_mm, to_mm, hard_pa}}, {});
        const PressedLumen before = bleeding.most_pressed(true);
        const PressedLumen other = bleeding.most_pressed(false);
        EXPECT_NE(before.segment < 0, other.segment < 0) << "it is one of both";
        EXPECT_EQ(std::max(before.segment, other.segment), segment);
        return before.segment == segment;
    };
    bleeding.set_tears({half_way(1, 30.0)});
    EXPECT_TRUE(pressed(0, 3.0, 7.0)) << "the trunk";
    EXPECT_TRUE(pressed(1, 3.0, 7.0));
    EXPECT_TRUE(pressed(1, 8.0, 12.0)) << "over the stump";
    EXPECT_FALSE(pressed(1, 13.0, 17.0)) << "behind it";
    EXPECT_FALSE(pressed(2, 3.0, 7.0)) << "the other branch";
    bleeding.set_tears({half_way(0, 30.0), half_way(1, 30.0)});
    EXPECT_TRUE(pressed(0, 3.0, 7.0));
    EXPECT_FALSE(pressed(1, 3.0, 7.0)) << "it is cut off its root";
    bleeding.set_tears({open_side_of(0, 3.0), half_way(1, 30.0)});
    EXPECT_TRUE(pressed(1, 3.0, 7.0)) << "past an open side blood flows on";
    bleeding.set_pressed({}, {});
    EXPECT_EQ(bleeding.most_pressed(true).segment, -1);
    EXPECT_EQ(bleeding.most_pressed(false).open_share, 1.0);
}

// Made whole under a tool, which is gone by then.
TEST(Bleeding, ForgetsWhatPressedOnceNothingIsTorn) {
    const RestingFlow rest;
    Bleeding bleeding(fork_of_two());
    bleeding.set_tears({half_way(1, 30.0)});
    const double free = bleeding.leak_g_s();
    bleeding.set_pressed({{1, 3.0, 7.0, rest.portal_pa + 1e5}}, {});
    ASSERT_LT(least_open_share(bleeding), 0.02);
    bleeding.set_tears({});
    EXPECT_EQ(least_open_share(bleeding), 1.0);
    bleeding.set_tears({half_way(1, 30.0)});
    EXPECT_EQ(bleeding.leak_g_s(), free);
}

// A clamp on the only way in: the arteries' pressure drives what is left through it, less the
// resistance of what lies between.
TEST(Bleeding, OfAHeldTrunkIsWhatTheArteriesPressThrough) {
    const RestingFlow rest;
    Bleeding bleeding(one_tube(VascularSystem::portal));
    bleeding.set_tears({half_way(0, 30.0)});
    bleeding.set_pressed({{0, 2.0, 6.0, rest.portal_pa + 2e4}}, {});
    const double share = least_open_share(bleeding);
    const double throat_mm2 = share * std::numbers::pi * 16.0;
    double low = 0.0, high = 1.0;  // of the resting inflow
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        const double flow_mm3_s = middle * rest.portal_g_s / density_g_mm3;
        const auto head = [&](double area_mm2) {
            return 0.5 * density_g_mm3 * std::pow(flow_mm3_s / area_mm2, 2.0);
        };
        const double poiseuille_pa = 8.0 * pure(blood()).viscosity_pa_s * 4.0 * flow_mm3_s /
                                     (std::numbers::pi * std::pow(4.0 * std::sqrt(share), 4.0));
        const double needed_pa =
            poiseuille_pa + jet_loss(share) * head(throat_mm2) + head(0.6 * 30.0);
        const bool too_much = needed_pa > rest.aorta_pa - middle * (rest.aorta_pa - rest.portal_pa);
        (too_much ? high : low) = middle;
    }
    EXPECT_LT(bleeding.leak_g_s(), 0.5 * rest.portal_g_s);
    EXPECT_NEAR(bleeding.leak_g_s(), low * rest.portal_g_s, 0.05 * low * rest.portal_g_s);
}

// As pools of it are drawn.
TEST(Bleeding, KeepsWhatWasLostAtEachTearAlsoWhereItIsStemmed) {
    Bleeding bleeding(fork_of_two());
    const std::vector<ThroughTear> both{half_way(1, 30.0), half_way(2, 30.0)};
    bleeding.set_tears({both[0]});
    EXPECT_EQ(bleeding.shares_of_loss(), std::vector<double>{1.0}) << "as it bleeds";
    bleeding.step(1.0);
    const double first_g = bleeding.leaked_g();
    bleeding.set_tears(both);
    EXPECT_EQ(bleeding.shares_of_loss(), (std::vector{1.0, 0.0}));
    bleeding.set_pressed({{1, 3.0, 7.0, RestingFlow{}.portal_pa + 1e5}}, {});
    ASSERT_LT(bleeding.leaks_g_s()[0], 0.5 * bleeding.leaks_g_s()[1]);
    bleeding.step(1.0);
    const std::vector<double> shares = bleeding.shares_of_loss();
    EXPECT_NEAR(shares[0] * bleeding.leaked_g(), first_g + bleeding.leaks_g_s()[0], 1e-9);
    EXPECT_NEAR(shares[1] * bleeding.leaked_g(), bleeding.leaks_g_s()[1], 1e-9);
    bleeding.set_leaked_g(5.0);
    EXPECT_NEAR(bleeding.shares_of_loss()[1], bleeding.leaks_g_s()[1] / bleeding.leak_g_s(), 1e-9)
        << "a checkpoint knows the sum alone";
    bleeding.set_tears({});
    EXPECT_TRUE(bleeding.shares_of_loss().empty());
}

// A cut that grows is found a stretch further on; another one begins with nothing lost.
TEST(Bleeding, ATearThatMovesALittleKeepsWhatWasLostThere) {
    Bleeding bleeding(fork_of_two());
    bleeding.set_tears({half_way(1, 30.0)});
    bleeding.step(1.0);
    ThroughTear moved = half_way(1, 28.0), far = half_way(1, 30.0);
    moved.at.arclength_mm = 11.5;
    far.at.arclength_mm = 2.0;
    bleeding.set_tears({far, half_way(2, 30.0), moved});
    EXPECT_EQ(bleeding.shares_of_loss(), (std::vector{0.0, 0.0, 1.0}));
    bleeding.set_tears({half_way(1, 30.0), moved});
    EXPECT_EQ(bleeding.shares_of_loss(), (std::vector{0.0, 1.0})) << "what is the same comes first";
}

double lying_g(const Bleeding& bleeding) {
    double sum = 0.0;
    for (const BloodPool& pool : bleeding.pools()) sum += pool.lost_g;
    return sum;
}

// What has bled stays bled: a side that closes bleeds no more, and goes on where it opens again.
TEST(Bleeding, OfASideThatHasClosedStaysWhereItWasLost) {
    Bleeding bleeding(fork_of_two());
    const ThroughTear side = open_side_of(1, 1.0), stump = half_way(2, 30.0);
    bleeding.set_tears({side, stump});
    bleeding.step(1.0);
    const double lost_g = bleeding.pools()[0].lost_g;
    EXPECT_EQ(lost_g, bleeding.leaks_g_s()[0]);
    ASSERT_GT(lost_g, 0.0);
    double last_g = bleeding.leaked_g();
    const auto goes_on = [&] {
        bleeding.step(0.5);
        EXPECT_NEAR(bleeding.leaked_g(), last_g + 0.5 * bleeding.leak_g_s(), 1e-12 * last_g);
        EXPECT_GE(bleeding.leaked_g(), last_g);
        EXPECT_NEAR(lying_g(bleeding), bleeding.leaked_g(), 1e-12 * last_g);
        last_g = bleeding.leaked_g();
    };

    bleeding.set_tears({stump});
    EXPECT_EQ(bleeding.leaks_g_s().size(), 1u);
    goes_on();
    ASSERT_EQ(bleeding.pools().size(), 2u);
    EXPECT_TRUE(bleeding.pools()[1].of == side) << "behind what is open";
    EXPECT_EQ(bleeding.pools()[1].lost_g, lost_g);
    const std::vector<double> shares = bleeding.shares_of_loss();
    ASSERT_EQ(shares.size(), 2u);
    EXPECT_NEAR(shares[1] * bleeding.leaked_g(), lost_g, 1e-12);

    bleeding.set_tears({});
    EXPECT_EQ(bleeding.leak_g_s(), 0.0);
    goes_on();
    EXPECT_EQ(bleeding.pools().size(), 2u);

    bleeding.set_tears({side});
    ASSERT_EQ(bleeding.pools().size(), 2u) << "it is the same side";
    EXPECT_EQ(bleeding.pools()[0].lost_g, lost_g);
    goes_on();
    EXPECT_EQ(bleeding.pools()[0].lost_g, lost_g + 0.5 * bleeding.leaks_g_s()[0]);
    bleeding.set_leaked_g(0.0);
    ASSERT_EQ(bleeding.pools().size(), 1u) << "that of what is open";
    EXPECT_EQ(bleeding.pools()[0].lost_g, 0.0);
}

TEST(Bleeding, NothingLiesWhereNothingHasBled) {
    Bleeding bleeding(fork_of_two());
    bleeding.set_tears({open_side_of(1, 1.0)});
    bleeding.set_tears({});
    EXPECT_TRUE(bleeding.pools().empty());
}

TEST(Bleeding, TheDrugThatHasLeakedStaysInItsPool) {
    Bleeding bleeding(fork_of_two());
    const ThroughTear side = open_side_of(1, 1.0), stump = half_way(2, 30.0);
    bleeding.set_tears({side, stump});
    bleeding.step(1.0);
    bleeding.leak_drug(0.5, {0.25, 0.75});
    bleeding.set_tears({stump});
    bleeding.step(1.0);
    bleeding.leak_drug(0.5, {1.0});
    bleeding.leak_drug(0.0, {});
    ASSERT_EQ(bleeding.pools().size(), 2u);
    EXPECT_EQ(bleeding.pools()[0].drug_g, 0.875);
    EXPECT_EQ(bleeding.pools()[1].drug_g, 0.125);
    EXPECT_EQ(bleeding.leaked_drug_g(), 1.0);
    Bleeding other(fork_of_two());
    other.set_tears({stump});
    other.set_leaked_g(bleeding.leaked_g());
    other.set_pools(bleeding.pools());
    ASSERT_EQ(other.pools().size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(other.pools()[i].lost_g, bleeding.pools()[i].lost_g);
        EXPECT_EQ(other.pools()[i].drug_g, bleeding.pools()[i].drug_g);
    }
    EXPECT_EQ(other.shares_of_loss(), bleeding.shares_of_loss());
}

TEST(Bleeding, AddsUpOverTimeAndStopsWhereNothingIsTorn) {
    Bleeding bleeding(one_tube(VascularSystem::portal));
    bleeding.step(1.0);
    EXPECT_EQ(bleeding.leaked_g(), 0.0);
    bleeding.set_tears({half_way(0, 50.0)});
    bleeding.step(0.5);
    bleeding.step(0.25);
    EXPECT_NEAR(bleeding.leaked_g(), 0.75 * bleeding.leak_g_s(), 1e-9);
    bleeding.set_tears({});
    EXPECT_EQ(bleeding.leak_g_s(), 0.0);
    bleeding.set_leaked_g(3.5);
    bleeding.step(1.0);
    EXPECT_EQ(bleeding.leaked_g(), 3.5);
}

}  // namespace
}  // namespace hepatica
