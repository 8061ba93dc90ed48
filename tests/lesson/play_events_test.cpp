// SPDX-License-Identifier: GPL-3.0-or-later
// What happened is noted once, when it happened, and what did not happen is not.
#include "core/lesson/play_events.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/lesson/play_meter.h"
#include "tests/lesson/frames.h"

namespace hepatica {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Sees one step after another, 0.06 s each.
class PlayEventsTest : public testing::Test {
  protected:
    std::vector<std::string> see(const std::vector<Command>& commands = {}) {
        now_s_ += 0.06;
        std::vector<std::string> texts;
        for (const PlayEvent& event :
             events_.see(now_s_, commands, frame_, standing_ ? &*standing_ : nullptr)) {
            EXPECT_EQ(event.at_s, now_s_);
            last_ = event.kind;
            texts.push_back(event.text);
        }
        return texts;
    }
    void load(float share) {
        frame_.tear->loads =
            std::make_shared<const std::vector<float>>(std::vector<float>{0.1F, share, 0.0F});
    }

    PlayEvents events_;
    Frame frame_;
    std::optional<LessonStanding> standing_;
    PlayEventKind last_ = PlayEventKind::trouble;
    double now_s_ = 0.0;
};

TEST_F(PlayEventsTest, TheHandTakesHoldAndLetsGo) {
    EXPECT_THAT(see({GrabPoint{}}), IsEmpty()) << "a click beside the vessel";
    EXPECT_THAT(see({ReleaseGrab{}}), IsEmpty());
    frame_.grab = GrabView{};
    EXPECT_THAT(see({GrabPoint{}}), ElementsAre("Took hold"));
    EXPECT_EQ(last_, PlayEventKind::hand);
    EXPECT_THAT(see({MoveGrab{}}), IsEmpty());
    frame_.grab.reset();
    EXPECT_THAT(see({ReleaseGrab{}}), ElementsAre("Let go"));
    EXPECT_THAT(see(), IsEmpty());
}

// Commands gather in one step where it is slow, and a grab takes the place of another one.
TEST_F(PlayEventsTest, TheHandTakesHoldElsewhereWithinAStep) {
    frame_.grab = GrabView{};
    EXPECT_THAT(see({GrabPoint{}}), ElementsAre("Took hold"));
    EXPECT_THAT(see({ReleaseGrab{}, GrabPoint{}}), ElementsAre("Let go", "Took hold"));
    EXPECT_THAT(see({GrabVertex{}}), ElementsAre("Let go", "Took hold"));
    EXPECT_THAT(see(), IsEmpty());
    frame_.grab.reset();
    EXPECT_THAT(see({GrabPoint{}, ReleaseGrab{}}), ElementsAre("Let go"));
    EXPECT_THAT(see({GrabPoint{}, ReleaseGrab{}}), IsEmpty()) << "too short to be seen";
}

TEST_F(PlayEventsTest, AToolTouchesAndAShortBreakIsTheSameTouch) {
    frame_.tool = ToolView{};
    EXPECT_THAT(see({AddTool{"capsule", 2.0, 10.0, Vec3::UnitZ(), Vec3::Zero(), {}}}),
                ElementsAre("Rod probe taken"));
    frame_.tool->touched = {4};
    EXPECT_THAT(see(), ElementsAre("Touched"));
    frame_.tool->touched.clear();
    EXPECT_THAT(see(), IsEmpty());
    EXPECT_THAT(see(), IsEmpty());
    frame_.tool->touched = {4};
    EXPECT_THAT(see(), ElementsAre("Touched")) << "free for 0.12 s";
    EXPECT_THAT(see(), IsEmpty()) << "it goes on";
    frame_.tool->touched.clear();
    EXPECT_THAT(see(), IsEmpty());
    frame_.tool->touched = {4};
    EXPECT_THAT(see(), IsEmpty()) << "free for 0.06 s";
    frame_.tool.reset();
    EXPECT_THAT(see({RemoveTool{}}), ElementsAre("Tool put away"));
}

// The time line of a review shows the contacts that the lesson counted.
TEST(PlayEventsAndMeter, CountTheSameContacts) {
    Lesson lesson = test::plain_lesson();
    lesson.scene.dt_s = 1.0 / 60.0;
    for (int apart = 4; apart <= 8; ++apart) {
        PlayMeter meter(lesson, test::small_patient());
        meter.begin(test::rest_frame());
        PlayEvents events;
        double now_s = 0.0;
        int noted = 0;
        for (int frame = 0; frame <= apart + 1; ++frame) {
            const Frame seen = test::touching(frame == 0 || frame == apart + 1);
            now_s += lesson.scene.dt_s;
            meter.see(seen);
            for (const PlayEvent& event : events.see(now_s, {}, seen, nullptr))
                noted += event.text == "Touched" ? 1 : 0;
        }
        EXPECT_EQ(noted, apart < 6 ? 1 : 2) << apart;
        EXPECT_EQ(meter.metrics().contacts, noted) << apart;
    }
}

TEST_F(PlayEventsTest, EveryToolHasItsName) {
    const auto taken = [&](const char* kind) {
        return see({AddTool{kind, 2.0, 10.0, Vec3::UnitZ(), Vec3::Zero(), {}}});
    };
    EXPECT_THAT(taken("sphere"), ElementsAre("Probe taken"));
    EXPECT_THAT(taken("capsule"), ElementsAre("Rod probe taken"));
    EXPECT_THAT(taken("hook"), ElementsAre("Hook taken"));
    EXPECT_THAT(taken("forceps"), ElementsAre("Forceps taken"));
    EXPECT_EQ(last_, PlayEventKind::tool);
}

// The window brings a tool again where it stopped beside the mouse, and by a click.
TEST_F(PlayEventsTest, AToolThatIsBroughtAgainIsTakenOnce) {
    const AddTool forceps{"forceps", 2.0, 30.0, Vec3::UnitZ(), Vec3::Zero(), {}};
    frame_.tool = ToolView{};
    EXPECT_THAT(see({forceps}), ElementsAre("Forceps taken"));
    EXPECT_THAT(see({forceps, forceps}), IsEmpty());
    EXPECT_THAT(see({AddTool{"hook", 2.0, 30.0, Vec3::UnitZ(), Vec3::Zero(), {}}}),
                ElementsAre("Hook taken"));
    EXPECT_THAT(see({RemoveTool{}, forceps}), ElementsAre("Tool put away", "Forceps taken"));
    frame_.tool.reset();
    EXPECT_THAT(see(), IsEmpty());
    frame_.tool = ToolView{};
    EXPECT_THAT(see({forceps}), ElementsAre("Forceps taken")) << "there was none any more";
}

TEST_F(PlayEventsTest, ForcepsCloseOnAVesselOrOnNothingAndOpen) {
    ToolView& jaws = frame_.tool.emplace();
    jaws.parts = {{Vec3::Zero(), Vec3(0, 0, 9), 1.0}, {Vec3(4, 0, 0), Vec3(4, 0, 9), 1.0}};
    jaws.opening_mm = 6.0;
    EXPECT_THAT(see(), IsEmpty());
    jaws.closing = true;
    jaws.opening_mm = 4.0;
    EXPECT_THAT(see({CloseForceps{}}), IsEmpty()) << "they are on their way";
    jaws.grip_un = 2e4;
    EXPECT_THAT(see(), ElementsAre("Forceps closed: they hold something"));
    EXPECT_EQ(last_, PlayEventKind::tool);
    EXPECT_THAT(see(), IsEmpty());
    jaws.grip_un = jaws.opening_mm = 0.0;
    EXPECT_THAT(see(), ElementsAre("Slipped out of the forceps"));
    jaws.closing = false;
    jaws.opening_mm = 6.0;
    EXPECT_THAT(see({OpenForceps{}}), ElementsAre("Forceps opened"));
    jaws.closing = true;
    jaws.opening_mm = 0.0;
    EXPECT_THAT(see({CloseForceps{}}), ElementsAre("Forceps closed: they hold nothing"));
}

TEST_F(PlayEventsTest, DrugsCutsAndReturnsAreNamed) {
    EXPECT_THAT(see({InjectDrug{}, CutLine{}, Blade{}, RemoveDrug{}}),
                ElementsAre("Injected", "Cut line drawn", "Blade drawn", "Drug taken out"));
    EXPECT_THAT(see({ResetWorld{}, RestoreSnapshot{}}),
                ElementsAre("Begun again from rest", "Back to the last good state"));
    EXPECT_THAT(see({SetGravity{}, MoveTool{}, TurnTool{}}), IsEmpty());
}

TEST_F(PlayEventsTest, ATearIsWarnedOfOnceUntilItEases) {
    frame_.tear = TearView{};
    load(0.79F);
    EXPECT_THAT(see(), IsEmpty());
    load(0.8F);
    EXPECT_THAT(see(), ElementsAre("About to tear"));
    load(0.7F);
    EXPECT_THAT(see(), IsEmpty());
    load(0.9F);
    EXPECT_THAT(see(), IsEmpty()) << "it had not eased";
    load(0.59F);
    EXPECT_THAT(see(), IsEmpty());
    load(0.95F);
    EXPECT_THAT(see(), ElementsAre("About to tear"));
}

TEST_F(PlayEventsTest, WhatTearsBleedsAndIsMadeWholeAgain) {
    frame_.tear = TearView{};
    frame_.tear->pieces = 3;  // from the start
    EXPECT_THAT(see(), IsEmpty());
    frame_.tear->joints_broken = 2;
    frame_.tear->leak_g_s = 0.5;
    EXPECT_THAT(see(), ElementsAre("Torn", "Bleeding began"));
    frame_.tear->joints_broken = 9;
    frame_.tear->pieces = 4;
    frame_.tear->stopped_by = "entropy";
    EXPECT_THAT(see(), ElementsAre("A piece came off", "Tearing stopped by its budget of entropy"));
    EXPECT_EQ(last_, PlayEventKind::tear);
    EXPECT_THAT(see(), IsEmpty());
    frame_.tear = TearView{};
    frame_.tear->pieces = 3;
    EXPECT_THAT(see({UseTear{false}}), ElementsAre("Whole again", "Bleeding ended"));
}

TEST_F(PlayEventsTest, TearingThatBeginsInMidPlayTakesNoPieceOffAndItsEndMakesWhole) {
    EXPECT_THAT(see(), IsEmpty());
    TearView whole;
    whole.pieces = 3;
    frame_.tear = whole;
    EXPECT_THAT(see({UseTear{}}), IsEmpty());
    frame_.tear->joints_broken = 2;
    frame_.tear->pieces = 4;
    frame_.tear->leak_g_s = 0.5;
    EXPECT_THAT(see(), ElementsAre("Torn", "A piece came off", "Bleeding began"));
    frame_.tear.reset();
    EXPECT_THAT(see({UseTear{false}}), ElementsAre("Whole again", "Bleeding ended"));
    EXPECT_THAT(see(), IsEmpty());
    frame_.tear = whole;
    EXPECT_THAT(see({UseTear{}}), IsEmpty());
}

TEST_F(PlayEventsTest, WhatABladePartsIsCutAndWhatPartsLaterIsTorn) {
    frame_.tear = TearView{};
    EXPECT_THAT(see(), IsEmpty());
    frame_.tear->joints_broken = 4;
    EXPECT_THAT(see({Blade{}}), ElementsAre("Blade drawn", "Cut"));
    EXPECT_EQ(last_, PlayEventKind::cut);
    frame_.tear->joints_broken = 6;
    EXPECT_THAT(see(), ElementsAre("Torn"));
    EXPECT_EQ(last_, PlayEventKind::tear);
    frame_.tear->joints_broken = 7;
    EXPECT_THAT(see(), IsEmpty()) << "it goes on";
    EXPECT_THAT(see({Blade{}}), ElementsAre("Blade drawn")) << "beside the vessel";
    frame_.tear->joints_broken = 0;
    EXPECT_THAT(see({ResetWorld{}}), ElementsAre("Begun again from rest", "Whole again"));
    frame_.tear->joints_broken = 1;
    EXPECT_THAT(see(), ElementsAre("Torn"));
}

TEST_F(PlayEventsTest, WhatTheProgramSaidOrStoppedByItself) {
    frame_.statistics.message = "The drug cannot flow there";
    EXPECT_THAT(see(), ElementsAre("The drug cannot flow there"));
    EXPECT_THAT(see(), IsEmpty());
    frame_.statistics.message = "the step was shortened";
    frame_.statistics.degraded = true;
    frame_.statistics.message_of_solver = true;
    EXPECT_THAT(see(), IsEmpty()) << "how the solver helped itself is nobody's doing";
    frame_.statistics.message = "The blade misses the vessels";
    frame_.statistics.message_of_solver = false;
    EXPECT_THAT(see(), ElementsAre("The blade misses the vessels")) << "a degraded step, too";
    frame_.statistics.message.clear();
    frame_.statistics.diverged = true;
    EXPECT_THAT(see(), ElementsAre("The simulation stopped by itself"));
    EXPECT_THAT(see(), IsEmpty());
}

TEST_F(PlayEventsTest, ALessonsStepsAndItsEnd) {
    standing_.emplace();
    EXPECT_THAT(see(), IsEmpty());
    standing_->step = 2;
    EXPECT_THAT(see(), ElementsAre("Step 1 reached", "Step 2 reached"));
    standing_->outcome = LessonOutcome::failed;
    standing_->reasons = {"limit broken: force", "tool: hook"};
    EXPECT_THAT(see(), ElementsAre("Not passed: limit broken: force", "Not passed: tool: hook"));
    EXPECT_THAT(see(), IsEmpty()) << "it ended once";
}

}  // namespace
}  // namespace hepatica
