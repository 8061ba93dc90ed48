// SPDX-License-Identifier: GPL-3.0-or-later
// What a lesson's file may say at its limits, each tool that may be allowed, and tables in full.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/lesson/allowed_commands.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/metrics.h"
#include "core/lesson/play_meter.h"
#include "core/lesson/score.h"
#include "core/session/recording.h"
#include "tests/lesson/frames.h"

namespace hepatica {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson brief_lesson_json() {
    return OrderedJson::parse(R"({"format": "hepatica-lesson", "version": 1, "name": "n",
        "scene": {"deform": {}},
        "steps": [{"text": "t", "hold_s": 1, "goal": [{"what": "time_s", "at_least": 1}]}]})");
}

bool is_read(const std::string& pointer, const OrderedJson& value) {
    OrderedJson json = brief_lesson_json();
    json[OrderedJson::json_pointer(pointer)] = value;
    try {
        lesson_of(json.dump(), "file");
        return true;
    } catch (const InputError&) {
        return false;
    }
}

TEST(LessonLimits, OfNumbersInAFile) {
    for (const double good : {0.0, 3600.0}) EXPECT_TRUE(is_read("/steps/0/hold_s", good)) << good;
    for (const double wrong : {-1e-9, 3600.001})
        EXPECT_FALSE(is_read("/steps/0/hold_s", wrong)) << wrong;
    for (const double good : {0.0, 1.0})
        EXPECT_TRUE(is_read("/target", OrderedJson{{"share_of_longest_path", good}})) << good;
    for (const double wrong : {-1e-9, 1.000001})
        EXPECT_FALSE(is_read("/target", OrderedJson{{"share_of_longest_path", wrong}})) << wrong;
    EXPECT_FALSE(is_read("/target", OrderedJson::object()));
    EXPECT_FALSE(is_read("/target", OrderedJson::parse(R"({"share_of_longest_path": 0.5,
                                                           "point_mm": [1, 2, 3]})")));
    EXPECT_TRUE(is_read("/target", OrderedJson::parse(R"({"point_mm": [1, 2, 3]})")));
    EXPECT_FALSE(is_read("/target", OrderedJson::parse(R"({"point_mm": [1, 2, 3, 4]})")));
    EXPECT_FALSE(is_read("/version", 0));
    EXPECT_FALSE(is_read("/version", 1.5));
}

TEST(LessonLimits, WhatIsLeftOutIsAsTheHeaderSays) {
    const Lesson lesson = lesson_of(brief_lesson_json().dump(), "file");
    EXPECT_EQ(lesson.patient, "any");
    EXPECT_EQ(lesson.about, "");
    EXPECT_TRUE(lesson.tools.empty() && lesson.marks.empty() && lesson.limits.empty());
    EXPECT_TRUE(lesson.pass.empty() && !lesson.target && lesson.setup.actions.empty());
    EXPECT_EQ(lesson.steps[0].hold_s, 1.0);
    EXPECT_EQ(LessonStep{}.hold_s, 0.0);
    EXPECT_EQ(lesson.steps[0].hint, "");
    const Predicate plain;
    EXPECT_EQ(plain, (Predicate{Quantity::time_s, -1, true, 0.0}));
}

TEST(LessonLimits, EveryToolHasItsName) {
    const std::vector<std::pair<LessonTool, std::string>> tools{
        {LessonTool::pull, "pull"},         {LessonTool::sphere, "sphere"},
        {LessonTool::capsule, "capsule"},   {LessonTool::forceps, "forceps"},
        {LessonTool::hook, "hook"},         {LessonTool::blade, "blade"},
        {LessonTool::cut_line, "cut_line"}, {LessonTool::inject, "inject"},
        {LessonTool::settings, "settings"}};
    for (const auto& [tool, name] : tools) {
        EXPECT_EQ(name_of(tool), name);
        OrderedJson json = brief_lesson_json();
        json["tools"] = {name};
        EXPECT_EQ(lesson_of(json.dump(), "file").tools, std::vector{tool});
    }
}

// A command is given by one tool, and by no other.
TEST(LessonLimits, EachCommandNeedsItsOwnTool) {
    const std::vector<std::pair<Command, LessonTool>> needs{
        {GrabPoint{}, LessonTool::pull},
        {GrabVertex{}, LessonTool::pull},
        {AddTool{.kind = "sphere"}, LessonTool::sphere},
        {AddTool{.kind = "capsule"}, LessonTool::capsule},
        {AddTool{.kind = "forceps"}, LessonTool::forceps},
        {AddTool{.kind = "hook"}, LessonTool::hook},
        {Blade{}, LessonTool::blade},
        {CutLine{}, LessonTool::cut_line},
        {InjectDrug{}, LessonTool::inject},
        {SetDrugTime{}, LessonTool::settings},
        {SetDrugSpeed{}, LessonTool::settings},
        {SetGravity{}, LessonTool::settings},
        {SetTether{}, LessonTool::settings},
        {SetWall{}, LessonTool::settings},
        {UseTear{}, LessonTool::settings},
        {UseContact{}, LessonTool::settings}};
    const std::map<LessonTool, std::string> called{{LessonTool::pull, "pulling by hand"},
                                                   {LessonTool::sphere, "probe"},
                                                   {LessonTool::capsule, "rod probe"},
                                                   {LessonTool::forceps, "forceps"},
                                                   {LessonTool::hook, "hook"},
                                                   {LessonTool::blade, "blade"},
                                                   {LessonTool::cut_line, "cut line"},
                                                   {LessonTool::inject, "injecting"},
                                                   {LessonTool::settings, "changing settings"}};
    for (const auto& [command, tool] : needs)
        for (int other = 0; other <= static_cast<int>(LessonTool::settings); ++other) {
            Lesson lesson;
            lesson.tools = {static_cast<LessonTool>(other)};
            const std::string objection = objection_to(command, lesson);
            if (lesson.tools[0] == tool)
                EXPECT_EQ(objection, "");
            else
                EXPECT_EQ(objection, "the lesson does not allow this: " + called.at(tool));
        }
    for (const Command& free :
         {Command(MoveGrab{}), Command(ReleaseGrab{}), Command(RemoveDrug{}), Command(PlayDrug{}),
          Command(SetQuality{}), Command(SetPaused{}), Command(FinishInjection{}),
          Command(MoveTool{}), Command(ShiftTool{}), Command(RemoveTool{}), Command(TurnTool{}),
          Command(UseTools{}), Command(CloseForceps{}), Command(OpenForceps{})})
        EXPECT_EQ(objection_to(free, Lesson{}), "");
}

TEST(LessonLimits, OnlyTheLessonsDrugMayBeInjected) {
    Lesson lesson;
    lesson.tools = {LessonTool::inject};
    lesson.drug = "lipiodol";
    EXPECT_EQ(objection_to(InjectDrug{.second_phase = "lipiodol"}, lesson), "");
    EXPECT_EQ(objection_to(InjectDrug{.second_phase = "carrier"}, lesson),
              "the lesson asks for another drug: lipiodol");
}

TEST(LessonLimits, TheTableOfMetricsInFull) {
    const LessonMetrics metrics{1.5, 2.25, 3, 4, 5, 6, 1.125, 8, 9, 10, 11, 12, 16, 0.25, 15, 17};
    EXPECT_EQ(to_csv(metrics),
              "metric,value,unit\ntime_s,1.5,s\npath_mm,2.25,mm\npeak_force_mn,3,mN\n"
              "impulse_mn_s,4,mN s\ncontacts,5,\ncontact_s,6,s\nlargest_stretch,1.125,\n"
              "joints_broken,8,\npieces_off,9,\ntorn_area_mm2,10,mm²\nblood_lost_g,11,g\n"
              "injected_g,12,g\ndelivered_g,16,g\ndose_target_g,0.25,g\ndose_elsewhere_g,15,g\n"
              "reflux_g,17,g\ndose_target_share,0.015625,\n");
    EXPECT_EQ(to_json(metrics).dump(),
              R"({"time_s":1.5,"path_mm":2.25,"peak_force_mn":3.0,"impulse_mn_s":4.0,)"
              R"("contacts":5,"contact_s":6.0,"largest_stretch":1.125,"joints_broken":8,)"
              R"("pieces_off":9,"torn_area_mm2":10.0,"blood_lost_g":11.0,"injected_g":12.0,)"
              R"("delivered_g":16.0,"dose_target_g":0.25,"dose_elsewhere_g":15.0,)"
              R"("reflux_g":17.0,"dose_target_share":0.015625})");
    EXPECT_EQ(to_json(LessonMetrics{}).dump(),
              R"({"time_s":0.0,"path_mm":0.0,"peak_force_mn":0.0,"impulse_mn_s":0.0,)"
              R"("contacts":0,"contact_s":0.0,"largest_stretch":1.0,"joints_broken":0,)"
              R"("pieces_off":0,"torn_area_mm2":0.0,"blood_lost_g":0.0,"injected_g":0.0,)"
              R"("delivered_g":0.0,"dose_target_g":0.0,"dose_elsewhere_g":0.0,)"
              R"("reflux_g":0.0,"dose_target_share":null})");
}

TEST(LessonLimits, ANumberInWordsHasAsManyDigitsAsItNeeds) {
    EXPECT_EQ(to_words(Quantity::path_mm, 5e-4), "0.0005 mm");
    EXPECT_EQ(to_words(Quantity::path_mm, 4.99e-4), "0 mm");
    EXPECT_EQ(to_words(Quantity::path_mm, -5e-4), "-0.0005 mm");
    EXPECT_EQ(to_words(Quantity::path_mm, 1.23456), "1.235 mm");
    EXPECT_EQ(to_words(Quantity::path_mm, HUGE_VAL), "none");
    EXPECT_EQ(to_words_beside({Quantity::path_mm, -1, false, 1.0}, 1.0), "1 mm");
    EXPECT_EQ(to_words_beside({Quantity::path_mm, -1, false, 1.0}, 1.00000000001),
              "1.00000000001 mm");
    EXPECT_EQ(to_words_beside({Quantity::path_mm, -1, false, 1.0}, 1.000000000001), "1 mm");
}

TEST(LessonLimits, ABoundHoldsAtItselfAndTheWorseIsFurtherOut) {
    const Predicate least{Quantity::time_s, -1, true, 2.0}, most{Quantity::time_s, -1, false, 2.0};
    EXPECT_TRUE(least.holds(2.0) && most.holds(2.0));
    EXPECT_FALSE(least.holds(1.999) || most.holds(2.001));
    EXPECT_EQ(least.worse(1.0, 3.0), 1.0);
    EXPECT_EQ(least.worse(3.0, 1.0), 1.0);
    EXPECT_EQ(most.worse(1.0, 3.0), 3.0);
    EXPECT_EQ(most.worse(3.0, 1.0), 3.0);
}

// A tenth of a second apart are two contacts, and less is one.
TEST(LessonLimits, OfTheTimeBetweenContacts) {
    EXPECT_EQ(PlayMeter::same_contact_s, 0.1);
    Lesson lesson = test::plain_lesson();
    lesson.scene.dt_s = 0.0625;
    const auto contacts_after = [&](int frames_apart) {
        PlayMeter meter(lesson, test::small_patient());
        meter.begin(test::rest_frame());
        meter.see(test::touching(true));
        for (int i = 0; i < frames_apart; ++i) meter.see(test::touching(false));
        meter.see(test::touching(true));
        return meter.metrics().contacts;
    };
    EXPECT_EQ(contacts_after(1), 1);
    EXPECT_EQ(contacts_after(2), 2);
}

TEST(LessonLimits, ScenesMayDifferInTheSolversAccuracyAlone) {
    SceneSpec scene;
    scene.deform.emplace();
    SceneSpec other = scene;
    other.deform->quality = 0.25;
    EXPECT_NO_THROW(require_same_scene(scene, other));
    other.dt_s = 0.5 * scene.dt_s;
    EXPECT_THROW(require_same_scene(scene, other), InputError);
    other = scene;
    other.deform.reset();
    EXPECT_THROW(require_same_scene(scene, other), InputError);
}

// Two lessons of flow alone have scenes of the same parts.
TEST(LessonScene, IsTheLessonsOwnByItsNameToo) {
    Recording recording;
    recording.scene = find_lesson("selective_injection").scene;
    const SceneSpec embolization = find_lesson("embolization").scene;
    EXPECT_FALSE(is_same_scene(recording.scene, embolization));
    EXPECT_EQ(built_in_lesson_of(recording)->name, "Selective injection");
    try {
        require_same_scene(recording.scene, embolization);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("name is \"injection\", not \"embolization\""),
                  std::string::npos)
            << error.what();
    }
}

// What differs, and not two whole scenes.
TEST(LessonScene, NamesWhatDiffers) {
    SceneSpec recorded, wanted;
    recorded.deform->tether_pa_per_mm2 = 7.0;
    wanted.deform->wall_mm = 2.0;
    wanted.tear.emplace();
    try {
        require_same_scene(recorded, wanted);
        ADD_FAILURE();
    } catch (const InputError& error) {
        const std::string said = error.what();
        EXPECT_NE(said.find("deform.tether_pa_per_mm2 is 7.0, not 20.0"), std::string::npos)
            << said;
        EXPECT_NE(said.find("deform.wall_mm is left out, not 2.0"), std::string::npos) << said;
        EXPECT_NE(said.find("tear.tear_factor is left out, not 1.0"), std::string::npos) << said;
        EXPECT_EQ(said.find("material"), std::string::npos) << said;
    }
    try {
        require_same_scene(wanted, recorded);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("deform.wall_mm is 2.0, not left out"),
                  std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace hepatica
