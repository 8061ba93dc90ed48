// SPDX-License-Identifier: GPL-3.0-or-later
// What a drug shows where vessels split and tear, and of an injection before.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "core/flow/injection.h"
#include "core/scene/flow_part.h"
#include "core/scene/world_checkpoint.h"
#include "tests/scene/shown_flow.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

using test::shown;
using test::Shown;
using test::tube_of_40_mm;
using test::unlike_blood;

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

// A keyframe in a file holds no end, and may be read where less or more is torn than where the
// drug was injected.
TEST(FlowPart, SplitVerticesDoNotMoveTheEndOfTheClock) {
    const VesselTree tree = tube_of_40_mm();
    const std::vector<VertexPlace> places{
        {{0, 4.0, 0.0}, 1.0}, {{0, 4.0, 0.0}, 1.0}, {{0, 4.0, 0.0}, 1.0}, {{0, 40.0, 0.0}, 1.0}};
    for (const Injection& injection : {Injection{.at = {0, 0.0, 0.0}}, unlike_blood}) {
        BodyTopology whole(places.size(), {}), torn(places.size(), {});
        FlowPart one(tree, places, {}, whole), other(tree, places, {}, torn);
        torn.split(std::vector<int>{3, 3, 3, 3, 3}, {{0, 1, 2}});
        other.step(0.1);
        for (FlowPart* part : {&one, &other}) {
            part->inject(injection);
            part->finish_injection();
        }
        const double end_s = one.drug().end_s;
        EXPECT_LT(end_s, one.drug().arrival_s->back()) << "that of most vertices";
        EXPECT_EQ(other.drug().end_s, end_s);
        ASSERT_EQ(other.drug().arrival_s->size(), torn.vertex_count());
        EXPECT_EQ(other.drug().arrival_s->back(), one.drug().arrival_s->back());
        WorldCheckpoint kept;
        kept.flow = one.checkpoint();
        other.restore(*world_checkpoint_from_json(to_json(kept)).flow);
        EXPECT_EQ(other.drug().end_s, end_s);
        EXPECT_EQ(other.drug().arrival_s->size(), torn.vertex_count());
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

// All branches came off the trunk together: what is injected into one of them leaks at their side.
TEST(FlowPart, ADrugBehindATrunkThatIsTornOffComesToTheStump) {
    const VesselTree& tree = test::small_patient()->tree;
    const std::vector<int> kids = children(tree)[0];
    ASSERT_EQ(kids.size(), 2u);
    const ThroughTear tear{{0, length_mm(tree.segments[0]), 0.0}, 3.0};
    Shown made(tree);
    made.part.inject(
        {.at = {kids[0], 0.5 * length_mm(tree.segments[kids[0]]), 0.0}, .tears = {tear}});
    made.part.finish_injection();
    EXPECT_TRUE(std::isfinite(made.part.arrival_at_stump_s(tear, -1)));
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
