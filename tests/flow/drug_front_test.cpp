// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/drug_front.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::Random;
using testing_flow::random_tree;

using std::numbers::pi;

FlowConditions injection_of(const Fluid& drug, double mass_flow_g_s, int node = 0) {
    FlowConditions conditions;
    conditions.inlets = {{node, InletKind::mass_flow, mass_flow_g_s, drug}};
    return conditions;
}

// A row of cylinders with equal radius, or one cylinder.
FlowNetwork tube(double radius_mm, double length_mm) {
    FlowNetwork network;
    network.node_count = 2;
    network.root_nodes = {0};
    network.outlet_nodes = {1};
    network.cones = {{radius_mm, radius_mm, length_mm}};
    network.segments = {{0, 1, 0, 1, 0}};
    return network;
}

TEST(DrugFront, MeetsTheClosedFormAtAnyStepSize) {
    Random random(51);
    for (int i = 0; i < 20; ++i) {
        const FlowNetwork network = random_tree(random, random.integer(1, 120));
        const FlowConditions conditions =
            injection_of(pure(blood()), random.logarithmic(0.05, 5.0));
        const ArrivalTimes exact = arrival_times(network, solve_flow(network, conditions), {0});
        for (const double step_s : {1e9, 0.37, 0.01}) {
            DrugFront front(network, conditions, 0);
            const double end = 1.01 * exact.end_s();
            while (front.time_s() < end) front.step(std::min(step_s, end));
            const ArrivalTimes stepped = front.arrival_times();
            for (int s = 0; s < static_cast<int>(network.segments.size()); ++s)
                for (const double share : {0.0, 0.3, 1.0}) {
                    const double x = share * length_mm(network, s);
                    ASSERT_NEAR(stepped.arrival_s(s, x), exact.arrival_s(s, x), 1e-9)
                        << "segment " << s << " of tree " << i << " at step " << step_s;
                }
            ASSERT_LE(front.balance().error_relative(), 1e-12);
        }
    }
}

TEST(DrugFront, EndsAStepWhereAFrontReachesANode) {
    FlowNetwork network = tube(1.0, 10.0);
    DrugFront front(network, injection_of(pure(blood()), 1.06e-2), 0);  // 10 mm3/s
    FrontStep step = front.step(1.0);
    EXPECT_EQ(step.event, FrontEvent::none);
    EXPECT_EQ(step.duration_s, 1.0);
    EXPECT_NEAR(front.filled_length_mm(0), 10.0 / pi, 1e-12);
    EXPECT_NEAR(front.filled_fraction(0), 1.0 / pi, 1e-12);
    step = front.step(100.0);
    EXPECT_EQ(step.event, FrontEvent::node_reached);
    EXPECT_NEAR(front.time_s(), pi, 1e-12);
    EXPECT_EQ(front.filled_fraction(0), 1.0);
    EXPECT_TRUE(front.at_rest());
    front.advance_to(10.0);
    EXPECT_EQ(front.time_s(), 10.0);
    EXPECT_NEAR(front.outlet_mass_g()[0], (10.0 - pi) * 1.06e-2, 1e-12);
}

// A vessel of a third of a cubic millimetre, and beside it a closed one that holds nothing.
TEST(DrugFront, FillsThinVesselsAndNothingWhereThereIsNoRoom) {
    FlowNetwork network = tube(0.1, 10.0);
    network.cones.push_back({0.1, 0.1, 0.0});
    FlowSegment closed{1, 1, 1, 1, 1};
    closed.open = false;
    network.segments.push_back(closed);
    DrugFront front(network, injection_of(pure(blood()), 1.06e-4), 0);  // 0.1 mm3/s
    front.step(1.0);
    EXPECT_NEAR(front.filled_fraction(0), 1.0 / pi, 1e-12);
    EXPECT_EQ(front.filled_fraction(1), 0.0);
}

// A cylinder between two pressures. The resistance changes linearly with the filled volume, so
// V' = P/(a + bV): aV + bV^2/2 = Pt.
TEST(DrugFront, AcceleratesOrSlowsDownAsAThinnerOrThickerFluidComes) {
    for (const double factor : {0.2, 7.0}) {
        const FlowNetwork network = tube(1.0, 50.0);
        const Fluid drug{1.06e-3, factor * 3.5e-3, 0.0};
        FlowConditions conditions;
        conditions.inlets = {{0, InletKind::pressure, 100.0, drug}};
        const double volume = 50.0 * pi;
        const double a = 8 * 3.5e-3 * 50.0 / pi;
        const double b = a * (factor - 1) / volume;
        double coarse_error = 0.0;
        for (const double tolerance : {0.02, 0.002}) {
            FrontOptions options;
            options.step_tolerance = tolerance;
            DrugFront front(network, conditions, 0, options);
            while (!front.at_rest()) front.step(1e3);
            const ArrivalTimes times = front.arrival_times();
            double error = 0.0;
            for (const double share : {0.1, 0.5, 1.0}) {
                const double v = share * volume;
                const double exact = (a * v + b * v * v / 2) / 100.0;
                error = std::max(error, std::abs(times.arrival_s(0, 50.0 * share) / exact - 1));
            }
            EXPECT_LT(error, tolerance);
            // Second order: ten times the steps, a hundredth of the error (with some allowance).
            if (tolerance == 0.002) {
                EXPECT_LT(error, coarse_error / 30);
            }
            coarse_error = error;
        }
    }
}

// Two tubes from one flow inlet: the split changes as they fill, but each instant obeys
// (a1 + b1 V1) V1' = (a2 + b2 V2) V2' and V1' + V2' = q, which integrates to
// a1 V1 + b1 V1^2/2 = a2 V2 + b2 V2^2/2 with V1 + V2 = q t.
TEST(DrugFront, ChangesTheSplitAsSegmentsFill) {
    FlowNetwork network;
    network.node_count = 3;
    network.root_nodes = {0};
    network.outlet_nodes = {1, 2};
    network.cones = {{1.0, 1.0, 30.0}, {0.8, 0.8, 25.0}};
    network.segments = {{0, 1, 0, 1, 0}, {0, 2, 1, 1, 1}};
    const Fluid drug = pure(lipiodol());
    const FlowConditions conditions = injection_of(drug, 0.01 * drug.density_g_mm3);
    FrontOptions options;
    options.step_tolerance = 1e-3;
    DrugFront front(network, conditions, 0, options);
    const double begin_split = front.flow().volume_flow_mm3_s[0];
    front.advance_to(3000.0);  // 30 mm3: neither is full
    const double v1 = front.drug_mm3(0);
    const double v2 = front.drug_mm3(1);
    EXPECT_NEAR(v1 + v2, 30.0, 1e-10);
    const auto potential = [](double radius, double length, double v) {
        const double per_length = 8 / (pi * std::pow(radius, 4));
        const double a = per_length * length * 3.5e-3;
        const double b = per_length * (25e-3 - 3.5e-3) / (pi * radius * radius);
        return a * v + b * v * v / 2;
    };
    EXPECT_NEAR(potential(1.0, 30.0, v1) / potential(0.8, 25.0, v2), 1.0, 1e-4);
    EXPECT_NE(front.flow().volume_flow_mm3_s[0], begin_split);
}

TEST(DrugFront, KeepsTheDrugsVolumeWithTwoFluids) {
    Random random(52);
    for (int i = 0; i < 10; ++i) {
        const FlowNetwork network = random_tree(random, 60, 2.0);
        const Fluid drug = mixture(blood(), i % 2 ? lipiodol() : gas(), 0.4);
        FlowConditions conditions = injection_of(drug, random.logarithmic(0.05, 2.0));
        conditions.law = static_cast<PressureLaw>(i % 3);
        DrugFront front(network, conditions, 0);
        const double fill_s = volume_mm3(network) / front.flow().inlet_flow_mm3_s[0];
        for (int k = 1; k <= 20; ++k) {
            front.advance_to(k * 0.1 * fill_s);
            const DrugBalance balance = front.balance();
            ASSERT_LE(balance.error_relative(), 1e-12);
            ASSERT_NEAR(balance.injected_mm3, k * 0.1 * volume_mm3(network),
                        1e-9 * balance.injected_mm3);
        }
        double mass = 0.0;
        for (const double m : front.outlet_mass_g()) mass += m;
        EXPECT_NEAR(mass, front.balance().left_mm3 * drug.density_g_mm3, 1e-12);
    }
}

// Blood goes on past the catheter; the drug is a share of what flows below the tip, and after the
// injection it is washed out to the last drop.
TEST(DrugFront, AShortInjectionIsWashedOut) {
    Random random(53);
    const FlowNetwork whole = random_tree(random, 31);
    FlowNetwork network = whole;
    const int tip = place_catheter(network, {1, 0.5 * length_mm(whole, 1), 0.0}, false);
    FlowConditions conditions;
    conditions.inlets = {{0, InletKind::mass_flow, 1.0, pure(blood())},
                         {tip, InletKind::mass_flow, 0.05, pure(blood())}};
    FrontOptions options;
    options.injection_end_s = 2.0;
    DrugFront front(network, conditions, 1, options);
    const double below = front.flow().volume_flow_mm3_s.back();
    front.advance_to(1e-3);
    EXPECT_NEAR(front.drug_mm3(31), 0.05 / 1.06e-3 * 1e-3, 1e-12);
    front.advance_to(1.999);
    EXPECT_NEAR(front.filled_fraction(31), 0.05 / 1.06e-3 / below, 1e-9);
    EXPECT_EQ(front.filled_fraction(2), 0.0);  // the sister stays clean
    front.advance_to(1e4);
    const DrugBalance balance = front.balance();
    EXPECT_NEAR(balance.injected_mm3, 2.0 * 0.05 / 1.06e-3, 1e-9);
    EXPECT_NEAR(balance.inside_mm3, 0.0, 1e-9);
    EXPECT_LE(balance.error_relative(), 1e-12);
}

// Where a loop closes, drug that came the short way meets blood from the long way: the share is
// that of the flows, until the drug comes both ways.
TEST(DrugFront, MixesWhereALoopCloses) {
    FlowNetwork network;
    network.node_count = 4;
    network.root_nodes = {0};
    network.outlet_nodes = {3};
    network.cones = {{2, 2, 1}, {1, 1, 10}, {1, 1, 30}, {2, 2, 10}};
    network.segments = {{0, 1, 0, 1, 0}, {1, 2, 1, 1, 1}, {1, 2, 2, 1, 2}, {2, 3, 3, 1, 3}};
    FlowConditions conditions = injection_of(pure(blood()), 1.06e-1);  // 100 mm3/s: 75 and 25
    DrugFront front(network, conditions, 0);
    const double first = 4 * pi / 100;
    const double short_way = first + 10 * pi / 75;
    const double long_way = first + 30 * pi / 25;
    front.advance_to(short_way + 0.1);
    EXPECT_NEAR(front.drug_mm3(3), 0.1 * 75, 1e-10);
    front.advance_to(short_way + 40 * pi / 100 + 1e-9);
    EXPECT_NEAR(front.filled_fraction(3), 0.75, 1e-8);
    front.advance_to(long_way + 40 * pi / 100 + 1e-9);
    EXPECT_NEAR(front.filled_fraction(3), 1.0, 1e-8);
    EXPECT_NEAR(front.arrival_times().arrival_s(3, 0.0), short_way, 1e-12);
    EXPECT_LE(front.balance().error_relative(), 1e-12);
}

TEST(DrugFront, KeepsTheDrugsVolumeInRandomLoopsWithTwoFluids) {
    Random random(54);
    for (int i = 0; i < 5; ++i) {
        FlowNetwork network = random_tree(random, 30, 2.0);
        for (int k = 0; k < 4; ++k) {
            FlowSegment s;
            s.proximal_node = random.integer(0, 14);
            s.distal_node = random.integer(15, 30);
            s.first_cone = static_cast<int>(network.cones.size());
            s.tree_segment = static_cast<int>(network.segments.size());
            network.cones.push_back({0.8, 0.7, 20.0});
            network.segments.push_back(s);
        }
        FrontOptions options;
        options.injection_end_s = 1.0;
        FlowConditions conditions = injection_of(pure(lipiodol()), 0.5);
        conditions.inlets.push_back({0, InletKind::mass_flow, 0.5, pure(blood())});
        DrugFront front(network, conditions, 0, options);
        for (int k = 1; k <= 10; ++k) {
            front.advance_to(0.3 * k);
            ASSERT_LE(front.balance().error_relative(), 1e-12) << i << " " << k;
        }
    }
}

TEST(DrugFront, BleedsFromATear) {
    Random random(55);
    FlowNetwork network = random_tree(random, 7);
    tear(network, {0, 0.5 * length_mm(network, 0), 0.0});
    const FlowConditions conditions = injection_of(pure(blood()), 1.0);
    DrugFront front(network, conditions, 0);
    front.advance_to(100.0);
    EXPECT_GT(front.balance().bled_mm3, 0.0);
    EXPECT_EQ(front.balance().left_mm3, 0.0);
    EXPECT_LE(front.balance().error_relative(), 1e-12);
}

// Drug that is thinned below the tolerance of shares is carried and counted, but arrives nowhere.
TEST(DrugFront, DrugThinnerThanTheToleranceArrivesNowhere) {
    FlowConditions conditions;
    conditions.inlets = {{0, InletKind::mass_flow, 1.06e-2, pure(blood())},  // 10 mm3/s
                         {0, InletKind::mass_flow, 1.06e-2 * 5e-5, pure(blood())}};
    DrugFront front(tube(1.0, 10.0), conditions, 1);
    front.advance_to(100.0);  // 32 fillings
    EXPECT_TRUE(std::isinf(front.arrival_times().arrival_s(0, 0.0)));
    EXPECT_TRUE(std::isinf(front.arrival_times().arrival_s(0, 10.0)));
    const DrugBalance balance = front.balance();
    EXPECT_NEAR(balance.injected_mm3, 100.0 * 10.0 * 5e-5, 1e-12);
    EXPECT_GT(balance.inside_mm3, 0.0);
    EXPECT_LE(balance.error_relative(), 1e-12);
}

TEST(DrugFront, NothingInjectedNothingMoves) {
    Random random(56);
    DrugFront front(random_tree(random, 7), injection_of(pure(lipiodol()), 0.0), 0);
    front.advance_to(5.0);
    EXPECT_EQ(front.time_s(), 5.0);
    EXPECT_EQ(front.balance().injected_mm3, 0.0);
    EXPECT_TRUE(std::isinf(front.arrival_times().arrival_s(0, 0.0)));
}

TEST(DrugFront, RefusesNonsense) {
    Random random(57);
    const FlowNetwork network = random_tree(random, 3);
    EXPECT_THROW(DrugFront(network, injection_of(pure(blood()), 1.0), 1), InputError);
    DrugFront front(network, injection_of(pure(blood()), 1.0), 0);
    EXPECT_THROW(front.step(-1.0), InputError);
    EXPECT_THROW(front.step(std::nan("")), InputError);
    EXPECT_THROW(front.step(std::numeric_limits<double>::infinity()), InputError);
}

}  // namespace
}  // namespace hepatica
