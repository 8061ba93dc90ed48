// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/scene/deform_part.h"
#include "core/scene/measured_dial.h"
#include "core/scene/world.h"
#include "core/session/replay.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

using test::keep_recording;
using test::middle_of;
using test::new_session;
using test::play;
using test::small_patient;

// Pulls at a branch for a second, injects at the root, and lets go. A recording is kept.
std::uint64_t play_script(Session& session) {
    const VesselTree& tree = small_patient()->tree;
    const Vec3 start = middle_of(tree, 1);
    session.post(GrabPoint{start});
    session.post(InjectDrug{.point_mm = tree.nodes[0].position_mm});
    for (int i = 0; i < 60; ++i) {
        session.post(MoveGrab{start + Vec3(0.1 * i, 0.05 * i, 0.0)});
        session.step();
    }
    session.post(ReleaseGrab{});
    return play(session, 30).state_hash;
}

TEST(Session, ShowsTheBodyAtRestBeforeTheFirstStep) {
    const auto session = new_session();
    ASSERT_TRUE(session->update_frame());
    const Frame& frame = session->frame();
    EXPECT_EQ(frame.positions_mm.size(), 3 * small_patient()->mesh.vertices_mm.size());
    EXPECT_FALSE(frame.surface->empty());
    EXPECT_EQ(frame.drug.arrival_s, nullptr);
    EXPECT_FALSE(session->update_frame());
}

TEST(Session, StaysAtRestWithoutForces) {
    const auto session = new_session();
    play(*session, 30);
    const auto& rest = small_patient()->mesh.vertices_mm;
    for (std::size_t v = 0; v < rest.size(); ++v)
        EXPECT_LT((session->world().vertex_mm(static_cast<int>(v)) - rest[v]).norm(), 1e-9);
}

TEST(Session, TheHeldPointFollowsTheHandAndComesBackAfterRelease) {
    const auto session = new_session();
    const Vec3 start = middle_of(small_patient()->tree, 0);
    session->post(GrabPoint{start});
    const Vec3 target = start + Vec3(6, 0, 0);
    session->post(MoveGrab{target});
    play(*session, 120);
    session->update_frame();
    ASSERT_TRUE(session->frame().grab.has_value());
    EXPECT_LT((session->frame().grab->point_mm - target).norm(), 1.5);
    EXPECT_GT(session->frame().grab->force_un, 0.0);

    session->post(ReleaseGrab{});
    play(*session, 600);
    session->update_frame();
    EXPECT_FALSE(session->frame().grab.has_value());
    const auto& rest = small_patient()->mesh.vertices_mm;
    for (std::size_t v = 0; v < rest.size(); ++v)
        EXPECT_LT((session->world().vertex_mm(static_cast<int>(v)) - rest[v]).norm(), 0.1);
}

TEST(Session, AHandThatJumpsPullsNoHarderThanItsLimit) {
    const auto session = new_session();
    const Vec3 start = middle_of(small_patient()->tree, 0);
    session->post(GrabPoint{start});
    session->step();
    session->update_frame();
    EXPECT_FALSE(session->frame().grab->at_limit);
    session->post(MoveGrab{start + Vec3(9e3, 0, 0)});
    play(*session, 60);
    EXPECT_TRUE(session->world().deform()->plausible());
    session->update_frame();
    const double radius = 4.0, modulus = 0.5e6;  // of the root branch, of the default material
    EXPECT_LE(session->frame().grab->force_un, 0.4 * modulus * M_PI * radius * radius * 1.001);
    EXPECT_TRUE(session->frame().grab->at_limit);
}

// Three steps of 1/60 s. What is shown is what a lesson judges.
TEST(Session, FramesCarryTheForceOfAStepAndTheMeanThatAHandWouldFeel) {
    const auto session = new_session();
    const Vec3 start = middle_of(small_patient()->tree, 0);
    session->post(GrabPoint{start});
    session->post(MoveGrab{start + Vec3(6, 0, 0)});
    std::vector<double> forces;
    FeltForce judged(1.0 / 60.0);
    for (int i = 0; i < 5; ++i) {
        session->step();
        session->update_frame();
        forces.push_back(session->frame().grab->force_un);
        judged.see(session->frame());
    }
    ASSERT_NE(forces[4], forces[2]);
    const double felt_un = session->frame().grab->felt_un.value();
    EXPECT_NEAR(felt_un, (forces[2] + forces[3] + forces[4]) / 3.0, 1e-9 * felt_un);
    EXPECT_DOUBLE_EQ(1e-3 * felt_un, judged.sum_mn());
    session->post(SetPaused{true});
    session->step();
    session->update_frame();
    EXPECT_EQ(session->frame().grab->felt_un, felt_un) << "no time has passed";
}

TEST(Session, FramesCarryTheExpectedErrorOfTheDial) {
    const auto session = new_session();
    ASSERT_TRUE(session->update_frame());
    const double middle = session->frame().statistics.expected_error;
    EXPECT_GT(middle, 0.0);
    EXPECT_FALSE(session->frame().statistics.error_reference.empty());
    session->post(SetQuality{1.0});
    session->step();
    ASSERT_TRUE(session->update_frame());
    EXPECT_LT(session->frame().statistics.expected_error, middle);
}

TEST(Session, FixedEndsStayWhereTheyAre) {
    SceneSpec spec = default_scene();
    spec.deform->fixed = FixedEnds::all;
    const auto session = new_session(spec);
    session->post(GrabPoint{middle_of(small_patient()->tree, 0)});
    session->post(MoveGrab{middle_of(small_patient()->tree, 0) + Vec3(20, 0, 0)});
    play(*session, 60);
    const VesselTree& tree = small_patient()->tree;
    const std::vector<int> degrees = node_degrees(tree);
    const auto& rest = small_patient()->mesh.vertices_mm;
    for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
        if (degrees[n] != 1) continue;
        std::size_t tip = 0;
        for (std::size_t v = 0; v < rest.size(); ++v)
            if ((rest[v] - tree.nodes[n].position_mm).norm() <
                (rest[tip] - tree.nodes[n].position_mm).norm())
                tip = v;
        EXPECT_EQ(session->world().vertex_mm(static_cast<int>(tip)), rest[tip]);
    }
}

TEST(Session, TheDrugReachesTheRootFirstAndRunsWithTheClock) {
    const auto session = new_session();
    session->post(InjectDrug{.point_mm = small_patient()->tree.nodes[0].position_mm});
    play(*session, 60);
    session->update_frame();
    const DrugView& drug = session->frame().drug;
    ASSERT_NE(drug.arrival_s, nullptr);
    EXPECT_NEAR(drug.time_s, 1.0, 1e-9);
    float least = 1e30F, most = 0.0F;
    std::size_t first = 0;
    for (std::size_t v = 0; v < drug.arrival_s->size(); ++v) {
        const float arrival = (*drug.arrival_s)[v];
        if (arrival < least) {
            least = arrival;
            first = v;
        }
        most = std::max(most, arrival);
    }
    EXPECT_LT(
        (small_patient()->mesh.vertices_mm[first] - small_patient()->tree.nodes[0].position_mm)
            .norm(),
        6.0);
    EXPECT_NEAR(most, drug.end_s, 0.1 * drug.end_s);  // the tree is filled from the root
    session->post(PlayDrug{false});
    play(*session, 10);
    session->update_frame();
    EXPECT_NEAR(session->frame().drug.time_s, 1.0, 1e-9);
}

TEST(Session, RefusesWhatIsOutOfRangeAndSaysSo) {
    const auto session = new_session();
    const auto untouched = new_session();
    const auto recording = keep_recording(*session), other = keep_recording(*untouched);
    for (const Command& command :
         {Command(GrabVertex{-1}),
          Command(GrabVertex{1 << 30}),
          Command(SetQuality{2.0}),
          Command(SetTether{-1.0}),
          Command(SetWall{-0.1}),
          Command(SetWall{1e-3}),
          Command(SetWall{std::numeric_limits<double>::infinity()}),
          Command(SetWall{std::numeric_limits<double>::quiet_NaN()}),
          Command(SetDrugTime{-1.0}),
          Command(SetDrugSpeed{0.0}),
          Command(InjectDrug{.mass_flow_g_s = -1.0}),
          Command(InjectDrug{.mass_flow_g_s = 1e-13}),
          Command(InjectDrug{.pressure_model = "nonsense"}),
          Command(InjectDrug{.void_fraction = 1.0}),
          Command(InjectDrug{.drug_viscosity_pa_s = 0.0}),
          Command(InjectDrug{.drug_viscosity_pa_s = -1.0}),
          Command(GrabPoint{Vec3(0, std::numeric_limits<double>::quiet_NaN(), 0)}),
          Command(GrabPoint{Vec3(1e308, 0, 0)}),
          Command(GrabPoint{Vec3(0, 0, -10001.0)}),
          Command(MoveGrab{Vec3(0, 10001.0, 0)}),
          Command(InjectDrug{Vec3(0, 10001.0, 0)}),
          Command(InjectDrug{Vec3(0, std::numeric_limits<double>::quiet_NaN(), 0)}),
          Command(MoveGrab{Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0)}),
          Command(SetGravity{Vec3(std::numeric_limits<double>::infinity(), 0, 0)})}) {
        session->post(command);
        EXPECT_EQ(session->step().state_hash, untouched->step().state_hash);
        session->update_frame();
        EXPECT_FALSE(session->frame().statistics.message.empty());
    }
}

TEST(Session, ScenesWithoutAPartRefuseItsCommands) {
    SceneSpec flow_only;
    flow_only.deform.reset();
    const auto session = new_session(flow_only);
    session->post(GrabPoint{});
    session->step();
    session->update_frame();
    EXPECT_NE(session->frame().statistics.message.find("nothing moves"), std::string::npos);
    EXPECT_EQ(session->frame().positions_mm.size(),
              3 * small_patient()->surface.vertices_mm.size());
}

// Of the body that moves: equal to the last bit, or not.
bool same_shape(const World& a, const std::vector<Vec3>& positions_mm) {
    const auto now = a.deform()->positions_mm();
    return std::equal(now.begin(), now.end(), positions_mm.begin(), positions_mm.end());
}

std::vector<Vec3> shape_of(const Session& session) {
    const auto now = session.world().deform()->positions_mm();
    return {now.begin(), now.end()};
}

double furthest_from_rest_mm(const Session& session) {
    const auto& rest = small_patient()->mesh.vertices_mm;
    double furthest = 0.0;
    for (std::size_t v = 0; v < rest.size(); ++v)
        furthest =
            std::max(furthest, (session.world().vertex_mm(static_cast<int>(v)) - rest[v]).norm());
    return furthest;
}

const Frame& newest_frame(Session& session) {
    session.update_frame();
    return session.frame();
}

// A pull that is under way, with a drug that runs: 20 steps of it.
std::unique_ptr<Session> pulled_and_injected() {
    auto session = new_session();
    keep_recording(*session);
    session->post(GrabPoint{middle_of(small_patient()->tree, 0)});
    session->post(MoveGrab{middle_of(small_patient()->tree, 0) + Vec3(5, 0, 0)});
    session->post(InjectDrug{.point_mm = small_patient()->tree.nodes[0].position_mm});
    play(*session, 20);
    return session;
}

TEST(Session, APauseStopsTheBodyAndTheDrugAndResumingGoesOn) {
    const auto session = pulled_and_injected();
    EXPECT_FALSE(newest_frame(*session).statistics.paused);
    const double drug_s = session->frame().drug.time_s;
    const double time_s = session->frame().time_s;
    const std::vector<Vec3> shape = shape_of(*session);
    session->post(SetPaused{true});
    const std::uint64_t paused = session->step().state_hash;
    EXPECT_EQ(play(*session, 5).state_hash, paused);
    EXPECT_TRUE(same_shape(session->world(), shape));
    EXPECT_TRUE(newest_frame(*session).statistics.paused);
    EXPECT_FALSE(session->frame().statistics.diverged);
    EXPECT_TRUE(session->frame().drug.playing);  // its clock goes on with the world's
    EXPECT_EQ(session->frame().drug.time_s, drug_s);
    EXPECT_EQ(session->frame().time_s, time_s);
    EXPECT_EQ(session->frame().step, 26u);  // the view stays alive
    session->post(SetPaused{false});
    EXPECT_NE(session->step().state_hash, paused);
    EXPECT_FALSE(same_shape(session->world(), shape));
    EXPECT_FALSE(newest_frame(*session).statistics.paused);
    EXPECT_GT(session->frame().drug.time_s, drug_s);
}

TEST(Session, AResetOpensTheHandTakesTheDrugAwayAndPlaysOn) {
    const auto session = pulled_and_injected();
    session->post(SetPaused{true});
    session->step();
    EXPECT_GT(furthest_from_rest_mm(*session), 1.0);
    session->post(ResetWorld{});
    play(*session, 5);
    EXPECT_LT(furthest_from_rest_mm(*session), 1e-9);
    const Frame& frame = newest_frame(*session);
    EXPECT_FALSE(frame.statistics.paused);
    EXPECT_FALSE(frame.grab.has_value());
    EXPECT_EQ(frame.drug.arrival_s, nullptr);
    EXPECT_FALSE(frame.drug.playing);
    EXPECT_EQ(frame.drug.time_s, 0.0);
}

TEST(Session, RemovingTheDrugLeavesTheBodyAsItIs) {
    const auto session = pulled_and_injected();
    const auto injected = pulled_and_injected();
    const std::uint64_t version = newest_frame(*session).drug.version;
    ASSERT_NE(session->frame().drug.arrival_s, nullptr);
    EXPECT_GT(session->frame().drug.time_s, 0.0);
    session->post(RemoveDrug{});
    session->step();
    injected->step();
    const DrugView& drug = newest_frame(*session).drug;
    EXPECT_EQ(drug.arrival_s, nullptr);
    EXPECT_NE(drug.version, version);
    EXPECT_EQ(drug.time_s, 0.0);
    EXPECT_EQ(drug.end_s, 0.0);
    EXPECT_FALSE(drug.playing);
    EXPECT_TRUE(session->frame().grab.has_value());
    EXPECT_TRUE(same_shape(session->world(), shape_of(*injected)));
    // Its clock can be set going only by another injection.
    session->post(PlayDrug{true});
    session->step();
    EXPECT_FALSE(newest_frame(*session).drug.playing);
    session->post(InjectDrug{.point_mm = small_patient()->tree.nodes[0].position_mm});
    session->step();
    EXPECT_TRUE(newest_frame(*session).drug.playing);
}

// Throws the vessels so far away that no step can be believed.
void make_diverge(Session& session) {
    BodyState state = session.world().deform()->state();
    for (Vec3& position : state.positions_mm) position.x() += 1e6;
    session.world().deform()->set_state(state);
}

TEST(Session, ADivergenceGoesBackToTheLastGoodStateStopsAndSaysSo) {
    const auto session = pulled_and_injected();
    play(*session, 40);
    const std::vector<Vec3> snapshot = shape_of(*session);  // of step 60
    play(*session, 20);
    EXPECT_FALSE(newest_frame(*session).statistics.diverged);
    make_diverge(*session);
    session->step();
    EXPECT_TRUE(same_shape(session->world(), snapshot));
    const FrameStatistics& said = newest_frame(*session).statistics;
    EXPECT_TRUE(said.diverged);
    EXPECT_TRUE(said.paused);
    EXPECT_NE(said.message.find("diverged"), std::string::npos) << said.message;
    EXPECT_FALSE(session->frame().grab.has_value());
    session->post(MoveGrab{Vec3(1, 2, 3)});  // a hand that still moves changes nothing
    play(*session, 3);
    EXPECT_TRUE(same_shape(session->world(), snapshot));
    EXPECT_TRUE(newest_frame(*session).statistics.diverged);
    EXPECT_FALSE(session->frame().statistics.message.empty());
}

TEST(Session, AfterADivergenceResumingRestoringAndResettingGoOn) {
    for (const Command& command :
         {Command(SetPaused{false}), Command(RestoreSnapshot{}), Command(ResetWorld{})}) {
        const auto session = pulled_and_injected();
        play(*session, 50);
        make_diverge(*session);
        const std::uint64_t stopped = session->step().state_hash;
        session->post(command);
        EXPECT_NE(session->step().state_hash, stopped);
        const Frame& frame = newest_frame(*session);
        EXPECT_FALSE(frame.statistics.diverged);
        EXPECT_FALSE(frame.statistics.paused);
        EXPECT_TRUE(frame.statistics.message.empty()) << frame.statistics.message;
        EXPECT_EQ(frame.drug.playing, !std::holds_alternative<ResetWorld>(command));
        EXPECT_EQ(furthest_from_rest_mm(*session) < 1e-6,
                  std::holds_alternative<ResetWorld>(command));
    }
}

// A world that stands still and has a great surface: the frame is all that a step costs.
TEST(Session, TheTimeOfAStepHoldsItsFrame) {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    std::vector<Vec3>& vertices = patient->surface.vertices_mm;
    const std::vector<Vec3> once = vertices;
    while (vertices.size() < 200'000) vertices.insert(vertices.end(), once.begin(), once.end());
    SceneSpec flow_only;
    flow_only.deform.reset();
    Job job;
    Session session(patient, flow_only, job);
    session.post(SetPaused{true});
    play(session, 5);
    double counted_ms = 0.0;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 50; ++i) {
        counted_ms += session.step().step_ms;
        session.update_frame();
        EXPECT_GT(session.frame().statistics.step_ms, 0.0);
    }
    const std::chrono::duration<double, std::milli> passed =
        std::chrono::steady_clock::now() - start;
    EXPECT_GT(counted_ms, 0.5 * passed.count());
    EXPECT_LE(counted_ms, passed.count());
}

TEST(Session, AResetIsTheStateThatARestoreGoesBackTo) {
    const auto session = new_session();
    session->post(GrabPoint{middle_of(small_patient()->tree, 0)});
    session->post(MoveGrab{middle_of(small_patient()->tree, 0) + Vec3(5, 0, 0)});
    play(*session, 130);  // two snapshots of the pulled body have been kept
    session->post(ResetWorld{});
    play(*session, 2);
    session->post(RestoreSnapshot{});
    play(*session, 1);
    const auto& rest = small_patient()->mesh.vertices_mm;
    for (std::size_t v = 0; v < rest.size(); ++v)
        EXPECT_LT((session->world().vertex_mm(static_cast<int>(v)) - rest[v]).norm(), 1e-9);
}

TEST(Session, GivesTheSameStatesForAnyNumberOfThreads) {
    std::uint64_t first = 0;
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        const auto session = new_session();
        const auto recording = keep_recording(*session);
        const std::uint64_t hash = play_script(*session);
        if (first == 0) first = hash;
        EXPECT_EQ(hash, first) << threads << " threads";
    }
}

TEST(Session, ReplaysToTheLastBitAndSaysWhereItDiverges) {
    const auto session = new_session();
    const auto kept = keep_recording(*session);
    const std::uint64_t end = play_script(*session);
    Recording recording = *kept;
    Job job;
    const ReplayResult same = replay(recording, small_patient(), job);
    EXPECT_EQ(same.steps, 90u);
    EXPECT_FALSE(same.diverged_at.has_value());
    EXPECT_EQ(same.state_hash, end);

    recording.steps[39].commands = {MoveGrab{Vec3(1, 2, 3)}};
    EXPECT_EQ(replay(recording, small_patient(), job).diverged_at, 40u);
    recording.patient_hash ^= 1;
    EXPECT_THROW(replay(recording, small_patient(), job), InputError);
}

TEST(Session, RunsOnItsOwnThreadAtItsRate) {
    const auto session = new_session();
    std::uint64_t frames = 0, last = 0;
    {
        std::jthread simulation([&](const std::stop_token& stop) { session->run(stop); });
        const auto start = std::chrono::steady_clock::now();
        while (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(500)) {
            session->post(GrabPoint{middle_of(small_patient()->tree, 0)});
            if (session->update_frame()) {
                EXPECT_GE(session->frame().step, last);
                last = session->frame().step;
                ++frames;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }
    EXPECT_GT(frames, 2u);
    EXPECT_LE(last, 32u);  // half a second at 60 Hz, never faster
}

}  // namespace
}  // namespace hepatica
