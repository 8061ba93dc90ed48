// SPDX-License-Identifier: GPL-3.0-or-later
// Notes beside a recording come back as they were written; a damaged file is refused by its place.
#include "core/lesson/play_notes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string problem_of(const std::string& text) {
    try {
        notes_of(text, "play.notes.json");
    } catch (const InputError& error) {
        return error.place() + " " + error.problem();
    }
    return "nothing";
}

TEST(PlayNotes, ComeBackInTheOrderOfTime) {
    const TemporaryFolder folder;
    const fs::path recording = folder.path() / "a play.hrec";
    EXPECT_TRUE(read_notes(recording).empty());
    write_notes(recording, {{9.5, "Länger \"halten\"\nbitte"}, {0.0, "Good"}});
    EXPECT_TRUE(fs::exists(folder.path() / "a play.notes.json"));
    const std::vector<PlayNote> sorted{{0.0, "Good"}, {9.5, "Länger \"halten\"\nbitte"}};
    EXPECT_EQ(read_notes(recording), sorted);
    write_notes(recording, {});
    EXPECT_FALSE(fs::exists(notes_file_of(recording)));
    write_notes(recording, {});  // and again
}

TEST(PlayNotes, OfADamagedFileAreRefusedByTheirPlace) {
    const auto with = [](const std::string& notes) {
        return R"({"format": "hepatica-notes", "version": 1, "notes": )" + notes + "}";
    };
    EXPECT_EQ(problem_of(with("[]")), "nothing");
    EXPECT_THAT(problem_of("{"), HasSubstr("is not JSON"));
    EXPECT_THAT(problem_of("[]"), HasSubstr("is not an object"));
    EXPECT_THAT(problem_of(R"({"format": "other", "version": 1, "notes": []})"),
                HasSubstr("format is \"other\""));
    EXPECT_THAT(problem_of(R"({"format": "hepatica-notes", "version": 2, "notes": []})"),
                HasSubstr("version is 2"));
    EXPECT_THAT(problem_of(with("{}")), HasSubstr("notes is {}, not a list"));
    EXPECT_THAT(problem_of(with(R"([{"at_s": -1, "text": "x"}])")),
                HasSubstr("notes[0].at_s is -1"));
    EXPECT_THAT(problem_of(with(R"([{"at_s": 0, "text": "x"}, {"at_s": "1", "text": "x"}])")),
                HasSubstr("not a number"));
    EXPECT_THAT(problem_of(with(R"([{"at_s": 0, "text": ""}])")), HasSubstr("notes[0].text"));
    EXPECT_THAT(problem_of(with(R"([{"at_s": 0, "text": "x", "by": "me"}])")),
                HasSubstr("notes[0].by is not known"));
}

TEST(PlayNotes, ThatCannotBeWrittenLeaveTheOldOnes) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "file";
    std::ofstream(file) << "no folder";
    EXPECT_THROW(write_notes(file / "play.hrec", {{1.0, "x"}}), InputError);
}

}  // namespace
}  // namespace hepatica
