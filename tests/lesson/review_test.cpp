// SPDX-License-Identifier: GPL-3.0-or-later
// A review shows what the play showed, frame by frame, and when what happened.
#include "core/lesson/review.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/score.h"
#include "core/session/script.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"

namespace hepatica {
namespace {

using test::keep_recording;
using test::new_session;
using test::small_patient;
using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;

struct Play {
    std::shared_ptr<Recording> recording;
    std::vector<Frame> frames;  // after each step
};

// A pull, an injection, half a second with the clock held, and a cut.
Play played() {
    SceneSpec scene = default_scene();
    scene.tear.emplace();
    const auto session = new_session(scene);
    Play play;
    play.recording = keep_recording(*session);
    const VesselTree& tree = small_patient()->tree;
    const Vec3 place = test::middle_of(tree, 0);
    for (int k = 0; k < 60; ++k) {
        if (k == 3) session->post(GrabPoint{test::middle_of(tree, 2)});
        if (k == 10) session->post(InjectDrug{.point_mm = place});
        if (k == 15) session->post(ReleaseGrab{});
        if (k == 20) session->post(SetPaused{true});
        if (k == 40) session->post(SetPaused{false});
        if (k == 50) session->post(Blade{place - Vec3(20, 0, 0), place + Vec3(20, 0, 0)});
        session->step();
        session->update_frame();
        play.frames.push_back(session->frame());
    }
    return play;
}

TEST(Review, ShowsThePlayFrameByFrame) {
    const Play play = played();
    ReviewTape tape;
    Job job;
    const Review found = review(*play.recording, std::nullopt, small_patient(), tape, job);
    EXPECT_FALSE(found.diverged_at);
    EXPECT_FALSE(found.standing);
    EXPECT_EQ(tape.size(), 40u) << "the clock was held for 20 of 60 steps";
    EXPECT_NEAR(tape.end_s(), 40.0 / 60.0, 1e-9);
    EXPECT_NEAR(played_s(*play.recording), tape.end_s(), 1e-9);
    double now_s = 0.0;
    for (const Frame& frame : play.frames) {
        if (!frame.statistics.paused) now_s += play.recording->scene.dt_s;
        const auto shown = tape.at(now_s + 1e-9);
        EXPECT_EQ(shown->positions_mm, frame.positions_mm) << frame.step;
        EXPECT_EQ(shown->drug.time_s, frame.drug.time_s);
    }
    const auto happened = [](double at_s, const char* text) {
        return Contains(AllOf(Field(&PlayEvent::at_s, testing::DoubleNear(at_s, 1e-9)),
                              Field(&PlayEvent::text, HasSubstr(text))));
    };
    const std::vector<PlayEvent> events = tape.events();
    EXPECT_THAT(events, happened(4.0 / 60, "Took hold"));
    EXPECT_THAT(events, happened(11.0 / 60, "Injected"));
    EXPECT_THAT(events, happened(16.0 / 60, "Let go"));
    EXPECT_THAT(events, happened(31.0 / 60, "Blade drawn"));
    EXPECT_THAT(events, happened(31.0 / 60, "Cut"));
}

TEST(Review, OfALessonHasItsEnd) {
    const Play play = played();
    Lesson lesson;
    lesson.scene = play.recording->scene;
    lesson.tools = {LessonTool::pull, LessonTool::inject, LessonTool::settings, LessonTool::blade};
    lesson.steps = {{"Hold", "", {{Quantity::holding, -1, true, 1.0}}, 0.0, {}},
                    {"Wait", "", {{Quantity::time_s, -1, true, 1e9}}, 0.0, {}}};
    ReviewTape tape;
    Job job;
    const Review found = review(*play.recording, lesson, small_patient(), tape, job);
    EXPECT_EQ(found.standing->outcome, LessonOutcome::failed);
    const auto events = tape.events();
    EXPECT_THAT(events, Contains(Field(&PlayEvent::text, "Step 1 reached")));
    EXPECT_THAT(events.back().text, HasSubstr("Not passed: step 2 of 2 was not reached"));
    EXPECT_NEAR(events.back().at_s, tape.end_s(), 1e-12);
    // The same, cut off by a crash: nobody judges it.
    ReviewTape cut;
    review(*play.recording, lesson, small_patient(), cut, job, cpu_back_end(), true);
    EXPECT_EQ(cut.events().back().text, "Interrupted before the end");
    EXPECT_EQ(cut.events().size(), events.size());
}

TEST(Review, SaysWhereItIsNotWhatWasPlayed) {
    const Play play = played();
    Recording changed = *play.recording;
    changed.steps[12].state_hash ^= 1;
    ReviewTape tape;
    Job job;
    EXPECT_EQ(review(changed, std::nullopt, small_patient(), tape, job).diverged_at, 13u);
    const auto events = tape.events();
    EXPECT_THAT(events,
                Contains(AllOf(Field(&PlayEvent::text, HasSubstr("not what was played")),
                               Field(&PlayEvent::at_s, testing::DoubleNear(13.0 / 60, 1e-9)))));
    EXPECT_TRUE(std::ranges::is_sorted(events, {}, &PlayEvent::at_s));
}

TEST(Review, OfNothingIsRefused) {
    Recording empty = *played().recording;
    empty.steps.clear();
    ReviewTape tape;
    Job job;
    EXPECT_THROW(review(empty, std::nullopt, small_patient(), tape, job), InputError);
}

TEST(Review, IsRefusedForAnotherScene) {
    const Play play = played();
    ReviewTape tape;
    Job job;
    EXPECT_THROW(review(*play.recording, Lesson{}, small_patient(), tape, job), InputError);
    EXPECT_EQ(tape.size(), 0u);
}

TEST(Review, FindsTheLessonThatComesWithTheProgram) {
    Recording recording;
    for (const BuiltInLesson& entry : built_in_lessons()) {
        const Lesson lesson = find_lesson(entry.id);
        recording.scene = lesson.scene;
        if (recording.scene.deform) recording.scene.deform->quality = 0.123;
        ASSERT_TRUE(built_in_lesson_of(recording)) << entry.id;
        EXPECT_EQ(built_in_lesson_of(recording)->name, lesson.name);
        recording.scene.dt_s *= 2.0;
        EXPECT_FALSE(built_in_lesson_of(recording)) << entry.id;
    }
}

}  // namespace
}  // namespace hepatica
