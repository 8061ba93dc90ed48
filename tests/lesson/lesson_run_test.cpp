// SPDX-License-Identifier: GPL-3.0-or-later
// Steps, limits and pass marks on frames made by hand, half a second each.
#include "core/lesson/lesson_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/scene/drug_arrival.h"
#include "tests/lesson/frames.h"
#include "tests/support/asked_to_stop.h"

namespace hepatica {
namespace {

using test::plain_lesson;
using test::rest_frame;
using test::small_patient;
using test::with_force;
using testing::ElementsAre;
using testing::HasSubstr;

Predicate at_least(Quantity quantity, double bound) {
    return {quantity, -1, true, bound};
}
Predicate at_most(Quantity quantity, double bound) {
    return {quantity, -1, false, bound};
}

// Pull with 2 mN for a second, then let go.
Lesson pull_lesson() {
    Lesson lesson = plain_lesson();
    lesson.tools = {LessonTool::pull};
    lesson.steps = {{"pull", "", {at_least(Quantity::force_mn, 2.0)}, 1.0, {}},
                    {"let go", "", {at_most(Quantity::force_mn, 0.0)}, 0.0, {}}};
    lesson.limits = {at_most(Quantity::force_mn, 10.0)};
    return lesson;
}

// Shown one frame each with these forces in mN, after the frame of the setup.
LessonRun attempt(const Lesson& lesson, const std::vector<double>& forces) {
    LessonRun run(lesson, small_patient());
    run.see({}, rest_frame());
    for (const double force : forces) run.see({}, with_force(1e3 * force));
    return run;
}

TEST(LessonRun, ReachesStepAfterStepAndIsPassed) {
    LessonRun run = attempt(pull_lesson(), {0.0, 3.0});
    EXPECT_EQ(run.standing().step, 0u);
    EXPECT_EQ(run.standing().steps[0].held_s, 0.5);
    EXPECT_TRUE(run.standing().steps[0].goal.empty()) << "not reached yet";
    run.see({}, with_force(4e3));
    EXPECT_EQ(run.standing().step, 1u);
    ASSERT_EQ(run.standing().steps[0].goal.size(), 1u);
    EXPECT_DOUBLE_EQ(run.standing().steps[0].goal[0].value, 4.0) << "what it came to then";
    EXPECT_TRUE(run.standing().steps[0].goal[0].kept);
    EXPECT_EQ(run.standing().steps[0].reached_s, 1.5);
    EXPECT_EQ(run.standing().outcome, LessonOutcome::running);
    run.see({}, rest_frame());
    EXPECT_EQ(run.standing().outcome, LessonOutcome::passed);
    EXPECT_EQ(run.standing().steps[1].reached_s, 2.0);
    EXPECT_EQ(run.samples().size(), 4u);
}

TEST(LessonRun, AHoldBeginsAnewAfterEveryBreak) {
    const LessonRun run = attempt(pull_lesson(), {3.0, 1.0, 3.0, 1.0, 3.0});
    EXPECT_EQ(run.standing().step, 0u);
    EXPECT_EQ(run.standing().steps[0].held_s, 0.5);
}

TEST(LessonRun, ABrokenLimitEndsItAndSaysByHowMuch) {
    LessonRun run = attempt(pull_lesson(), {3.0, 11.0});
    EXPECT_EQ(run.standing().outcome, LessonOutcome::failed);
    EXPECT_THAT(run.standing().reasons,
                ElementsAre("limit broken: force at most 10 mN, but it was 11 mN"));
    const LessonMetrics before = run.standing().metrics;
    run.see({}, with_force(50e3));
    EXPECT_EQ(run.standing().metrics, before) << "what comes later changes nothing";
}

// A tool of these parts in hand.
Frame with_parts(const std::vector<ToolView::Part>& parts) {
    Frame frame = rest_frame();
    frame.tool.emplace();
    frame.tool->parts = parts;
    return frame;
}

TEST(LessonRun, AGoalCountsOnlyWithTheToolThatItsStepNames) {
    const std::vector<ToolView::Part> sphere{{Vec3::Zero(), Vec3::Zero(), 2.0}};
    const std::vector<ToolView::Part> rod{{Vec3::Zero(), Vec3(0, 0, 9), 2.0}};
    const std::vector<ToolView::Part> jaws{{Vec3::Zero(), Vec3(0, 0, 9), 1.0},
                                           {Vec3(4, 0, 0), Vec3(4, 0, 9), 1.0}};
    const std::vector<ToolView::Part> hook{{Vec3::Zero(), Vec3(0, 0, 9), 1.0},
                                           {Vec3(0, 0, 9), Vec3(0, 4, 9), 1.0}};
    const std::vector<std::pair<LessonTool, Frame>> hands{
        {LessonTool::pull, with_force(0.0)},    {LessonTool::sphere, with_parts(sphere)},
        {LessonTool::capsule, with_parts(rod)}, {LessonTool::forceps, with_parts(jaws)},
        {LessonTool::hook, with_parts(hook)},
    };
    for (const auto& [asked, ignored] : hands)
        for (const auto& [taken, frame] : hands) {
            Lesson lesson = plain_lesson();
            lesson.steps = {{"wait", "", {at_least(Quantity::time_s, 0.5)}, 0.0, {}, asked}};
            LessonRun run(lesson, small_patient());
            run.see({}, rest_frame());
            EXPECT_TRUE(run.standing().tool_missing);
            run.see({}, frame);
            const bool right = asked == taken;
            const std::string which = std::string(name_of(asked)) + ", " + name_of(taken);
            EXPECT_EQ(run.standing().outcome == LessonOutcome::passed, right) << which;
            EXPECT_EQ(run.standing().tool_missing, !right) << which;
            const BoundStanding& goal =
                right ? run.standing().steps[0].goal.at(0) : run.standing().goal.at(0);
            EXPECT_EQ(goal.kept, right) << which;
        }
}

TEST(LessonRun, ALimitOfAStepHoldsForThatStepAlone) {
    Lesson lesson = pull_lesson();
    lesson.steps[0].limits = {at_most(Quantity::step_time_s, 1.5)};
    EXPECT_EQ(attempt(lesson, {0, 0, 0, 0}).standing().outcome, LessonOutcome::failed);
    EXPECT_EQ(attempt(lesson, {3, 3, 3, 3, 3, 3}).standing().outcome, LessonOutcome::running);
    lesson.steps[0].limits.clear();
    lesson.steps[1].limits = {at_most(Quantity::step_time_s, 1.5)};
    EXPECT_EQ(attempt(lesson, {0, 0, 0, 0, 3, 3, 3}).standing().outcome, LessonOutcome::running);
}

TEST(LessonRun, PassMarksAreLookedAtInTheEndAlone) {
    Lesson lesson = pull_lesson();
    lesson.pass = {at_least(Quantity::impulse_mn_s, 4.0)};
    EXPECT_EQ(attempt(lesson, {4, 4, 0}).standing().outcome, LessonOutcome::passed);
    const LessonRun missed = attempt(lesson, {3, 3, 0});
    EXPECT_EQ(missed.standing().outcome, LessonOutcome::failed);
    EXPECT_THAT(missed.standing().reasons, ElementsAre(HasSubstr("pass mark missed")));
}

// Half a second each; what ends before its end is not judged by them.
TEST(LessonRun, SaysHowPassMarksStandSoFar) {
    Lesson lesson = pull_lesson();
    lesson.pass = {at_most(Quantity::impulse_mn_s, 2.0)};
    lesson.limits = {at_most(Quantity::force_mn, 8.0)};
    const auto mark = [](const LessonRun& run) { return run.standing().pass.at(0); };
    const LessonRun one = attempt(lesson, {3});
    EXPECT_DOUBLE_EQ(mark(one).value, 1.5);
    EXPECT_TRUE(mark(one).kept);
    const LessonRun two = attempt(lesson, {3, 3});
    EXPECT_DOUBLE_EQ(mark(two).value, 3.0);
    EXPECT_FALSE(mark(two).kept);
    const LessonRun broken = attempt(lesson, {3, 9});
    ASSERT_EQ(broken.standing().outcome, LessonOutcome::failed);
    EXPECT_TRUE(std::isnan(mark(broken).value));
    EXPECT_FALSE(mark(broken).kept);
    LessonRun given_up = attempt(lesson, {3});
    given_up.end();
    EXPECT_TRUE(std::isnan(mark(given_up).value));
    const LessonRun done = attempt(lesson, {3, 3, 0});
    EXPECT_DOUBLE_EQ(mark(done).value, 3.0) << "what it was judged by";
}

TEST(LessonRun, ACourseMayAskForMore) {
    LessonRun run(pull_lesson(), small_patient(), {at_most(Quantity::time_s, 1.0)});
    run.see({}, rest_frame());
    for (const double force : {3.0, 3.0, 0.0}) run.see({}, with_force(1e3 * force));
    EXPECT_THAT(run.standing().reasons,
                ElementsAre("pass mark missed: time at most 1 s, but it is 1.5 s"));
}

TEST(Predicate, IsAddedOnce) {
    const Predicate time{Quantity::time_s, -1, false, 60.0},
        force{Quantity::force_mn, -1, false, 1};
    std::vector<Predicate> marks{time};
    EXPECT_EQ(add_new({time, force, force}, marks), std::vector{force}) << "what is new";
    EXPECT_EQ(marks, (std::vector{time, force}));
    EXPECT_TRUE(add_new({force, time}, marks).empty());
}

TEST(LessonRun, WhatEndsTooEarlyHasFailed) {
    LessonRun run = attempt(pull_lesson(), {3.0, 3.0});
    run.end();
    EXPECT_THAT(run.standing().reasons, ElementsAre("step 2 of 2 was not reached: let go"));
    LessonRun done = attempt(pull_lesson(), {3.0, 3.0, 0.0});
    done.end();
    EXPECT_EQ(done.standing().outcome, LessonOutcome::passed);
}

std::vector<std::string> reasons_after(const Command& command, const Lesson& lesson) {
    LessonRun run(lesson, small_patient());
    run.see({}, rest_frame());
    run.see(std::vector{command}, rest_frame());
    return run.standing().reasons;
}

TEST(LessonRun, OnlyTheLessonsToolsMayBeUsed) {
    const Lesson lesson = pull_lesson();
    for (const Command& command :
         {Command(GrabPoint{}), Command(MoveGrab{}), Command(ReleaseGrab{}), Command(UseTools{}),
          Command(SetPaused{}), Command(SetQuality{})})
        EXPECT_THAT(reasons_after(command, lesson), ElementsAre());
    for (const Command& command :
         {Command(AddTool{.kind = "forceps"}), Command(Blade{}), Command(CutLine{}),
          Command(InjectDrug{}), Command(SetTether{}), Command(UseTear{})})
        EXPECT_THAT(reasons_after(command, lesson), ElementsAre(HasSubstr("does not allow")));
    for (const Command& command : {Command(ResetWorld{}), Command(RestoreSnapshot{})})
        EXPECT_THAT(reasons_after(command, lesson), ElementsAre("the play was taken back"));
    Lesson with_hook = lesson;
    with_hook.tools = {LessonTool::hook};
    EXPECT_THAT(reasons_after(AddTool{.kind = "hook"}, with_hook), ElementsAre());
    EXPECT_THAT(reasons_after(AddTool{.kind = "sphere"}, with_hook),
                ElementsAre("the lesson does not allow this: probe"));
}

TEST(LessonRun, BeginsWithWhatTheLessonSetsUp) {
    Lesson lesson = pull_lesson();
    lesson.setup = script_of(
        R"({"actions": [{"do": "blade", "from_mm": [0, 0, 1], "to_mm": [0, 1, 1]}]})", "setup");
    LessonRun without(lesson, small_patient());
    without.see({}, rest_frame());
    EXPECT_EQ(without.standing().outcome, LessonOutcome::failed);
    LessonRun with(lesson, small_patient());
    ASSERT_EQ(with.setup().size(), 1u);
    with.see(with.setup(), rest_frame());
    EXPECT_EQ(with.standing().outcome, LessonOutcome::running);
    LessonRun early(pull_lesson(), small_patient());
    early.see(std::vector<Command>{GrabPoint{}}, rest_frame());
    EXPECT_THAT(early.standing().reasons, ElementsAre(HasSubstr("before the lesson began")));
}

// A session applies the newest of consecutive moves alone and records the dial as a setting.
TEST(LessonRun, BeginsWithASetupThatASessionRecordsInOtherWords) {
    Lesson lesson = pull_lesson();
    lesson.setup = script_of(R"({"actions": [
        {"do": "grab", "where": {"share_of_longest_path": 0.5}},
        {"do": "move", "by_mm": [1, 0, 0]}, {"do": "move", "by_mm": [0, 1, 0]},
        {"do": "set_quality", "quality": 0.5}]})",
                             "setup");
    LessonRun run(lesson, small_patient());
    ASSERT_EQ(run.setup().size(), 3u);
    const Vec3 grabbed = std::get<GrabPoint>(run.setup()[0]).point_mm;
    EXPECT_TRUE(std::get<MoveGrab>(run.setup()[1]).target_mm.isApprox(grabbed + Vec3(1, 1, 0)));
    std::vector<Command> recorded = run.setup();
    recorded[2] = UseSetting{};
    run.see(recorded, rest_frame());
    EXPECT_EQ(run.standing().outcome, LessonOutcome::running);
    LessonRun without(lesson, small_patient());
    recorded.pop_back();
    without.see(recorded, rest_frame());
    EXPECT_EQ(without.standing().outcome, LessonOutcome::failed);
}

// Without a frame between, in which nothing is held.
TEST(LessonRun, NothingGoesTheWayToWhereAnotherToolOrGrabIsTaken) {
    Lesson lesson = plain_lesson();
    lesson.tools = {LessonTool::pull, LessonTool::sphere};
    LessonRun run(lesson, small_patient());
    run.see({}, rest_frame());
    const std::vector<Command> tool{AddTool{}}, point{GrabPoint{}}, vertex{GrabVertex{}};
    run.see(tool, test::with_tip({0, 0, 0}));
    run.see({}, test::with_tip({3, 4, 0}));
    run.see(tool, test::with_tip({90, 0, 0}));
    run.see({}, test::with_tip({90, 2, 0}));
    EXPECT_DOUBLE_EQ(run.standing().metrics.path_mm, 5.0 + 2.0);
    Frame held = test::with_tip({50, 0, 0});
    held.statistics.paused = true;
    run.see(tool, held);
    run.see({}, test::with_tip({50, 1, 0}));
    EXPECT_DOUBLE_EQ(run.standing().metrics.path_mm, 7.0) << "also while the clock is held";
    const auto hand_at = [](const Vec3& target_mm) {
        Frame frame = with_force(0.0);
        frame.grab->target_mm = target_mm;
        return frame;
    };
    run.see(point, hand_at({0, 0, 0}));
    run.see({}, hand_at({0, 3, 0}));
    run.see(point, hand_at({40, 0, 0}));
    run.see(vertex, hand_at({80, 0, 0}));
    run.see({}, hand_at({80, 0, 1}));
    EXPECT_DOUBLE_EQ(run.standing().metrics.path_mm, 7.0 + 3.0 + 1.0);
    EXPECT_EQ(run.standing().outcome, LessonOutcome::running);
}

TEST(LessonRun, TheClockStandsWhileItIsHeld) {
    Frame held = with_force(3e3);
    held.statistics.paused = true;
    LessonRun run = attempt(pull_lesson(), {3.0});
    for (int i = 0; i < 9; ++i) run.see({}, held);
    EXPECT_EQ(run.standing().metrics.time_s, 0.5);
    EXPECT_EQ(run.standing().step, 0u);
}

TEST(LessonRun, AStopOfTheSimulationIsNoAttempt) {
    Frame stopped = rest_frame();
    stopped.statistics.diverged = true;
    LessonRun run = attempt(pull_lesson(), {3.0});
    run.see({}, stopped);
    EXPECT_EQ(run.standing().outcome, LessonOutcome::failed);
}

TEST(LessonRun, ADoseThatTakesLongIsNotWaitedForOnceAStopIsRequested) {
    Lesson lesson = pull_lesson();
    lesson.scene.flow.emplace();
    LessonRun run(lesson, small_patient());
    run.see({}, rest_frame());
    InjectionOptions viscous =
        injection_options({.at = {0, 20.0}, .void_fraction = 0.5}, small_patient()->tree);
    viscous.front.step_tolerance = 1e-6;  // minutes of work
    Frame frame = rest_frame();
    frame.drug.injection = std::make_shared<const InjectionOptions>(viscous);
    frame.drug.end_s = frame.drug.time_s = 15.0;
    EXPECT_THROW(run.see({}, frame, test::asked_to_stop()), Cancelled);
}

TEST(LessonRun, TheAnswerNamesStepsLimitsAndMetrics) {
    const LessonRun run = attempt(pull_lesson(), {3.0, 3.0, 0.0});
    const auto json = to_json(run.standing(), run.lesson());
    EXPECT_EQ(json["passed"], true);
    EXPECT_EQ(json["steps"][0]["reached_s"], 1.0);
    EXPECT_EQ(json["limits"][0]["bound"], "force at most 10 mN");
    EXPECT_EQ(json["limits"][0]["value"], 3.0);
    EXPECT_EQ(json["metrics"]["impulse_mn_s"], 3.0);
}

}  // namespace
}  // namespace hepatica
