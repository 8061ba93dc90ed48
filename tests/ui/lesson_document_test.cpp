// SPDX-License-Identifier: GPL-3.0-or-later
// The lesson that is being made, without its window: undo, its file, how it names its patient, and
// what a crash leaves behind.
#include "ui/lesson_editor/lesson_document.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"
#include "core/base/text_file.h"
#include "core/lesson/attempts.h"
#include "core/lesson/draft_file.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_writer.h"
#include "ui/lesson_editor/draft_slot.h"

namespace hepatica {
namespace {

TEST(LessonDocument, UndoesWhatWasTypedInOneFieldAtOnce) {
    LessonDocument document({});
    EXPECT_FALSE(document.dirty() || document.can_undo());
    for (const char* name : {"P", "Pu", "Pull"})
        document.change("name", [&](Lesson& lesson) { lesson.name = name; });
    document.change("about", [](Lesson& lesson) { lesson.about = "why"; });
    document.change("", [](Lesson& lesson) { lesson.tools.clear(); });
    document.change("", [](Lesson& lesson) { lesson.tools = {LessonTool::hook}; });
    EXPECT_FALSE(document.change("", [](Lesson& lesson) { lesson.about = "why"; }));
    document.undo();
    EXPECT_TRUE(document.lesson().tools.empty()) << "two changes without a field are two";
    document.undo();
    document.undo();
    EXPECT_EQ(document.lesson().about, "");
    EXPECT_EQ(document.lesson().name, "Pull");
    document.undo();
    EXPECT_EQ(document.lesson().name, "A new lesson");
    EXPECT_FALSE(document.can_undo() || document.dirty());
    document.redo();
    EXPECT_EQ(document.lesson().name, "Pull");
    document.change("name", [](Lesson& lesson) { lesson.name = "Push"; });
    EXPECT_FALSE(document.can_redo());
    document.undo();
    EXPECT_EQ(document.lesson().name, "Pull") << "typing after a redo is a change of its own";
}

// By it attempts find their lesson.
TEST(LessonDocument, GivesALessonAnIdThatARenamingKeepsAndACopyDoesNot) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "a.json", copy = folder.path() / "b.json";
    LessonDocument document({});
    document.save(file);
    const std::string id = read_lesson(file).id;
    EXPECT_NE(id, "");
    EXPECT_FALSE(document.dirty());
    document.change("name", [](Lesson& lesson) { lesson.name = "Renamed"; });
    document.save(file);
    EXPECT_EQ(read_lesson(file).id, id);
    document.undo();
    document.save(file);
    EXPECT_EQ(read_lesson(file).id, id);
    document.save(copy);
    EXPECT_NE(read_lesson(copy).id, id);
    EXPECT_FALSE(document.dirty());
    LessonDocument again({});
    again.open(file);
    EXPECT_FALSE(again.dirty());
    again.save(file);
    EXPECT_EQ(read_lesson(file).id, id);
}

TEST(LessonDocument, KnowsAnOlderLessonByTheNameOfItsAttempts) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "a.json";
    write_lesson(file, new_lesson());
    LessonDocument document({});
    document.open(file);
    document.save(file);
    EXPECT_EQ(read_lesson(file).id, "");
    document.change("name", [](Lesson& lesson) { lesson.name = "Renamed"; });
    document.save(file);
    EXPECT_EQ(read_lesson(file).id, id_of_former_name(new_lesson().name));
}

// The program ended between the renaming and the save.
TEST(LessonDocument, KnowsAnOlderLessonThatWasRenamedBeforeACrash) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "a.json", kept = folder.path() / "kept";
    write_lesson(file, new_lesson());
    {
        LessonDocument document(kept);
        document.open(file);
        document.change("name", [](Lesson& lesson) { lesson.name = "Renamed"; });
        document.keep_copy();
    }
    LessonDocument recovered(kept);
    ASSERT_TRUE(recovered.left_behind());
    recovered.save(file);
    EXPECT_EQ(read_lesson(file).id, id_of_former_name(new_lesson().name));
}

TEST(LessonDocument, NamesAPatientBelowTheFileRelativeToIt) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "lesson.json";
    const std::string inside = (folder.path() / "cases" / "a.hep").string();
    for (const auto& [patient, written] :
         {std::pair(inside, std::string("cases/a.hep")),
          std::pair(std::string("any"), std::string("any")),
          std::pair(std::string("/elsewhere/b.hep"), std::string("/elsewhere/b.hep"))}) {
        LessonDocument document({});
        document.change("", [&](Lesson& lesson) { lesson.patient = patient; });
        document.save(file);
        EXPECT_FALSE(patient != "any" && document.dirty());
        EXPECT_EQ(read_lesson(file).patient, written);
        LessonDocument again({});
        again.open(file);
        EXPECT_EQ(again.lesson().patient, patient);
        EXPECT_EQ(again.file(), file);
        EXPECT_FALSE(again.dirty());
    }
}

TEST(LessonDocument, NamesAPatientAboveTheFileAsItDidBefore) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "course" / "lesson.json";
    std::filesystem::create_directories(file.parent_path());
    Lesson lesson = new_lesson();
    lesson.patient = "../cases/a.hep";
    write_lesson(file, lesson);
    LessonDocument document({});
    document.open(file);
    EXPECT_EQ(document.lesson().patient, (folder.path() / "cases" / "a.hep").string());
    document.change("", [](Lesson& changed) { changed.name = "Other"; });
    document.save(file);
    EXPECT_EQ(read_lesson(file).patient, "../cases/a.hep");
    document.save(folder.path() / "lesson.json");  // from there the path would be another
    EXPECT_EQ(read_lesson(folder.path() / "lesson.json").patient, "cases/a.hep");
}

// The path in the first file means another place when it is read from the second one's folder.
TEST(LessonDocument, NamesThePatientOfTheFileThatItWasSavedAsFromThereOn) {
    const TemporaryFolder folder;
    const std::filesystem::path first = folder.path() / "first", second = folder.path() / "second";
    std::filesystem::create_directories(first);
    std::filesystem::create_directories(second);
    const std::string patient = (first / "a.hep").string();
    Lesson lesson = new_lesson();
    lesson.patient = "a.hep";
    write_lesson(first / "lesson.json", lesson);
    LessonDocument document({});
    document.open(first / "lesson.json");
    document.save(second / "lesson.json");
    EXPECT_EQ(read_lesson(second / "lesson.json").patient, patient);
    document.change("", [](Lesson& changed) { changed.name = "Other"; });
    document.save(second / "lesson.json");
    EXPECT_EQ(read_lesson(second / "lesson.json").patient, patient);
    LessonDocument again({});
    again.open(second / "lesson.json");
    EXPECT_EQ(again.lesson().patient, patient);
}

TEST(LessonDocument, LeavesWhatIsNotSavedBehindUntilItIs) {
    const TemporaryFolder folder;
    const std::filesystem::path copy = folder.path() / "data" / "unsaved.json";
    LessonDocument document(copy);
    document.keep_copy();
    EXPECT_FALSE(std::filesystem::exists(copy)) << "nothing is unsaved";
    document.change("", [](Lesson& lesson) { lesson.name = "Mine"; });
    document.keep_copy();
    document.change("", [](Lesson& lesson) { lesson.steps[0].goal.clear(); });
    document.keep_copy();  // half of a change, too
    EXPECT_TRUE(document.kept());
    {
        const LessonDocument after_a_crash(copy);
        EXPECT_EQ(text_of(after_a_crash.lesson()), text_of(document.lesson()));
        EXPECT_TRUE(after_a_crash.left_behind());
        EXPECT_TRUE(after_a_crash.dirty()) << "or the next start would throw it away";
    }
    EXPECT_THROW(document.save(folder.path() / "lesson.json"), InputError);
    EXPECT_TRUE(document.dirty());
    document.undo();
    document.save(folder.path() / "lesson.json");
    EXPECT_FALSE(std::filesystem::exists(copy));
    EXPECT_FALSE(LessonDocument(copy).left_behind());
    std::ofstream(copy) << "{half";
    EXPECT_EQ(LessonDocument(copy).lesson().name, new_lesson().name);
    EXPECT_EQ(read_text_file(copy.string() + ".unreadable", ""), "{half");
}

TEST(LessonDocument, KnowsAfterACrashWhereItsLessonLies) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "course" / "lesson.json";
    const std::filesystem::path copy = folder.path() / "unsaved.json";
    std::filesystem::create_directories(file.parent_path());
    Lesson lesson = new_lesson();
    lesson.patient = "../cases/a.hep";
    write_lesson(file, lesson);
    LessonDocument document(copy);
    document.open(file);
    document.change("", [](Lesson& changed) { changed.name = "Other"; });
    document.keep_copy();
    LessonDocument after_a_crash(copy);
    EXPECT_EQ(after_a_crash.file(), file);
    EXPECT_TRUE(after_a_crash.dirty());
    after_a_crash.save(after_a_crash.file());
    EXPECT_EQ(read_lesson(file).name, "Other");
    EXPECT_EQ(read_lesson(file).patient, "../cases/a.hep") << "named as before";
}

TEST(DraftSlot, IsOfOneProgramAndFindsWhatOneLeft) {
    const TemporaryFolder folder;
    const std::filesystem::path first = folder.path() / "data" / "unsaved.json";
    const std::filesystem::path second = folder.path() / "data" / "unsaved-2.json";
    {
        const DraftSlot one(first), two(first);
        EXPECT_EQ(one.file(), first);
        EXPECT_EQ(two.file(), second);
        std::ofstream(two.file()) << "left behind";
    }
    const DraftSlot three(first);
    EXPECT_EQ(three.file(), second) << "what was left behind comes first";
    const DraftSlot four(first);
    EXPECT_EQ(four.file(), first);
    EXPECT_TRUE(DraftSlot({}).file().empty());
}

}  // namespace
}  // namespace hepatica
