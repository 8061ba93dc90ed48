// SPDX-License-Identifier: GPL-3.0-or-later
// A live play and its recording have one score; each of the seven lessons is passed by one play and
// failed by another; and the one that the editor begins with can be passed.
#include "core/lesson/score.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "core/opening/open_patient.h"
#include "core/session/recording_file.h"
#include "tests/lesson/frames.h"
#include "tests/session/recorded.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::keep_recording;
using test::small_patient;
using testing::HasSubstr;

struct Played {
    LessonStanding standing;
    std::size_t samples = 0;
    std::shared_ptr<Recording> recording;
};

// As the window plays: watched and recorded, the setup first.
Played play(const Lesson& lesson, const Script& script, std::shared_ptr<const PatientCase> patient,
            int steps) {
    Job job;
    LessonRun run(lesson, patient);
    Session session(patient, lesson.scene, job);
    Played played;
    played.recording = keep_recording(session);
    session.watch([&](const auto& commands, const Frame& frame, const auto& /*stop*/) {
        run.see(commands, frame);
        return true;
    });
    for (const Command& command : run.setup()) session.post(command);
    for (const auto& commands : schedule(script, patient->tree, lesson.scene.dt_s, steps)) {
        for (const Command& command : commands) session.post(command);
        session.step();
        if (run.standing().outcome != LessonOutcome::running) break;
    }
    run.end();
    played.standing = run.standing();
    played.samples = run.samples().size();
    return played;
}

// A pull and an injection on the small patient.
Lesson small_lesson() {
    Lesson lesson;
    lesson.name = "small";
    lesson.scene = default_scene();
    lesson.scene.flow->drug_speed = 30.0;
    lesson.tools = {LessonTool::pull, LessonTool::inject};
    lesson.target = ScriptPlace{.share_of_longest_path = 0.5};
    lesson.marks = {{"mark", {.share_of_longest_path = 0.5}}};
    lesson.steps = {{"pull", "", {{Quantity::moved_mm, 0, true, 3.0}}, 0.1, {}},
                    {"let go", "", {{Quantity::holding, -1, false, 0.0}}, 0.0, {}},
                    {"wait", "", {{Quantity::injected_g, -1, true, 4.0}}, 0.0, {}}};
    return lesson;
}

const Script& small_play() {
    static const Script script = script_of(R"({"actions": [
        {"at_s": 0.05, "do": "inject", "where": {"share_of_longest_path": 0.3}, "mass_flow_g_s": 2},
        {"at_s": 0.1, "do": "grab", "where": {"share_of_longest_path": 0.5}},
        {"at_s": 0.1, "do": "move", "by_mm": [5, 0, 1], "over_s": 0.2},
        {"at_s": 0.5, "do": "release"}]})",
                                           "play");
    return script;
}

TEST(Score, OfARecordingIsThatOfThePlayToTheBit) {
    const Lesson lesson = small_lesson();
    const Played played = play(lesson, small_play(), small_patient(), 60);
    EXPECT_EQ(played.standing.outcome, LessonOutcome::passed)
        << to_json(played.standing, lesson).dump(1);
    EXPECT_GT(played.standing.metrics.impulse_mn_s, 0.0);
    EXPECT_GT(played.standing.metrics.dose_target_g, 0.0);
    const fs::path file = fs::path(testing::TempDir()) / "score.hrec";
    write_recording(file, *played.recording);
    for (const int threads : {1, 2}) {
        const ThreadLimit limit(threads);
        Job job;
        const Score again = score(read_recording(file), lesson, small_patient(), job);
        EXPECT_EQ(again.standing.metrics, played.standing.metrics);
        EXPECT_EQ(again.standing.moment, played.standing.moment);
        EXPECT_EQ(to_json(again.standing, lesson).dump(), to_json(played.standing, lesson).dump());
        EXPECT_EQ(again.samples.size(), played.samples);
    }
    fs::remove(file);
}

// Steps that a resting session would leave out are time for who plays against the clock.
TEST(Score, AWatchedSessionDoesNotRest) {
    Job job;
    Session session(small_patient(), small_lesson().scene, job);
    bool rested = false;
    int seen = 0;
    session.watch([&](const auto&, const Frame& frame, const auto&) {
        rested = rested || frame.statistics.resting;
        return ++seen < 40;
    });
    for (int i = 0; i < 40; ++i) session.step();
    EXPECT_FALSE(rested);
    // It has seen enough, and what nobody watches rests.
    for (int i = 0; i < 40; ++i) session.step();
    session.update_frame();
    EXPECT_TRUE(session.frame().statistics.resting);
    EXPECT_EQ(seen, 40);
}

TEST(Score, IsRefusedWhereThePlayWasAnother) {
    const Lesson lesson = small_lesson();
    const Played played = play(lesson, small_play(), small_patient(), 20);
    Job job;
    Lesson other = lesson;
    other.scene.deform->tether_pa_per_mm2 = 7.0;
    EXPECT_THROW(score(*played.recording, other, small_patient(), job), InputError);
    Lesson finer = lesson;
    finer.scene.deform->quality = 1.0;
    EXPECT_NO_THROW(score(*played.recording, finer, small_patient(), job));
    Recording changed = *played.recording;
    changed.steps[9].state_hash ^= 1;
    int seen = 0;
    try {
        score(changed, lesson, small_patient(), job, cpu_back_end(),
              [&seen](const Frame&, const LessonStanding&) { ++seen; });
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("step 10"));
    }
    EXPECT_EQ(seen, 10) << "what follows proves nothing, and is not waited for";
}

// What cannot be measured is the reason, not another processor.
TEST(Score, SaysWhyAPlayCannotBeScored) {
    const Lesson lesson = small_lesson();
    const Played played = play(lesson, small_play(), small_patient(), 20);
    Job job;
    int seen = 0;
    try {
        score(*played.recording, lesson, small_patient(), job, cpu_back_end(),
              [&](const Frame&, const LessonStanding&) {
                  if (++seen == 7) throw InputError("does not flow", "injection", "Inject more");
              });
        FAIL() << "the error is lost";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "does not flow");
    }
}

// The vessel is held already where this recording begins, and no clock ran while it was taken.
TEST(Score, WhatBeginsAmidAPlayPassesNoLesson) {
    Lesson lesson = small_lesson();
    lesson.steps = {{"hold", "", {{Quantity::holding, -1, true, 1.0}}, 0.0, {}}};
    Job job;
    Session session(small_patient(), lesson.scene, job);
    const auto& tree = small_patient()->tree;
    session.post(GrabPoint{point_on_longest_path(tree, 0.5)});
    for (int i = 0; i < 5; ++i) session.step();
    Recording amid;
    session.record_from_now([&amid](const Recording& start) -> Session::Keep {
        amid = start;
        return [&amid](RecordedStep step) { amid.steps.push_back(std::move(step)); };
    });
    for (int i = 0; i < 5; ++i) session.step();
    ASSERT_TRUE(amid.begin);
    const LessonStanding standing = score(amid, lesson, small_patient(), job).standing;
    EXPECT_EQ(standing.step, 1u) << "its step was reached";
    EXPECT_EQ(standing.outcome, LessonOutcome::failed);
    EXPECT_THAT(standing.reasons, testing::ElementsAre(HasSubstr("before the lesson began")));
}

TEST(Score, WhatARecordingEndsBeforeIsNotReached) {
    const Played played = play(small_lesson(), small_play(), small_patient(), 10);
    EXPECT_EQ(played.standing.outcome, LessonOutcome::failed);
    EXPECT_THAT(played.standing.reasons.front(), HasSubstr("was not reached"));
}

// What the lesson editor begins with, pulled with more force than a thin vessel needs.
void expect_new_lesson_is_passed(const std::shared_ptr<const PatientCase>& patient) {
    Lesson lesson = new_lesson();
    lesson.scene.deform->quality = 0.0;
    const Script pull = script_of(R"({"actions": [
        {"at_s": 0.1, "do": "grab", "where": {"share_of_longest_path": 0.5}},
        {"at_s": 0.15, "do": "move", "by_mm": [-9, 0, 0], "over_s": 0.5}]})",
                                  "pull");
    const Played played = play(lesson, pull, patient, 200);
    EXPECT_EQ(played.standing.outcome, LessonOutcome::passed)
        << to_json(played.standing, lesson).dump(1);
    EXPECT_GT(played.standing.metrics.peak_force_mn, 400.0);
}

// One test, because making the built-in patient takes longer than all the plays.
TEST(BuiltInLessons, EachIsPassedByOnePlayAndFailedByAnother) {
    Job job;
    const auto patient = open_patient({.built_in = true, .reconstruct = {}}, job).patient;
    const fs::path plays = fs::path(HEPATICA_SOURCE_DIR) / "tests/lesson/plays";
    for (const BuiltInLesson& entry : built_in_lessons()) {
        Lesson lesson = find_lesson(entry.id);
        if (lesson.scene.deform) lesson.scene.deform->quality = 0.0;
        const int steps = lesson.scene.deform ? 200 : 900;  // a drug takes longer than a pull
        const std::string id = entry.id;
        const Played good =
            play(lesson, read_script(plays / (id + "_passes.json")), patient, steps);
        EXPECT_EQ(good.standing.outcome, LessonOutcome::passed)
            << to_json(good.standing, lesson).dump(1);
        // As its hints say, with the window's own tools, the jaws closed at once and not quite
        // about the vessel's middle.
        if (const fs::path hinted = plays / (id + "_hinted.json"); fs::exists(hinted)) {
            const Played followed = play(lesson, read_script(hinted), patient, steps);
            EXPECT_EQ(followed.standing.outcome, LessonOutcome::passed)
                << to_json(followed.standing, lesson).dump(1);
        }
        // The limit of the force leaves room for a grip that is well off the middle.
        if (const fs::path off = plays / (id + "_off_centre.json"); fs::exists(off)) {
            const Played gripped = play(lesson, read_script(off), patient, steps);
            EXPECT_EQ(gripped.standing.outcome, LessonOutcome::passed) << id;
            for (const BoundStanding& limit : gripped.standing.limits) {
                if (limit.predicate.quantity != Quantity::force_mn) continue;
                EXPECT_LT(limit.value, 0.75 * limit.predicate.bound) << id;
            }
        }
        // With one tool alone where the steps ask for another, or the emulsion taken out again.
        if (const fs::path wrong = plays / (id + "_wrong_tool.json"); fs::exists(wrong)) {
            const Played pressed = play(lesson, read_script(wrong), patient, steps);
            EXPECT_NE(pressed.standing.outcome, LessonOutcome::passed) << id;
            EXPECT_TRUE(pressed.standing.steps.front().reached_s) << id;
        }
        const Played bad = play(lesson, read_script(plays / (id + "_fails.json")), patient, steps);
        ASSERT_EQ(bad.standing.outcome, LessonOutcome::failed) << id;
        EXPECT_THAT(bad.standing.reasons.front(), HasSubstr("limit broken"))
            << id << ": the play does harm, it is not merely too short";
    }
    expect_new_lesson_is_passed(patient);
}

}  // namespace
}  // namespace hepatica
