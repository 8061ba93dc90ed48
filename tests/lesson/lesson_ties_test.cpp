// SPDX-License-Identifier: GPL-3.0-or-later
// On a fork whose lengths are known: a trunk of 40 mm and two branches of 30 and 20 mm.
#include "core/lesson/lesson_ties.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_writer.h"
#include "core/tree/editing/tree_edit.h"

namespace hepatica {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

VesselSegment tube(int from, int to, int parent, const Vec3& begin, const Vec3& end,
                   double radius_mm) {
    VesselSegment segment;
    segment.proximal_node = from;
    segment.distal_node = to;
    segment.parent = parent;
    constexpr int pieces = 10;
    for (int i = 0; i <= pieces; ++i)
        segment.points_mm.push_back(begin + (end - begin) * i / pieces);
    segment.radii_mm.assign(pieces + 1, radius_mm);
    return segment;
}

VesselTree fork() {
    const Vec3 root(0, 0, 0), middle(0, 0, 40), right(30, 0, 40), back(0, 20, 40);
    VesselTree tree;
    tree.nodes = {{root, 4.0}, {middle, 3.0}, {right, 2.0}, {back, 1.5}};
    tree.segments = {tube(0, 1, -1, root, middle, 4.0), tube(1, 2, 0, middle, right, 2.0),
                     tube(1, 3, 0, middle, back, 1.5)};
    return tree;
}

VesselTree without_branch_at(const Vec3& at) {
    TreeEdit edit;
    edit.kind = TreeEditKind::delete_branch;
    edit.at_mm = at;
    return edited(fork(), edit);
}

const Vec3 on_right(20, 0, 40), on_back(0, 15, 40);

Lesson lesson_of_a_case() {
    Lesson lesson = new_lesson();
    lesson.patient = "anna.hep";
    lesson.marks = {{"right", {on_right, std::nullopt}}, {"back", {on_back, std::nullopt}}};
    return lesson;
}

constexpr const char* blade_on_back =
    R"({"do": "blade", "from_mm": [-5, 15, 40], "to_mm": [5, 15, 40]})";
constexpr const char* cut_line_on_right =
    R"({"do": "cut_line", "from": {"point_mm": [20, 0, 40]}, "to": {"point_mm": [22, 0, 40]}})";

void give_setup(Lesson& lesson, const std::string& actions) {
    lesson.setup_json = actions;
    lesson.setup = script_of(R"({"name": "setup", "actions": )" + actions + "}", "setup");
}

TEST(LessonTies, FitTheVesselsOnWhichTheyWereMade) {
    Lesson lesson = lesson_of_a_case();
    lesson.target = ScriptPlace{std::nullopt, 0.25};
    EXPECT_FALSE(is_tied(lesson));
    EXPECT_THAT(misfits(lesson, without_branch_at(on_back)), IsEmpty()) << "never tied";
    tie(lesson, fork());
    EXPECT_TRUE(is_tied(lesson));
    EXPECT_THAT(misfits(lesson, fork()), IsEmpty());
    EXPECT_EQ(lesson.marks[0].tie, (PlaceTie{on_right, 2.0, 0.0}));
    // A quarter of 70 mm from the root; beyond it the rest of the trunk and both branches.
    EXPECT_EQ(lesson.target_tie, (PlaceTie{Vec3(0, 0, 17.5), 4.0, 40.0 - 17.5 + 30.0 + 20.0}));
}

TEST(LessonTies, NameTheMarkWhoseBranchIsGone) {
    Lesson lesson = lesson_of_a_case();
    tie(lesson, fork());
    EXPECT_THAT(misfits(lesson, without_branch_at(on_back)),
                ElementsAre("\"back\" now lies 15 mm from where it was when the lesson was made."));
}

// A share is found on every patient, and on every correction of him.
TEST(LessonTies, NameTheShareThatFollowsAnotherLongestPath) {
    Lesson lesson = lesson_of_a_case();
    lesson.marks = {{"far", {std::nullopt, 1.0}}, {"trunk", {std::nullopt, 0.0}}};
    tie(lesson, fork());
    EXPECT_EQ(lesson.marks[0].tie->at_mm, Vec3(30, 0, 40));
    EXPECT_THAT(misfits(lesson, without_branch_at(on_right)),
                ElementsAre(HasSubstr("\"far\" now lies 36 mm")));  // from (30, 0) to (0, 20)
}

// It lies where it did, and what is beyond it is less.
TEST(LessonTies, NameTheTargetThatHasOtherVesselsBeyondIt) {
    Lesson lesson = lesson_of_a_case();
    lesson.marks.clear();
    lesson.target = ScriptPlace{Vec3(0, 0, 20), std::nullopt};
    tie(lesson, fork());
    EXPECT_THAT(misfits(lesson, without_branch_at(on_back)),
                ElementsAre("The target has 50 mm of vessels beyond it, and had 70 mm when the "
                            "lesson was made."));
}

TEST(LessonTies, NameWhatTheSetupCuts) {
    Lesson lesson = lesson_of_a_case();
    lesson.marks.clear();
    give_setup(lesson, std::string("[") + blade_on_back + ", " + cut_line_on_right + "]");
    tie(lesson, fork());
    EXPECT_EQ(lesson.setup_ties.size(), 3u);
    EXPECT_THAT(misfits(lesson, without_branch_at(on_back)),
                ElementsAre(HasSubstr("Place 1 of the setup now lies 15 mm")));
    EXPECT_THAT(misfits(lesson, without_branch_at(on_right)),
                ElementsAre(HasSubstr("Place 2 of the setup now lies 20 mm"),
                            HasSubstr("Place 3 of the setup now lies 22 mm")));
}

// Actions that are commands of a recording name their points without a "where".
TEST(LessonTies, NameWhereACommandOfTheSetupActs) {
    for (const Command& command : {Command(GrabPoint{on_back}), Command(InjectDrug{on_back}),
                                   Command(AddTool{.point_mm = on_back})}) {
        nlohmann::ordered_json json = to_json(command);
        const std::string name = json["command"];
        json["do"] = name;
        json.erase("command");
        const std::string action = json.dump();
        Lesson lesson = lesson_of_a_case();
        lesson.marks.pop_back();  // the one on the branch that goes
        give_setup(lesson, "[" + action + "]");
        EXPECT_FALSE(is_tied(lesson)) << action;
        tie(lesson, fork());
        EXPECT_TRUE(is_tied(lesson)) << action;
        EXPECT_THAT(misfits(lesson, fork()), IsEmpty()) << action;
        EXPECT_THAT(misfits(lesson, without_branch_at(on_back)),
                    ElementsAre(HasSubstr("Place 1 of the setup now lies 15 mm")))
            << action;
        const Lesson read = lesson_of(text_of(lesson), "file");
        EXPECT_TRUE(is_tied(read)) << action << ": its tie is kept in the file";
    }
}

// Whoever edits the file by hand puts something in front, exchanges two actions, takes one away.
TEST(LessonTies, StayWithThePlacesOfASetupWhoseOrderChanges) {
    Lesson lesson = lesson_of_a_case();
    lesson.marks.pop_back();  // the one on the branch that goes
    give_setup(lesson, std::string("[") + blade_on_back + ", " + cut_line_on_right + "]");
    tie(lesson, fork());
    const std::string inject_at_root = R"({"do": "inject", "where": {"share_of_longest_path": 0}})";
    give_setup(lesson,
               "[" + inject_at_root + ", " + cut_line_on_right + ", " + blade_on_back + "]");
    EXPECT_THAT(misfits(lesson, fork()), IsEmpty()) << "all places are where they were";
    EXPECT_FALSE(is_tied(lesson)) << "the new one is not noted yet";
    const Lesson read = lesson_of(text_of(lesson), "file");
    EXPECT_THAT(misfits(read, without_branch_at(on_back)),
                ElementsAre(HasSubstr("Place 4 of the setup now lies 15 mm")));
    give_setup(lesson, std::string("[") + cut_line_on_right + "]");
    EXPECT_THAT(misfits(lesson, without_branch_at(on_back)), IsEmpty()) << "cut no more";
    tie(lesson, fork());
    EXPECT_EQ(lesson.setup_ties.size(), 2u);
}

// As the program before wrote them: nobody knows of which places they are.
TEST(LessonTies, OfASetupThatNameNoPlaceAreLeft) {
    Lesson lesson = lesson_of_a_case();
    give_setup(lesson, std::string("[") + blade_on_back + "]");
    std::string text = text_of(lesson);
    text.insert(text.find("\"tools\""),
                R"("setup_tied": [{"at_mm": [90, 0, 0], "radius_mm": 1}], )");
    const Lesson read = lesson_of(text, "file");
    EXPECT_THAT(misfits(read, fork()), IsEmpty());
    EXPECT_FALSE(is_tied(read));
}

// Of a rebuilding the centreline comes out a little beside where it was.
TEST(LessonTies, BearWhatStaysWithinTheLumen) {
    Lesson lesson = lesson_of_a_case();
    tie(lesson, fork());
    const auto moved = [](double by_mm) {
        VesselTree tree = fork();
        for (Vec3& point : tree.segments[1].points_mm) point.z() += by_mm;
        return tree;
    };
    EXPECT_THAT(misfits(lesson, moved(1.9)), IsEmpty());
    EXPECT_THAT(misfits(lesson, moved(2.1)), Not(IsEmpty()));
}

TEST(LessonTies, HoldOnlyLessonsForOneCase) {
    for (const char* patient : {"any", "built-in"}) {
        Lesson lesson = lesson_of_a_case();
        lesson.patient = patient;
        tie(lesson, fork());
        EXPECT_FALSE(lesson.marks[0].tie) << patient;
        EXPECT_FALSE(can_be_tied(lesson)) << patient;
    }
}

TEST(LessonTies, ArePutAnewOnlyWhereThereAreNone) {
    Lesson lesson = lesson_of_a_case();
    tie(lesson, fork());
    const VesselTree corrected = without_branch_at(on_back);
    tie(lesson, corrected);
    EXPECT_THAT(misfits(lesson, corrected), Not(IsEmpty())) << "saving again is no consent";
    untie(lesson);
    EXPECT_FALSE(is_tied(lesson));
    tie(lesson, corrected);
    EXPECT_THAT(misfits(lesson, corrected), IsEmpty());
}

TEST(LessonTies, AreInTheFile) {
    Lesson lesson = lesson_of_a_case();
    lesson.target = ScriptPlace{std::nullopt, 0.25};
    give_setup(lesson, std::string("[") + blade_on_back + ", " + cut_line_on_right + "]");
    tie(lesson, fork());
    const Lesson read = lesson_of(text_of(lesson), "file");
    EXPECT_TRUE(is_tied(read));
    EXPECT_EQ(read.marks[0].tie, lesson.marks[0].tie);
    EXPECT_EQ(read.target_tie, lesson.target_tie);
    EXPECT_EQ(read.setup_ties.size(), 3u);
    EXPECT_EQ(text_of(read), text_of(lesson));
    EXPECT_THROW(lesson_of(R"({"format": "hepatica-lesson", "version": 1, "name": "n",
        "scene": {"flow": {}}, "marks": {"m": {"point_mm": [0, 0, 0], "tied": {"at_mm": [0, 0]}}},
        "steps": [{"text": "t", "goal": [{"what": "holding", "at_least": 1}]}]})",
                           "file"),
                 InputError);
}

}  // namespace
}  // namespace hepatica
