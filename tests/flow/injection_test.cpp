// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/injection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::make_tree;

TEST(Injection, FillsTheTreeAndLosesNothing) {
    const VesselTree tree = make_tree(61, 4);
    for (const double void_fraction : {0.0, 0.5}) {
        Job job;
        InjectionOptions options;
        options.void_fraction = void_fraction;
        options.record_filled_lengths = true;
        const InjectionResult injection = inject(tree, options, job);
        EXPECT_LE(injection.balance.error_relative(), 1e-12);
        EXPECT_NEAR(injection.series.back().filled_fraction, 1.0, 1e-9);
        EXPECT_EQ(injection.series.front().filled_fraction, 0.0);
        double before = -1.0;
        for (const InjectionSample& s : injection.series) {
            EXPECT_GT(s.time_s, before);
            before = s.time_s;
            EXPECT_NEAR(s.injected_g, 2.0 * s.time_s, 1e-9);
            EXPECT_NEAR(s.injected_g, s.inside_g + s.delivered_g, 1e-9);
            const double out = std::accumulate(s.outlet_mass_g.begin(), s.outlet_mass_g.end(), 0.0);
            EXPECT_NEAR(out, s.delivered_g, 1e-9);
        }
        for (std::size_t i = 0; i < tree.segments.size(); ++i) {
            const int id = static_cast<int>(i);
            EXPECT_NEAR(injection.series.back().filled_length_mm[i], length_mm(tree.segments[i]),
                        1e-4);
            if (tree.segments[i].parent >= 0) {
                EXPECT_GT(first_arrival_s(injection, id),
                          first_arrival_s(injection, tree.segments[i].parent));
            }
        }
        EXPECT_NEAR(end_flow_g_s(injection, 0), 2.0, 1e-12);
    }
}

TEST(Injection, OfBloodMeetsTheClosedForm) {
    const VesselTree tree = make_tree(62, 5);
    Job job;
    const InjectionResult injection = inject(tree, {}, job);
    const ArrivalTimes exact = arrival_times(injection.network, injection.begin, {0});
    for (int s = 0; s < static_cast<int>(tree.segments.size()); ++s)
        EXPECT_NEAR(injection.arrival.arrival_s(s, 1.0), exact.arrival_s(s, 1.0), 1e-9);
    EXPECT_NEAR(injection.arrival.end_s(), exact.end_s(), 1e-9);
}

TEST(Injection, ReachesItsFinalPressureWhenAllIsFilled) {
    const VesselTree tree = make_tree(63, 3);
    Job job;
    InjectionOptions options;
    options.void_fraction = 0.4;
    const InjectionResult injection = inject(tree, options, job);
    FlowConditions filled = injection.conditions;
    filled.resident = injection.drug;
    const double steady = solve_flow(injection.network, filled).inlet_pressure_pa[0];
    EXPECT_NEAR(injection.series.back().inlet_pressure_pa / steady, 1.0, 1e-9);
    EXPECT_GT(steady, injection.series.front().inlet_pressure_pa);
}

TEST(Injection, FollowsTheDrugOfATerritory) {
    const VesselTree tree = make_tree(64, 4);
    Job job;
    InjectionOptions options;
    options.territories = {{0, 0.0, 0.0}, {1, 0.0, 0.0}};
    for (std::size_t i = 0; i < tree.segments.size(); ++i)
        if (tree.segments[i].parent == 0 && i != 1)
            options.territories.push_back({static_cast<int>(i), 0.0, 0.0});
    ASSERT_EQ(options.territories.size(), 3u);
    const InjectionResult injection = inject(tree, options, job);
    const double trunk_g = volume_mm3(injection.network, 0) * 1.06e-3;
    for (const InjectionSample& s : injection.series) {
        EXPECT_NEAR(s.territory_mass_g[0], s.injected_g, 1e-9);
        EXPECT_NEAR(s.territory_mass_g[1] + s.territory_mass_g[2],
                    std::max(0.0, s.injected_g - trunk_g), 1e-9);
    }
}

TEST(Injection, ATerritoryHasNoDrugThatHasNotPassedItsPoint) {
    const VesselTree tree = make_tree(64, 4);
    Job job;
    InjectionOptions options;
    const double begins_mm = 0.6 * length_mm(tree.segments[0]);
    options.territories = {{0, begins_mm, 0.0}};
    const InjectionResult injection = inject(tree, options, job);
    const double before_g = volume_up_to_mm3(injection.network, 0, begins_mm) * 1.06e-3;
    ASSERT_GT(before_g, 0.0);
    for (const InjectionSample& s : injection.series)
        EXPECT_NEAR(s.territory_mass_g[0], std::max(0.0, s.injected_g - before_g), 1e-9);
}

TEST(Injection, ByAWedgedCatheterStaysDownstream) {
    const VesselTree tree = make_tree(65, 4);
    Job job;
    InjectionOptions options;
    options.tip = TreePoint{1, 0.5 * length_mm(tree.segments[1]), 0.0};
    options.mass_flow_g_s = 0.1;
    const InjectionResult injection = inject(tree, options, job);
    EXPECT_TRUE(std::isinf(first_arrival_s(injection, 0)));
    EXPECT_EQ(first_arrival_s(injection, 1), 0.0);
    EXPECT_EQ(end_flow_g_s(injection, 0), 0.0);
    EXPECT_NEAR(end_flow_g_s(injection, 1), 0.1, 1e-12);
    EXPECT_LE(injection.balance.error_relative(), 1e-12);
}

TEST(Injection, AShortOneFollowedByBloodIsDeliveredInFull) {
    const VesselTree tree = make_tree(66, 4);
    Job job;
    InjectionOptions options;
    options.wedged = false;
    options.blood_flow_g_s = 4.0;
    options.mass_flow_g_s = 0.5;
    options.void_fraction = 0.3;
    options.injection_s = 1.0;
    const InjectionResult injection = inject(tree, options, job);
    const InjectionSample& end = injection.series.back();
    EXPECT_NEAR(end.injected_g, 0.5, 1e-9);
    EXPECT_NEAR(end.delivered_g, 0.5, 1e-6);
    EXPECT_LE(injection.balance.error_relative(), 1e-12);
}

TEST(Injection, FeelsAClosedAndATornVessel) {
    const VesselTree tree = make_tree(71, 4);
    InjectionOptions options;
    Job job;
    options.closed_segments = {1};
    const InjectionResult closed = inject(tree, options, job);
    EXPECT_TRUE(std::isinf(first_arrival_s(closed, 1)));
    EXPECT_EQ(end_flow_g_s(closed, 1), 0.0);
    EXPECT_GT(closed.series.front().inlet_pressure_pa,
              inject(tree, {}, job).series.front().inlet_pressure_pa);
    options.closed_segments.clear();
    options.tears = {{1, 0.5 * length_mm(tree.segments[1]), 0.0}};
    const InjectionResult torn = inject(tree, options, job);
    EXPECT_GT(torn.balance.bled_mm3, 0.0);
    EXPECT_LE(torn.balance.error_relative(), 1e-12);
    EXPECT_TRUE(std::isinf(first_arrival_s(torn, 2)));  // beyond the tear
    options.closed_segments = {999};
    EXPECT_THROW(inject(tree, options, job), InputError);
}

// What was torn half way leaks, and the rest goes on.
TEST(Injection, GoesOnBehindAVesselWhoseSideIsOpen) {
    const VesselTree tree = make_tree(71, 4);
    Job job;
    InjectionOptions options;
    const InjectionResult whole = inject(tree, options, job);
    options.tears = {{1, 0.5 * length_mm(tree.segments[1]), 0.0}};
    options.tear_areas_mm2 = {0.5};
    options.tear_sides = {1};
    const InjectionResult open = inject(tree, options, job);
    EXPECT_GT(open.balance.bled_mm3, 0.0);
    EXPECT_LE(open.balance.error_relative(), 1e-11);
    EXPECT_TRUE(std::isfinite(first_arrival_s(open, 2))) << "beyond the hole";
    EXPECT_LT(end_flow_g_s(open, 2), end_flow_g_s(whole, 2));
    EXPECT_GT(end_flow_g_s(open, 2), 0.0);
}

// Whether a vessel is torn at its very end, which takes its outlet away, or a hair before it.
TEST(Injection, ATearAtTheEndOfAVesselLeavesTheBedsOfOthersAlone) {
    const VesselTree tree = make_tree(71, 2);
    const auto last = static_cast<int>(tree.segments.size()) - 1;
    const double length = length_mm(tree.segments.back());
    InjectionOptions options;
    options.terminal_resistance_pa_s_mm3 = 0.5;
    options.until_s = 0.1;
    options.tear_areas_mm2 = {0.5};
    Job job;
    options.tears = {{last, length - 1e-4, 0.0}};
    const InjectionResult before = inject(tree, options, job);
    options.tears = {{last, length, 0.0}};
    const InjectionResult at = inject(tree, options, job);
    std::vector<int> others = before.network.outlet_nodes;
    ASSERT_EQ(others.back(), tree.segments.back().distal_node);
    others.pop_back();
    ASSERT_EQ(at.network.outlet_nodes, others);
    std::vector<double> beds = before.conditions.terminal_resistances;
    beds.pop_back();
    EXPECT_EQ(at.conditions.terminal_resistances, beds);
    for (std::size_t o = 0; o < others.size(); ++o) {
        const double flow = before.begin.outlet_flow_mm3_s[o];
        EXPECT_GT(flow, 0.0);
        EXPECT_NEAR(at.begin.outlet_flow_mm3_s[o], flow, 1e-3 * flow) << others[o];
    }
}

TEST(Injection, SamplesDoNotChangeTheSolution) {
    const VesselTree tree = make_tree(67, 4);
    Job job;
    InjectionOptions options;
    options.until_s = 1.0;
    std::vector<double> delivered;
    for (const double step_s : {0.5, 0.01}) {
        options.step_s = step_s;
        const InjectionResult injection = inject(tree, options, job);
        EXPECT_EQ(injection.series.back().time_s, 1.0);
        delivered.push_back(injection.series.back().inside_g);
    }
    EXPECT_NEAR(delivered[0], delivered[1], 1e-12);
}

TEST(Injection, SamplesLieOneIntervalApartAndEndAtTheEnd) {
    Job job;
    InjectionOptions options;
    options.until_s = 1.0;
    options.step_s = 0.3;
    const InjectionResult injection = inject(make_tree(66, 3), options, job);
    const std::vector<double> expected_s{0.0, 0.3, 0.6, 0.9, 1.0};
    ASSERT_EQ(injection.series.size(), expected_s.size());
    for (std::size_t k = 0; k < expected_s.size(); ++k)
        EXPECT_NEAR(injection.series[k].time_s, expected_s[k], 1e-12);
}

// The time in which what flows in would fill the tree is that of a plug: volume over volume flow.
TEST(Injection, SamplesLieAHundredthOfTheFillingTimeApartUnlessAskedFor) {
    VesselTree tree;
    tree.nodes = {{Vec3::Zero(), 1.5}, {Vec3(0, 0, 40), 1.5}};
    VesselSegment tube;
    tube.proximal_node = 0;
    tube.distal_node = 1;
    for (int i = 0; i <= 8; ++i) {
        tube.points_mm.emplace_back(0, 0, 5.0 * i);
        tube.radii_mm.push_back(1.5);
    }
    tree.segments = {tube};
    Job job;
    const InjectionResult injection = inject(tree, {}, job);
    ASSERT_EQ(injection.begin.inlet_flow_mm3_s.size(), 1u);
    const double filling_s =
        std::numbers::pi * 1.5 * 1.5 * 40.0 / injection.begin.inlet_flow_mm3_s[0];
    ASSERT_GT(injection.series.size(), 2u);
    EXPECT_NEAR(injection.series[1].time_s, filling_s / 100.0, 1e-12 * filling_s);
    EXPECT_NEAR(injection.series[2].time_s, filling_s / 50.0, 1e-12 * filling_s);
}

TEST(Injection, RefusesNonsenseAndStopsWhenAsked) {
    const VesselTree tree = make_tree(68, 2);
    const auto refused = [&](auto change) {
        InjectionOptions options;
        change(options);
        Job job;
        EXPECT_THROW(inject(tree, options, job), InputError);
    };
    refused([](InjectionOptions& o) { o.mass_flow_g_s = -1.0; });
    refused([](InjectionOptions& o) { o.mass_flow_g_s = std::nan(""); });
    refused([](InjectionOptions& o) { o.mass_flow_g_s = 0.0; });
    refused([](InjectionOptions& o) { o.inlet_pressure_pa = -5.0; });
    refused([](InjectionOptions& o) {
        o.outlet_pressure_pa = 1000.0;
        o.inlet_pressure_pa = 1000.0;
    });
    refused([](InjectionOptions& o) { o.void_fraction = 1.0; });
    refused([](InjectionOptions& o) { o.drug_viscosity_pa_s = 0.0; });
    refused([](InjectionOptions& o) { o.step_s = 0.0; });
    refused([](InjectionOptions& o) { o.until_s = -1.0; });
    refused([](InjectionOptions& o) { o.tip = TreePoint{77, 0.0, 0.0}; });
    Job job;
    EXPECT_THROW(inject({}, {}, job), InputError);
    job.cancel();
    EXPECT_THROW(inject(tree, {}, job), Cancelled);
}

TEST(Injection, BeginsInAnArteryElseThePortalVeinAndInItsLargestPiece) {
    VesselTree tree = make_tree(69, 1);
    const VesselTree larger = make_tree(70, 3);
    const int nodes = static_cast<int>(tree.nodes.size());
    const int segments = static_cast<int>(tree.segments.size());
    tree.nodes.insert(tree.nodes.end(), larger.nodes.begin(), larger.nodes.end());
    for (VesselSegment s : larger.segments) {
        s.proximal_node += nodes;
        s.distal_node += nodes;
        if (s.parent >= 0) s.parent += segments;
        s.system = tree.segments.front().system;
        tree.segments.push_back(s);
    }
    EXPECT_EQ(main_root(tree).segment, segments);
    const auto entry = [&](VascularSystem smaller, VascularSystem larger_one) {
        VesselTree named = tree;
        for (int i = 0; i < std::ssize(named.segments); ++i)
            named.segments[i].system = i < segments ? smaller : larger_one;
        return main_root(named).segment;
    };
    using enum VascularSystem;
    EXPECT_EQ(entry(portal, hepatic), 0);
    EXPECT_EQ(entry(artery, portal), 0);
    EXPECT_EQ(entry(unknown, hepatic), 0);
    EXPECT_EQ(entry(portal, unknown), 0);
    EXPECT_EQ(entry(portal, artery), segments);
    EXPECT_EQ(entry(hepatic, hepatic), segments);
    Job job;
    const InjectionResult injection = inject(tree, {}, job);
    EXPECT_TRUE(std::isinf(first_arrival_s(injection, 0)));
    EXPECT_EQ(first_arrival_s(injection, segments), 0.0);
}

TEST(Injection, RefusesSegmentsThatDoNotExist) {
    const VesselTree tree = make_tree(71, 2);
    const int count = static_cast<int>(tree.segments.size());
    Job job;
    for (const int wrong : {-1, count}) {
        InjectionOptions options;
        options.tip = TreePoint{wrong, 0.0, 0.0};
        EXPECT_THROW(inject(tree, options, job), InputError) << wrong;
        options.tip.reset();
        options.closed_segments = {wrong};
        EXPECT_THROW(inject(tree, options, job), InputError) << wrong;
    }
    InjectionOptions options;
    options.closed_segments = {count - 1};
    const InjectionResult injection = inject(tree, options, job);
    EXPECT_TRUE(std::isinf(first_arrival_s(injection, count - 1)));
    EXPECT_EQ(end_flow_g_s(injection, count - 1), 0.0);
}

}  // namespace
}  // namespace hepatica
