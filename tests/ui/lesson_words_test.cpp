// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_words.h"

#include <gtest/gtest.h>

#include <QFormLayout>
#include <QLabel>
#include <QRegularExpression>
#include <QTextDocument>
#include <algorithm>
#include <limits>

#include "core/flow/fluid.h"
#include "core/lesson/lesson_file.h"
#include "ui/core_sentences.h"
#include "ui/flow_units.h"
#include "ui/tool_panel.h"

namespace hepatica {
namespace {

constexpr FlowUnits clinic = FlowUnits::clinic, computed = FlowUnits::computed;
// Blood weighs 1.06 g per mL: 1.06 g/s are 1 mL/s.
const Predicate bleeding{Quantity::leak_g_s, -1, false, 0.53};
const Predicate lost{Quantity::blood_lost_g, -1, false, 10.6};
const Predicate drug{Quantity::injected_g, -1, false, 2.0};

TEST(LessonWords, SayBloodInTheUnitsOfTheClinicAndAllElseAsEver) {
    EXPECT_EQ(to_words(bleeding, {}, computed), "bleeding at most 0.53 g/s");
    EXPECT_EQ(to_words(bleeding, {}, clinic), "bleeding at most 30 mL/min");
    EXPECT_EQ(to_words(lost, {}, clinic), "blood lost at most 10 mL");
    EXPECT_EQ(to_words(Predicate{Quantity::blood_lost_g, -1, false, 50.0}, {}, clinic),
              "blood lost at most 47.1 mL")
        << "of 47.1698";
    EXPECT_EQ(to_words(Predicate{Quantity::leak_g_s, -1, false, 20.0}, {}, clinic),
              "bleeding at most 1130 mL/min");
    EXPECT_EQ(to_words(Predicate{Quantity::leak_g_s, -1, true, 20.0}, {}, clinic),
              "bleeding at least 1140 mL/min");
    EXPECT_EQ(to_words(Quantity::blood_lost_g, 0.106, clinic), "0.1 mL");
    EXPECT_EQ(to_words(drug, {}, clinic), "drug injected at most 2 g");
    EXPECT_EQ(to_words(Quantity::leak_g_s, 1.06, clinic), "60 mL/min");
    EXPECT_EQ(to_words(Quantity::leak_g_s, 1.06, computed), "1.06 g/s");
    const std::string marks[] = {"a"};
    EXPECT_EQ(to_words(Predicate{Quantity::moved_mm, 0, true, 3.0}, marks, clinic),
              "way moved by a at least 3 mm");
}

// As many digits as mean something, always as many, and none of a number that only trembles.
TEST(LessonWords, SayWhatWasMeasuredWithThreeDigitsAtMost) {
    const auto said = [](Quantity quantity, double value) {
        return to_words(quantity, value, computed);
    };
    EXPECT_EQ(said(Quantity::moved_mm, 0.005867), "0.0 mm");
    EXPECT_EQ(said(Quantity::moved_mm, -1e-9), "0.0 mm");
    EXPECT_EQ(said(Quantity::time_s, 0.7333), "0.7 s");
    EXPECT_EQ(said(Quantity::time_s, 24.13), "24.1 s");
    EXPECT_EQ(said(Quantity::time_s, 26.0), "26.0 s");
    EXPECT_EQ(said(Quantity::time_s, 123.45), "123 s");
    EXPECT_EQ(said(Quantity::time_s, 99.94), "99.9 s");
    EXPECT_EQ(said(Quantity::time_s, 99.96), "100 s");
    EXPECT_EQ(said(Quantity::largest_stretch, 9.996), "10.0");
    EXPECT_EQ(said(Quantity::force_mn, 999.6), "1000 mN");
    EXPECT_EQ(said(Quantity::force_mn, 467.26), "467 mN");
    EXPECT_EQ(said(Quantity::impulse_mn_s, 12345.0), "12300 mN s");
    EXPECT_EQ(said(Quantity::largest_stretch, 1.23456), "1.23");
    EXPECT_EQ(said(Quantity::contacts, 3.0), "3");
    EXPECT_EQ(said(Quantity::distance_mm, std::numeric_limits<double>::infinity()), "none");
    const Predicate limit{Quantity::force_mn, -1, false, 350.0};
    EXPECT_EQ(to_words_beside(limit, 467.26, computed), "467 mN");
    EXPECT_EQ(to_words_beside(limit, 350.04, computed), "350.04 mN");
}

TEST(LessonWords, SayThatNoneIsAllowedWhereNoneIs) {
    EXPECT_EQ(to_words(Predicate{Quantity::holding, -1, false, 0.0}, {}, computed),
              "no vessels held by hand or tool");
    EXPECT_EQ(to_words(Predicate{Quantity::pieces_off, -1, false, 1.0}, {}, computed),
              "pieces off at most 1");
    EXPECT_EQ(to_words(Predicate{Quantity::pieces_off, -1, true, 0.0}, {}, computed),
              "pieces off at least 0");
    EXPECT_EQ(to_words(Predicate{Quantity::force_mn, -1, false, 0.0}, {}, computed),
              "force at most 0 mN");
}

// The panel shows flows in the units that the trainee chose, which a text does not know.
TEST(LessonWords, OfBuiltInLessonsNameNoFlowInOneUnitAlone) {
    for (const BuiltInLesson& entry : built_in_lessons())
        for (const LessonStep& step : find_lesson(entry.id).steps)
            for (const std::string& text : {step.text, step.hint})
                EXPECT_EQ(text.find("g/s") == std::string::npos,
                          text.find("mL/min") == std::string::npos)
                    << text;
}

// The panel beside the hint shows what flow of volume a flow of mass is for the drug of the lesson.
TEST(LessonWords, OfBuiltInLessonsSayFlowsOfTheirOwnDrug) {
    const Lesson lesson = find_lesson("embolization");
    ASSERT_EQ(lesson.drug, "lipiodol");
    const double density_g_mm3 = mixture(blood(), lipiodol(), 2.0 / 3.0).density_g_mm3;
    const QRegularExpression flow(R"(([\d.]+) g/s, which is about (\d+) mL/min)");
    const auto said = flow.match(QString::fromStdString(lesson.steps[0].hint));
    ASSERT_TRUE(said.hasMatch()) << lesson.steps[0].hint;
    EXPECT_NEAR(ml_min_of(said.captured(1).toDouble(), density_g_mm3), said.captured(2).toDouble(),
                0.5);
}

TEST(LessonWords, OfTheCutLineNameTheFieldToSet) {
    ToolPanel panel({});
    const auto* form = qobject_cast<QFormLayout*>(
        panel.findChild<QWidget*>("lineStrength")->parentWidget()->layout());
    ASSERT_NE(form, nullptr);
    const auto* label =
        qobject_cast<QLabel*>(form->labelForField(panel.findChild<QWidget*>("lineStrength")));
    ASSERT_NE(label, nullptr);
    const std::string hint = find_lesson("cut_line").steps[0].hint;
    EXPECT_NE(hint.find("\"" + label->text().toStdString() + "\""), std::string::npos) << hint;
}

TEST(LessonWords, NoLineBreaksBeforeAUnit) {
    EXPECT_EQ(with_units_beside("at most 350 mN, 10 mN s, 3 mm and 5 matters"),
              QString("at most 350\u00a0mN, 10\u00a0mN\u00a0s, 3\u00a0mm and 5 matters"));
}

// Qt makes a common space of most others there.
TEST(LessonWords, KeepANumberBesideItsUnitInRichText) {
    QTextDocument shown;
    shown.setHtml("<p>" + with_units_beside("peak force 1150 mN") + "</p>");
    EXPECT_EQ(shown.toRawText(), QString("peak force 1150\u00a0mN"));
}

TEST(LessonWords, SayTheReasonsAlike) {
    LessonStanding standing;
    standing.limits = {{bleeding, 1.06, false}, {drug, 3.0, false}};
    standing.pass = {{lost, 21.2, false}};
    standing.reasons = {"another reason", reason_of_limit(standing.limits[0], {}),
                        reason_of_limit(standing.limits[1], {}),
                        reason_of_pass_mark(standing.pass[0], {})};
    EXPECT_EQ(reasons_in(standing, {}, computed),
              (std::vector<std::string>{
                  "another reason", "limit broken: bleeding at most 0.53 g/s, but it was 1.06 g/s",
                  "limit broken: drug injected at most 2 g, but it was 3.00 g",
                  "pass mark missed: blood lost at most 10.6 g, but it is 21.2 g"}));
    EXPECT_EQ(
        reasons_in(standing, {}, clinic),
        (std::vector<std::string>{
            "another reason", "limit broken: bleeding at most 30 mL/min, but it was 60 mL/min",
            "limit broken: drug injected at most 2 g, but it was 3.00 g",
            "pass mark missed: blood lost at most 10 mL, but it is 20.0 mL"}));
    // What breaks a limit by a hair is told apart from it.
    standing.limits[0].value = 0.53 * (1.0 + 1e-5);
    standing.reasons = {reason_of_limit(standing.limits[0], {})};
    EXPECT_EQ(reasons_in(standing, {}, clinic),
              (std::vector<std::string>{
                  "limit broken: bleeding at most 30 mL/min, but it was 30.0003 mL/min"}));
}

TEST(LessonWords, DrawBleedingInTheUnitsOfTheClinic) {
    const Chart chart{"Bleeding", "Time (s)", "Bleeding (g/s)", {Curve{"Bleeding", {1}, {1.06}}}};
    EXPECT_EQ(bleeding_in_units(chart, computed).curves[0].y[0], 1.06);
    const Chart shown = bleeding_in_units(chart, clinic);
    EXPECT_EQ(shown.y_label, "Bleeding (mL/min)");
    EXPECT_TRUE(std::ranges::any_of(core_sentences(), [&](const char* sentence) {
        return shown.y_label == sentence;
    })) << "it is said in German, too";
    EXPECT_NEAR(shown.curves[0].y[0], 60.0, 1e-9);
    Chart force = chart;
    force.y_label = "Force (mN)";
    EXPECT_EQ(bleeding_in_units(force, clinic).curves[0].y[0], 1.06);
}

// All steps were reached and a pass mark was missed: both labels stand at one moment.
TEST(LessonWords, OfAPlotGiveTheVerdictToNoStep) {
    LessonStanding standing;
    standing.outcome = LessonOutcome::failed;
    standing.reasons = {"pass mark missed"};
    standing.steps.resize(1);
    standing.steps[0].reached_s = 6.5;
    standing.metrics.time_s = 6.5;
    EXPECT_EQ(plot_events_of(standing),
              (std::vector<PlotEvent>{{6.5, "step 1"}, {6.5, "verdict: not passed"}}));
    standing.outcome = LessonOutcome::passed;
    EXPECT_EQ(plot_events_of(standing).size(), 1u);
}

}  // namespace
}  // namespace hepatica
