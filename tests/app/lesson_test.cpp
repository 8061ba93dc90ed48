// SPDX-License-Identifier: GPL-3.0-or-later
// From a play to its score and its report, by the programs themselves.
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "core/lesson/attempts.h"
#include "core/lesson/play_notes.h"
#include "core/session/recording_file.h"
#include "tests/app/tour.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::answer;
using test::Json;
using test::Outcome;
using test::run_cli;

std::string contents_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

class LessonVerb : public test::Tour {
  protected:
    // A pull by 6 mm, and a lesson that asks for so much.
    static void play(double least_mm) {
        const std::string scene = R"({"name": "pull", "deform": {"quality": 0}})";
        const std::string place = R"({"share_of_longest_path": 0.5})";
        std::ofstream(path("play.json"))
            << R"({"scene": )" + scene + R"(, "actions": [{"at_s": 0.1, "do": "grab", "where": )" +
                   place + R"(}, {"at_s": 0.1, "do": "move", "by_mm": [6, 0, 0], "over_s": 0.3}]})";
        std::ofstream(path("lesson.json"))
            << R"({"format": "hepatica-lesson", "version": 1, "name": "Pull <gently>", "scene": )" +
                   scene + R"(, "tools": ["pull"], "marks": {"it": )" + place +
                   R"(}, "steps": [{"text": "Pull", "goal": [{"what": "moved_mm", "mark": "it", )" +
                   R"("at_least": )" + std::to_string(least_mm) + "}]}]}";
        answer({"simulate", path("p.hep"), "--script", path("play.json"), "--steps", "45",
                "--record", path("play.hrec")});
    }
};

TEST_F(LessonVerb, ScoresARecordingTwiceTheSame) {
    play(3.0);
    const std::vector<std::string> ask{"lesson",      path("lesson.json"),
                                       "--recording", path("play.hrec"),
                                       "--csv",       path("metrics.csv")};
    const Json scored = answer(ask);
    EXPECT_EQ(scored["passed"], true) << scored.dump(1);
    EXPECT_GT(scored["metrics"]["peak_force_mn"], 0.0);
    EXPECT_EQ(answer(ask), scored);
    EXPECT_NE(contents_of(path("metrics.csv")).find("peak_force_mn,"), std::string::npos);
}

TEST_F(LessonVerb, SaysWhatWasNotReached) {
    play(100.0);
    const Json scored = answer({"lesson", path("lesson.json"), "--recording", path("play.hrec")});
    EXPECT_EQ(scored["passed"], false);
    EXPECT_EQ(scored["reasons"][0], "step 1 of 1 was not reached: Pull");
}

// The script names no scene, and the lesson is in the middle of something when it begins.
TEST_F(LessonVerb, ScoresWhatSimulatePlayedOfALesson) {
    play(3.0);
    Json lesson = Json::parse(contents_of(path("lesson.json")));
    lesson["scene"]["tear"] = Json::object();
    const Json place = Json::object({{"share_of_longest_path", 0.8}});
    lesson["setup"] =
        Json::array({Json{{"do", "cut_line"}, {"from", place}, {"to", place}, {"strength", 0.5}}});
    std::ofstream(path("torn lesson.json")) << lesson.dump();
    Json script = Json::parse(contents_of(path("play.json")));
    script.erase("scene");
    for (Json& action : script["actions"]) action["at_s"] = 0.0;
    std::ofstream(path("script.json")) << script.dump();
    const std::vector<std::string> simulate{"simulate", path("p.hep"),
                                            "--script", path("script.json"),
                                            "--steps",  "45",
                                            "--lesson", path("torn lesson.json"),
                                            "--record", path("scored.hrec")};
    answer(simulate);
    const Json scored =
        answer({"lesson", path("torn lesson.json"), "--recording", path("scored.hrec")});
    EXPECT_EQ(scored["passed"], true) << scored.dump(1);
}

TEST_F(LessonVerb, RefusesALessonOfAnotherSceneAndOneThatIsNone) {
    play(3.0);
    const Outcome other = run_cli(
        {"lesson", "embolization", "--recording", path("play.hrec"), "--patient", path("p.hep")});
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_NE(other.errors.find("another scene"), std::string::npos) << other.errors;
    const Outcome none = run_cli({"lesson", path("play.json"), "--recording", path("play.hrec")});
    EXPECT_EQ(none.exit_code, 1);
    EXPECT_NE(none.errors.find("format"), std::string::npos) << none.errors;
}

// A lesson for any patient may have been played on the built-in one. Making that takes long, and
// its beginning is enough.
TEST_F(LessonVerb, TriesTheBuiltInPatientWhereNoCaseFits) {
    play(3.0);
    fs::create_directories(path("alone"));
    fs::copy_file(path("play.hrec"), path("alone/play.hrec"), fs::copy_options::overwrite_existing);
    const Outcome run =
        run_cli({"lesson", path("lesson.json"), "--recording", path("alone/play.hrec")},
                {.interrupt_at = "info: [1/"});
    EXPECT_EQ(run.exit_code, 130) << run.errors;
}

#ifdef HEPATICA_WINDOW_PROGRAM
Outcome report(std::vector<std::string> arguments) {
    return run_cli(arguments, {.program = HEPATICA_WINDOW_PROGRAM});
}

TEST_F(LessonVerb, MakesAReportWithoutADisplay) {
    play(3.0);
    const Outcome run =
        report({"--report", path("play.hrec"), "--out", path("report"), "--lesson",
                path("lesson.json"), "--name", "Trainee 7", "--units", "clinic", "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(Json::parse(run.output)["passed"], true);
    const std::string page = contents_of(path("report/report.html"));
    for (const char* text :
         {"PASSED", "Trainee 7", "Pull &lt;gently&gt;", "peak force", "picture_1.png", "plot_1.png",
          "<html lang=\"en\"", "Date unknown", "<thead>"})
        EXPECT_NE(page.find(text), std::string::npos) << text;
    for (const char* text : {"blood", "dose", "contacts", "injected"})
        EXPECT_EQ(page.find(text), std::string::npos) << text << " means nothing here";
    std::smatch peak, reached;
    ASSERT_TRUE(std::regex_search(page, peak, std::regex("largest force: .*, after ([0-9.]+)")));
    ASSERT_TRUE(std::regex_search(page, reached, std::regex("Step 1 reached, after ([0-9.]+)")));
    const std::regex goal("at least 3\u00a0mm</td><td>[3-9][0-9.]*\u00a0mm</td>");
    EXPECT_TRUE(std::regex_search(page, goal)) << "what the goal came to";
    EXPECT_EQ(peak.position() < reached.position(), std::stod(peak[1]) < std::stod(reached[1]))
        << "pictures lie in the order of their times";
    EXPECT_EQ(contents_of(path("report/report.pdf")).substr(0, 5), "%PDF-");
    EXPECT_GT(fs::file_size(path("report/report.pdf")), 20'000u) << "it has pictures";
    EXPECT_EQ(contents_of(path("report/recording.hrec")), contents_of(path("play.hrec")));
    EXPECT_EQ(page.find(path("")), std::string::npos) << "a path may name the patient";
    for (const char* file : {"metrics.csv", "plots.csv", "picture_1.png", "plot_2.png"})
        EXPECT_TRUE(fs::exists(path(std::string("report/") + file))) << file;
}

TEST_F(LessonVerb, AReportHoldsTheNotesOfTheInstructor) {
    play(3.0);
    const std::vector<PlayNote> notes{{0.4, "Good, but <slow> here"}, {0.5, "Langsamer"}};
    write_notes(path("play.hrec"), notes);
    const auto page_of = [&](const char* name) {
        const Outcome run = report(
            {"--report", path("play.hrec"), "--out", path(name), "--lesson", path("lesson.json")});
        EXPECT_EQ(run.exit_code, 0) << run.errors;
        return contents_of(path(std::string(name) + "/report.html"));
    };
    const std::string page = page_of("noted");
    for (const char* text : {"Notes of the instructor", "0.4\u00a0s</td><td>Good, but &lt;slow",
                             "0.5\u00a0s</td><td>Langsamer"})
        EXPECT_NE(page.find(text), std::string::npos) << text;
    EXPECT_EQ(read_notes(path("noted/recording.hrec")), notes);
    write_notes(path("play.hrec"), {});
    for (const char* out : {"plain", "noted"}) {
        EXPECT_EQ(page_of(out).find("Notes of"), std::string::npos) << out;
        EXPECT_FALSE(fs::exists(notes_file_of(path(std::string(out) + "/recording.hrec")))) << out;
    }
}

// A file's own time changes with every copy.
TEST_F(LessonVerb, AReportTellsTheDateOfTheRecordingAndNeverThatOfTheFile) {
    play(3.0);
    const auto page_of = [&](const std::string& name, const std::string& played_at) {
        Recording recording = read_recording(path("play.hrec"));
        recording.played_at = played_at;
        write_recording(path(name + ".hrec"), recording);
        const Outcome run = report({"--report", path(name + ".hrec"), "--out", path(name),
                                    "--lesson", path("lesson.json")});
        EXPECT_EQ(run.exit_code, 0) << run.errors;
        return contents_of(path(name + "/report.html"));
    };
    EXPECT_NE(page_of("dated", "2024-05-06T12:00:00Z").find("Played on 6 May 2024"),
              std::string::npos);
    Attempt attempt;
    attempt.recording = path("older.hrec");
    attempt.lesson = "Pull <gently>";
    attempt.ended_at = "2023-02-03T12:00:00Z";
    write_attempt(attempt);
    EXPECT_NE(page_of("older", "").find("Played on 3 February 2023"), std::string::npos);
    const std::string undated = page_of("undated", "");
    EXPECT_NE(undated.find("Date unknown"), std::string::npos);
    EXPECT_EQ(undated.find("Played on"), std::string::npos);
}

TEST_F(LessonVerb, AReportSaysThatTheRecordingIsCutShort) {
    play(3.0);
    const std::string text = contents_of(path("play.hrec"));
    const std::size_t amid_a_step = text.find('\n', text.size() / 2) + 10;
    std::ofstream(path("short.hrec")) << text.substr(0, amid_a_step);
    const Outcome run = report(
        {"--report", path("short.hrec"), "--out", path("short"), "--lesson", path("lesson.json")});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.errors.find("was not written to its end and is left out"), std::string::npos)
        << run.errors;
    const std::string page = contents_of(path("short/report.html"));
    EXPECT_NE(page.find("The recording is cut short"), std::string::npos);
    EXPECT_EQ(page.find(path("")), std::string::npos) << "a path may name the patient";
    const Outcome whole = report(
        {"--report", path("play.hrec"), "--out", path("whole"), "--lesson", path("lesson.json")});
    EXPECT_EQ(whole.errors.find("to its end"), std::string::npos) << whole.errors;
    EXPECT_EQ(contents_of(path("whole/report.html")).find("cut short"), std::string::npos);
}

TEST_F(LessonVerb, AReportGivesNoVerdictWhereNothingWasPlayed) {
    play(3.0);
    Json lesson = Json::parse(contents_of(path("lesson.json")));
    lesson["limits"] = Json::array({Json{{"what", "time_s"}, {"at_most", 10}}});
    std::ofstream(path("limited.json")) << lesson.dump();
    const std::string text = contents_of(path("play.hrec"));
    std::ofstream(path("header.hrec")) << text.substr(0, text.find('\n') + 1);
    const Outcome run = report({"--report", path("header.hrec"), "--out", path("header"),
                                "--lesson", path("limited.json"), "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_TRUE(Json::parse(run.output)["passed"].is_null()) << run.output;
    const std::string page = contents_of(path("header/report.html"));
    EXPECT_NE(page.find("Nothing was played."), std::string::npos);
    for (const char* text_of_a_verdict : {"PASSED", "Limits", "Kept", "Metrics", "Pictures"})
        EXPECT_EQ(page.find(text_of_a_verdict), std::string::npos) << text_of_a_verdict;
}

// The window has one bar of the whole report, which needs to know which stage of how many it is.
TEST_F(LessonVerb, TheProgressOfAReportNumbersItsStages) {
    play(3.0);
    const Outcome run = report({"--report", path("play.hrec"), "--out", path("stages"), "--lesson",
                                path("lesson.json"), "--progress", "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    std::istringstream lines(run.output);
    int number = 0, count = 0;
    for (std::string text; std::getline(lines, text);) {
        const Json line = Json::parse(text);
        if (!line.contains("stage")) continue;  // the last one names the files
        const int now = line.at("number");
        EXPECT_TRUE(now == number || now == number + 1) << text;
        if (number == 0) count = line.at("count");
        EXPECT_EQ(line.at("count"), count) << text;
        number = now;
    }
    EXPECT_GT(count, 0);
    EXPECT_EQ(number, count);
}

TEST_F(LessonVerb, AReportDoesNotTakeThePlaceOfAnotherRecording) {
    play(3.0);
    fs::create_directories(path("plays"));
    std::ofstream(path("plays/recording.hrec")) << "another play";
    const Outcome run = report(
        {"--report", path("play.hrec"), "--out", path("plays"), "--lesson", path("lesson.json")});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.errors.find("plays/recording.hrec"), std::string::npos) << run.errors;
    EXPECT_EQ(contents_of(path("plays/recording.hrec")), "another play");
    EXPECT_FALSE(fs::exists(path("plays/report.html")));
}

TEST_F(LessonVerb, AnInterruptedReportLeavesNothing) {
    play(3.0);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        const Outcome cut = run_cli(
            {"--report", path("play.hrec"), "--out", path("cut"), "--lesson", path("lesson.json"),
             "--progress"},
            {.interrupt_at = "\"stage\":", .signal = number, .program = HEPATICA_WINDOW_PROGRAM});
        EXPECT_EQ(cut.exit_code, 130) << number << ": " << cut.errors;
        EXPECT_FALSE(fs::exists(path("cut"))) << number;
    }
}

// What a course asks for beside the lesson lies with the attempt, and the report judges by it.
TEST_F(LessonVerb, AReportJudgesByThePassMarksOfTheCourse) {
    play(3.0);
    const auto judged = [&](double most_mm) {
        Attempt attempt;
        attempt.recording = path("play.hrec");
        attempt.lesson = "Pull <gently>";
        attempt.ended_at = "2026";
        attempt.course_pass = {{Quantity::path_mm, -1, false, most_mm}};
        write_attempt(attempt);
        const Outcome run = report({"--report", path("play.hrec"), "--out", path("judged"),
                                    "--lesson", path("lesson.json"), "--json"});
        EXPECT_EQ(run.exit_code, 0) << run.errors;
        return Json::parse(run.output)["passed"].get<bool>();
    };
    EXPECT_TRUE(judged(1e6));
    EXPECT_FALSE(judged(0.5));
    const std::string page = contents_of(path("judged/report.html"));
    EXPECT_NE(page.find("NOT PASSED"), std::string::npos);
    EXPECT_NE(page.find("path of the tip at most 0.5"), std::string::npos) << page;
}

TEST_F(LessonVerb, AScoreAndAReviewJudgeByThePassMarksOfTheCourse) {
    play(3.0);
    Attempt attempt;
    attempt.recording = path("course.hrec");
    attempt.lesson = "Pull <gently>";
    attempt.ended_at = "2026";
    attempt.course_pass = {{Quantity::path_mm, -1, false, 0.5}};
    fs::copy_file(path("play.hrec"), path("course.hrec"), fs::copy_options::overwrite_existing);
    write_attempt(attempt);
    const Json scored = answer({"lesson", path("lesson.json"), "--recording", path("course.hrec")});
    EXPECT_EQ(scored["passed"], false);
    EXPECT_EQ(scored["reasons"].size(), 1u) << scored.dump(1);
    const Json seen = answer({"review", path("course.hrec"), "--lesson", path("lesson.json")});
    EXPECT_NE(seen.dump().find("pass mark missed"), std::string::npos) << seen.dump(1);
}

TEST_F(LessonVerb, AReviewFindsTheCaseThatTheLessonNames) {
    play(3.0);
    Json lesson = Json::parse(contents_of(path("lesson.json")));
    lesson["patient"] = "p.hep";
    std::ofstream(path("named.json")) << lesson.dump();
    fs::create_directories(path("away"));
    fs::copy_file(path("play.hrec"), path("away/play.hrec"), fs::copy_options::overwrite_existing);
    const Json seen = answer({"review", path("away/play.hrec"), "--lesson", path("named.json")});
    EXPECT_EQ(seen["lesson"], "Pull <gently>");
    EXPECT_FALSE(seen["events"].empty());
}

// Older attempts hold a course's marks also where the lesson has them itself.
TEST_F(LessonVerb, AReportNamesAMarkOfLessonAndCourseOnce) {
    play(3.0);
    Json lesson = Json::parse(contents_of(path("lesson.json")));
    lesson["pass"] = Json::array({Json{{"what", "path_mm"}, {"at_most", 777}}});
    std::ofstream(path("both.json")) << lesson.dump();
    Attempt attempt;
    attempt.recording = path("play.hrec");
    attempt.lesson = "Pull <gently>";
    attempt.ended_at = "2026";
    attempt.course_pass = {{Quantity::path_mm, -1, false, 777}};
    write_attempt(attempt);
    const Outcome run = report({"--report", path("play.hrec"), "--out", path("both"), "--lesson",
                                path("both.json"), "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const std::string page = contents_of(path("both/report.html"));
    const std::string mark = "path of the tip at most 777";
    const std::size_t first = page.find(mark);
    ASSERT_NE(first, std::string::npos) << page;
    EXPECT_EQ(page.find(mark, first + 1), std::string::npos);
}

TEST_F(LessonVerb, AReportSaysWhyAPassMarkIsNotJudged) {
    play(100.0);  // is not reached
    Attempt attempt;
    attempt.recording = path("play.hrec");
    attempt.lesson = "Pull <gently>";
    attempt.ended_at = "2026";
    attempt.course_pass = {{Quantity::path_mm, -1, false, 50.0}};
    write_attempt(attempt);
    const Outcome run = report({"--report", path("play.hrec"), "--out", path("unreached"),
                                "--lesson", path("lesson.json"), "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const std::string page = contents_of(path("unreached/report.html"));
    EXPECT_NE(page.find("not judged: the lesson did not reach its end"), std::string::npos);
    EXPECT_EQ(page.find("not measured"), std::string::npos) << "the path is among the measures";
}

// What broke a limit is not rounded to it, and the goal stands with how far it came.
TEST_F(LessonVerb, AReportSaysHowFarTheGoalCameAndWhatBrokeALimit) {
    play(100.0);
    Json lesson = Json::parse(contents_of(path("lesson.json")));
    lesson["limits"] = Json::array({Json{{"what", "time_s"}, {"at_most", 0.51}}});
    std::ofstream(path("late.json")) << lesson.dump();
    const Outcome run = report({"--report", path("play.hrec"), "--out", path("late"), "--lesson",
                                path("late.json"), "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const std::string page = contents_of(path("late/report.html"));
    const std::string was = "0.517\u00a0s";
    const std::size_t reason = page.find(was);
    ASSERT_NE(reason, std::string::npos) << page;
    EXPECT_NE(page.find(was, reason + 1), std::string::npos) << "in the table of limits too";
    EXPECT_NE(page.find("way moved by it at least 100\u00a0mm"), std::string::npos) << page;
    EXPECT_NE(page.find("Circles"), std::string::npos);
}

TEST_F(LessonVerb, AReportOfAnInjectionShowsTheSharesThatTheDrugReached) {
    const std::string scene = R"({"name": "inject", "flow": {}})";
    std::ofstream(path("drug play.json"))
        << R"({"scene": )" + scene + R"(, "actions": [{"at_s": 0.1, "do": "inject", "where": )" +
               R"({"share_of_longest_path": 0.3}, "void_fraction": 0, "second_phase": "carrier"}]})";
    std::ofstream(path("drug.json"))
        << R"({"format": "hepatica-lesson", "version": 1, "name": "Inject", "scene": )" + scene +
               R"(, "tools": ["inject"], "target": {"share_of_longest_path": 0.6}, "steps": )" +
               R"([{"text": "Inject", "goal": [{"what": "target_filled", "at_least": 1}]}]})";
    answer({"simulate", path("p.hep"), "--script", path("drug play.json"), "--steps", "45",
            "--record", path("drug.hrec")});
    const Outcome run = report({"--report", path("drug.hrec"), "--out", path("drug"), "--lesson",
                                path("drug.json"), "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const std::string page = contents_of(path("drug/report.html"));
    for (const char* text : {"Vessels that the drug has reached", "Brown to yellow"})
        EXPECT_NE(page.find(text), std::string::npos) << text;
    for (const char* text : {"<figcaption>Force", "Largest stretch beyond rest", "Circles"})
        EXPECT_EQ(page.find(text), std::string::npos) << text;
    const std::string curves = contents_of(path("drug/plots.csv"));
    EXPECT_NE(curves.find("\"The target\","), std::string::npos) << curves;
    EXPECT_NE(curves.find("\"The rest\","), std::string::npos) << curves;
}

// The lesson asks for the blood, so that none is a result; everything is said in German.
TEST_F(LessonVerb, MakesAReportInTheLanguageThatIsAskedFor) {
    play(3.0);
    Json lesson = Json::parse(contents_of(path("lesson.json")));
    lesson["limits"] = Json::array({Json{{"what", "blood_lost_g"}, {"at_most", 2}}});
    std::ofstream(path("limited.json")) << lesson.dump();
    const Outcome run = report({"--report", path("play.hrec"), "--out", path("Bericht"), "--lesson",
                                path("limited.json"), "--units", "clinic", "--language", "de",
                                "--patient-name", "Fall 7", "--progress"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.output.find("\"fraction\":"), std::string::npos) << run.output;
    const std::string page = contents_of(path("Bericht/report.html"));
    for (const char* text : {"<html lang=\"de\"", "BESTANDEN", "Patient: Fall 7", "Datum unbekannt",
                             "Schritte", "Bilder", "Blut", "0,0\u00a0mL<", "Hepatica "})
        EXPECT_NE(page.find(text), std::string::npos) << text;
    for (const char* text : {"PASSED", "Pictures", "peak force", "Before the first"})
        EXPECT_EQ(page.find(text), std::string::npos) << text;
    EXPECT_TRUE(std::regex_search(page, std::regex("\\d,\\d+\u00a0m?[Nms]"))) << "decimal commas";
    const Outcome other =
        report({"--report", path("play.hrec"), "--out", path("no report"), "--language", "fr"});
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_NE(other.errors.find("--language is en or de"), std::string::npos);
    const Outcome missing =
        report({"--report", path("none.hrec"), "--out", path("no report"), "--language", "de"});
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_NE(missing.errors.find("existiert nicht"), std::string::npos) << missing.errors;
}

// A recording that lies elsewhere than the case which its lesson names.
TEST_F(LessonVerb, ReportsOfTheCaseThatTheLessonNames) {
    play(3.0);
    Json lesson = Json::parse(contents_of(path("lesson.json")));
    lesson["patient"] = "p.hep";
    std::ofstream(path("named.json")) << lesson.dump();
    fs::create_directories(path("elsewhere"));
    fs::copy_file(path("play.hrec"), path("elsewhere/play.hrec"),
                  fs::copy_options::overwrite_existing);
    const Outcome run = report({"--report", path("elsewhere/play.hrec"), "--out",
                                path("elsewhere/report"), "--lesson", path("named.json")});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
}

TEST_F(LessonVerb, LeavesNoReportOfWhatCannotBeScored) {
    const Outcome run = report({"--report", path("nothing.hrec"), "--out", path("no report")});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.errors.find("nothing.hrec"), std::string::npos) << run.errors;
    EXPECT_FALSE(fs::exists(path("no report")));
    EXPECT_EQ(report({"--report", path("nothing.hrec")}).exit_code, 2);
    const Outcome unnamed = report({"--report", "--out", path("no report")});
    EXPECT_EQ(unnamed.exit_code, 2);
    EXPECT_NE(unnamed.errors.find("--report needs a RECORDING, and is followed by --out"),
              std::string::npos)
        << unnamed.errors;
    const Outcome units =
        report({"--report", path("nothing.hrec"), "--out", path("no report"), "--units", "ounces"});
    EXPECT_EQ(units.exit_code, 2);
    EXPECT_NE(units.errors.find("--units is computed or clinic"), std::string::npos);
}

// A name longer than a file system takes is an error of the system, not of this program's input.
TEST_F(LessonVerb, AReportSaysWhatTheFileSystemRefuses) {
    const std::string long_name(300, 'x');
    const Outcome run = report({"--report", path("nothing.hrec"), "--out", path(long_name)});
    EXPECT_EQ(run.exit_code, 1) << run.errors;
    EXPECT_NE(run.errors.find(long_name), std::string::npos) << run.errors;
}
#endif

}  // namespace
}  // namespace hepatica
