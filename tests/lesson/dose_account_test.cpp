// SPDX-License-Identifier: GPL-3.0-or-later
// Doses against conservation, against flows solved apart, and against each other.
#include "core/lesson/dose_account.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stop_token>
#include <thread>

#include "core/base/error.h"
#include "core/scene/drug_arrival.h"
#include "core/scene/world.h"
#include "core/scene/world_checkpoint.h"
#include "tests/mesh/random_tree.h"
#include "tests/session/new_session.h"

namespace hepatica {
namespace {

const VesselTree& tree() {
    static const VesselTree grown = test::random_tree(5, 3, 4.0);
    return grown;
}

TreePoint middle_of_segment(int segment) {
    return {segment, 0.5 * length_mm(tree().segments[segment])};
}

InjectionOptions into(const TreePoint& at, double void_fraction = 0.0) {
    return injection_options({.at = at, .mass_flow_g_s = 3.0, .void_fraction = void_fraction},
                             tree());
}

TargetRegion from(int segment) {
    return {tree(), {segment, 0.0}};
}

constexpr double end_s = 20.0;

TEST(DoseCurve, WhatIsInjectedIsTheRateTimesTheTime) {
    const DoseCurve curve(tree(), into({0, 0.0}), end_s, {});
    for (const double t : {0.0, 0.013, 1.7, 19.99, 20.0})
        EXPECT_NEAR(curve.at(t).injected_g, 3.0 * t, 1e-9 * (1.0 + t));
    EXPECT_NEAR(curve.at(1e9).injected_g, 60.0, 1e-8) << "clamped to the run";
}

// From a tip at the end of a vessel everything may have been reached at once.
TEST(DoseCurve, OfARunWithoutTimeIsNothing) {
    for (const double none_s : {0.0, 1e-8}) {
        const Dose dose = DoseCurve(tree(), into({0, 0.0}), none_s, from(0)).at(none_s);
        EXPECT_NEAR(dose.injected_g, 3.0 * none_s, 1e-12);
        EXPECT_NEAR(dose.delivered_g, 0.0, 1e-12);
    }
}

// Two branches leave the trunk: what one of them delivers is what the other one does not.
TEST(DoseCurve, DosesOfTheBranchesAddUpToWhatIsDelivered) {
    const std::vector<std::vector<int>> kids = children(tree());
    ASSERT_EQ(kids[0].size(), 2u);
    for (const double share : {0.0, 0.5}) {
        const InjectionOptions options = into(middle_of_segment(kids[0][0]), share);
        const DoseCurve left(tree(), options, end_s, from(kids[0][0]));
        const DoseCurve right(tree(), options, end_s, from(kids[0][1]));
        for (const double t : {3.0, 11.1, 20.0}) {
            const Dose a = left.at(t), b = right.at(t);
            EXPECT_GT(a.delivered_g, 0.0);
            EXPECT_LE(a.delivered_g, a.injected_g);
            EXPECT_NEAR(a.target_g + b.target_g, a.delivered_g, 1e-9 * a.injected_g);
            EXPECT_NEAR(a.elsewhere_g(), b.target_g, 1e-9 * a.injected_g);
        }
    }
}

// The whole tree as target: all of it; and from the root nothing runs back.
TEST(DoseCurve, OfTheWholeTreeIsAllThatIsDelivered) {
    const Dose all = DoseCurve(tree(), into({0, 0.0}), end_s, from(0)).at(end_s);
    EXPECT_GT(all.delivered_g, 1.0);
    EXPECT_NEAR(all.target_g, all.delivered_g, 1e-9);
    EXPECT_NEAR(all.reflux_g, 0.0, 1e-9);
}

// To the last bit, at any time: a table showed -0.0000 g elsewhere, and a share above 1.
TEST(DoseCurve, WhereAllReachesTheTargetNothingIsElsewhere) {
    const DoseCurve curve(tree(), into({0, 0.0}, 0.5), end_s, from(0));
    for (int tenth = 0; tenth <= 10 * static_cast<int>(end_s); ++tenth) {
        const Dose dose = curve.at(0.1 * tenth + 0.003);
        EXPECT_EQ(dose.elsewhere_g(), 0.0) << tenth;
        EXPECT_EQ(dose.target_g, dose.delivered_g) << tenth;
    }
}

// What goes elsewhere is a sum of masses, and no sum of masses is negative.
TEST(DoseCurve, NoMoreReachesATargetThanIsDelivered) {
    const std::vector<int> branches = children(tree())[0];
    for (const int branch : branches) {
        const DoseCurve curve(tree(), into(middle_of_segment(branch)), end_s, from(branch));
        for (int tenth = 0; tenth <= 10 * static_cast<int>(end_s); ++tenth)
            EXPECT_GE(curve.at(0.1 * tenth + 0.003).elsewhere_g(), 0.0) << branch << ' ' << tenth;
    }
}

// Once everything is full, each territory gets its share of the steady flow.
TEST(DoseCurve, GrowsByTheTerritorysFlowOnceItIsFull) {
    const int branch = children(tree())[0][0];
    InjectionOptions options = into({0, 0.0});
    options.until_s = end_s;
    Job job;
    const InjectionResult steady = inject(tree(), options, job);
    const DoseCurve curve(tree(), options, end_s, from(branch));
    const double grown = curve.at(20.0).target_g - curve.at(19.0).target_g;
    EXPECT_NEAR(grown, end_flow_g_s(steady, branch), 1e-6);
}

TEST(DoseCurve, RefluxIsWhatLeavesUpstreamOfTheTip) {
    const int branch = children(tree())[0][0];
    const InjectionOptions options = into(middle_of_segment(branch));
    const Dose dose = DoseCurve(tree(), options, end_s, from(branch)).at(end_s);
    EXPECT_GT(dose.reflux_g, 0.01);
    EXPECT_NEAR(dose.reflux_g, dose.elsewhere_g(), 1e-9 * dose.injected_g)
        << "the branch that holds the tip is the target";
}

TEST(DoseCurve, WhatLeaksAtATearIsDeliveredNowhere) {
    const int branch = children(tree())[0][0];
    InjectionOptions options = into({0, 0.0});
    const Dose whole = DoseCurve(tree(), options, end_s, from(branch)).at(end_s);
    options.tears = {middle_of_segment(branch)};
    options.tear_areas_mm2 = {3.0};
    const Dose torn = DoseCurve(tree(), options, end_s, from(branch)).at(end_s);
    EXPECT_NEAR(torn.injected_g, whole.injected_g, 1e-9);
    EXPECT_GT(whole.target_g, 1.0);
    EXPECT_NEAR(torn.target_g, 0.0, 1e-9);
    EXPECT_GT(torn.elsewhere_g(), 0.0) << "into the other branch";
}

// The trunk tears half way through the run: from then on all that comes is lost.
TEST(DoseCurve, WhatComesToALaterTearIsLost) {
    InjectionOptions options = into({0, 0.0});
    const double torn_s = 0.5 * end_s;
    options.later_tears = {{torn_s, {middle_of_segment(0)}, {3.0}, {0}}};
    const DoseCurve whole(tree(), into({0, 0.0}), end_s, from(0));
    const DoseCurve torn(tree(), options, end_s, from(0));
    EXPECT_NEAR(torn.at(0.9 * torn_s).delivered_g, whole.at(0.9 * torn_s).delivered_g, 1e-9);
    const Dose then = torn.at(torn_s), last = torn.at(end_s);
    EXPECT_GT(then.delivered_g, 1.0);
    EXPECT_NEAR(last.delivered_g, then.delivered_g, 1e-9);
    EXPECT_GT(last.injected_g, then.injected_g);
}

TEST(DoseAccount, AddsUpInjectionsAsFarAsTheyWent) {
    const auto options = std::make_shared<const InjectionOptions>(into({0, 0.0}));
    DrugView drug;
    drug.injection = options;
    drug.injections = 1;
    drug.end_s = end_s;
    drug.time_s = 5.0;
    DoseAccount account(tree(), from(0));
    account.see(drug);
    EXPECT_NEAR(account.total().injected_g, 15.0, 1e-9);
    DrugView none;
    none.injections = 1;
    account.see(none);
    EXPECT_NEAR(account.total().injected_g, 15.0, 1e-9) << "taken out";
    drug.injection = std::make_shared<const InjectionOptions>(*options);
    drug.injections = 2;
    drug.time_s = 2.0;
    account.see(drug);
    EXPECT_NEAR(account.total().injected_g, 21.0, 1e-9);
}

// The curve is computed by a thread of its own, with the same numbers.
TEST(DoseAccount, OfADrugUnlikeBloodIsThatOfItsInjection) {
    DrugView drug;
    drug.injection = std::make_shared<const InjectionOptions>(into({0, 0.0}, 0.5));
    drug.injections = 1;
    drug.end_s = end_s;
    InjectionOptions run = *drug.injection;
    run.until_s = end_s;
    run.step_s = end_s / 500.0;
    Job job;
    const InjectionResult whole = inject(tree(), run, job);
    DoseAccount account(tree(), from(0));
    for (const double time_s : {0.02, 5.0, end_s}) {
        drug.time_s = time_s;
        account.see(drug);
    }
    EXPECT_EQ(account.total().delivered_g, whole.series.back().delivered_g);
    EXPECT_EQ(account.total().injected_g, whole.series.back().injected_g);
}

TEST(DoseCurve, WhatCannotFlowIsSaidAlthoughAnotherThreadFindsIt) {
    InjectionOptions options = into({0, 0.0});
    options.tip->segment = 99;
    const DoseCurve curve(tree(), options, end_s, {});
    EXPECT_THROW(curve.at(1.0), InputError);
    EXPECT_THROW(curve.at(end_s), InputError) << "again";
}

// Holds a computation back until it is opened. A test that fails opens it late instead of hanging.
class Gate {
  public:
    void open() {
        const std::scoped_lock lock(mutex_);
        open_ = true;
        opened_.notify_all();
    }
    void pass() {
        std::unique_lock lock(mutex_);
        passed_by_ = std::this_thread::get_id();
        if (!opened_.wait_for(lock, std::chrono::seconds(30), [&] { return open_; })) late_ = true;
        open_ = true;
    }
    bool late() const {
        const std::scoped_lock lock(mutex_);
        return late_;
    }
    std::thread::id passed_by() const {
        const std::scoped_lock lock(mutex_);
        return passed_by_;
    }

  private:
    mutable std::mutex mutex_;
    std::condition_variable opened_;
    bool open_ = false, late_ = false;
    std::thread::id passed_by_;
};

TEST(DoseCurve, IsComputedBesideTheThreadThatAsks) {
    Gate gate;
    const DoseCurve curve(tree(), into({0, 0.0}, 0.5), end_s, {}, [&](JobEvent) { gate.pass(); });
    gate.open();
    EXPECT_FALSE(gate.late()) << "the constructor waited";
    EXPECT_NEAR(curve.at(end_s).injected_g, 3.0 * end_s, 1e-6);
    EXPECT_NE(gate.passed_by(), std::thread::id());
    EXPECT_NE(gate.passed_by(), std::this_thread::get_id());
}

TEST(DoseCurve, IsNotWaitedForOnceAStopIsRequested) {
    Gate gate;
    std::stop_source source;
    const DoseCurve curve(tree(), into({0, 0.0}, 0.5), end_s, {}, [&](JobEvent) {
        source.request_stop();
        gate.pass();
    });
    EXPECT_THROW(curve.at(end_s, source.get_token()), Cancelled);
    gate.open();
    EXPECT_FALSE(gate.late()) << "it waited for the end";
    const Dose whole = curve.at(end_s);
    EXPECT_NEAR(whole.injected_g, 3.0 * end_s, 1e-6) << "for those who wait it goes on";
    EXPECT_EQ(curve.at(end_s, source.get_token()).injected_g, whole.injected_g)
        << "what is known needs no waiting";
}

// A play of the small patient whose drug is weighed in every frame.
struct WeighedPlay {
    WeighedPlay() {
        SceneSpec scene;
        scene.deform.reset();
        session = test::new_session(scene);
    }
    void play(int steps) {
        for (int i = 0; i < steps; ++i) {
            session->step();
            session->update_frame();
            account.see(drug());
        }
    }
    void inject(double mass_flow_g_s) {
        session->post(InjectDrug{.point_mm = test::small_patient()->tree.nodes[0].position_mm,
                                 .mass_flow_g_s = mass_flow_g_s});
    }
    const DrugView& drug() const { return session->frame().drug; }

    std::unique_ptr<Session> session;
    DoseAccount account{test::small_patient()->tree, {}};
};

// What the session shows can be weighed, though it would take years to fill the vessels; what could
// not be is refused there.
TEST(DoseAccount, TheLeastInjectionThatIsShownIsWeighed) {
    for (const double mass_flow_g_s : {1e-12, 1e-9}) {
        WeighedPlay play;
        play.inject(mass_flow_g_s);
        play.play(6);
        ASSERT_TRUE(play.drug().injection);
        EXPECT_NEAR(play.account.total().injected_g, mass_flow_g_s * play.drug().time_s,
                    1e-6 * mass_flow_g_s);
    }
    WeighedPlay play;
    play.inject(1e-13);
    play.play(1);
    EXPECT_FALSE(play.drug().injection);
    const std::string said = play.session->frame().statistics.message;
    EXPECT_NE(said.find("mass flow in g/s is 1e-13"), std::string::npos) << said;
    EXPECT_NE(said.find("Give a value from 1e-12"), std::string::npos) << said;
}

TEST(DoseAccount, WhereThePlayGoesBackAnInjectionCountsOnce) {
    WeighedPlay play;
    play.inject(2.0);
    play.play(70);
    ASSERT_LT(play.drug().time_s, play.drug().end_s);
    ASSERT_NEAR(play.account.total().injected_g, 2.0 * play.drug().time_s, 1e-9);
    const auto injected = play.drug().injection;
    play.session->post(RestoreSnapshot{});
    play.play(1);
    EXPECT_NEAR(play.drug().time_s, 61.0 / 60.0, 1e-9) << "the snapshot is of step 60";
    EXPECT_EQ(play.drug().injection, injected) << "its curves need not be computed again";
    EXPECT_NEAR(play.account.total().injected_g, 2.0 * play.drug().time_s, 1e-9);
    play.play(5);
    play.inject(1.0);  // replaces it, and is undone
    play.play(5);
    EXPECT_GT(play.account.total().injected_g, 2.0 * 66.0 / 60.0);
    play.session->post(RestoreSnapshot{});
    play.play(1);
    EXPECT_NEAR(play.account.total().injected_g, 2.0 * play.drug().time_s, 1e-9);
}

TEST(DoseAccount, WhereThePlayGoesBackToBeforeAnInjectionNothingWasInjected) {
    WeighedPlay play;
    play.play(62);
    play.inject(2.0);
    play.play(20);
    EXPECT_GT(play.account.total().injected_g, 0.5);
    play.session->post(RestoreSnapshot{});
    play.play(1);
    EXPECT_EQ(play.account.total().injected_g, 0.0);
    play.inject(3.0);
    play.play(10);
    EXPECT_NEAR(play.account.total().injected_g, 3.0 * play.drug().time_s, 1e-9);
}

// A keyframe that was read from a file knows the injection by its values alone.
TEST(DoseAccount, AnInjectionOfAKeyframeThatWasReadCountsOnce) {
    WeighedPlay play;
    play.inject(2.0);
    play.play(30);
    const std::string text = to_json(play.session->world().checkpoint()).dump();
    WeighedPlay later;
    later.session->restore(
        {.world = world_checkpoint_from_json(nlohmann::ordered_json::parse(text))});
    later.play(20);
    EXPECT_NEAR(later.account.total().injected_g, 2.0 * 50.0 / 60.0, 1e-9);
    later.session->post(RestoreSnapshot{});
    later.play(1);
    EXPECT_NEAR(later.account.total().injected_g, 2.0 * 31.0 / 60.0, 1e-9);
}

TEST(TargetRegion, IsTheAnatomyBeyondThePlace) {
    const int branch = children(tree())[0][0];
    const TargetRegion region(tree(), {branch, 5.0});
    EXPECT_FALSE(region.contains({0, 1.0}));
    EXPECT_FALSE(region.contains({branch, 4.9}));
    EXPECT_TRUE(region.contains({branch, 5.0}));
    const std::vector<std::vector<int>> kids = children(tree());
    ASSERT_EQ(kids[branch].size(), 2u);
    for (const int child : kids[branch]) EXPECT_TRUE(region.contains({child, 0.0}));
    EXPECT_FALSE(region.contains({children(tree())[0][1], 1.0}));
    EXPECT_FALSE(region.contains_end_of(0));
    EXPECT_TRUE(region.contains_end_of(branch));
}

TEST(TargetRegion, OfASegmentThatTheTreeLacksIsRefused) {
    const int count = static_cast<int>(tree().segments.size());
    EXPECT_NO_THROW(TargetRegion(tree(), {count - 1, 0.0}));
    for (const int segment : {-1, count, count + 1})
        EXPECT_THROW(TargetRegion(tree(), {segment, 0.0}), InputError) << segment;
}

// Hepatic veins lead away from a tumour: the nearest vessel is not taken where it is one.
TEST(PlaceThatFeeds, IsTheNearestOfThePortalAndArterialVessels) {
    const auto line = [](VascularSystem system, double y) {
        VesselSegment segment;
        segment.points_mm = {Vec3(0, y, 0), Vec3(40, y, 0)};
        segment.radii_mm = {2.0, 2.0};
        segment.system = system;
        return segment;
    };
    VesselTree tree;
    tree.segments = {line(VascularSystem::portal, 30.0), line(VascularSystem::hepatic, 4.0),
                     line(VascularSystem::portal, -9.0), line(VascularSystem::artery, 8.0)};
    const Vec3 middle(25, 0, 0);
    EXPECT_LT((place_that_feeds(tree, middle) - Vec3(25, 8, 0)).norm(), 1e-9);
    tree.segments.pop_back();
    EXPECT_LT((place_that_feeds(tree, middle) - Vec3(25, -9, 0)).norm(), 1e-9);
    tree.segments = {line(VascularSystem::hepatic, 4.0), line(VascularSystem::unknown, 3.0)};
    EXPECT_LT((place_that_feeds(tree, middle) - Vec3(25, 3, 0)).norm(), 1e-9);
    EXPECT_THROW(place_that_feeds({}, middle), InputError);
}

}  // namespace
}  // namespace hepatica
