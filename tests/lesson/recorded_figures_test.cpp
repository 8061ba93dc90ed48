// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of lessons as they are today: a play made by hand, of a body that moves, tears, bleeds
// and is injected, and the doses on the way.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/lesson/dose_account.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_run.h"
#include "core/scene/drug_arrival.h"
#include "tests/lesson/frames.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;
using test::small_patient;

std::span<const std::uint8_t> bytes_of_text(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

double or_minus_one(double value) {
    return std::isfinite(value) ? value : -1.0;
}

Lesson rich_lesson(bool deforms) {
    Lesson lesson = test::plain_lesson();
    lesson.scene.dt_s = 0.04;
    lesson.scene.flow.emplace();
    if (deforms) lesson.scene.deform.emplace();
    const VesselTree& tree = small_patient()->tree;
    lesson.marks = {{"near", {.point_mm = test::middle_of(tree, 1)}},
                    {"far", {.share_of_longest_path = 0.9}},
                    {"beyond", {.point_mm = Vec3(300, -200, 500)}}};
    lesson.target = ScriptPlace{.share_of_longest_path = 0.6};
    return lesson;
}

// Step k of the play: all that a frame can show changes, each in its own time.
Frame frame_of_play(int k, const DrugView& drug) {
    Frame frame = test::rest_frame();
    const double time = 0.04 * k;
    for (std::size_t i = 0; i < frame.positions_mm.size(); ++i)
        frame.positions_mm[i] += static_cast<float>(
            0.8 * std::sin(0.05 * static_cast<double>(frame.positions_mm[i]) + 3.0 * time));
    frame.time_s = time;
    frame.statistics.paused = k % 11 == 10;
    if (k % 9 < 5) {
        frame.grab.emplace();
        frame.grab->point_mm = Vec3(3 * time, 1, 40);
        frame.grab->target_mm = Vec3(5 * time, std::sin(time), 44);
        frame.grab->force_un = 1e4 * (1.0 + std::sin(5 * time));
    }
    if (k % 7 < 4) {
        frame.tool.emplace();
        frame.tool->tip_mm = Vec3(9 - time, 2 * std::cos(4 * time), 60);
        frame.tool->at_mm = frame.tool->tip_mm + Vec3(0, 1, 2);
        frame.tool->force_un = Vec3(2e3, -4e3 * time, 700);
        frame.tool->grip_un = 900.0 * k;
        if (k % 7 > 1) frame.tool->touched = {3, 5};
    }
    if (k > 8) {
        frame.tear.emplace();
        frame.tear->joints_broken = k / 3;
        frame.tear->pieces = 1 + k / 20;
        frame.tear->leak_g_s = 0.1 * std::sqrt(static_cast<double>(k));
        frame.tear->leaked_g = 0.01 * k;
    }
    if (k > 14 && k < 60) {
        frame.drug = drug;
        frame.drug.time_s = 0.25 * (k - 14);
    }
    return frame;
}

DrugView drug_of_play() {
    const VesselTree& tree = small_patient()->tree;
    DrugView drug;
    drug.injection = std::make_shared<const InjectionOptions>(
        injection_options({.at = {0, 20.0}, .mass_flow_g_s = 4.0, .void_fraction = 0.2}, tree));
    drug.version = 5;
    drug.end_s = 15.0;
    drug.playing = true;
    auto arrivals = std::make_shared<std::vector<float>>();
    for (std::size_t v = 0; v < small_patient()->mesh.vertices_mm.size(); ++v)
        arrivals->push_back(static_cast<float>((v * 37) % 101) * 0.13f);
    drug.arrival_s = arrivals;
    return drug;
}

void append_metrics(std::vector<double>& numbers, const LessonMetrics& metrics) {
    const nlohmann::ordered_json json = to_json(metrics);
    for (const auto& [name, value] : json.items())
        numbers.push_back(value.is_number() ? or_minus_one(value.get<double>()) : -1.0);
}

void append_moment(std::vector<double>& numbers, const LessonMoment& m) {
    numbers.insert(numbers.end(),
                   {m.force_mn, m.grip_mn, m.stretch, m.leak_g_s, m.target_filled,
                    m.elsewhere_filled, m.drug_present ? 1.0 : 0.0, m.holding ? 1.0 : 0.0});
    for (const MarkMoment& mark : m.marks)
        numbers.insert(numbers.end(), {or_minus_one(mark.distance_mm), mark.moved_mm,
                                       or_minus_one(mark.touch_mm)});
}

TEST(LessonFigures, OfAPlayMadeByHand) {
    const DrugView drug = drug_of_play();
    const Lesson lesson = rich_lesson(true);
    PlayMeter meter(lesson, small_patient());
    meter.begin(frame_of_play(0, drug));
    std::vector<double> metrics, moments, marks;
    for (int k = 1; k < 80; ++k) {
        const Frame frame = frame_of_play(k, drug);
        meter.see(frame);
        append_metrics(metrics, meter.metrics());
        append_moment(moments, meter.moment());
        for (const Vec3& mark : meter.marks_in(frame))
            marks.insert(marks.end(), mark.begin(), mark.end());
    }
    for (const Vec3& mark : meter.marks_in(test::rest_frame()))
        marks.insert(marks.end(), mark.begin(), mark.end());
    expect_recorded("lesson", "play",
                    Figures().add("metrics", metrics).add("moments", moments).add("marks", marks));
}

// Every quantity bounds the play from both sides, as a goal, a limit and a pass mark.
TEST(LessonFigures, OfAnAttemptWithAllBounds) {
    const DrugView drug = drug_of_play();
    Lesson lesson = rich_lesson(true);
    lesson.steps.clear();
    const auto bound = [](Quantity quantity, bool at_least, double value) {
        return Predicate{quantity, words_of(quantity).of_mark ? 1 : -1, at_least, value};
    };
    lesson.steps = {
        {"begin", "", {bound(Quantity::force_mn, true, 8.0)}, 0.08, {}},
        {"touch",
         "soon",
         {bound(Quantity::contacts, true, 2.0)},
         0.0,
         {bound(Quantity::step_time_s, false, 9.0)}},
        {"inject",
         "",
         {bound(Quantity::drug_present, true, 1.0), bound(Quantity::target_filled, true, 0.2)},
         0.2,
         {}},
        {"wait", "", {bound(Quantity::time_s, true, 2.2)}, 0.0, {}}};
    for (const QuantityWords& words : quantities()) {
        // Where there is neither tool nor hand, a mark is infinitely far.
        const double most = words.of_mark ? std::numeric_limits<double>::infinity() : 1e9;
        lesson.limits.push_back(bound(words.quantity, false, most));
        lesson.pass.push_back(bound(words.quantity, words.quantity < Quantity::contacts, 3.0));
    }
    LessonRun run(lesson, small_patient(), {bound(Quantity::moved_mm, true, 0.125)});
    std::vector<double> held;
    for (int k = 0; k < 80; ++k) {
        run.see({}, frame_of_play(k, drug));
        held.push_back(static_cast<double>(run.standing().step));
        if (run.standing().step < lesson.steps.size())
            held.push_back(run.standing().steps[run.standing().step].held_s);
    }
    run.end();
    std::vector<double> samples;
    for (const LessonSample& s : run.samples())
        samples.insert(samples.end(), {s.time_s, s.force_mn, s.stretch, s.leak_g_s});
    std::vector<double> numbers;
    append_metrics(numbers, run.standing().metrics);
    for (const auto* bounds : {&run.standing().limits, &run.standing().pass})
        for (const BoundStanding& standing : *bounds) {
            numbers.push_back(or_minus_one(standing.value));
            numbers.push_back(standing.kept ? 1.0 : 0.0);
        }
    std::string words;
    for (const std::string& reason : run.standing().reasons) words += reason + "\n";
    EXPECT_EQ(run.standing().step, lesson.steps.size());
    expect_recorded("lesson", "attempt",
                    Figures()
                        .add("held", held)
                        .add("samples", samples)
                        .add("standing", numbers)
                        .add("reasons", bytes_of_text(words)));
}

TEST(LessonFigures, OfDoses) {
    const VesselTree& tree = small_patient()->tree;
    Figures figures;
    for (const double share : {0.0, 0.4}) {
        const InjectionOptions options =
            injection_options({.at = {1, 9.0}, .mass_flow_g_s = 3.0, .void_fraction = share}, tree);
        const DoseCurve curve(tree, options, 12.0, TargetRegion(tree, {3, 4.0}));
        std::vector<double> numbers;
        for (double t = -1.0; t < 13.0; t += 0.37) {
            const Dose dose = curve.at(t);
            numbers.insert(numbers.end(), {dose.injected_g, dose.delivered_g, dose.target_g,
                                           dose.reflux_g, dose.elsewhere_g()});
        }
        figures.add("share" + std::to_string(share), numbers);
    }
    const TargetRegion region(tree, {1, 5.0});
    std::vector<double> inside;
    for (int s = 0; s < static_cast<int>(tree.segments.size()); ++s) {
        inside.push_back(region.contains_end_of(s) ? 1.0 : 0.0);
        for (const double at : {0.0, 5.0, 6.0})
            inside.push_back(region.contains({s, at, 0.0}) ? 1.0 : 0.0);
    }
    expect_recorded("lesson", "doses", figures.add("region", inside));
}

TEST(LessonFigures, OfTheLessonsThatComeWithTheProgram) {
    Figures figures;
    for (const BuiltInLesson& built_in : built_in_lessons()) {
        const Lesson lesson = find_lesson(built_in.id);
        std::string text = lesson.name + lesson.about + lesson.patient + "\n";
        const std::vector<std::string> marks = lesson.mark_names();
        for (const LessonTool tool : lesson.tools) text += std::string(name_of(tool)) + " ";
        const auto add = [&](const std::vector<Predicate>& predicates) {
            for (const Predicate& predicate : predicates) text += to_words(predicate, marks) + "\n";
        };
        for (const LessonStep& step : lesson.steps) {
            text += step.text + step.hint + std::to_string(step.hold_s) + "\n";
            if (step.tool) text += std::string(name_of(*step.tool)) + "\n";
            add(step.goal);
            add(step.limits);
        }
        add(lesson.limits);
        add(lesson.pass);
        figures.add(built_in.id, bytes_of_text(text));
    }
    expect_recorded("lesson", "built_in", figures);
}

// Each is a lesson with one thing wrong; what is said about it is for the person who wrote it.
TEST(LessonFigures, OfWhatIsSaidAboutWrongLessons) {
    using Json = nlohmann::ordered_json;
    const auto good = Json::parse(R"({"format": "hepatica-lesson", "version": 1, "name": "n",
        "scene": {"deform": {}}, "marks": {"m": {"point_mm": [1, 2, 3]}}, "tools": ["pull"],
        "steps": [{"text": "t", "goal": [{"what": "moved_mm", "mark": "m", "at_least": 1}]}]})");
    std::string said;
    for (const auto& [place, value] : std::vector<std::pair<std::string, std::string>>{
             {"/format", R"("x")"},
             {"/format", "7"},
             {"/version", "2"},
             {"/version", R"("1")"},
             {"/name", R"("")"},
             {"/patient", "[]"},
             {"/extra", "1"},
             {"/tools", "{}"},
             {"/tools/0", R"("spoon")"},
             {"/marks", "[]"},
             {"/marks/m/point_mm", "[1]"},
             {"/marks/m/point_mm/1", "null"},
             {"/marks/m", "{}"},
             {"/target", R"({"share_of_longest_path": 2})"},
             {"/steps", "[]"},
             {"/steps", "{}"},
             {"/steps/0", "[]"},
             {"/steps/0/text", "1"},
             {"/steps/0/goal", "[]"},
             {"/steps/0/goal/0/what", R"("courage")"},
             {"/steps/0/goal/0/mark", R"("x")"},
             {"/steps/0/goal/0/at_most", "1"},
             {"/steps/0/goal/0/at_least", "true"},
             {"/steps/0/goal/0/what", R"("time_s")"},
             {"/steps/0/hold_s", "-1"},
             {"/steps/0/hold_s", "3601"},
             {"/limits", R"([{"what": "moved_mm", "at_most": 1}])"},
             {"/setup", R"([{"do": "blade", "from_mm": [0, 0, 1], "to_mm": [0, 1, 1],
                             "at_s": 1}])"},
             {"/scene/nothing", "1"}}) {
        Json json = good;
        json[Json::json_pointer(place)] = Json::parse(value);
        try {
            lesson_of(json.dump(), "file");
            ADD_FAILURE() << place << " = " << value << " was read";
        } catch (const InputError& error) {
            said += error.problem() + "|" + error.place() + "|" + error.remedy() + "\n";
        }
    }
    for (const char* text : {"{", "[]", R"({"format": "hepatica-course", "version": 1})",
                             R"({"format": "hepatica-course", "version": 1, "name": "c",
                                 "lessons": {}})"}) {
        try {
            course_of(text, "course");
            ADD_FAILURE() << text;
        } catch (const InputError& error) {
            said += error.problem() + "|" + error.place() + "|" + error.remedy() + "\n";
        }
    }
    expect_recorded("lesson", "refusals", Figures().add("words", bytes_of_text(said)));
}

}  // namespace
}  // namespace hepatica
