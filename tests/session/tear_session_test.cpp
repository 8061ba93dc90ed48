// SPDX-License-Identifier: GPL-3.0-or-later
// A session in which the vessels tear: cut lines and a blade, what the frame shows of it, what
// bleeds, and that all of it plays again. torn_drug_session_test.cpp has what a drug does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/scene/bleeding.h"
#include "core/scene/deform_part.h"
#include "core/scene/world.h"
#include "core/scene/world_checkpoint.h"
#include "core/session/script.h"
#include "tests/session/cut_vessel.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"

namespace hepatica {
namespace {

using test::blade;
using test::keep_recording;
using test::middle_of;
using test::new_session;
using test::of_portal_veins;
using test::play;
using test::small_patient;
using test::that_tears;
using testing::HasSubstr;

// Across the first branch.
CutLine line() {
    const Vec3 at = middle_of(small_patient()->tree, 0);
    return {at, at, 0.01};
}

// The far end of what is cut is pulled along the vessel until something gives.
TearReport pull(Session& session, int steps) {
    const auto& points = small_patient()->tree.segments[0].points_mm;
    const Vec3 along = (points.back() - points.front()).normalized();
    session.post(GrabPoint{points.back()});
    SessionStep last;
    for (int i = 0; i < steps; ++i) {
        session.post(MoveGrab{points.back() + 0.15 * (i + 1) * along});
        last = session.step();
    }
    return last.deform.tear;
}

TEST(TearSession, AVesselTearsAlongItsCutLine) {
    const auto session = new_session(that_tears());
    session->post(line());
    const TearReport torn = pull(*session, 120);
    EXPECT_GT(torn.joints_broken, 0);
    const auto& deform = *session->world().deform();
    const auto& places = deform.places();
    for (const Joint& joint : deform.torn()->joints()) {
        const auto sides = deform.torn()->sides(joint, 0);
        if (sides[0] == sides[1]) continue;
        EXPECT_NEAR((joint.centre_mm - middle_of(small_patient()->tree, 0)).norm(), 0.0, 8.0);
    }
    EXPECT_EQ(places.size(), session->world().vertex_count());
    EXPECT_LT(deform.mass_error_relative(), 1e-12);
}

// What was split but is bound still is no rim; what has come apart wholly has one.
TEST(TearSession, WhatIsBoundStillIsNotShownAsTorn) {
    const auto session = new_session(that_tears());
    session->post(line());
    int bound = 0, torn = 0;
    const auto& points = small_patient()->tree.segments[0].points_mm;
    const Vec3 along = (points.back() - points.front()).normalized();
    session->post(GrabPoint{points.back()});
    for (int i = 0; i < 120; ++i) {
        session->post(MoveGrab{points.back() + 0.15 * (i + 1) * along});
        const TearReport report = session->step().deform.tear;
        session->update_frame();
        const auto rims = session->frame().tear->rims;
        if (report.vertices_split == 0) continue;
        ASSERT_TRUE(rims);
        ASSERT_EQ(rims->size(), session->world().vertex_count());
        const auto shown = std::ranges::count(*rims, 1);
        ++(shown == 0 ? bound : torn);
        ASSERT_GE(shown, report.joints_broken > 0 ? 4 : 0);
    }
    EXPECT_GT(bound, 0);
    EXPECT_GT(torn, 0);
}

// What comes near its limit is told before it tears, where it will tear, and no more once it has.
TEST(TearSession, WhatIsNearItsLimitIsToldBeforeItTears) {
    const auto session = new_session(that_tears());
    session->post(line());
    session->step();
    session->update_frame();
    ASSERT_TRUE(session->frame().tear);
    EXPECT_EQ(session->frame().tear->loads, nullptr);
    const auto& points = small_patient()->tree.segments[0].points_mm;
    const Vec3 along = (points.back() - points.front()).normalized();
    session->post(GrabPoint{points.back()});
    for (int i = 0; i < 120; ++i) {
        session->post(MoveGrab{points.back() + 0.15 * (i + 1) * along});
        const SessionStep done = session->step();
        session->update_frame();
        const Frame& frame = session->frame();
        if (!frame.tear->loads) continue;
        EXPECT_EQ(done.deform.tear.joints_parted, 0);
        ASSERT_EQ(frame.tear->loads->size(), frame.positions_mm.size() / 3);
        const auto most = std::ranges::max_element(*frame.tear->loads);
        EXPECT_GE(*most, 0.5f);
        EXPECT_LT(*most, 1.0f);
        const int vertex = static_cast<int>(most - frame.tear->loads->begin());
        const Vec3 at = session->world().rest_positions_mm()[vertex];
        EXPECT_LT((at - middle_of(small_patient()->tree, 0)).norm(), 8.0);
        return;
    }
    FAIL() << "nothing came near its limit";
}

TEST(TearSession, ABladeCutsThroughAndItsStumpsBleed) {
    const auto session = of_portal_veins();
    const int pieces = session->step().deform.tear.pieces;
    session->post(blade());
    EXPECT_EQ(session->step().deform.tear.pieces, pieces + 1);
    session->update_frame();
    const Frame& frame = session->frame();
    ASSERT_TRUE(frame.tear);
    EXPECT_EQ(frame.tear->pieces, pieces + 1);
    EXPECT_EQ(frame.positions_mm.size(), 3 * session->world().vertex_count());
    ASSERT_EQ(frame.tear->origins->size(), session->world().vertex_count());
    EXPECT_EQ(std::ranges::count(*frame.tear->rims, 1) % 2, 0);
    EXPECT_GT(std::ranges::count(*frame.tear->rims, 1), 8);
    const double leak = session->world().bleeding()->leak_g_s();
    EXPECT_GT(leak, 0.5 * RestingFlow{}.portal_g_s);
    EXPECT_LT(leak, 1.001 * RestingFlow{}.portal_g_s);
    const double before = session->world().bleeding()->leaked_g();
    play(*session, 60);
    EXPECT_NEAR(session->world().bleeding()->leaked_g() - before, leak, 1e-9 * leak);
}

// What bleeds is shown from the first drop on, where a pull tears it as well.
TEST(TearSession, WhereItBleedsIsToldFromTheFirstDrop) {
    const auto session = of_portal_veins();
    session->post(line());
    const auto& points = small_patient()->tree.segments[0].points_mm;
    const Vec3 along = (points.back() - points.front()).normalized();
    session->post(GrabPoint{points.back()});
    int bled = 0;
    for (int i = 0; i < 240; ++i) {
        session->post(MoveGrab{points.back() + 0.15 * (i + 1) * along});
        session->step();
        session->update_frame();
        const TearView& tear = *session->frame().tear;
        if (tear.leak_g_s <= 0.0) continue;
        ++bled;
        ASSERT_FALSE(tear.leaks.empty()) << "step " << i;
        double shares = 0.0;
        for (const LeakView& leak : tear.leaks) shares += leak.share;
        EXPECT_NEAR(shares, 1.0, 1e-9);
    }
    EXPECT_GT(bled, 0);
}

// A body that sleeps goes on bleeding: what is lost is told as long as it is.
TEST(TearSession, WhatBleedsDoesNotRest) {
    const auto session = of_portal_veins();
    session->post(blade());
    SessionStep last = play(*session, 200);  // the blade goes through
    for (int i = 0; i < 2000 && !last.deform.asleep; ++i) last = session->step();
    ASSERT_TRUE(last.deform.asleep);
    ASSERT_GT(session->world().bleeding()->leak_g_s(), 0.0);
    session->update_frame();
    EXPECT_FALSE(session->frame().statistics.resting);
    session->post(ResetWorld{});
    for (int i = 0; i < 2000 && !session->frame().statistics.resting; ++i) {
        session->step();
        session->update_frame();
    }
    EXPECT_TRUE(session->frame().statistics.resting);
}

TEST(TearSession, AResetGivesTheWholeVesselBack) {
    const auto session = new_session(that_tears());
    const std::size_t vertices = session->world().vertex_count();
    const std::uint64_t version = session->world().topology().version();
    session->post(blade());
    session->step();
    EXPECT_GT(session->world().vertex_count(), vertices);
    const std::uint64_t torn = session->world().topology().version();
    session->post(ResetWorld{});
    session->step();
    EXPECT_EQ(session->world().vertex_count(), vertices);
    EXPECT_NE(session->world().topology().version(), torn);
    EXPECT_NE(session->world().topology().version(), version);
    EXPECT_EQ(session->world().bleeding()->leaked_g(), 0.0);
    EXPECT_EQ(*session->world().topology().triangles(), boundary_triangles(small_patient()->mesh));
}

TEST(TearSession, TheRecordingPlaysAgainFromItsStartAndFromAKeyframeInATear) {
    const auto session = new_session(that_tears());
    const auto recording = keep_recording(*session);
    session->post(line());
    play(*session, 520);
    pull(*session, 120);  // over the keyframe at 600
    session->post(blade());
    play(*session, 20);
    session->post(RestoreSnapshot{});
    play(*session, 5);
    session->post(SetWall{0.5});  // another body, torn like this one
    play(*session, 5);
    test::expect_to_play_again(*session, *recording, {620});
}

// As the window does it: nothing is built for it until somebody wants it.
TEST(TearSession, TearingComesAndGoesWithItsPartOfTheScene) {
    const auto session = new_session();
    session->post(blade());
    session->step();
    session->update_frame();
    EXPECT_THAT(session->frame().statistics.message, HasSubstr("nothing tears"));
    EXPECT_FALSE(session->frame().tear);
    session->post(UseTear{true, 0.5});
    session->post(blade());
    session->step();
    session->update_frame();
    ASSERT_TRUE(session->frame().tear);
    EXPECT_GT(session->frame().tear->pieces, 1);
    session->post(UseTear{false, 1.0});
    session->step();
    session->update_frame();
    EXPECT_FALSE(session->frame().tear);
    EXPECT_EQ(session->world().vertex_count(), small_patient()->mesh.vertices_mm.size());
}

// The last good state is torn, but tearing has ended since: the frame after an error is of the
// whole body in all its parts.
TEST(TearSession, AfterAnErrorTheFrameIsOfTheBodyThatNoLongerTears) {
    const auto session = new_session(that_tears());
    bool fails = false;
    session->record([&fails](const RecordedStep&) {
        if (fails) throw std::runtime_error("the disk is full");
    });
    session->post(blade());
    play(*session, 60);  // up to the last good state
    const std::size_t whole = small_patient()->mesh.vertices_mm.size();
    ASSERT_GT(session->world().vertex_count(), whole);
    session->post(UseTear{false, 1.0});
    session->step();
    ASSERT_EQ(session->world().vertex_count(), whole);
    fails = true;
    session->step();
    session->step();  // goes back
    session->update_frame();
    const Frame& frame = session->frame();
    ASSERT_TRUE(frame.statistics.diverged);
    EXPECT_FALSE(frame.tear);
    EXPECT_EQ(frame.positions_mm.size(), 3 * whole);
    EXPECT_EQ(session->world().topology().vertex_count(), whole);
    EXPECT_EQ(*frame.surface, boundary_triangles(small_patient()->mesh));
}

// Also factors that a keyframe of the recording could not be read with.
TEST(TearSession, AFactorOutOfRangeChangesNothing) {
    const auto session = new_session();
    session->post(UseSetting{{.order = ElementOrder::quadratic}});
    session->step();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const double factor : {0.0, -1.0, 0.9e-6, 1.1e9, infinite, std::nan("")}) {
        session->post(UseTear{true, factor});
        session->step();
        session->update_frame();
        EXPECT_THAT(session->frame().statistics.message, HasSubstr("tear factor")) << factor;
        EXPECT_FALSE(session->world().deform()->tears()) << factor;
        EXPECT_EQ(session->world().deform()->setting().order, ElementOrder::quadratic) << factor;
    }
    for (const double factor : {least_tear_factor, greatest_tear_factor}) {
        EXPECT_NO_THROW(validate_tear_factor(factor));
        EXPECT_EQ(tear_from_json(to_json(TearSpec{.tear_factor = factor})).tear_factor, factor);
    }
}

// As before, with what cannot tear; the setting in use stays.
TEST(TearSession, TheWholeDialIsBackOnceNothingTearsAnyMore) {
    const auto session = new_session();
    const StepperOptions exact{.order = ElementOrder::quadratic};
    session->use_dial(QualityDial({{{}, 1.0, 0.2, "mixed"}, {exact, 9.0, 0.1, "mixed"}}));
    const auto order_at = [&](double quality) {
        session->post(SetQuality{quality});
        session->step();
        return session->world().deform()->setting().order;
    };
    EXPECT_EQ(order_at(1.0), ElementOrder::quadratic);
    session->post(UseTear{true, 1.0});
    session->step();
    EXPECT_EQ(order_at(1.0), ElementOrder::linear);
    session->post(UseTear{false, 1.0});
    session->step();
    session->update_frame();
    EXPECT_EQ(session->world().deform()->setting().order, ElementOrder::linear);
    EXPECT_EQ(session->frame().statistics.expected_error, 0.2);
    EXPECT_EQ(order_at(1.0), ElementOrder::quadratic);
}

// Tearing may have begun, or ended, between the start of the session and the keyframe.
TEST(TearSession, TheDialIsThatOfTheKeyframeThatIsRestored) {
    const StepperOptions exact{.order = ElementOrder::quadratic};
    const auto session = new_session();
    session->use_dial(QualityDial({{{}, 1.0, 0.2, "mixed"}, {exact, 9.0, 0.1, "mixed"}}));
    session->step();
    const Keyframe whole{.world = session->world().checkpoint()};
    const auto other = new_session();
    other->post(UseTear{true, 1.0});
    other->step();
    const Keyframe torn{.world = other->world().checkpoint()};
    const auto finest = [&] {
        session->post(SetQuality{1.0});
        session->step();
        session->update_frame();
        return session->frame().statistics.expected_error;
    };
    session->restore(torn);
    EXPECT_EQ(finest(), 0.2);
    EXPECT_EQ(session->frame().statistics.message, "") << "it asked for one that cannot tear";
    session->restore(whole);
    EXPECT_EQ(finest(), 0.1);
}

// Neither the dial nor the commands of that step are lost.
TEST(TearSession, RefusesADialOfWhichNothingTearsAndKeepsItsOwn) {
    const auto session = new_session(that_tears());
    session->post(SetQuality{0.0});
    session->step();
    session->update_frame();
    const std::string reference = session->frame().statistics.error_reference;
    ASSERT_FALSE(reference.empty());
    session->use_dial(
        QualityDial({{{.order = ElementOrder::quadratic}, 1.0, 0.1, "another dial"}}));
    session->post(SetGravity{Vec3(0, 0, -500)});
    session->step();
    session->update_frame();
    EXPECT_THAT(session->frame().statistics.message, HasSubstr("none of its settings can tear"));
    EXPECT_FALSE(session->frame().statistics.diverged);
    EXPECT_FALSE(session->frame().statistics.paused);
    EXPECT_EQ(session->world().deform()->settings().gravity_mm_per_s2, Vec3(0, 0, -500));
    EXPECT_EQ(session->frame().statistics.error_reference, reference);
    session->post(SetQuality{1.0});
    session->step();
    session->update_frame();
    EXPECT_THAT(session->frame().statistics.message, testing::Not(HasSubstr("the dial")));
    EXPECT_EQ(session->frame().statistics.error_reference, reference);
}

TEST(TearSession, SaysWhatIsWrongWithALine) {
    const auto session = new_session(that_tears());
    CutLine wrong = line();
    wrong.strength = 2.0;
    session->post(wrong);
    session->step();
    session->update_frame();
    EXPECT_THAT(session->frame().statistics.message, HasSubstr("strength along a cut line"));
}

TEST(TearSession, ShowsACutLineUntilItHasTorn) {
    const auto session = new_session(that_tears());
    play(*session, 2);
    session->update_frame();
    ASSERT_TRUE(session->frame().tear);
    EXPECT_EQ(session->frame().tear->weak_edges, nullptr);
    session->post(line());
    play(*session, 1);
    session->update_frame();
    const Frame& frame = session->frame();
    ASSERT_NE(frame.tear->weak_edges, nullptr);
    const auto shown = frame.tear->weak_edges;
    ASSERT_GE(shown->size(), 3u) << "a ring around the vessel";
    const auto place = [&](int v) {
        const auto i = 3 * static_cast<std::size_t>(v);
        return Vec3(frame.positions_mm[i], frame.positions_mm[i + 1], frame.positions_mm[i + 2]);
    };
    const Vec3 at = middle_of(small_patient()->tree, 0);
    for (const auto& [a, b] : *shown) {
        EXPECT_LT(a, b);
        EXPECT_LT((place(a) - at).norm(), 12.0) << "at the line, and nowhere else";
        EXPECT_LT((place(a) - place(b)).norm(), 6.0) << "an edge";
    }
    play(*session, 1);
    session->update_frame();
    EXPECT_EQ(session->frame().tear->weak_edges, shown) << "found once";
    pull(*session, 120);
    session->update_frame();
    const auto left = session->frame().tear->weak_edges;
    EXPECT_TRUE(left == nullptr || left->size() < shown->size()) << "what has torn is no line";
    session->post(ResetWorld{});
    play(*session, 1);
    session->update_frame();
    EXPECT_EQ(session->frame().tear->weak_edges, nullptr);
}

}  // namespace
}  // namespace hepatica
