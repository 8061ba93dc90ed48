// SPDX-License-Identifier: GPL-3.0-or-later
// What determines a world's steps to come: its hash is of all of it, the text of its checkpoint
// takes all of it elsewhere, and what is refused changes nothing of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.h"
#include "core/scene/bleeding.h"
#include "core/scene/deform_part.h"
#include "core/scene/flow_part.h"
#include "core/scene/setting_json.h"
#include "core/scene/world.h"
#include "core/scene/world_checkpoint.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

using test::middle_of;
using test::small_patient;
using Json = nlohmann::ordered_json;

const double nan = std::nan("");

// Tools may be had, vessels tear, a drug flows.
SceneSpec scene_of_everything() {
    SceneSpec spec = default_scene();
    spec.contact = ContactSpec{.tools = true, .self = false};
    spec.tear = TearSpec{.tear_factor = 0.4};
    return spec;
}

struct Played {
    explicit Played(const SceneSpec& spec = scene_of_everything())
        : world(small_patient(), spec, job), body(*world.deform()), flow(*world.flow()) {}

    Job job;
    World world;
    DeformPart& body;
    FlowPart& flow;
    const VesselTree& tree = small_patient()->tree;
    const Vec3 place = middle_of(tree, 1);
};

// What both show now: bodies of one shape.
std::pair<Frame, Frame> frames_of_one_shape(const Played& one, const Played& other) {
    std::pair<Frame, Frame> frames;
    one.world.fill(frames.first);
    other.world.fill(frames.second);
    EXPECT_EQ(frames.first.positions_mm, frames.second.positions_mm);
    EXPECT_EQ(*frames.first.surface, *frames.second.surface);
    return frames;
}

TEST(WorldState, ItsHashIsOfAllThatCanBeDone) {
    Played p;
    std::set<std::uint64_t> seen{p.world.state_hash()};
    const auto changes = [&](const char* what) {
        EXPECT_TRUE(seen.insert(p.world.state_hash()).second) << what;
    };
    p.body.grab(p.place);
    changes("a hand");
    p.body.move_grab(p.place + Vec3(1, 0, 0));
    changes("where it is");
    p.body.release();
    p.body.grab(p.place + Vec3(0.5, 0, 0));
    changes("where it took hold");
    p.body.set_tether(21.0);
    changes("the tissue around");
    p.body.set_wall(0.6);
    changes("the wall");
    p.body.set_gravity(Vec3(0, 0, -1));
    changes("gravity");
    StepperOptions setting = p.body.setting();
    setting.substeps += 3;
    p.body.use(setting);
    changes("the setting");
    p.flow.inject({.at = {0, 0.0, 0.0}});
    changes("a drug");
    p.flow.set_time(2.0);
    changes("its time");
    p.flow.set_speed(3.0);
    changes("its speed");
    p.flow.play(false);
    changes("whether it plays");
    p.flow.inject({.at = {0, 0.0, 0.0}, .mass_flow_g_s = 1.5});
    changes("how much");
    p.flow.remove_drug();
    changes("none");
    p.world.step();
    changes("a step");
    p.body.cut(p.tree, p.place - Vec3(15, 0, 0), p.place + Vec3(15, 0, 0));
    changes("a cut");
}

TEST(WorldState, GoesOnFromTheTextOfItsCheckpoint) {
    Played one, other;
    one.body.add_tool({"sphere", 2.0, 0.0, Vec3::UnitX(), {}}, one.place);
    one.body.cut(one.tree, middle_of(one.tree, 0) - Vec3(15, 1, 0),
                 middle_of(one.tree, 0) + Vec3(15, 1, 0));
    one.flow.inject({.at = {0, 0.0, 0.0}});
    one.body.grab(one.place);
    for (int k = 0; k < 12; ++k) {
        one.body.move_grab(one.place + Vec3(0, 0.4 * k, 0));
        one.world.step();
    }
    EXPECT_GT(one.body.torn_so_far().pieces, other.body.torn_so_far().pieces);
    const std::string text = to_json(one.world.checkpoint()).dump();
    other.world.restore(world_checkpoint_from_json(Json::parse(text)));
    EXPECT_EQ(to_json(other.world.checkpoint()).dump(), text);
    EXPECT_EQ(other.world.time_s(), one.world.time_s());
    EXPECT_EQ(other.world.vertex_count(), one.world.vertex_count());
    EXPECT_TRUE(other.body.holding());
    for (int k = 0; k < 8; ++k) {
        EXPECT_EQ(other.world.state_hash(), one.world.state_hash()) << k;
        one.world.step();
        other.world.step();
    }
    const auto [a, b] = frames_of_one_shape(one, other);
    EXPECT_EQ(*a.tear->origins, *b.tear->origins);
    EXPECT_EQ(*a.tear->rims, *b.tear->rims);
    EXPECT_EQ(a.tear->leaked_g, b.tear->leaked_g);
    EXPECT_EQ(a.tear->leak_g_s, b.tear->leak_g_s);
    EXPECT_EQ(a.tool, b.tool);
}

// As that of a side that has closed.
TEST(WorldState, BloodStaysWhereItWasLostAlsoAfterARestore) {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    for (VesselSegment& segment : patient->tree.segments) segment.system = VascularSystem::portal;
    Job job;
    World one(patient, scene_of_everything(), job), other(patient, scene_of_everything(), job);
    const auto& points = patient->tree.segments[0].points_mm;
    const std::size_t m = points.size() / 2;
    const Vec3 across = 15.0 * (points[m + 1] - points[m - 1]).unitOrthogonal();
    one.deform()->cut(patient->tree, points[m] - across, points[m] + across);
    one.step();
    WorldCheckpoint kept = one.checkpoint();
    ASSERT_GT(kept.leaked_g, 0.0);
    double lying_g = 0.0;
    for (const BloodPool& pool : kept.pools) lying_g += pool.lost_g;
    EXPECT_NEAR(lying_g, kept.leaked_g, 1e-12);

    const BloodPool closed{{{1, 0.0, 0.0}, 1.0, true}, kept.leaked_g, 0.25 * kept.leaked_g};
    kept.pools.push_back(closed);
    kept.leaked_g *= 2.0;
    const std::string text = to_json(kept).dump();
    other.restore(world_checkpoint_from_json(Json::parse(text)));
    EXPECT_EQ(to_json(other.checkpoint()).dump(), text);
    for (int k = 0; k < 2; ++k) {
        Frame frame;
        other.fill(frame);
        ASSERT_EQ(frame.tear->leaks.size(), kept.pools.size()) << k;
        const LeakView& leak = frame.tear->leaks.back();
        EXPECT_NEAR(leak.share * frame.tear->leaked_g, closed.lost_g, 1e-12) << k;
        EXPECT_EQ(leak.drug_g, closed.drug_g) << k;
        other.step();
    }
    other.reset();
    EXPECT_TRUE(other.checkpoint().pools.empty());

    for (const int segment : {-1, static_cast<int>(patient->tree.segments.size())}) {
        kept.pools.back().of.at.segment = segment;
        EXPECT_THROW(other.restore(kept), InputError) << segment;
    }
    Json spoilt = Json::parse(text);
    spoilt["pools"][0]["lost_g"] = -1.0;
    EXPECT_THROW(world_checkpoint_from_json(spoilt), InputError);
}

// Whatever was torn before.
TEST(WorldState, ARestoredTearHasItsOwnVertices) {
    Played p;
    const std::size_t whole = p.body.rest_positions_mm().size();
    const auto cut_through = [&](int segment) {
        const Vec3 at = middle_of(p.tree, segment);
        p.body.cut(p.tree, at - Vec3(15, 1, 0), at + Vec3(15, 1, 0));
        EXPECT_GT(p.body.rest_positions_mm().size(), whole);
    };
    cut_through(1);
    const DeformCheckpoint checkpoint = p.body.checkpoint();
    const std::vector<Vec3> rest_mm = p.body.rest_positions_mm();
    p.body.mend();
    cut_through(0);
    EXPECT_NE(p.body.rest_positions_mm(), rest_mm);
    p.body.restore(checkpoint);
    EXPECT_EQ(p.body.rest_positions_mm(), rest_mm);
}

// A changed setting makes another stepper, whose versions begin anew: what is shown is of the
// present body though its version may have the number of the one before.
TEST(WorldState, WhatIsShownIsOfThePresentTearWhateverItsVersion) {
    Played p;
    const auto expect_own = [&](const char* when) {
        EXPECT_EQ(p.world.topology().vertex_count(), p.world.vertex_count()) << when;
        Frame frame;
        p.world.fill(frame);
        int highest = 0;
        for (const auto& triangle : *frame.surface)
            highest = std::max({highest, triangle[0], triangle[1], triangle[2]});
        EXPECT_LT(static_cast<std::size_t>(highest), p.world.vertex_count()) << when;
        ASSERT_TRUE(frame.tear);
        if (frame.tear->origins) {
            EXPECT_EQ(frame.tear->origins->size(), p.world.vertex_count()) << when;
        }
    };
    const auto cut_through = [&](int segment) {
        const Vec3 at = middle_of(p.tree, segment);
        p.body.cut(p.tree, at - Vec3(15, 1, 0), at + Vec3(15, 1, 0));
        p.world.follow_tear();
    };
    const WorldCheckpoint whole = p.world.checkpoint();
    p.body.set_touchable(false);
    p.world.follow_tear();
    cut_through(1);
    expect_own("cut");
    p.world.restore(whole);  // with tools again
    expect_own("whole again");
    EXPECT_EQ(p.world.vertex_count(), small_patient()->mesh.vertices_mm.size());

    Played q;
    q.body.set_touchable(false);
    q.world.follow_tear();
    const Vec3 at = middle_of(q.tree, 1), other = middle_of(q.tree, 0);
    q.body.cut(q.tree, at - Vec3(15, 1, 0), at + Vec3(15, 1, 0));
    q.world.follow_tear();
    // As the governor changes the setting, which tells the world nothing; then something tears.
    q.body.set_touchable(true);
    q.body.cut_line(q.tree, other, other, 0.0);
    q.world.step();
    EXPECT_EQ(q.world.topology().vertex_count(), q.world.vertex_count());
}

TEST(WorldState, AResetTakesEverythingBackButTheClock) {
    Played p, fresh;
    p.body.add_tool({"sphere", 2.0, 0.0, Vec3::UnitX(), {}}, p.place);
    p.body.cut(p.tree, p.place - Vec3(15, 0, 0), p.place + Vec3(15, 0, 0));
    p.flow.inject({.at = {0, 0.0, 0.0}});
    p.body.grab(p.place);
    p.body.move_grab(p.place + Vec3(0, 5, 0));
    for (int k = 0; k < 3; ++k) p.world.step();
    EXPECT_GT(p.world.vertex_count(), fresh.world.vertex_count());
    p.world.reset();
    const auto [after, before] = frames_of_one_shape(p, fresh);
    EXPECT_FALSE(after.grab);
    EXPECT_FALSE(after.tool);
    EXPECT_EQ(after.drug.arrival_s, nullptr);
    EXPECT_EQ(after.tear->leaked_g, 0.0);
    EXPECT_EQ(after.tear->joints_broken, 0);
    EXPECT_GT(after.topology_version, before.topology_version);
    EXPECT_DOUBLE_EQ(after.time_s, 3.0 * frame_s);
    for (const Vec3& v : p.body.velocities_mm_per_s()) EXPECT_EQ(v.norm(), 0.0);
}

TEST(WorldState, ACheckpointOfAnotherSceneIsRefused) {
    Job job;
    SceneSpec drag = default_scene(), flow = default_scene();
    drag.flow.reset();
    flow.deform.reset();
    World both(small_patient(), default_scene(), job), dragged(small_patient(), drag, job),
        flowing(small_patient(), flow, job);
    EXPECT_THROW(both.restore(dragged.checkpoint()), InputError);
    EXPECT_THROW(both.restore(flowing.checkpoint()), InputError);
    EXPECT_THROW(dragged.restore(both.checkpoint()), InputError);
    EXPECT_THROW(flowing.restore(both.checkpoint()), InputError);
    EXPECT_NO_THROW(flowing.restore(flowing.checkpoint()));
    EXPECT_NE(flowing.state_hash(), dragged.state_hash());
    WorldCheckpoint spoilt = both.checkpoint();
    const auto count = static_cast<int>(spoilt.deform->stepper.nodes.positions_mm.size());
    for (const int vertex : {-1, count, count + 1}) {
        spoilt.deform->hold = Hold{.vertices = {vertex}, .offsets_mm = {Vec3::Zero()}};
        EXPECT_THROW(both.restore(spoilt), InputError) << vertex;
    }
    spoilt.deform->hold = Hold{.vertices = {count - 1, 0}, .offsets_mm = {Vec3::Zero()}};
    EXPECT_THROW(both.restore(spoilt), InputError);
    spoilt = both.checkpoint();
    const auto segments = static_cast<int>(small_patient()->tree.segments.size());
    for (const int segment : {-1, segments}) {
        spoilt.flow->injected = Injection{.at = {segment, 0.0, 0.0}};
        EXPECT_THROW(both.restore(spoilt), InputError) << segment;
    }
    spoilt.flow->injected = Injection{.at = {segments - 1, 0.0, 0.0}};
    EXPECT_NO_THROW(both.restore(spoilt)) << "computed anew";
    EXPECT_NE(both.flow()->drug().arrival_s, nullptr);
    EXPECT_THROW(world_checkpoint_from_json(Json::parse(R"({"time_s": "x"})")), InputError);
    EXPECT_THROW(world_checkpoint_from_json(Json::parse(R"({})")), InputError);
}

TEST(WorldState, AVertexKnowsItsPlaceWithAndWithoutAFlow) {
    Job job;
    SceneSpec drag = default_scene();
    drag.flow.reset();
    const World world(small_patient(), drag, job), both(small_patient(), default_scene(), job);
    const Vec3 place = middle_of(small_patient()->tree, 2);
    for (const World* each : {&world, &both}) {
        EXPECT_EQ(each->place_near(place).segment, 2);
        EXPECT_THROW(static_cast<void>(each->place_near(Vec3(0, nan, 0))), InputError);
    }
}

TEST(WorldState, PartsAreNamedWithWhatTheyCost) {
    Job job;
    SceneSpec spec = default_scene();
    spec.contact = ContactSpec{.tools = false, .self = true};
    World world(small_patient(), spec, job);
    EXPECT_EQ(job.progress().fraction, 1.0);
    world.step();
    ASSERT_EQ(world.parts().size(), 4u);
    EXPECT_EQ(world.parts()[2].name, "self-contact");
    EXPECT_GT(world.parts()[2].bytes, 0u);
    for (const PartCost& part : world.parts()) {
        EXPECT_GE(part.build_ms, 0.0) << part.name;
        EXPECT_LT(part.bytes, std::size_t{1} << 32) << part.name;
    }
    EXPECT_GT(world.parts()[1].build_ms, 0.0);
    EXPECT_GT(world.parts()[1].frame_ms + world.parts()[2].frame_ms, 0.0);
}

TEST(DeformPartState, WhatIsRefusedChangesNothing) {
    Played p;
    const std::uint64_t before = p.world.state_hash();
    const auto count = static_cast<int>(p.world.vertex_count());
    for (const int vertex : {-1, count}) EXPECT_THROW(p.body.grab_vertex(vertex), InputError);
    EXPECT_THROW(p.body.grab(Vec3(nan, 0, 0)), InputError);
    EXPECT_THROW(p.body.move_grab(Vec3(0, HUGE_VAL, 0)), InputError);
    EXPECT_NO_THROW(p.body.move_grab(Vec3(1, 2, 3))) << "nothing is held";
    for (const double wrong : {-1e-9, nan, HUGE_VAL})
        EXPECT_THROW(p.body.set_tether(wrong), InputError) << wrong;
    EXPECT_THROW(p.body.cut(p.tree, Vec3(nan, 0, 0), p.place), InputError);
    for (const double wrong : {-1e-9, 1.0 + 1e-9, nan})
        EXPECT_THROW(p.body.cut_line(p.tree, p.place, p.place, wrong), InputError) << wrong;
    EXPECT_NO_THROW(p.body.close_jaws(1.0)) << "there is no tool";
    EXPECT_EQ(p.world.state_hash(), before);
    EXPECT_FALSE(p.body.holding());
    p.body.set_tether(0.0);
    p.body.cut_line(p.tree, p.place, p.place, 1.0);
    p.body.cut_line(p.tree, p.place, p.place, 0.0);
    p.body.grab_vertex(0);
    p.body.grab_vertex(count - 1);
    p.body.add_tool({"hook", 1.0, 14.0, Vec3::UnitX(), {}}, p.place);
    EXPECT_THROW(p.body.close_jaws(1.0), InputError) << "a hook has none";
    for (const double wrong : {-1.0, nan, HUGE_VAL}) {
        EXPECT_THROW(p.flow.set_time(wrong), InputError) << wrong;
        EXPECT_THROW(p.flow.set_speed(wrong), InputError) << wrong;
    }
    EXPECT_THROW(p.flow.set_speed(0.0), InputError);
    EXPECT_NO_THROW(p.flow.set_time(0.0));
}

TEST(DeformPartState, WhereNothingTearsNothingIsCut) {
    Played p(default_scene());
    EXPECT_FALSE(p.body.tears());
    EXPECT_EQ(p.body.torn_so_far().pieces, 0);
    EXPECT_EQ(p.body.critical_opening_mm(), 0.0);
    EXPECT_EQ(p.body.torn(), nullptr);
    EXPECT_THROW(p.body.cut(p.tree, p.place - Vec3(9, 0, 0), p.place), InputError);
    EXPECT_THROW(p.body.cut_line(p.tree, p.place, p.place, 0.5), InputError);
    EXPECT_THROW(p.body.add_tool({"sphere", 2.0, 0.0, Vec3::UnitX(), {}}, p.place), InputError);
    p.body.set_tear(TearSpec{});
    EXPECT_TRUE(p.body.tears());
    EXPECT_GE(p.body.torn_so_far().pieces, 1);
    EXPECT_GT(p.body.critical_opening_mm(), 0.0);
}

// All settings at once are those one by one; what is in force already is not built anew.
TEST(DeformPartState, SettingsAreTakenAllAtOnce) {
    Played one, other;
    one.body.set_gravity(Vec3(0, 100, 0));
    one.body.set_tether(5.0);
    one.body.set_wall(0.7);
    StepperOptions setting = one.body.setting();
    setting.substeps = 3;
    one.body.use(setting);
    one.body.set_touchable(false);
    one.body.set_tear({});
    const DeformSettings settings = one.body.settings();
    other.body.use(settings);
    EXPECT_EQ(other.body.settings().gravity_mm_per_s2, Vec3(0, 100, 0));
    EXPECT_EQ(other.body.settings().tether_pa_per_mm2, 5.0);
    EXPECT_EQ(other.body.settings().wall_mm, 0.7);
    EXPECT_EQ(other.body.setting().substeps, 3);
    EXPECT_FALSE(other.body.touchable());
    EXPECT_FALSE(other.body.tears());
    EXPECT_EQ(other.world.state_hash(), one.world.state_hash());
    other.body.use(settings);
    EXPECT_EQ(other.world.state_hash(), one.world.state_hash());
}

// Neither quadratic elements nor the solver of the skeleton tear.
TEST(DeformPartState, IsRestoredFromASettingThatTearsToOneThatDoesNotAndBack) {
    for (const StepperOptions& other : {StepperOptions{.order = ElementOrder::quadratic},
                                        StepperOptions{.solver = LinearSolverKind::skeleton}}) {
        Played p(default_scene());
        const StepperOptions able = p.body.setting();
        p.body.use(other);
        const DeformCheckpoint whole = p.body.checkpoint();
        p.body.use(able);
        p.body.set_tear(TearSpec{.tear_factor = 0.4});
        const DeformCheckpoint tearing = p.body.checkpoint();
        const std::uint64_t hash = p.body.state_hash();
        p.body.restore(whole);
        EXPECT_FALSE(p.body.tears());
        EXPECT_TRUE(same_setting(p.body.setting(), other));
        p.body.restore(tearing);
        EXPECT_TRUE(p.body.tears());
        EXPECT_TRUE(same_setting(p.body.setting(), able));
        EXPECT_EQ(p.body.state_hash(), hash);
    }
}

TEST(DeformPartState, IsPlausibleUpToTenTimesItsSize) {
    Played p(default_scene());
    EXPECT_TRUE(p.body.plausible());
    Vec3 low = p.body.rest_positions_mm().front(), high = low;
    for (const Vec3& x : p.body.rest_positions_mm()) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    const double size_mm = (high - low).norm();
    for (const double sizes : {9.9, 10.1, nan}) {
        BodyState state = p.body.state();
        state.positions_mm[7] = p.body.rest_positions_mm()[7] + Vec3(0, 0, sizes * size_mm);
        if (std::isnan(sizes)) {
            EXPECT_THROW(p.body.set_state(state), InputError);
            continue;
        }
        p.body.set_state(state);
        EXPECT_EQ(p.body.plausible(), sizes < 10.0) << sizes;
    }
}

TEST(SettingWords, NameWhatIsNotAsUsual) {
    StepperOptions options;
    const std::string usual = words_of(options);
    EXPECT_EQ(usual, "corotated");
    options.substeps = 2;
    options.newton_iterations = 2;
    EXPECT_EQ(words_of(options), usual + ", 2 substeps, 2 Newton iterates");
    options = {};
    options.solver = LinearSolverKind::block_jacobi;
    EXPECT_EQ(words_of(options), usual + ", " + std::string(name_of(options.solver)));
    options.linear.energy_tolerance = 0.0;
    options.linear.max_iterations = 5;
    EXPECT_EQ(words_of(options), usual + ", 5 iterations");
    options.solver = LinearSolverKind::cholesky;
    EXPECT_EQ(words_of(options), usual + ", " + std::string(name_of(options.solver)));
}

}  // namespace
}  // namespace hepatica
