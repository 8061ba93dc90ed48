// SPDX-License-Identifier: GPL-3.0-or-later
// Results come back as they were written, in the order of time, each lesson's for itself.
#include "core/lesson/attempts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Attempt attempt_at(const fs::path& recording, const std::string& ended_at, double time_s) {
    LessonStanding standing;
    standing.outcome = LessonOutcome::failed;
    standing.reasons = {"limit broken: \"force\"", "später"};
    standing.metrics.time_s = time_s;
    standing.metrics.contacts = 3;
    return attempt_of(recording, "Gentle pull", standing, ended_at);
}

TEST(Attempts, ComeBackInTheOrderOfTimeEachLessonsForItself) {
    const TemporaryFolder folder;
    write_attempt(attempt_at(folder.path() / "b.hrec", "2026-11-23T10:00:00Z", 1.0 / 3.0));
    Attempt earlier = attempt_at(folder.path() / "z.hrec", "2026-11-22T10:00:00Z", 7.0);
    earlier.reference = earlier.passed = true;
    earlier.reasons.clear();
    write_attempt(earlier);
    Attempt other = attempt_at(folder.path() / "c.hrec", "2026-11-21T10:00:00Z", 9.0);
    other.lesson = "Another";
    write_attempt(other);
    std::ofstream(folder.path() / "d.result.json") << "{";
    const Attempts found = attempts_at({"", "Gentle pull"}, folder.path());
    ASSERT_EQ(found.list.size(), 2u);
    EXPECT_EQ(found.list[0].recording, folder.path() / "z.hrec");
    EXPECT_TRUE(found.list[0].passed);
    EXPECT_TRUE(found.list[0].reference);
    EXPECT_TRUE(found.list[0].reasons.empty());
    EXPECT_EQ(found.list[1].value(Quantity::time_s), 1.0 / 3.0);
    EXPECT_EQ(found.list[1].value(Quantity::contacts), 3.0);
    EXPECT_TRUE(std::isnan(found.list[1].value(Quantity::dose_target_share)));
    EXPECT_FALSE(found.list[1].passed);
    EXPECT_EQ(found.list[1].reasons.back(), "später");
    ASSERT_EQ(found.passed_over.size(), 1u);
    EXPECT_THAT(found.passed_over[0], HasSubstr("d.result.json is not JSON"));
    EXPECT_TRUE(attempts_at({"", "Gentle pull"}, folder.path() / "none").list.empty());
}

// Lessons of the same name are not mixed, and one that is renamed keeps its attempts; those of
// older programs know a name alone.
TEST(Attempts, BelongToTheLessonWhoseIdTheyKnow) {
    const TemporaryFolder folder;
    Attempt mine = attempt_at(folder.path() / "a.hrec", "1", 1.0);
    mine.lesson_id = "mine";
    write_attempt(mine);
    Attempt other = attempt_at(folder.path() / "b.hrec", "2", 2.0);
    other.lesson_id = "other";
    write_attempt(other);
    write_attempt(attempt_at(folder.path() / "c.hrec", "3", 3.0));
    const auto times_at = [&](const LessonKey& lesson) {
        std::vector<double> times;
        for (const Attempt& attempt : attempts_at(lesson, folder.path()).list)
            times.push_back(attempt.value(Quantity::time_s));
        return times;
    };
    EXPECT_EQ(times_at({"mine", "Gentle pull"}), (std::vector<double>{1.0, 3.0}));
    EXPECT_EQ(times_at({"other", "Gentle pull"}), (std::vector<double>{2.0, 3.0}));
    EXPECT_EQ(times_at({"mine", "Renamed"}), std::vector<double>{1.0});
    EXPECT_EQ(times_at({"", "Gentle pull"}), std::vector<double>{3.0});
    EXPECT_EQ(times_at({id_of_former_name("Gentle pull"), "Renamed"}), std::vector<double>{3.0});
    EXPECT_TRUE(times_at({"Gentle pull", "Renamed"}).empty()) << "an id is no name";
}

TEST(Attempts, NameWhoGaveANameAndNobodyElse) {
    const TemporaryFolder folder;
    const fs::path plain = folder.path() / "a.hrec", named = folder.path() / "b.hrec";
    write_attempt(attempt_at(plain, "1", 5.0));
    Attempt of_someone = attempt_at(named, "2", 6.0);
    of_someone.name = "Nr. 7, \"Ä\"";
    write_attempt(of_someone);
    std::ifstream file(result_file_of(plain));
    const std::string text(std::istreambuf_iterator<char>(file), {});
    EXPECT_EQ(text.find("\"name\""), std::string::npos) << text;
    const Attempts found = all_attempts(folder.path());
    ASSERT_EQ(found.list.size(), 2u);
    EXPECT_EQ(found.list[0].name, "");
    EXPECT_EQ(found.list[1].name, of_someone.name);
    EXPECT_EQ(names_in(found.list), std::vector<std::string>{of_someone.name});
    EXPECT_EQ(name_beside(named), of_someone.name);
    EXPECT_EQ(name_beside(plain), "");
    EXPECT_EQ(name_beside(folder.path() / "none.hrec"), "");
    EXPECT_EQ(to_csv({found.list[0]}).find("name"), std::string::npos);
    const std::string table = to_csv(found.list);
    EXPECT_THAT(table, HasSubstr(",name\n"));
    EXPECT_THAT(table, HasSubstr(",\"Nr. 7, \"\"Ä\"\"\"\n"));
}

TEST(Attempts, TheBandIsOfThoseThatOthersAreMeasuredBy) {
    std::vector<Attempt> attempts{attempt_at("a.hrec", "1", 5.0), attempt_at("b.hrec", "2", 2.0),
                                  attempt_at("c.hrec", "3", 9.0)};
    EXPECT_EQ(band_of(attempts, Quantity::time_s), std::nullopt);
    attempts[0].reference = true;
    EXPECT_EQ(band_of(attempts, Quantity::time_s), (Band{5.0, 5.0}));
    attempts[1].reference = true;
    EXPECT_EQ(band_of(attempts, Quantity::time_s), (Band{2.0, 5.0}));
    EXPECT_EQ(band_of(attempts, Quantity::dose_target_share), std::nullopt) << "not known of any";
}

TEST(Attempts, AsATableHaveARowEach) {
    std::vector<Attempt> attempts{attempt_at("a.hrec", "2026", 0.1)};
    attempts[0].passed = true;
    const std::string csv = to_csv(attempts);
    EXPECT_TRUE(csv.starts_with("lesson,attempt,ended_at,passed,reference,time_s,path_mm"));
    EXPECT_THAT(csv, HasSubstr("\n\"Gentle pull\",1,\"2026\",yes,no,0.1,0,"));
    EXPECT_TRUE(csv.ends_with(",\n")) << "a share that is not known is empty";
    attempts[0].ended_at = "on Monday, \"late\"";  // files can be edited by hand
    EXPECT_THAT(to_csv(attempts), HasSubstr(",1,\"on Monday, \"\"late\"\"\",yes,no,"));
}

// Seventeen digits are noise of the computation that no table is read for.
TEST(Attempts, OfATableHaveSixDigits) {
    const Attempt attempt = attempt_at("a.hrec", "2026", 100.0 / 3.0);
    EXPECT_THAT(to_csv({attempt}), HasSubstr(",\"2026\",no,no,33.3333,0,"));
}

TEST(Attempts, OfADamagedFileAreRefusedByTheirPlace) {
    const TemporaryFolder folder;
    const Attempt attempt = attempt_at(folder.path() / "a.hrec", "2026", 0.1);
    write_attempt(attempt);
    std::ifstream in(result_file_of(attempt.recording));
    const std::string whole((std::istreambuf_iterator<char>(in)), {});
    const auto problem_of = [&](const std::string& part, const std::string& by) {
        std::string text = whole;
        const std::size_t at = text.find(part);
        if (at == std::string::npos) return std::string("no such part");
        text.replace(at, part.size(), by);
        try {
            attempt_from(text, attempt.recording, "a.result.json");
        } catch (const InputError& error) {
            return error.place() + " " + error.problem();
        }
        return std::string("nothing");
    };
    EXPECT_EQ(problem_of("\"2026\"", "\"2027\""), "nothing");
    EXPECT_EQ(problem_of("{", ""), "a.result.json is not JSON");
    EXPECT_THAT(problem_of("hepatica-result", "other"), HasSubstr("format is \"other\""));
    EXPECT_THAT(problem_of("\"version\": 1", "\"version\": 2"), HasSubstr("version is 2"));
    EXPECT_THAT(problem_of("\"passed\": false", "\"passed\": 0"), HasSubstr("passed is 0, not"));
    EXPECT_THAT(problem_of("\"reference\": false", "\"ref\": false"),
                HasSubstr("ref is not known"));
    EXPECT_THAT(problem_of("\"time_s\": 0.1", "\"time_s\": \"x\""),
                HasSubstr("metrics.time_s is \"x\""));
    EXPECT_THAT(problem_of("\"time_s\"", "\"time\""), HasSubstr("metrics has no \"time_s\""));
    EXPECT_THAT(problem_of("\"Gentle pull\"", "\"\""), HasSubstr("lesson is \"\""));
}

// Of a lesson of two steps with one pass mark of its own, begun from a course that asks for 60 s.
LessonStanding standing_of_course(bool own_kept, bool course_kept) {
    LessonStanding standing;
    standing.steps.resize(2);
    standing.step = 2;
    standing.pass = {{{Quantity::path_mm, -1, false, 100.0}, 50.0, own_kept},
                     {{Quantity::time_s, -1, false, 60.0}, 129.0, course_kept}};
    for (const BoundStanding& mark : standing.pass)
        if (!mark.kept) standing.reasons.push_back(reason_of_pass_mark(mark, {}));
    standing.outcome = own_kept && course_kept ? LessonOutcome::passed : LessonOutcome::failed;
    return standing;
}

TEST(Attempts, KeepTheMarksOfTheCourseThatTheyWerePlayedUnder) {
    const TemporaryFolder folder;
    const fs::path recording = folder.path() / "a.hrec";
    const std::vector<Predicate> marks{{Quantity::time_s, -1, false, 60.0}};
    EXPECT_TRUE(course_pass_beside(recording).empty()) << "there is no result";
    for (const auto& [own, course] : {std::pair(true, true), std::pair(true, false),
                                      std::pair(false, true), std::pair(false, false)}) {
        write_attempt(attempt_of(recording, "x", standing_of_course(own, course), "1", marks));
        const Attempt kept = all_attempts(folder.path()).list.at(0);
        EXPECT_EQ(kept.passed, own && course);
        EXPECT_EQ(kept.passed_lesson, own) << "as another course judges it";
        EXPECT_EQ(kept.course_pass, marks);
        EXPECT_EQ(course_pass_beside(recording), marks);
    }
    // A limit that was broken, or an end that was not reached, is none of the course's.
    LessonStanding broken = standing_of_course(true, false);
    broken.reasons = {"limit broken"};
    broken.step = 1;
    EXPECT_FALSE(attempt_of(recording, "x", broken, "1", marks).passed_lesson);
    broken = standing_of_course(true, false);
    broken.reasons.push_back("limit broken");
    EXPECT_FALSE(attempt_of(recording, "x", broken, "1", marks).passed_lesson);
}

// What the lesson asks for itself is no mark of the course alone, even where the course names it.
TEST(Attempts, MissTheLessonsOwnMarkThatACourseNamesToo) {
    const Predicate path{Quantity::path_mm, -1, false, 100.0},
        time{Quantity::time_s, -1, false, 60};
    std::vector<Predicate> pass{path, time};
    const std::vector<Predicate> of_course = add_new({time}, pass);
    const LessonStanding standing = standing_of_course(true, false);
    EXPECT_FALSE(attempt_of("a.hrec", "x", standing, "1", of_course).passed_lesson);
}

TEST(Attempts, AreNamedAfterwards) {
    const TemporaryFolder folder;
    const fs::path recording = folder.path() / "a.hrec";
    EXPECT_THROW(name_attempt(recording, "Anna"), InputError) << "there is no result";
    write_attempt(attempt_at(recording, "1", 5.0));
    name_attempt(recording, "Anna");
    EXPECT_EQ(name_beside(recording), "Anna");
    EXPECT_EQ(all_attempts(folder.path()).list.at(0).value(Quantity::time_s), 5.0);
    name_attempt(recording, "");
    EXPECT_EQ(name_beside(recording), "");
}

TEST(Attempts, BecomeReferencesAndKeepWhatElseIsKnownOfThem) {
    const TemporaryFolder folder;
    const fs::path recording = folder.path() / "a.hrec";
    EXPECT_THROW(mark_reference(recording, true), InputError) << "there is no result";
    write_attempt(attempt_at(recording, "1", 5.0));
    name_attempt(recording, "Anna");
    mark_reference(recording, true);
    EXPECT_EQ(name_beside(recording), "Anna");
    EXPECT_TRUE(all_attempts(folder.path()).list.at(0).reference);
    mark_reference(recording, false);
    EXPECT_FALSE(all_attempts(folder.path()).list.at(0).reference);
    EXPECT_EQ(all_attempts(folder.path()).list.at(0).value(Quantity::time_s), 5.0);
}

}  // namespace
}  // namespace hepatica
