// SPDX-License-Identifier: GPL-3.0-or-later
// Arrival times that the scene shows against the closed form and against a front stepped finely.
#include "core/scene/flow_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <thread>

#include "core/base/error.h"
#include "core/flow/arrival_times.h"
#include "core/flow/injection.h"
#include "core/scene/world_checkpoint.h"
#include "tests/scene/shown_flow.h"
#include "tests/session/small_patient.h"
#include "tests/support/asked_to_stop.h"

namespace hepatica {
namespace {

using test::places_along;
using test::shown;
using test::Shown;
using test::tube_of_40_mm;
using test::unlike_blood;

// Largest difference of two sets of times, relative to the latest of the first.
double difference(const std::vector<float>& a, const std::vector<float>& b) {
    double latest = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(std::isfinite(a[i]), std::isfinite(b[i]));
        if (!std::isfinite(a[i]) || !std::isfinite(b[i])) continue;
        latest = std::max(latest, static_cast<double>(a[i]));
        largest = std::max(largest, std::abs(static_cast<double>(a[i]) - b[i]));
    }
    return largest / latest;
}

std::vector<float> stepped(const VesselTree& tree, const Injection& injection, double tolerance) {
    InjectionOptions options;
    options.tip = injection.at;
    options.wedged = false;
    options.mass_flow_g_s = injection.mass_flow_g_s;
    options.second_phase = second_phase(injection.second_phase);
    options.void_fraction = injection.void_fraction;
    options.front.step_tolerance = tolerance;
    Job job;
    const InjectionResult result = inject(tree, options, job);
    std::vector<float> times;
    for (const VertexPlace& place : places_along(tree))
        times.push_back(static_cast<float>(result.arrival.arrival_s(place.on_tree)));
    return times;
}

std::vector<float> steady(const VesselTree& tree, const Injection& injection, const Fluid& fluid) {
    FlowNetwork network = network_of(tree);
    const int tip = place_catheter(network, injection.at, false);
    FlowConditions conditions;
    conditions.resident = fluid;
    conditions.inlets = {{tip, InletKind::mass_flow, injection.mass_flow_g_s, fluid}};
    const ArrivalTimes arrival =
        arrival_times(network, solve_flow(network, conditions), std::vector<int>{tip});
    std::vector<float> times;
    for (const VertexPlace& place : places_along(tree))
        times.push_back(static_cast<float>(arrival.arrival_s(place.on_tree)));
    return times;
}

TEST(FlowPart, FillsATubeWithItsVolumeWhateverTheDrug) {
    const VesselTree tree = tube_of_40_mm();
    for (const char* second : {"gas", "lipiodol"}) {
        const Injection injection{.at = {0, 0.0, 0.0},
                                  .mass_flow_g_s = 1.5,
                                  .void_fraction = 0.4,
                                  .second_phase = second};
        const std::vector<float> times = shown(tree, injection);
        const double density = mixture(blood(), second_phase(second), 0.4).density_g_mm3;
        const double filled_s = std::numbers::pi * 4.0 * 40.0 * density / 1.5;
        for (int k = 0; k <= 10; ++k) EXPECT_NEAR(times[k], 0.1 * k * filled_s, 1e-5 * filled_s);
    }
}

TEST(FlowPart, TheClockRunsThoughMostVerticesLieAtTheTip) {
    const std::vector<VertexPlace> places{
        {{0, 0.0, 0.0}, 1.0}, {{0, 0.0, 0.0}, 1.0}, {{0, 0.0, 0.0}, 1.0}, {{0, 40.0, 0.0}, 1.0}};
    BodyTopology topology(places.size(), {});
    FlowPart part(tube_of_40_mm(), places, {}, topology);
    const Injection injection{.at = {0, 0.0, 0.0}};
    part.inject(injection);
    const double filled_s =
        std::numbers::pi * 4.0 * 40.0 * blood().density_g_mm3 / injection.mass_flow_g_s;
    EXPECT_NEAR(part.drug().end_s, filled_s, 1e-6 * filled_s);
}

TEST(FlowPart, AnInjectionIntoTheEndOfAVesselIsRefused) {
    Shown made(tube_of_40_mm());
    made.part.inject({.at = {0, 0.0, 0.0}});
    const auto before = made.part.drug().arrival_s;
    EXPECT_THROW(made.part.inject({.at = {0, 40.0, 0.0}}), InputError);
    EXPECT_EQ(made.part.drug().arrival_s, before);
}

// A wide branch that takes all the blood and three hair-thin ones, in which most places lie.
TEST(FlowPart, TheClockEndsThoughBloodStandsInMostOfTheVessels) {
    VesselTree tree;
    const Vec3 root(0, 0, 0), fork(0, 0, 10);
    const std::vector<Vec3> ends{{0, 0, 20}, {100, 0, 10}, {-100, 0, 10}, {0, 100, 10}};
    tree.nodes = {{root, 2.0},     {fork, 2.0},     {ends[0], 2.0},
                  {ends[1], 0.02}, {ends[2], 0.02}, {ends[3], 0.02}};
    const auto segment = [](int from, int to, int parent, const Vec3& a, const Vec3& b, double r) {
        VesselSegment made;
        made.proximal_node = from;
        made.distal_node = to;
        made.parent = parent;
        made.points_mm = {a, b};
        made.radii_mm = {r, r};
        return made;
    };
    tree.segments = {segment(0, 1, -1, root, fork, 2.0), segment(1, 2, 0, fork, ends[0], 2.0),
                     segment(1, 3, 0, fork, ends[1], 0.02), segment(1, 4, 0, fork, ends[2], 0.02),
                     segment(1, 5, 0, fork, ends[3], 0.02)};
    Shown made(tree);
    FlowPart& part = made.part;
    Injection injection;
    injection.at = {0, 0.0, 0.0};
    part.inject(injection);
    const double volume_mm3 = std::numbers::pi * (2.0 * 2.0 * 20.0 + 0.02 * 0.02 * 300.0);
    const double filling_s = volume_mm3 * blood().density_g_mm3 / injection.mass_flow_g_s;
    EXPECT_GT(part.drug().end_s, filling_s);
    EXPECT_LE(part.drug().end_s, 10.0 * filling_s * (1.0 + 1e-9));
}

TEST(FlowPart, TheClockStopsAtItsEndAndStandsWhereItWasSet) {
    Shown made(test::small_patient()->tree);
    FlowPart& part = made.part;
    part.inject({.at = {0, 0.0, 0.0}});
    const double end_s = part.drug().end_s;
    part.set_time(0.5 * end_s);
    part.step(0.25 * end_s);
    EXPECT_TRUE(part.drug().playing);
    EXPECT_DOUBLE_EQ(part.drug().time_s, 0.75 * end_s);
    part.step(end_s);
    EXPECT_FALSE(part.drug().playing);
    EXPECT_EQ(part.drug().time_s, end_s);
    // Started there again, it stops again at once; beyond it no step takes it back.
    for (const double set_s : {end_s, 2.0 * end_s}) {
        part.set_time(set_s);
        part.play(true);
        part.step(0.1 * end_s);
        EXPECT_FALSE(part.drug().playing);
        EXPECT_EQ(part.drug().time_s, set_s);
    }
    part.set_time(0.0);
    part.play(true);
    part.step(0.1 * end_s);
    EXPECT_TRUE(part.drug().playing);
}

TEST(FlowPart, ADrugLikeBloodHasTheTimesOfTheClosedForm) {
    const VesselTree& tree = test::small_patient()->tree;
    const Injection injection{.at = {0, 0.0, 0.0}};
    EXPECT_EQ(shown(tree, injection), steady(tree, injection, pure(blood())));
}

TEST(FlowPart, ADrugUnlikeBloodChangesTheSplitsAsItAdvances) {
    const VesselTree& tree = test::small_patient()->tree;
    const Injection injection{.at = {0, 0.0, 0.0}, .void_fraction = 0.4, .second_phase = "gas"};
    const std::vector<float> times = shown(tree, injection);
    const double missed = difference(stepped(tree, injection, 1e-3), times);
    EXPECT_LT(missed, 2e-3);
    // The drug is not where it would be if it displaced a fluid of its own kind.
    const Fluid own = mixture(blood(), gas(), 0.4);
    EXPECT_GT(difference(times, steady(tree, injection, own)), 5.0 * missed);
}

TEST(FlowPart, KeepsWhatWasInjectedWhereTheNextInjectionIsRefused) {
    const VesselTree& tree = test::small_patient()->tree;
    Shown made(tree);
    FlowPart& part = made.part;
    part.inject({.at = {0, 0.0, 0.0}});
    const auto before = part.drug().arrival_s;
    EXPECT_THROW(part.inject({.at = {0, 0.0, 0.0}, .void_fraction = 1.5}), InputError);
    EXPECT_THROW(part.inject({.at = {0, 0.0, 0.0}, .drug_viscosity_pa_s = -1.0}), InputError);
    EXPECT_THROW(part.inject({.at = {0, 0.0, 0.0}, .mass_flow_g_s = 0.0}), InputError);
    EXPECT_EQ(part.drug().arrival_s, before);
    EXPECT_FALSE(part.computing());
}

TEST(FlowPart, ADrugUnlikeBloodIsComputedBesideThePlayAndShownWhenItIsAskedFor) {
    const VesselTree& tree = test::small_patient()->tree;
    Shown made(tree);
    FlowPart& part = made.part;
    part.inject({.at = {0, 0.0, 0.0}});
    EXPECT_FALSE(part.computing());
    const auto first = part.drug().arrival_s;
    part.step(0.5);
    part.inject(unlike_blood);
    EXPECT_TRUE(part.computing());
    EXPECT_TRUE(part.drug().computing);
    while (!part.injection_ready()) std::this_thread::yield();
    part.step(0.5);
    EXPECT_EQ(part.drug().arrival_s, first);  // ready is not shown
    EXPECT_EQ(part.drug().time_s, 1.0);
    const std::uint64_t version = part.drug().version;
    part.finish_injection();
    EXPECT_NE(part.drug().arrival_s, first);
    EXPECT_EQ(*part.drug().arrival_s, shown(tree, unlike_blood));
    EXPECT_NE(part.drug().version, version);
    EXPECT_EQ(part.drug().time_s, 0.0);
    EXPECT_TRUE(part.drug().playing);
    EXPECT_FALSE(part.computing());
    EXPECT_FALSE(part.drug().computing);
    const auto last = part.drug().arrival_s;
    part.finish_injection();  // nothing to finish
    EXPECT_EQ(part.drug().arrival_s, last);
}

// A tree whose front takes far longer than this test may.
VesselTree slow_tree() {
    return test::random_tree(7, 11, 6.0);
}

TEST(FlowPart, WaitingForAnInjectionHearsAStop) {
    const VesselTree tree = slow_tree();
    Shown made(tree);
    made.part.inject({.at = {0, 0.0, 0.0}});  // like blood: there at once
    const auto shown = made.part.drug().arrival_s;
    made.part.inject(unlike_blood);
    EXPECT_THROW(made.part.finish_injection(test::asked_to_stop()), Cancelled);
    EXPECT_EQ(made.part.drug().arrival_s, shown);
    EXPECT_FALSE(made.part.computing());
}

TEST(FlowPart, AStopIsHeardThoughTheInjectionIsDone) {
    const VesselTree& tree = test::small_patient()->tree;
    Shown made(tree);
    made.part.inject(unlike_blood);
    while (!made.part.injection_ready()) std::this_thread::yield();
    EXPECT_THROW(made.part.finish_injection(test::asked_to_stop()), Cancelled);
    EXPECT_EQ(made.part.drug().arrival_s, nullptr);
    EXPECT_FALSE(made.part.computing());
}

TEST(FlowPart, AnotherInjectionRemovingTheDrugAndTheEndCancelWhatIsComputed) {
    const VesselTree tree = slow_tree();
    const auto start = std::chrono::steady_clock::now();
    {
        Shown made(tree);
        FlowPart& part = made.part;
        part.inject(unlike_blood);
        EXPECT_TRUE(part.computing());
        part.inject({.at = {0, 0.0, 0.0}});  // like blood: there at once
        EXPECT_FALSE(part.computing());
        EXPECT_NE(part.drug().arrival_s, nullptr);
        part.inject(unlike_blood);
        part.remove_drug();
        EXPECT_FALSE(part.computing());
        EXPECT_FALSE(part.drug().computing);
        EXPECT_EQ(part.drug().arrival_s, nullptr);
        part.finish_injection();
        EXPECT_EQ(part.drug().arrival_s, nullptr);
        part.inject(unlike_blood);
        EXPECT_FALSE(part.injection_ready());
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    // Computed to their ends the three would take minutes.
    EXPECT_LT(passed.count(), 20.0);
}

}  // namespace
}  // namespace hepatica
