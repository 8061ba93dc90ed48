// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_words.h"

#include <gtest/gtest.h>

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
    EXPECT_EQ(to_words(drug, {}, clinic), "injected at most 2 g");
    EXPECT_EQ(to_words(Quantity::leak_g_s, 1.06, clinic), "60 mL/min");
    EXPECT_EQ(to_words(Quantity::leak_g_s, 1.06, computed), "1.06 g/s");
    const std::string marks[] = {"a"};
    EXPECT_EQ(to_words(Predicate{Quantity::moved_mm, 0, true, 3.0}, marks, clinic),
              "way moved by a at least 3 mm");
}

TEST(LessonWords, SayTheReasonsAlike) {
    LessonStanding standing;
    standing.limits = {{bleeding, 1.06, false}, {drug, 3.0, false}};
    standing.pass = {{lost, 21.2, false}};
    standing.reasons = {"another reason", reason_of_limit(standing.limits[0], {}),
                        reason_of_limit(standing.limits[1], {}),
                        reason_of_pass_mark(standing.pass[0], {})};
    EXPECT_EQ(reasons_in(standing, {}, computed), standing.reasons);
    EXPECT_EQ(
        reasons_in(standing, {}, clinic),
        (std::vector<std::string>{"another reason",
                                  "limit broken: bleeding at most 30 mL/min, but it was 60 mL/min",
                                  "limit broken: injected at most 2 g, but it was 3 g",
                                  "pass mark missed: blood lost at most 10 mL, but it is 20 mL"}));
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
    EXPECT_NEAR(shown.curves[0].y[0], 60.0, 1e-9);
    Chart force = chart;
    force.y_label = "Force (mN)";
    EXPECT_EQ(bleeding_in_units(force, clinic).curves[0].y[0], 1.06);
}

}  // namespace
}  // namespace hepatica
