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
#include "tests/session/small_patient.h"
#include "tests/support/asked_to_stop.h"

namespace hepatica {
namespace {

// Every place of a tree at tenths of its segments.
std::vector<VertexPlace> places_along(const VesselTree& tree) {
    std::vector<VertexPlace> places;
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        double length_mm = 0.0;
        const auto& points = tree.segments[s].points_mm;
        for (std::size_t i = 1; i < points.size(); ++i)
            length_mm += (points[i] - points[i - 1]).norm();
        for (int k = 0; k <= 10; ++k)
            places.push_back({{static_cast<int>(s), 0.1 * k * length_mm, 0.0}, 1.0});
    }
    return places;
}

// A flow part with a vertex at each of these places.
struct Shown {
    explicit Shown(const VesselTree& tree)
        : topology(places_along(tree).size(), {}), part(tree, places_along(tree), {}, topology) {}

    BodyTopology topology;
    FlowPart part;
};

std::vector<float> shown(const VesselTree& tree, const Injection& injection) {
    Shown made(tree);
    FlowPart& part = made.part;
    part.inject(injection);
    part.finish_injection();
    EXPECT_LT(part.mass_error_relative(), 1e-9);
    return *part.drug().arrival_s;
}

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

VesselTree tube_of_40_mm() {
    VesselTree tree;
    tree.nodes = {{Vec3(0, 0, 0)}, {Vec3(40, 0, 0)}};
    VesselSegment segment;
    segment.proximal_node = 0;
    segment.distal_node = 1;
    segment.points_mm = {Vec3(0, 0, 0), Vec3(20, 0, 0), Vec3(40, 0, 0)};
    segment.radii_mm = {2.0, 2.0, 2.0};
    tree.segments = {segment};
    return tree;
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

const Injection unlike_blood{.at = {0, 0.0, 0.0}, .void_fraction = 0.4, .second_phase = "gas"};

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

// What the vertices of a split show is what their parents do.
TEST(FlowPart, VerticesThatWereSplitOffHaveTheirParentsPlaceAndTime) {
    const VesselTree& tree = test::small_patient()->tree;
    Shown made(tree);
    FlowPart& part = made.part;
    part.inject({.at = {0, 0.0, 0.0}});
    const std::vector<float> before = *part.drug().arrival_s;
    const std::uint64_t version = part.drug().version;
    const auto count = static_cast<int>(before.size());
    made.topology.split(std::vector<int>{7, 3, count}, {{0, 1, count + 2}});
    part.step(0.1);
    const std::vector<float>& after = *part.drug().arrival_s;
    ASSERT_EQ(after.size(), before.size() + 3);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin()));
    EXPECT_EQ(after[count], before[7]);
    EXPECT_EQ(after[count + 1], before[3]);
    EXPECT_EQ(after[count + 2], before[7]);
    EXPECT_NE(before[7], before[3]);
    EXPECT_NE(part.drug().version, version);
    EXPECT_EQ(part.place_of(count + 2).arclength_mm, part.place_of(7).arclength_mm);
    const std::uint64_t split = part.drug().version;
    part.step(0.1);
    EXPECT_EQ(part.drug().version, split);  // once
    // A later injection reaches them as well.
    part.inject({.at = {1, 0.0, 0.0}});
    EXPECT_EQ(part.drug().arrival_s->size(), before.size() + 3);
}

// Another tear may have as many vertices.
TEST(FlowPart, VerticesOfAnotherTearHaveTheirOwnParentsPlaceAndTime) {
    const VesselTree& tree = test::small_patient()->tree;
    Shown made(tree);
    FlowPart& part = made.part;
    part.inject({.at = {0, 0.0, 0.0}});
    const std::vector<float> before = *part.drug().arrival_s;
    const auto count = static_cast<int>(before.size());
    for (const int parent : {7, 3}) {
        std::vector<int> parents(before.size());
        std::iota(parents.begin(), parents.end(), 0);
        parents.push_back(parent);
        made.topology.become(parents, {});
        part.step(0.1);
        EXPECT_EQ(part.place_of(count).arclength_mm, part.place_of(parent).arclength_mm);
        EXPECT_EQ(part.drug().arrival_s->back(), before[parent]);
    }
}

// Behind the tear there is none of it; before it nothing has changed.
TEST(FlowPart, ADrugEndsAtTheTearOfATube) {
    const VesselTree tree = tube_of_40_mm();
    const ThroughTear tear{{0, 20.0, 0.0}, 4.0 * std::numbers::pi};
    Injection whole{.at = {0, 0.0, 0.0}};
    for (const double share : {0.0, 0.4}) {
        whole.void_fraction = share;
        Injection torn = whole;
        torn.tears = {tear};
        const std::vector<float> usual = shown(tree, whole);
        Shown made(tree);
        made.part.inject(torn);
        made.part.finish_injection();
        const DrugView& drug = made.part.drug();
        for (std::size_t k = 0; k < 11; ++k) {  // 4 mm apart
            if (k < 5)
                EXPECT_NEAR((*drug.arrival_s)[k], usual[k], 1e-3 * usual[10]) << k;
            else
                EXPECT_TRUE(std::isinf((*drug.arrival_s)[k])) << k;
        }
        const float at_stump_s = made.part.arrival_at_stump_s(tear, -1);
        EXPECT_NEAR(at_stump_s, usual[5], 1e-3 * usual[10]);
        EXPECT_GT(drug.end_s, at_stump_s) << "it goes on leaking";
    }
}

// Behind a hole in the side of a tube it goes on more slowly: of the flow q, x leaks, and the
// quadratic of the orifice says how much.
TEST(FlowPart, ADrugGoesOnBehindAnOpenSide) {
    const VesselTree tree = tube_of_40_mm();
    const Injection whole{.at = {0, 0.0, 0.0}};
    Injection open = whole;
    const ThroughTear hole{{0, 20.0, 0.0}, 3.0, true};
    open.tears = {hole};
    const std::vector<float> usual = shown(tree, whole);
    Shown made(tree);
    made.part.inject(open);
    const Fluid fluid = pure(blood());
    const double q = whole.mass_flow_g_s / fluid.density_g_mm3;
    const double r = 8.0 * fluid.viscosity_pa_s * 20.0 / (std::numbers::pi * 16.0);
    const double k_loss = 0.5 * fluid.density_g_mm3 / std::pow(0.6 * 3.0, 2);
    const double x = (std::sqrt(r * r + 4.0 * k_loss * r * q) - r) / (2.0 * k_loss);
    ASSERT_GT(x, 0.1 * q);
    for (std::size_t k = 0; k < 11; ++k) {
        double expected = usual[k];
        if (k > 5) expected = usual[5] + (usual[k] - usual[5]) * q / (q - x);
        EXPECT_NEAR((*made.part.drug().arrival_s)[k], expected, 1e-4 * usual[10]) << k;
    }
    EXPECT_NEAR(made.part.arrival_at_stump_s(hole, -1), usual[5], 1e-4 * usual[10]);
}

TEST(FlowPart, ADrugGoesToTheBranchesThatAreNotTorn) {
    const VesselTree& tree = test::small_patient()->tree;
    const std::vector<std::vector<int>> kids = children(tree);
    ASSERT_EQ(kids[0].size(), 2u);
    const int off = kids[0][0], beside = kids[0][1];
    const std::vector<float> arrival_s =
        shown(tree, {.at = {0, 0.0, 0.0}, .tears = {{{off, 0.0, 0.0}, 3.0}}});
    const auto at = [&](int segment, int tenth) {
        return arrival_s[static_cast<std::size_t>(11 * segment + tenth)];
    };
    for (int tenth = 0; tenth <= 10; ++tenth) {
        EXPECT_TRUE(std::isfinite(at(0, tenth)));
        EXPECT_TRUE(std::isfinite(at(beside, tenth)));
        EXPECT_TRUE(std::isinf(at(off, tenth)));
        for (const int further : kids[off]) EXPECT_TRUE(std::isinf(at(further, tenth)));
    }
}

std::vector<std::uint8_t> reached_by(const DrugView& drug) {
    std::vector<std::uint8_t> reached;
    for (const float arrival_s : *drug.arrival_s) reached.push_back(arrival_s <= drug.time_s);
    return reached;
}

// Until the drug is taken away, as PlayMeter counts it.
TEST(FlowPart, WhatAnInjectionReachedIsKeptBesideTheNext) {
    Shown made(tube_of_40_mm());
    FlowPart& part = made.part;
    part.inject({.at = {0, 0.0, 0.0}});
    EXPECT_FALSE(part.drug().reached_before) << "there was none before";
    part.set_time(0.35 * part.drug().end_s);
    const std::vector<std::uint8_t> first = reached_by(part.drug());
    EXPECT_EQ(first, (std::vector<std::uint8_t>{1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0}));
    part.inject({.at = {0, 20.0, 0.0}});
    ASSERT_TRUE(part.drug().reached_before);
    EXPECT_EQ(*part.drug().reached_before, first);
    part.step(0.01 * part.drug().end_s);
    const auto kept = part.drug().reached_before;
    part.step(0.01 * part.drug().end_s);
    EXPECT_EQ(part.drug().reached_before, kept) << "nothing is copied while the drug runs";
    const FlowCheckpoint second = part.checkpoint();
    part.set_time(part.drug().end_s);
    const std::vector<std::uint8_t> also = reached_by(part.drug());
    part.inject(unlike_blood);
    EXPECT_EQ(part.drug().reached_before, kept) << "while the next is computed";
    part.finish_injection();
    for (std::size_t v = 0; v < first.size(); ++v)
        EXPECT_EQ((*part.drug().reached_before)[v], first[v] | also[v]) << v;
    part.restore(second);
    EXPECT_EQ(*part.drug().reached_before, first) << "back to before the third";
    part.remove_drug();
    EXPECT_FALSE(part.drug().reached_before);
    part.inject({.at = {0, 0.0, 0.0}});
    EXPECT_FALSE(part.drug().reached_before) << "nothing of before";
}

TEST(FlowPart, WhatWasReachedBeforeGoesWithSplitVerticesAndIntoFiles) {
    Shown made(tube_of_40_mm()), other(tube_of_40_mm());
    made.part.inject({.at = {0, 0.0, 0.0}});
    made.part.set_time(0.35 * made.part.drug().end_s);
    made.part.inject({.at = {0, 20.0, 0.0}});
    WorldCheckpoint kept;
    kept.flow = made.part.checkpoint();
    auto json = to_json(kept);
    other.part.restore(*world_checkpoint_from_json(json).flow);
    ASSERT_TRUE(other.part.drug().reached_before);
    EXPECT_EQ(*other.part.drug().reached_before, *made.part.drug().reached_before);
    json["flow"]["reached_before"] = "012";
    EXPECT_THROW(world_checkpoint_from_json(json), InputError);
    made.topology.split(std::vector<int>{0, 10}, {});
    made.part.step(0.01);
    EXPECT_EQ(*made.part.drug().reached_before,
              (std::vector<std::uint8_t>{1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0}));
}

// As from a keyframe in a file, which holds no times.
TEST(FlowPart, TheTearsOfAnInjectionGoIntoCheckpoints) {
    const VesselTree tree = tube_of_40_mm();
    const ThroughTear tear{{0, 20.0, 0.0}, 5.0};
    Shown made(tree), other(tree), whole(tree);
    made.part.inject({.at = {0, 0.0, 0.0}, .tears = {tear}});
    whole.part.inject({.at = {0, 0.0, 0.0}});
    EXPECT_NE(made.part.state_hash(), whole.part.state_hash());
    WorldCheckpoint kept;
    kept.flow = made.part.checkpoint();
    other.part.restore(*world_checkpoint_from_json(to_json(kept)).flow);
    EXPECT_EQ(*other.part.drug().arrival_s, *made.part.drug().arrival_s);
    EXPECT_EQ(other.part.drug().end_s, made.part.drug().end_s);
    EXPECT_EQ(other.part.arrival_at_stump_s(tear, -1), made.part.arrival_at_stump_s(tear, -1));
    EXPECT_EQ(other.part.state_hash(), made.part.state_hash());
    Injection side{.at = {0, 0.0, 0.0}, .tears = {tear}};
    side.tears[0].side = true;
    whole.part.inject(side);
    EXPECT_NE(whole.part.state_hash(), made.part.state_hash());
    WorldCheckpoint with_side;
    with_side.flow = whole.part.checkpoint();
    other.part.restore(*world_checkpoint_from_json(to_json(with_side)).flow);
    EXPECT_EQ(other.part.state_hash(), whole.part.state_hash());
    EXPECT_EQ(*other.part.drug().arrival_s, *whole.part.drug().arrival_s);
    kept.flow->injected->tears[0].at.segment = 1;
    EXPECT_THROW(other.part.restore(*kept.flow), InputError) << "of another tree";
}

}  // namespace
}  // namespace hepatica
