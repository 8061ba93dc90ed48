// SPDX-License-Identifier: GPL-3.0-or-later
// What the panel of a lesson says of a standing, without a window.
#include <gtest/gtest.h>

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStringList>
#include <cmath>
#include <tuple>

#include "core/lesson/lesson_draft.h"
#include "ui/lesson_panel.h"

namespace hepatica {
namespace {

Lesson two_steps() {
    Lesson lesson;
    lesson.name = "A <name>";
    lesson.steps = {{"Pull", "Gently", {{Quantity::force_mn, -1, true, 2.0}}, 4.0, {}},
                    {"Let go", "", {{Quantity::force_mn, -1, false, 0.0}}, 0.0, {}}};
    lesson.limits = {{Quantity::force_mn, -1, false, 10.0}};
    return lesson;
}

class LessonPanelTest : public ::testing::Test {
  protected:
    LessonPanelTest()
        : panel_({[this] { ++again_; },
                  [this] { ++left_; },
                  [this] { ++reports_; },
                  [this] { ++looks_back_; },
                  [this] { ++asked_for_attempts_; },
                  {},
                  {},
                  [this](const QString& step) { steps_told_ << step; }}) {
        panel_.begin(two_steps());
        standing_.steps.resize(2);
        standing_.goal = {{two_steps().steps[0].goal[0], 1.0, false}};
        standing_.limits = {{two_steps().limits[0], 3.0, true}};
    }
    QString text(const char* name) { return panel_.findChild<QLabel*>(name)->text(); }
    QPushButton* button(const char* name) { return panel_.findChild<QPushButton*>(name); }

    int again_ = 0, left_ = 0, reports_ = 0, looks_back_ = 0, asked_for_attempts_ = 0;
    QStringList steps_told_;
    LessonPanel panel_;
    LessonStanding standing_;
};

TEST_F(LessonPanelTest, says_the_step_its_goal_and_the_limits) {
    standing_.steps[0].held_s = 1.0;
    panel_.show_standing(standing_);
    EXPECT_EQ(text("lessonStep"), "Step 1 of 2: Pull");
    EXPECT_TRUE(text("lessonGoal").contains("force at least 2\u00a0mN"));
    EXPECT_TRUE(text("lessonGoal").contains("1\u00a0mN"));
    EXPECT_TRUE(text("lessonLimits").contains("force at most 10\u00a0mN"));
    EXPECT_TRUE(text("lessonTitle").contains("A &lt;name&gt;")) << "a name is no markup";
    EXPECT_EQ(panel_.findChild<QProgressBar*>("lessonHold")->value(), 25);
    EXPECT_TRUE(button("lessonReport")->isHidden());
}

TEST(LessonPanel, says_which_tool_the_step_is_done_with_while_another_is_in_hand) {
    LessonPanel::Ways ways;
    ways.tool_and_key = [](LessonTool tool) {
        return tool == LessonTool::sphere ? QString("Probe (4)") : QString("another");
    };
    LessonPanel panel(ways);
    Lesson lesson = two_steps();
    lesson.steps[0].tool = LessonTool::sphere;
    panel.begin(lesson);
    LessonStanding standing;
    standing.steps.resize(2);
    standing.tool_missing = true;
    panel.show_standing(standing);
    const auto* said = panel.findChild<QLabel*>("lessonStepTool");
    EXPECT_EQ(said->text(), "This step is done with: Probe (4)");
    EXPECT_FALSE(said->isHidden());
    standing.tool_missing = false;
    panel.show_standing(standing);
    EXPECT_TRUE(said->isHidden());
}

// Lessons come from anybody.
TEST_F(LessonPanelTest, shows_texts_that_look_like_html_as_they_are) {
    Lesson lesson = two_steps();
    lesson.about = "<b>about</b>";
    lesson.steps[0].text = "<b>pull</b>";
    lesson.steps[0].hint = "<b>hint</b>";
    panel_.begin(lesson);
    panel_.set_next("<b>next</b>");
    panel_.show_standing(standing_);
    int shown = 0;
    for (const QLabel* label : panel_.findChildren<QLabel*>())
        for (const char* part : {"<b>about</b>", "<b>pull</b>", "<b>hint</b>"})
            if (label->text().contains(part) && label->textFormat() == Qt::PlainText) ++shown;
    EXPECT_EQ(shown, 3);
    EXPECT_EQ(button("lessonNext")->toolTip(), "<span>&lt;b&gt;next&lt;/b&gt;</span>");
}

// A row "time of this step" would seem to be of the step that is played now.
TEST_F(LessonPanelTest, shows_no_limits_of_a_step_that_is_over) {
    Lesson lesson = two_steps();
    lesson.steps[0].limits = {{Quantity::step_time_s, -1, false, 20.0}};
    lesson.steps[1].limits = {{Quantity::path_mm, -1, false, 30.0}};
    panel_.begin(lesson);
    standing_.limits.push_back({lesson.steps[0].limits[0], 4.0, true});
    panel_.show_standing(standing_);
    EXPECT_TRUE(text("lessonLimits").contains("20\u00a0s"));
    standing_.limits.push_back({lesson.steps[1].limits[0], 5.0, true});
    standing_.step = 1;
    panel_.show_standing(standing_);
    EXPECT_FALSE(text("lessonLimits").contains("20\u00a0s")) << text("lessonLimits").toStdString();
    EXPECT_TRUE(text("lessonLimits").contains("10\u00a0mN")) << "the lesson's own";
    EXPECT_TRUE(text("lessonLimits").contains("30\u00a0mm")) << "of this step";
    standing_.step = 2;
    standing_.outcome = LessonOutcome::passed;
    panel_.show_standing(standing_);
    EXPECT_FALSE(text("lessonLimits").contains("30\u00a0mm"));
    EXPECT_TRUE(text("lessonLimits").contains("10\u00a0mN"));
}

TEST_F(LessonPanelTest, says_that_the_play_is_paused_after_the_verdict) {
    standing_.outcome = LessonOutcome::passed;
    panel_.show_standing(standing_, true);
    EXPECT_TRUE(text("lessonClock").startsWith("The play is paused as it was when"));
    EXPECT_TRUE(text("lessonClock").contains("what was in hand is put away"));
    EXPECT_FALSE(panel_.findChild<QLabel*>("lessonClock")->isHidden());
    // Free play is shown instead.
    panel_.show_standing(standing_, true, LessonPanel::InView::other);
    EXPECT_FALSE(text("lessonClock").contains("paused as it was"));
    EXPECT_TRUE(text("lessonClock").contains("The play that was judged is left"));
    EXPECT_FALSE(panel_.findChild<QLabel*>("lessonClock")->isHidden());
    panel_.show_standing(standing_, true, LessonPanel::InView::review);
    EXPECT_TRUE(text("lessonClock").startsWith("The view looks back on this attempt"));
    EXPECT_FALSE(panel_.findChild<QLabel*>("lessonClock")->isHidden());
}

TEST_F(LessonPanelTest, says_of_what_must_not_be_that_the_number_beside_it_was_counted) {
    standing_.limits = {{{Quantity::holding, -1, false, 0.0}, 1.0, false}};
    panel_.show_standing(standing_);
    EXPECT_TRUE(text("lessonLimits").contains("no vessels held by hand or tool"));
    EXPECT_TRUE(text("lessonLimits").contains("<b>counted: 1</b>"))
        << text("lessonLimits").toStdString();
}

// Who knows them only in the end plays for something else.
TEST_F(LessonPanelTest, says_the_pass_marks_from_the_start) {
    standing_.pass = {{{Quantity::impulse_mn_s, -1, false, 6000.0}, std::nan(""), false}};
    panel_.show_standing(standing_);
    EXPECT_FALSE(panel_.findChild<QLabel*>("lessonPass")->isHidden());
    EXPECT_TRUE(text("lessonPass").contains("force over time at most 6000\u00a0mN\u00a0s"));
    EXPECT_FALSE(text("lessonPass").contains("none"));
    standing_.pass[0].value = 1500.0;
    panel_.show_standing(standing_);
    EXPECT_TRUE(text("lessonPass").contains("1500\u00a0mN\u00a0s")) << "how it stands so far";
    standing_.outcome = LessonOutcome::passed;
    standing_.pass[0].value = 1.0;
    panel_.show_standing(standing_);
    EXPECT_TRUE(panel_.findChild<QLabel*>("lessonPass")->isHidden()) << "they are told of below";
    EXPECT_TRUE(text("lessonEnd").contains("force over time"));
}

TEST_F(LessonPanelTest, says_whether_it_fits_the_patient) {
    EXPECT_TRUE(panel_.findChild<QLabel*>("lessonPlaceDoubts")->isHidden());
    panel_.begin(new_lesson(), {"\"mark 1\" lies beside"});
    EXPECT_FALSE(panel_.findChild<QLabel*>("lessonPlaceDoubts")->isHidden());
    EXPECT_TRUE(text("lessonPlaceDoubts").contains("\"mark 1\" lies beside"));
    panel_.begin(new_lesson());
    EXPECT_TRUE(panel_.findChild<QLabel*>("lessonPlaceDoubts")->isHidden());
}

TEST_F(LessonPanelTest, says_blood_in_the_units_that_were_chosen) {
    const BoundStanding bleeding{{Quantity::leak_g_s, -1, false, 0.53}, 1.06, false};
    standing_.limits = {bleeding};
    panel_.set_units(FlowUnits::clinic);
    panel_.show_standing(standing_);
    EXPECT_TRUE(text("lessonLimits").contains("bleeding at most 30\u00a0mL/min"));
    EXPECT_TRUE(text("lessonLimits").contains("60\u00a0mL/min"));
    standing_.outcome = LessonOutcome::failed;
    standing_.reasons = {reason_of_limit(bleeding, {})};
    panel_.show_standing(standing_);
    EXPECT_TRUE(text("lessonEnd").contains("it was 60\u00a0mL/min"));
    panel_.set_units(FlowUnits::computed);
    panel_.show_standing(standing_);
    EXPECT_TRUE(text("lessonEnd").contains("it was 1.06\u00a0g/s"));
}

// The portal trunk full of drug is little of all vessels that are no target.
TEST_F(LessonPanelTest, says_of_what_the_shares_are_that_a_drug_has_reached) {
    Lesson lesson = new_lesson();
    lesson.scene.flow.emplace();
    panel_.begin(lesson);
    for (const char* name : {"lessonGoal", "lessonLimits", "lessonPass"})
        EXPECT_TRUE(panel_.findChild<QLabel*>(name)->toolTip().contains("surface")) << name;
    lesson.scene.flow.reset();
    panel_.begin(lesson);
    EXPECT_TRUE(panel_.findChild<QLabel*>("lessonGoal")->toolTip().isEmpty());
}

TEST_F(LessonPanelTest, gives_a_hint_where_it_is_asked_for) {
    panel_.show_standing(standing_);
    auto* hint = panel_.findChild<QLabel*>("lessonHint");
    EXPECT_TRUE(hint->isHidden());
    button("lessonHintButton")->click();
    EXPECT_FALSE(hint->isHidden());
    EXPECT_EQ(hint->text(), "Gently");
    standing_.step = 1;
    panel_.show_standing(standing_);
    EXPECT_TRUE(hint->isHidden()) << "of the step before";
    EXPECT_FALSE(button("lessonHintButton")->isEnabled()) << "this step has none";
}

TEST_F(LessonPanelTest, says_in_the_end_whether_it_is_passed_and_why_not) {
    standing_.outcome = LessonOutcome::failed;
    standing_.reasons = {"limit broken: force"};
    panel_.show_standing(standing_);
    EXPECT_TRUE(text("lessonEnd").contains("Not passed"));
    EXPECT_TRUE(text("lessonEnd").contains("limit broken: force"));
    EXPECT_FALSE(button("lessonReport")->isHidden());
    button("lessonReport")->click();
    button("lessonLookBack")->click();
    button("lessonAttempts")->click();
    button("lessonAgain")->click();
    button("lessonLeave")->click();
    EXPECT_EQ(std::tuple(again_, left_, reports_, looks_back_, asked_for_attempts_),
              std::tuple(1, 1, 1, 1, 1));
    EXPECT_FALSE(text("lessonEnd").contains("not kept")) << "it is no try";
    standing_.outcome = LessonOutcome::passed;
    standing_.reasons.clear();
    panel_.show_standing(standing_);
    EXPECT_TRUE(text("lessonEnd").contains("✓ Passed"));
}

// Who watches the vessels sees no line that changes in the panel.
TEST_F(LessonPanelTest, tells_of_each_later_step_once) {
    panel_.show_standing(standing_);
    EXPECT_TRUE(steps_told_.isEmpty()) << "the first is read before it begins";
    standing_.step = 1;
    panel_.show_standing(standing_);
    panel_.show_standing(standing_);
    EXPECT_EQ(steps_told_, QStringList{"Step 2 of 2: Let go"});
    panel_.begin(two_steps());
    standing_.step = 0;
    panel_.show_standing(standing_);
    standing_.step = 1;
    panel_.show_standing(standing_);
    EXPECT_EQ(steps_told_.size(), 2) << "of another attempt";
}

// "It was 0.1001" alone says not that only the pump was still to be stopped.
TEST_F(LessonPanelTest, says_in_the_end_which_steps_were_reached) {
    standing_.outcome = LessonOutcome::failed;
    standing_.reasons = {"limit broken: force"};
    standing_.step = 1;
    panel_.show_standing(standing_);
    const QString end = text("lessonEnd");
    const qsizetype first = end.indexOf("Step 1 of 2: Pull");
    const qsizetype second = end.indexOf("<b>Step 2 of 2: Let go</b>");
    const qsizetype reached = end.indexOf(";reached<"), missed = end.indexOf(";not reached<");
    EXPECT_TRUE(0 <= first && first < reached && reached < second && second < missed)
        << end.toStdString();
    standing_.outcome = LessonOutcome::passed;
    panel_.show_standing(standing_);
    EXPECT_FALSE(text("lessonEnd").contains("Step 1")) << "all were";
}

// What is still in the vessels is judged by no bound, and where that is of a dose it is said.
TEST_F(LessonPanelTest, says_in_the_end_how_much_of_the_drug_counts_as_no_dose) {
    standing_.outcome = LessonOutcome::passed;
    standing_.metrics.injected_g = 5.0;
    standing_.metrics.delivered_g = 3.75;
    panel_.show_standing(standing_);
    EXPECT_FALSE(text("lessonEnd").contains("of the drug")) << "the lesson judges no dose";
    Lesson lesson = two_steps();
    lesson.steps[1].goal = {{Quantity::dose_target_g, -1, true, 3.0}};
    panel_.begin(lesson);
    panel_.show_standing(standing_);
    EXPECT_TRUE(
        text("lessonEnd").contains("judged by the 3.75\u00a0g of 5.00\u00a0g that had come"))
        << text("lessonEnd").toStdString();
    standing_.metrics.delivered_g = 5.0;
    panel_.show_standing(standing_);
    EXPECT_FALSE(text("lessonEnd").contains("of the drug"));
    // A mark that only a course asks for.
    standing_.metrics.delivered_g = 3.75;
    standing_.pass = {{{Quantity::dose_target_share, -1, true, 0.5}, 0.75, true}};
    panel_.begin(two_steps());
    panel_.show_standing(standing_);
    EXPECT_TRUE(text("lessonEnd").contains("the other 1.25\u00a0g of the drug count neither"));
}

}  // namespace
}  // namespace hepatica
