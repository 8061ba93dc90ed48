// SPDX-License-Identifier: GPL-3.0-or-later
// What a drug shows that runs while vessels tear.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/error.h"
#include "core/flow/injection.h"
#include "core/scene/flow_part.h"
#include "core/scene/world_checkpoint.h"
#include "tests/scene/shown_flow.h"
#include "tests/support/asked_to_stop.h"

namespace hepatica {
namespace {

using test::shown;
using test::Shown;
using test::tube_of_40_mm;
using test::unlike_blood;

const ThroughTear tear_at_20_mm{{0, 20.0, 0.0}, 4.0 * std::numbers::pi};

// As from a file, which holds no times.
void expect_the_same_from_its_text(FlowPart& part, const VesselTree& tree) {
    WorldCheckpoint kept;
    kept.flow = part.checkpoint();
    Shown other(tree);
    other.part.restore(*world_checkpoint_from_json(to_json(kept)).flow);
    EXPECT_EQ(*other.part.drug().arrival_s, *part.drug().arrival_s);
    EXPECT_EQ(other.part.drug().end_s, part.drug().end_s);
    EXPECT_EQ(other.part.drug().computing, part.drug().computing);
    EXPECT_EQ(other.part.state_hash(), part.state_hash());
    EXPECT_EQ(other.part.arrival_at_stump_s(tear_at_20_mm, -1),
              part.arrival_at_stump_s(tear_at_20_mm, -1));
}

// The vessel is torn at 20 mm while the drug is at 10 or at 30: what it has reached stays reached,
// and nothing comes behind the tear any more.
TEST(FlowPart, ADrugThatRunsEndsAtATear) {
    const VesselTree tree = tube_of_40_mm();
    const std::vector<float> usual = shown(tree, {.at = {0, 0.0, 0.0}});
    for (const int at_mm : {10, 30}) {
        Shown made(tree);
        FlowPart& part = made.part;
        part.inject({.at = {0, 0.0, 0.0}});
        const DrugView before = part.drug();
        const double time_s = before.end_s * at_mm / 40.0;
        part.set_time(time_s);
        const std::uint64_t whole = part.state_hash();
        part.follow_tears({tear_at_20_mm});
        part.finish_injection();
        const DrugView& drug = part.drug();
        EXPECT_EQ(drug.time_s, time_s);
        EXPECT_EQ(drug.injections, before.injections) << "the same one";
        EXPECT_TRUE(drug.playing);
        EXPECT_GE(drug.end_s, before.end_s) << "it goes on leaking";
        EXPECT_NE(drug.version, before.version);
        EXPECT_NE(part.state_hash(), whole);
        ASSERT_EQ(drug.injection->later_tears.size(), 1u);
        for (std::size_t k = 0; k < 11; ++k) {  // 4 mm apart
            const int mm = 4 * static_cast<int>(k);
            if (mm < std::max(20, at_mm))
                EXPECT_NEAR((*drug.arrival_s)[k], usual[k], 1e-5 * usual[10]) << mm;
            else
                EXPECT_TRUE(std::isinf((*drug.arrival_s)[k])) << mm;
        }
        EXPECT_NEAR(part.arrival_at_stump_s(tear_at_20_mm, -1), usual[5], 1e-5 * usual[10]);
        expect_the_same_from_its_text(part, tree);
    }
}

TEST(FlowPart, ADrugsFlowIsSolvedAnewWhereATearIsAnotherOne) {
    const VesselTree tree = tube_of_40_mm();
    Shown made(tree);
    FlowPart& part = made.part;
    part.follow_tears({tear_at_20_mm});
    EXPECT_FALSE(part.drug().injection) << "there is none";
    const ThroughTear side{{0, 20.0, 0.0}, 3.0, true};
    part.inject({.at = {0, 0.0, 0.0}, .tears = {side}});
    const auto changes = [&](const std::vector<ThroughTear>& tears) {
        const std::uint64_t version = part.drug().version;
        part.follow_tears(tears);
        part.finish_injection();
        return part.drug().version != version;
    };
    EXPECT_FALSE(changes({side}));
    ThroughTear wider = side;
    wider.area_mm2 = 5.9;
    EXPECT_FALSE(changes({wider})) << "below twice";
    wider.area_mm2 = 6.0;
    EXPECT_TRUE(changes({wider}));
    EXPECT_FALSE(changes({wider}));
    EXPECT_TRUE(changes({side})) << "half";
    EXPECT_TRUE(changes({side, {{0, 30.0, 0.0}, 3.0, true}}));
    EXPECT_TRUE(changes({}));
    const std::vector<float> usual = shown(tree, {.at = {0, 0.0, 0.0}});
    for (std::size_t k = 0; k < 11; ++k)
        EXPECT_NEAR((*part.drug().arrival_s)[k], usual[k], 1e-5 * usual[10])
            << "closed again before it began";
    part.play(false);
    EXPECT_FALSE(changes({tear_at_20_mm})) << "the clock stands";
    part.play(true);
    EXPECT_TRUE(changes({tear_at_20_mm}));
}

// A side that swings opens and closes at every frame; each change makes the front's whole run anew.
TEST(FlowPart, ChangesOfTearsThatAreCloseTogetherAreTakenTogether) {
    const VesselTree tree = tube_of_40_mm();
    Shown made(tree);
    FlowPart& part = made.part;
    part.inject({.at = {0, 0.0, 0.0}});
    const double end_s = part.drug().end_s;
    const std::vector<ThroughTear> open{{{0, 30.0, 0.0}, 3.0, true}};
    for (int frame = 0; frame < 400; ++frame) {
        part.set_time(end_s * (0.5 + 1e-4 * frame));
        part.follow_tears(frame % 2 == 0 ? open : std::vector<ThroughTear>{});
        part.finish_injection();
    }
    const auto& later = part.drug().injection->later_tears;
    EXPECT_GE(later.size(), 2u);
    EXPECT_LE(later.size(), 5u);
    part.set_time(0.9 * end_s);
    part.follow_tears({tear_at_20_mm});
    part.finish_injection();
    EXPECT_EQ(part.drug().injection->later_tears.back().from_s, 0.9 * end_s);
}

// Turned back to before the tear, it is another one that tears.
TEST(FlowPart, ATearAfterTheClockWasTurnedBackTakesThePlaceOfLaterOnes) {
    const VesselTree tree = tube_of_40_mm();
    Shown made(tree);
    FlowPart& part = made.part;
    part.inject({.at = {0, 0.0, 0.0}});
    const double end_s = part.drug().end_s;
    part.set_time(0.75 * end_s);
    part.follow_tears({tear_at_20_mm});
    part.finish_injection();
    EXPECT_TRUE(std::isfinite((*part.drug().arrival_s)[7]));
    part.set_time(0.25 * end_s);
    part.follow_tears({tear_at_20_mm});
    EXPECT_TRUE(std::isfinite((*part.drug().arrival_s)[7])) << "it is the same tear";
    const ThroughTear before{{0, 15.0, 0.0}, 4.0 * std::numbers::pi};
    part.follow_tears({before});
    part.finish_injection();
    ASSERT_EQ(part.drug().injection->later_tears.size(), 1u);
    EXPECT_TRUE(std::isfinite((*part.drug().arrival_s)[3]));
    EXPECT_TRUE(std::isinf((*part.drug().arrival_s)[4]));
}

// It is computed again in the background; what is cut off is taken away at once.
TEST(FlowPart, ADrugOfAnotherFluidHearsOfATearToo) {
    const VesselTree tree = tube_of_40_mm();
    const std::vector<float> usual = shown(tree, unlike_blood);
    Shown made(tree);
    FlowPart& part = made.part;
    part.inject(unlike_blood);
    part.follow_tears({tear_at_20_mm});
    part.finish_injection();
    const DrugView before = part.drug();
    EXPECT_EQ(*before.arrival_s, usual) << "it had not begun";
    const double time_s = 0.5 * usual[2];
    part.set_time(time_s);
    part.follow_tears({tear_at_20_mm});
    EXPECT_TRUE(part.computing());
    EXPECT_TRUE(part.drug().computing);
    EXPECT_NE(part.drug().version, before.version);
    for (std::size_t k = 0; k < 11; ++k)
        EXPECT_EQ((*part.drug().arrival_s)[k],
                  k < 5 ? usual[k] : std::numeric_limits<float>::infinity())
            << k;
    expect_the_same_from_its_text(part, tree);
    part.step(0.01 * time_s);
    const double later_s = part.drug().time_s;
    part.finish_injection();
    EXPECT_FALSE(part.drug().computing);
    EXPECT_EQ(part.drug().time_s, later_s) << "the clock runs on";
    EXPECT_EQ(part.drug().injections, before.injections);
    for (std::size_t k = 0; k < 11; ++k)
        if (k < 5)
            EXPECT_NEAR((*part.drug().arrival_s)[k], usual[k], 1e-2 * usual[10]) << k;
        else
            EXPECT_TRUE(std::isinf((*part.drug().arrival_s)[k])) << k;
    expect_the_same_from_its_text(part, tree);
    const std::uint64_t version = part.drug().version;
    part.follow_tears({tear_at_20_mm});
    EXPECT_EQ(part.drug().version, version) << "it knows";
}

// Whenever the computation ends, so that the same commands give the same bits.
TEST(FlowPart, TheFlowAfterATearIsShownAFixedNumberOfStepsLater) {
    const VesselTree tree = tube_of_40_mm();
    Shown made(tree), restored(tree);
    FlowPart& part = made.part;
    part.inject({.at = {0, 0.0, 0.0}});
    const double begin_s = 0.25 * part.drug().end_s, dt_s = 1e-3 * part.drug().end_s;
    part.set_time(begin_s);
    part.follow_tears({tear_at_20_mm});
    ASSERT_EQ(part.steps_to_update(), 6);
    for (int left = 6; left > 0; --left) {
        SCOPED_TRACE(left);
        EXPECT_TRUE(part.computing());
        EXPECT_FALSE(part.waits_for_finish()) << "nobody else shows it";
        EXPECT_TRUE(part.drug().injection->later_tears.empty());
        EXPECT_TRUE(std::isinf((*part.drug().arrival_s)[5])) << "cut off at once";
        FlowCheckpoint kept = part.checkpoint();
        EXPECT_EQ(kept.steps_left, left);
        expect_the_same_from_its_text(part, tree);
        ++kept.steps_left;
        restored.part.restore(kept);
        EXPECT_NE(restored.part.state_hash(), part.state_hash());
        const std::uint64_t version = part.drug().version;
        part.follow_tears({{{0, 30.0, 0.0}, 3.0, true}});
        EXPECT_EQ(part.drug().version, version) << "what tears until then waits";
        part.step(dt_s);
        restored.part.step(dt_s);
    }
    EXPECT_FALSE(part.computing());
    EXPECT_NEAR(part.drug().time_s, begin_s + 6.0 * dt_s, 1e-9 * begin_s) << "the clock ran on";
    ASSERT_EQ(part.drug().injection->later_tears.size(), 1u);
    EXPECT_EQ(part.drug().injection->later_tears[0].from_s, begin_s);
    EXPECT_TRUE(restored.part.computing()) << "it was given one step more";
    restored.part.step(0.0);
    EXPECT_EQ(*restored.part.drug().arrival_s, *part.drug().arrival_s);
    part.follow_tears({{{0, 30.0, 0.0}, 3.0, true}});
    EXPECT_FALSE(part.computing()) << "taken together within a hundredth of the run";
    part.set_time(begin_s + 0.02 * part.drug().end_s);
    part.follow_tears({{{0, 30.0, 0.0}, 3.0, true}});
    EXPECT_TRUE(part.computing());
}

// Closing must not wait until the flow that is due is found.
TEST(FlowPart, AStopIsHeardWhereTheFlowAfterATearIsDue) {
    Shown made(tube_of_40_mm());
    FlowPart& part = made.part;
    part.inject({.at = {0, 0.0, 0.0}});
    const double dt_s = 1e-3 * part.drug().end_s;
    part.set_time(0.25 * part.drug().end_s);
    part.follow_tears({tear_at_20_mm});
    for (int left = part.steps_to_update(); left > 1; --left) part.step(dt_s);
    const FlowCheckpoint good = part.checkpoint();
    EXPECT_THROW(part.step(dt_s, test::asked_to_stop()), Cancelled);
    part.restore(good);
    part.step(dt_s);
    EXPECT_EQ(part.drug().injection->later_tears.size(), 1u) << "as if there had been no stop";
}

// A trunk of 20 mm that divides into two branches of 20 mm.
VesselTree fork_of_20_mm() {
    VesselTree tree;
    tree.nodes = {{Vec3(0, 0, 0)}, {Vec3(20, 0, 0)}, {Vec3(36, 12, 0)}, {Vec3(36, -12, 0)}};
    for (const auto& [from, to] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{1, 3}}) {
        VesselSegment segment;
        segment.proximal_node = from;
        segment.distal_node = to;
        segment.parent = from - 1;
        const Vec3 begin = tree.nodes[static_cast<std::size_t>(from)].position_mm;
        const Vec3 end = tree.nodes[static_cast<std::size_t>(to)].position_mm;
        segment.points_mm = {begin, 0.5 * (begin + end), end};
        segment.radii_mm.assign(3, from == 0 ? 2.0 : 1.6);
        tree.segments.push_back(segment);
    }
    return tree;
}

// As a world does it, step by step, while the drug is in the trunk. Where it goes from the fork on
// is what both tears lead to, however soon one follows the other.
TEST(FlowPart, ASecondTearBeforeTheFlowAfterTheFirstIsShownIsTakenUpOnce) {
    const VesselTree tree = fork_of_20_mm();
    const ThroughTear first{{1, 10.0, 0.0}, 5.0};
    const ThroughTear second{{2, 12.0, 0.0}, 3.0, true};
    const std::vector<float> both = shown(tree, {.at = {0, 0.0, 0.0}, .tears = {first, second}});
    const std::vector<float> one = shown(tree, {.at = {0, 0.0, 0.0}, .tears = {first}});
    const std::size_t end_beside = 32;  // of the branch with the open side
    ASSERT_GT(both[end_beside], 1.02f * one[end_beside]) << "the second tear makes a difference";
    for (const int steps_between : {1, 3, 5, 6, 7}) {
        SCOPED_TRACE(steps_between);
        Shown made(tree), apart(tree);
        FlowPart& part = made.part;
        part.inject({.at = {0, 0.0, 0.0}});
        const double begin_s = 0.2 * both[10];  // of the way to the fork
        const double dt_s = 5e-4 * part.drug().end_s;
        part.set_time(begin_s);
        double torn_s = 0.0, least_s = 0.0;
        for (int step = 0; step < 60; ++step) {
            if (step == steps_between) torn_s = part.drug().time_s;
            least_s = std::max(least_s, 0.01 * part.drug().end_s);
            part.follow_tears(step < steps_between ? std::vector{first}
                                                   : std::vector{first, second});
            part.step(dt_s);
        }
        ASSERT_FALSE(part.computing());
        ASSERT_LT(part.drug().time_s, both[10]) << "still in the trunk";
        const auto& later = part.drug().injection->later_tears;
        ASSERT_EQ(later.size(), 2u) << "neither lost nor counted twice";
        EXPECT_EQ(later[0].from_s, begin_s);
        EXPECT_GE(later[1].from_s, torn_s);
        EXPECT_LE(later[1].from_s,
                  begin_s + std::max(least_s, part.steps_to_update() * dt_s) + 1.5 * dt_s);
        for (std::size_t k = 0; k < both.size(); ++k)
            if (std::isfinite(both[k]))
                EXPECT_NEAR((*part.drug().arrival_s)[k], both[k], 1e-5 * both[end_beside]) << k;
            else
                EXPECT_TRUE(std::isinf((*part.drug().arrival_s)[k])) << k;
        // The same bits as where nothing had to wait.
        apart.part.inject({.at = {0, 0.0, 0.0}});
        apart.part.set_time(begin_s);
        apart.part.follow_tears({first});
        apart.part.finish_injection();
        apart.part.set_time(later[1].from_s);
        apart.part.follow_tears({first, second});
        apart.part.finish_injection();
        EXPECT_EQ(*part.drug().arrival_s, *apart.part.drug().arrival_s);
        EXPECT_EQ(part.drug().end_s, apart.part.drug().end_s);
    }
}

// Its flow may end later than the one that is shown.
TEST(FlowPart, TheClockRunsOnUntilTheFlowAfterATearIsShown) {
    Shown made(tube_of_40_mm());
    FlowPart& part = made.part;
    part.inject({.at = {0, 0.0, 0.0}});
    const double dt_s = 1e-3 * part.drug().end_s;
    part.set_time(part.drug().end_s - 2.0 * dt_s);
    part.follow_tears({{{0, 30.0, 0.0}, 3.0, true}});
    for (int left = part.steps_to_update(); left > 1; --left) {
        part.step(dt_s);
        EXPECT_TRUE(part.drug().playing) << left;
    }
    const double time_s = part.drug().time_s;
    EXPECT_GT(time_s, part.drug().end_s);
    part.step(dt_s);
    EXPECT_EQ(part.drug().injection->later_tears.size(), 1u);
    EXPECT_EQ(part.drug().playing, part.drug().time_s < part.drug().end_s);
}

TEST(FlowPart, TheStepsUntilATearIsKnownGrowAsTheFrontsWorkDoes) {
    VesselTree tree = tube_of_40_mm();
    tree.segments.resize(1000, tree.segments.front());
    EXPECT_EQ(Shown(tree).part.steps_to_update(), 24);
}

TEST(FlowPart, LaterTearsOfAnotherTreeAreRefused) {
    Shown made(tube_of_40_mm());
    made.part.inject({.at = {0, 0.0, 0.0}});
    made.part.follow_tears({tear_at_20_mm});
    made.part.finish_injection();
    FlowCheckpoint kept = made.part.checkpoint();
    ASSERT_EQ(kept.injected->later.size(), 1u);
    kept.injected->later[0].tears[0].at.segment = 1;
    EXPECT_THROW(made.part.restore(kept), InputError);
}

}  // namespace
}  // namespace hepatica
