// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_doubts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/base/temporary_folder.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(LessonDoubts, HasNoneOfTheLessonsOfTheProgram) {
    for (const BuiltInLesson& entry : built_in_lessons())
        EXPECT_THAT(doubts_about(lesson_of(entry.text, entry.id)), IsEmpty()) << entry.id;
}

// Each part of a scene taken away makes doubtful what needs it, and nothing else.
TEST(LessonDoubts, NamesThePartThatIsMissing) {
    Lesson lesson = new_lesson();
    lesson.scene.deform.reset();
    EXPECT_THAT(
        doubts_about(lesson),
        ElementsAre(AllOf(HasSubstr("tool pull"), HasSubstr("vessels that move")),
                    AllOf(HasSubstr("Step 1 \"Pull the"), HasSubstr("goal: \"way moved by mark 1"),
                          HasSubstr("vessels that move")),
                    HasSubstr("Limits all the time: \"largest stretch at most 1.5\"")));

    struct Missing {
        const char* id;
        void (*take_away)(SceneSpec&);
        const char* part;
        std::size_t doubts;  // tools and bounds of the lesson that need it
    };
    const Missing parts[] = {
        {"bleeding_vessel", [](SceneSpec& scene) { scene.contact.reset(); }, "tools that touch", 5},
        {"probe_free", [](SceneSpec& scene) { scene.contact->tools = false; }, "tools that touch",
         5},
        {"cut_line", [](SceneSpec& scene) { scene.tear.reset(); }, "vessels that tear", 4},
        {"embolization", [](SceneSpec& scene) { scene.flow.reset(); }, "a drug that flows", 6}};
    for (const auto& [id, take_away, part, doubts] : parts) {
        Lesson built_in = find_lesson(id);
        take_away(built_in.scene);
        EXPECT_THAT(doubts_about(built_in),
                    AllOf(SizeIs(doubts), Each(HasSubstr(std::string("no ") + part))))
            << id;
    }
}

TEST(LessonDoubts, MissesATarget) {
    Lesson lesson = find_lesson("embolization");
    lesson.target.reset();
    EXPECT_THAT(doubts_about(lesson), testing::Each(HasSubstr("needs a target")));
    EXPECT_FALSE(doubts_about(lesson).empty());
}

TEST(LessonDoubts, MissesATargetForEachQuantityThatSpeaksOfOne) {
    using enum Quantity;
    Lesson lesson = find_lesson("embolization");
    lesson.target.reset();
    lesson.limits.clear();
    lesson.pass.clear();
    lesson.steps = {new_step()};
    const auto needs_target = [&](Quantity quantity) {
        lesson.steps[0].goal = {{quantity, -1, true, 0.5}};
        return std::ranges::any_of(doubts_about(lesson), [](const std::string& doubt) {
            return doubt.find("needs a target") != std::string::npos;
        });
    };
    for (const Quantity quantity :
         {dose_target_g, dose_elsewhere_g, dose_target_share, target_filled, elsewhere_filled})
        EXPECT_TRUE(needs_target(quantity)) << words_of(quantity).words;
    for (const Quantity quantity : {injected_g, delivered_g, reflux_g, drug_present})
        EXPECT_FALSE(needs_target(quantity)) << words_of(quantity).words;
}

TEST(LessonDoubts, KnowsThatAPointBelongsToOnePatient) {
    Lesson lesson = new_lesson();
    lesson.marks[0].place = {Vec3(1, 2, 3), std::nullopt};
    lesson.target = lesson.marks[0].place;
    EXPECT_THAT(doubts_about(lesson), ElementsAre(HasSubstr("\"mark 1\""), HasSubstr("target")));
    lesson.patient = "built-in";
    EXPECT_THAT(doubts_about(lesson), IsEmpty());
}

TEST(LessonDoubts, SeesAStepThatEndsBeforeItIsHeld) {
    Lesson lesson = new_lesson();
    lesson.steps[0].hold_s = 5.0;
    lesson.steps[0].limits = {{Quantity::step_time_s, -1, false, 5.0}};
    EXPECT_THAT(doubts_about(lesson), ElementsAre(HasSubstr("takes 5 s or more")));
    lesson.steps[0].limits[0].bound = 6.0;
    EXPECT_THAT(doubts_about(lesson), IsEmpty());
}

// What is held and waited for adds up: of the step, until its end, and of the lesson.
TEST(LessonDoubts, AddsUpWhatIsHeldAndWaitedFor) {
    const auto at_most = [](Quantity quantity, double bound) {
        return Predicate{quantity, -1, false, bound};
    };
    Lesson lesson = new_lesson();
    lesson.limits.clear();
    lesson.pass.clear();
    lesson.steps.push_back(new_step());
    lesson.steps[0].hold_s = 3.0;
    lesson.steps[1].goal = {{Quantity::step_time_s, -1, true, 4.0}};
    lesson.steps[1].hold_s = 2.0;
    struct Place {
        std::vector<Predicate>& bounds;
        Quantity quantity;
        double least_s;
        const char* where;
    };
    const Place places[] = {
        {lesson.limits, Quantity::time_s, 9.0, "Limits all the time: \"time at most"},
        {lesson.limits, Quantity::step_time_s, 6.0, "Limits all the time: \"time of this step"},
        {lesson.pass, Quantity::time_s, 9.0, "Pass marks"},
        {lesson.steps[0].limits, Quantity::time_s, 3.0, "Step 1"},
        {lesson.steps[1].limits, Quantity::time_s, 9.0, "Step 2"},
        {lesson.steps[1].limits, Quantity::step_time_s, 6.0, "Step 2"}};
    for (const auto& [bounds, quantity, least_s, where] : places) {
        bounds = {at_most(quantity, least_s)};
        EXPECT_THAT(doubts_about(lesson), ElementsAre(AllOf(HasSubstr(where), HasSubstr("short"))));
        bounds = {at_most(quantity, least_s + 0.5)};
        EXPECT_THAT(doubts_about(lesson), IsEmpty()) << where;
        bounds.clear();
    }
    lesson.steps[1].goal = {{Quantity::time_s, -1, true, 20.0}};
    lesson.limits = {at_most(Quantity::time_s, 22.0)};
    EXPECT_THAT(doubts_about(lesson), ElementsAre(HasSubstr("takes 22 s")));
}

TEST(LessonDoubts, SeesLimitsThatAreBrokenAtOnce) {
    Lesson lesson = new_lesson();
    lesson.steps.push_back(new_step());
    const auto doubts_with = [&](std::vector<Predicate>& limits, const Predicate& limit) {
        const std::vector<Predicate> before = std::exchange(limits, {limit});
        const std::vector<std::string> doubts = doubts_about(lesson);
        limits = before;
        return doubts;
    };
    const auto broken = ElementsAre(HasSubstr("broken at once"));
    const Predicate force_at_least{Quantity::force_mn, -1, true, 1.0};
    const Predicate near{Quantity::distance_mm, 0, false, 5.0};
    const Predicate below_rest{Quantity::stretch, -1, false, 0.9};
    const Predicate late{Quantity::step_time_s, -1, true, 1.0};
    for (const Predicate& limit : {force_at_least, near, below_rest, late}) {
        EXPECT_THAT(doubts_with(lesson.limits, limit), broken) << to_words(limit, {});
        EXPECT_THAT(doubts_with(lesson.steps[0].limits, limit), broken) << to_words(limit, {});
    }
    // Nobody knows what the step before has left, but for these.
    for (const Predicate& limit : {force_at_least, near})
        EXPECT_THAT(doubts_with(lesson.steps[1].limits, limit), IsEmpty()) << to_words(limit, {});
    for (const Predicate& limit : {below_rest, late})
        EXPECT_THAT(doubts_with(lesson.steps[1].limits, limit), broken) << to_words(limit, {});
    const Predicate at_rest{Quantity::stretch, -1, false, 1.0};
    EXPECT_THAT(doubts_with(lesson.limits, at_rest), IsEmpty());
    lesson.setup.actions.emplace_back();  // who knows what it does
    EXPECT_THAT(doubts_with(lesson.limits, force_at_least), IsEmpty());
}

TEST(LessonDoubts, SeesGoalsThatNoToolReaches) {
    Lesson lesson = find_lesson("probe_free");
    lesson.limits.clear();
    lesson.pass.clear();
    lesson.steps = {new_step()};
    lesson.scene.flow.emplace();
    struct Reach {
        Predicate goal;
        LessonTool reaches, does_not;
    };
    const Reach all[] = {
        {{Quantity::force_mn, -1, true, 1.0}, LessonTool::pull, LessonTool::cut_line},
        {{Quantity::grip_mn, -1, true, 1.0}, LessonTool::forceps, LessonTool::hook},
        {{Quantity::contacts, -1, true, 1.0}, LessonTool::sphere, LessonTool::pull},
        {{Quantity::touch_mm, 0, false, 5.0}, LessonTool::capsule, LessonTool::pull},
        {{Quantity::injected_g, -1, true, 1.0}, LessonTool::inject, LessonTool::settings},
        {{Quantity::joints_broken, -1, true, 1.0}, LessonTool::blade, LessonTool::inject},
        {{Quantity::moved_mm, 0, true, 5.0}, LessonTool::settings, LessonTool::inject}};
    for (const auto& [goal, reaches, does_not] : all) {
        const std::string words = to_words(goal, lesson.mark_names());
        lesson.steps[0].goal = {goal};
        lesson.tools = {does_not};
        EXPECT_THAT(doubts_about(lesson), ElementsAre(HasSubstr("out of reach"))) << words;
        lesson.tools = {does_not, reaches};
        EXPECT_THAT(doubts_about(lesson), IsEmpty()) << words;
    }
    lesson.tools = {LessonTool::pull};
    lesson.steps[0].goal = {{Quantity::injected_g, -1, true, 1.0}};
    lesson.setup.actions.emplace_back();  // it may inject
    EXPECT_THAT(doubts_about(lesson), IsEmpty());
    lesson.setup.actions.clear();
    EXPECT_THAT(doubts_about(lesson), Not(IsEmpty()));
    // It is so by itself, or gravity does it.
    lesson.tools = {LessonTool::inject};
    lesson.steps[0].goal = {{Quantity::force_mn, -1, false, 1.0}};
    EXPECT_THAT(doubts_about(lesson), IsEmpty());
    lesson.steps[0].goal = {{Quantity::moved_mm, 0, true, 5.0}};
    lesson.scene.deform->gravity_mm_per_s2 = Vec3(0, 0, -9810);
    EXPECT_THAT(doubts_about(lesson), IsEmpty());
}

TEST(LessonDoubts, KnowsThatSharesEndAtOne) {
    Lesson lesson = find_lesson("embolization");
    lesson.limits.clear();
    for (const Quantity share : {Quantity::dose_target_share, Quantity::target_filled,
                                 Quantity::elsewhere_filled, Quantity::drug_present}) {
        lesson.pass = {{share, -1, true, 1.5}};
        EXPECT_THAT(doubts_about(lesson), ElementsAre(HasSubstr("1 at most")));
        lesson.pass[0].bound = 1.0;
        EXPECT_THAT(doubts_about(lesson), IsEmpty());
    }
}

TEST(LessonDoubts, LooksForTheCase) {
    const TemporaryFolder folder;
    Lesson lesson = new_lesson();
    lesson.patient = "a.hep";
    EXPECT_THAT(doubts_about(lesson, folder.path()),
                ElementsAre(HasSubstr((folder.path() / "a.hep").string() + " is not there")));
    std::filesystem::create_directory(folder.path() / "a.hep");
    EXPECT_THAT(doubts_about(lesson, folder.path()), IsEmpty());
    lesson.patient = (folder.path() / "a.hep").string();
    EXPECT_THAT(doubts_about(lesson), IsEmpty());
}

TEST(LessonDoubts, SeesPointsBesideTheVessels) {
    const std::shared_ptr<const PatientCase> patient = test::small_patient();
    const Vec3 inside = patient->tree.segments[0].points_mm[1];
    Lesson lesson = new_lesson();
    EXPECT_THAT(doubts_about_places(lesson, patient->tree), IsEmpty());
    lesson.marks[0].place = {inside, std::nullopt};
    lesson.target = lesson.marks[0].place;
    EXPECT_THAT(doubts_about_places(lesson, patient->tree), IsEmpty());
    lesson.marks[0].place.point_mm = inside + Vec3(0, 0, 200);
    EXPECT_THAT(doubts_about_places(lesson, patient->tree),
                ElementsAre(AllOf(HasSubstr("\"mark 1\" lies"), HasSubstr("another"))));
    std::swap(lesson.target->point_mm, lesson.marks[0].place.point_mm);
    EXPECT_THAT(doubts_about_places(lesson, patient->tree), ElementsAre(HasSubstr("The target")));
}

TEST(LessonDoubts, AsksForATool) {
    Lesson lesson = new_lesson();
    lesson.tools.clear();
    EXPECT_THAT(doubts_about(lesson), ElementsAre(HasSubstr("no tool")));
}

}  // namespace
}  // namespace hepatica
