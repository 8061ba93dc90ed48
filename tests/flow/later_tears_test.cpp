// SPDX-License-Identifier: GPL-3.0-or-later
// What tears while a drug runs: times in closed form, flows solved apart, and conservation.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/base/error.h"
#include "core/flow/injection.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::make_tree;

constexpr double tube_lumen_mm2 = 4.0 * std::numbers::pi;

VesselSegment straight(const Vec3& from, const Vec3& to, int first, int last, int parent) {
    VesselSegment segment;
    segment.proximal_node = first;
    segment.distal_node = last;
    segment.parent = parent;
    segment.points_mm = {from, 0.5 * (from + to), to};
    segment.radii_mm = {2.0, 2.0, 2.0};
    return segment;
}

VesselTree tube_to_tear() {
    VesselTree tree;
    tree.nodes = {{Vec3(0, 0, 0)}, {Vec3(40, 0, 0)}};
    tree.segments = {straight(Vec3(0, 0, 0), Vec3(40, 0, 0), 0, 1, -1)};
    return tree;
}

// A trunk of 20 mm and two branches of 40 mm each, all of one radius.
VesselTree fork_with_equal_branches() {
    VesselTree tree;
    const std::array<Vec3, 4> nodes{Vec3(0, 0, 0), Vec3(20, 0, 0), Vec3(44, 32, 0),
                                    Vec3(44, -32, 0)};
    for (const Vec3& node : nodes) tree.nodes.push_back({node});
    tree.segments = {straight(nodes[0], nodes[1], 0, 1, -1), straight(nodes[1], nodes[2], 1, 2, 0),
                     straight(nodes[1], nodes[3], 1, 3, 0)};
    return tree;
}

InjectionOptions into_root() {
    InjectionOptions options;
    options.tip = TreePoint{0, 0.0, 0.0};
    options.wedged = false;
    options.until_s = 0.5;
    options.step_s = 0.05;
    return options;
}

LaterTears torn_at(double from_s, const TreePoint& at, double area_mm2 = tube_lumen_mm2,
                   bool side = false) {
    return {from_s, {at}, {area_mm2}, {static_cast<std::uint8_t>(side ? 1 : 0)}};
}

InjectionResult run_torn(const VesselTree& tree, const InjectionOptions& options) {
    Job job;
    InjectionResult result = inject(tree, options, job);
    EXPECT_LE(result.balance.error_relative(), 1e-11);
    double last_g = 0.0;
    for (const InjectionSample& s : result.series) {
        EXPECT_NEAR(s.injected_g, s.inside_g + s.delivered_g + s.bled_g, 1e-9);
        EXPECT_GE(s.bled_g, last_g - 1e-12);
        last_g = s.bled_g;
    }
    return result;
}

double speed_mm_s(double mass_flow_g_s) {
    return mass_flow_g_s / pure(blood()).density_g_mm3 / tube_lumen_mm2;
}

double arrival_s(const InjectionResult& result, int segment, double at_mm) {
    return result.arrival.arrival_s(TreePoint{segment, at_mm, 0.0});
}

// The front is at 7.5 mm, or at 30 mm: what it has passed stays reached, nothing beyond comes, and
// what is injected but not needed to fill the vessel up to the tear bleeds.
TEST(LaterTears, EndTheWayOfTheDrugFromThenOn) {
    const double speed = speed_mm_s(2.0);
    for (const double from_s : {0.05, 30.0 / speed}) {
        InjectionOptions options = into_root();
        options.later_tears = {torn_at(from_s, {0, 20.0, 0.0})};
        const InjectionResult torn = run_torn(tube_to_tear(), options);
        const double reached_mm = std::max(20.0, from_s * speed);
        for (int mm = 1; mm < 40; mm += 2) {
            const double at_s = arrival_s(torn, 0, mm);
            if (mm < reached_mm)
                EXPECT_NEAR(at_s, mm / speed, 1e-9) << mm;
            else
                EXPECT_TRUE(std::isinf(at_s)) << mm;
        }
        EXPECT_NEAR(torn.balance.bled_mm3, tube_lumen_mm2 * (0.5 * speed - reached_mm), 1e-6);
        EXPECT_NEAR(torn.balance.inside_mm3, tube_lumen_mm2 * reached_mm, 1e-6);
        EXPECT_NEAR(torn.balance.left_mm3, 0.0, 1e-9);
    }
}

TEST(LaterTears, FromTheStartAreThoseOfTheInjection) {
    InjectionOptions first = into_root(), later = into_root();
    first.tears = {{1, 10.0, 0.0}};
    first.tear_areas_mm2 = {3.0};
    first.tear_sides = {0};
    later.later_tears = {torn_at(0.0, {1, 10.0, 0.0}, 3.0)};
    const InjectionResult a = run_torn(fork_with_equal_branches(), first),
                          b = run_torn(fork_with_equal_branches(), later);
    for (int segment = 0; segment < 3; ++segment)
        for (double mm = 0.5; mm < 20.0; mm += 1.0) {
            const double expected = arrival_s(a, segment, mm), is = arrival_s(b, segment, mm);
            if (std::isfinite(expected))
                EXPECT_NEAR(is, expected, 1e-9) << segment << ' ' << mm;
            else
                EXPECT_TRUE(std::isinf(is)) << segment << ' ' << mm;
        }
    EXPECT_NEAR(a.balance.bled_mm3, b.balance.bled_mm3, 1e-6);
}

// The drug waits 10 mm into the branch until the tear is closed, and then goes on from there.
TEST(LaterTears, StopADrugThatGoesOnWhenTheyCloseAgain) {
    const double speed = speed_mm_s(2.0), branch = 0.5 * speed;
    const double torn_s = 20.0 / speed + 10.0 / branch, closed_s = torn_s + 0.05;
    InjectionOptions options = into_root();
    options.until_s = 1.0;
    options.later_tears = {torn_at(torn_s, {1, 5.0, 0.0}), {.from_s = closed_s}};
    const InjectionResult torn = run_torn(fork_with_equal_branches(), options);
    for (int mm = 1; mm < 40; mm += 2) {
        const double usual_s = 20.0 / speed + mm / branch;
        EXPECT_NEAR(arrival_s(torn, 1, mm), mm < 10 ? usual_s : usual_s + 0.05, 1e-9) << mm;
    }
}

// Half of the flow runs in each branch until one is torn; then what a solution of the torn network
// says.
TEST(LaterTears, GiveTheOtherBranchWhatTheTornNetworkSays) {
    const VesselTree tree = fork_with_equal_branches();
    const double speed = speed_mm_s(2.0), from_s = 20.0 / speed + 10.0 / (0.5 * speed);
    InjectionOptions options = into_root();
    options.later_tears = {torn_at(from_s, {1, 5.0, 0.0}, 1.0)};
    const InjectionResult torn = run_torn(tree, options);

    FlowNetwork network = network_of(tree);
    const std::array<TreePoint, 1> at{TreePoint{1, 5.0, 0.0}};
    const std::array<double, 1> areas{1.0};
    FlowConditions conditions;
    conditions.torn_areas_mm2 = torn_areas_mm2(network, tear_all(network, at, areas));
    conditions.resident = pure(blood());
    conditions.inlets = {{0, InletKind::mass_flow, 2.0, conditions.resident}};
    const double after = solve_flow(network, conditions).volume_flow_mm3_s[2] / tube_lumen_mm2;
    ASSERT_GT(std::abs(after - 0.5 * speed), 0.01 * speed);
    EXPECT_NEAR(arrival_s(torn, 2, 5.0), 20.0 / speed + 5.0 / (0.5 * speed), 1e-9);
    for (const double mm : {15.0, 25.0, 39.0})
        EXPECT_NEAR(arrival_s(torn, 2, mm), from_s + (mm - 10.0) / after, 1e-7) << mm;
    EXPECT_TRUE(std::isfinite(arrival_s(torn, 1, 9.0))) << "it was there before";
    EXPECT_TRUE(std::isinf(arrival_s(torn, 1, 11.0)));
}

// A side that opens and closes: behind it the drug is slower for that time.
TEST(LaterTears, OfASideSlowWhatIsBehindWhileItIsOpen) {
    const double speed = speed_mm_s(2.0);
    const double opens_s = 25.0 / speed;
    InjectionOptions options = into_root();
    options.later_tears = {torn_at(opens_s, {0, 20.0, 0.0}, 3.0, true)};
    const InjectionResult open = run_torn(tube_to_tear(), options);
    EXPECT_NEAR(arrival_s(open, 0, 24.0), 24.0 / speed, 1e-9);
    const double slow = 5.0 / (arrival_s(open, 0, 30.0) - opens_s);
    EXPECT_LT(slow, 0.9 * speed);
    EXPECT_NEAR(arrival_s(open, 0, 35.0), opens_s + 10.0 / slow, 1e-7) << "steady";
    const double closes_s = opens_s + 5.0 / slow;
    options.later_tears.push_back({closes_s});
    const InjectionResult closed = run_torn(tube_to_tear(), options);
    EXPECT_NEAR(arrival_s(closed, 0, 38.0), closes_s + 8.0 / speed, 1e-7);
    EXPECT_NEAR(closed.balance.bled_mm3, tube_lumen_mm2 * (speed - slow) * (closes_s - opens_s),
                1e-5);
}

// Nodes have other numbers where fewer vessels are torn than at first.
TEST(LaterTears, ThatHaveClosedLeaveThePressureOfTheTip) {
    InjectionOptions whole = into_root();
    whole.tip = TreePoint{1, 0.0, 0.0};
    InjectionOptions closes = whole;
    closes.tears = {{1, 0.0, 0.0}};
    closes.tear_areas_mm2 = {tube_lumen_mm2};
    closes.tear_sides = {0};
    closes.later_tears = {LaterTears{.from_s = 0.2}};
    const VesselTree tree = fork_with_equal_branches();
    const InjectionResult expected = run_torn(tree, whole), is = run_torn(tree, closes);
    const double pressure_pa = expected.series.back().inlet_pressure_pa;
    EXPECT_GT(std::abs(is.series.front().inlet_pressure_pa - pressure_pa), 0.01 * pressure_pa);
    EXPECT_NEAR(is.series.back().inlet_pressure_pa, pressure_pa, 1e-6 * pressure_pa);
}

// As injection.h has it: the vessel behind the tear got nothing at the start.
TEST(LaterTears, ThatCloseLeaveTerritoriesAsTheyWereAtTheStart) {
    InjectionOptions options = into_root();
    options.until_s = 1.0;
    options.tears = {{1, 5.0, 0.0}};
    options.tear_areas_mm2 = {tube_lumen_mm2};
    options.tear_sides = {0};
    options.later_tears = {LaterTears{.from_s = 0.2}};
    options.territories = {{0, 0.0, 0.0}};
    const InjectionResult closed = run_torn(fork_with_equal_branches(), options);
    const InjectionSample& end = closed.series.back();
    ASSERT_EQ(end.outlet_mass_g.size(), 2u);
    const double behind_g = 35.0 * tube_lumen_mm2 * closed.drug.density_g_mm3;
    EXPECT_GT(end.outlet_mass_g[0], 0.1) << "the drug goes on";
    EXPECT_NEAR(end.territory_mass_g.at(0),
                end.inside_g + end.delivered_g - behind_g - end.outlet_mass_g[0], 1e-6);
}

// The end of a vessel is torn off: what went through it until then counts as delivered, what comes
// afterwards does not.
TEST(LaterTears, OfAnEndLeaveWhatItHasDelivered) {
    const double speed = speed_mm_s(2.0);
    InjectionOptions options = into_root();
    const double from_s = 60.0 / speed;
    options.later_tears = {torn_at(from_s, {0, 40.0, 0.0})};
    const InjectionResult torn = run_torn(tube_to_tear(), options);
    EXPECT_NEAR(torn.balance.left_mm3, 20.0 * tube_lumen_mm2, 1e-6);
    EXPECT_NEAR(torn.balance.bled_mm3, tube_lumen_mm2 * (0.5 * speed - 60.0), 1e-6);
    const InjectionSample& last = torn.series.back();
    ASSERT_EQ(last.outlet_mass_g.size(), 1u);
    EXPECT_NEAR(last.outlet_mass_g[0], last.delivered_g, 1e-9);
}

// And where an end that was torn off from the start closes, what leaves there is delivered again.
TEST(LaterTears, OfAnEndThatClosesLetItDeliverAgain) {
    InjectionOptions options = into_root();
    options.until_s = 2.0;
    options.tears = {{1, 40.0, 0.0}};
    options.tear_areas_mm2 = {3.0};
    options.tear_sides = {0};
    options.later_tears = {{.from_s = 0.2}};  // the drug has not come to the end yet
    const InjectionResult closed = run_torn(fork_with_equal_branches(), options);
    EXPECT_NEAR(closed.balance.bled_mm3, 0.0, 1e-9);
    EXPECT_NEAR(closed.balance.inside_mm3, tube_lumen_mm2 * 100.0, 1e-6);
    EXPECT_NEAR(closed.balance.left_mm3, tube_lumen_mm2 * (2.0 * speed_mm_s(2.0) - 100.0), 1e-6);
    ASSERT_EQ(closed.outlet_nodes, (std::vector<int>{2, 3}));
    const InjectionSample& last = closed.series.back();
    ASSERT_EQ(last.outlet_mass_g.size(), 2u);
    EXPECT_GT(last.outlet_mass_g[0], 0.0);
    EXPECT_NEAR(last.outlet_mass_g[0] + last.outlet_mass_g[1], last.delivered_g, 1e-9);
}

// After the injection has ended nothing drives what is left.
TEST(LaterTears, MayComeAfterTheCatheterIsClosed) {
    InjectionOptions options = into_root();
    options.injection_s = 0.1;
    options.later_tears = {torn_at(0.2, {0, 20.0, 0.0})};
    const InjectionResult torn = run_torn(tube_to_tear(), options);
    EXPECT_NEAR(torn.series.back().injected_g, 0.2, 1e-9);
}

// A drug of another fluid, on a tree of four generations with a tear in each of three branches.
TEST(LaterTears, LoseNothingOfADrugOfAnotherFluid) {
    const VesselTree tree = make_tree(71, 4);
    Job job;
    InjectionOptions options;
    options.void_fraction = 0.5;
    const InjectionResult whole = inject(tree, options, job);
    const double end_s = whole.series.back().time_s;
    const auto middle = [&](int segment) {
        return TreePoint{segment, 0.5 * length_mm(tree.segments[std::size_t(segment)]), 0.0};
    };
    options.until_s = end_s;
    for (int k = 1; k <= 3; ++k) {
        LaterTears later{.from_s = 0.1 * k * end_s};
        for (int segment = 1; segment <= k; ++segment) {
            later.tears.push_back(middle(segment));
            later.areas_mm2.push_back(0.5);
            later.sides.push_back(segment == 2 ? 1 : 0);
        }
        options.later_tears.push_back(later);
    }
    const InjectionResult torn = run_torn(tree, options);
    EXPECT_GT(torn.balance.bled_mm3, 0.0);
    // Before the first tear it is the same front, to the tolerance of its steps.
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
        const int segment = static_cast<int>(i);
        const double first_s = first_arrival_s(whole, segment);
        if (!(first_s < 0.1 * end_s)) continue;
        EXPECT_NEAR(first_arrival_s(torn, segment), first_s, 0.01 * end_s) << segment;
    }
}

TEST(LaterTears, AreRefusedOutOfOrderAndOfAnotherTree) {
    Job job;
    InjectionOptions options = into_root();
    for (const double second_s : {0.1, -1.0, std::nan("")}) {
        options.later_tears = {torn_at(0.2, {0, 20.0, 0.0}), torn_at(second_s, {0, 30.0, 0.0})};
        EXPECT_THROW(inject(tube_to_tear(), options, job), InputError) << second_s;
    }
    options.later_tears = {torn_at(0.2, {1, 20.0, 0.0})};
    EXPECT_THROW(inject(tube_to_tear(), options, job), InputError);
    options.later_tears = {torn_at(0.2, {0, 20.0, 0.0}, 0.0)};
    EXPECT_THROW(inject(tube_to_tear(), options, job), InputError) << "an opening of nothing";
}

}  // namespace
}  // namespace hepatica
