// SPDX-License-Identifier: GPL-3.0-or-later
// What a lesson takes over from the play before it, which is nothing, and what cannot be chosen
// while it is played.
#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStatusBar>
#include <QToolTip>
#include <algorithm>

#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_writer.h"
#include "core/scene/measured_dial.h"
#include "tests/ui/lesson_window_test.h"
#include "ui/lesson_marks.h"
#include "ui/message_bar.h"
#include "ui/mouse_tool.h"
#include "ui/plain_text.h"
#include "ui/review_dock.h"
#include "ui/slices/view_layout.h"

namespace hepatica {
namespace {

using testing::wait_for;

// Nothing moves, only a drug; judged after 0.2 s.
Lesson soon_lost_without_motion() {
    Lesson lesson = new_lesson();
    lesson.scene.deform.reset();
    lesson.scene.flow.emplace();
    lesson.tools = {LessonTool::inject};
    lesson.limits = {{Quantity::time_s, -1, false, 0.2}};
    lesson.steps[0].goal = {{Quantity::time_s, -1, true, 1000.0}};
    return lesson;
}

class LessonToolsTest : public testing::LessonWindowTest {
  protected:
    void begin(const Lesson& lesson) {
        const std::string file = folder_.filePath("lesson.json").toStdString();
        write_lesson(file, lesson);
        begin(file);
    }
    void begin(const std::string& file) {
        window_.lessons().start(file);
        ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
        paint();
        start_clock();
    }
    bool runs_for(double seconds) {
        return wait_for([&] {
            return window_.lessons().standing().outcome != LessonOutcome::running ||
                   window_.lessons().standing().metrics.time_s > seconds;
        });
    }
    bool enabled(const char* name) { return window_.findChild<QWidget*>(name)->isEnabled(); }
    // Moves the pointer over vessels until one is highlighted; how many of its vertices are.
    std::ptrdiff_t lit_by_pointing() {
        const std::vector<std::uint8_t>& highlight = window_.view().scene().highlight();
        const Frame& frame = window_.frame();
        const int vertices = static_cast<int>(frame.positions_mm.size()) / 3;
        for (int v = 0; highlight.empty() && v < vertices; v += 5) {
            const QPoint place = on_widget(frame.place_mm(v));
            QMouseEvent move(QEvent::MouseMove, place, window_.view().mapToGlobal(place),
                             Qt::NoButton, Qt::NoButton, Qt::NoModifier);
            QApplication::sendEvent(&window_.view(), &move);
        }
        return std::ranges::count(highlight, std::uint8_t{1});
    }
    LessonStanding standing() { return window_.lessons().standing(); }
    QAction& action(ActionId id) { return window_.actions()[id]; }
};

TEST(LessonMarks, the_one_that_the_step_names_is_wanted_and_all_are_reached_at_the_end) {
    Lesson lesson;
    lesson.marks = {{"first", {}}, {"second", {}}, {"of no goal", {}}};
    lesson.steps.resize(2);
    lesson.steps[0].goal = {{Quantity::distance_mm, 0, false, 12.0}};
    lesson.steps[1].goal = {{Quantity::distance_mm, 1, false, 12.0}};
    const std::vector<Vec3> places_mm(3, Vec3::Zero());
    const auto seen = [&](std::size_t step, bool MarkView::*what) {
        std::vector<bool> list;
        for (const MarkView& mark : views_of_marks(lesson, places_mm, step))
            list.push_back(mark.*what);
        return list;
    };
    EXPECT_EQ(seen(0, &MarkView::wanted), (std::vector{true, false, false}));
    EXPECT_EQ(seen(1, &MarkView::wanted), (std::vector{false, true, false}));
    EXPECT_EQ(seen(1, &MarkView::reached), (std::vector{true, false, false}));
    EXPECT_EQ(seen(2, &MarkView::wanted), (std::vector{false, false, false}));
    EXPECT_EQ(seen(2, &MarkView::reached), (std::vector{true, true, true}));
}

TEST_F(LessonToolsTest, it_begins_with_nothing_of_the_play_before) {
    open_built_in();
    window_.findChild<QCheckBox*>("vesselsTear")->click();
    ASSERT_TRUE(wait_for([&] { return window_.frame().tear.has_value(); }));
    wait_for_figures();
    auto* factor = window_.findChild<QDoubleSpinBox*>("tearFactor");
    factor->setValue(0.3);
    action(ActionId::sphere_tool).trigger();
    Lesson lesson = new_lesson();
    lesson.scene.tear.emplace();
    for (int time = 0; time < 2; ++time) {  // begun again, the box shows that its scene tears
        begin(lesson);
        ASSERT_TRUE(runs_for(0.3));
        EXPECT_EQ(standing().outcome, LessonOutcome::running);
        EXPECT_TRUE(standing().reasons.empty()) << standing().reasons.front();
        wait_for_figures();
        EXPECT_TRUE(window_.findChild<QCheckBox*>("vesselsTear")->isChecked());
        EXPECT_EQ(factor->value(), 1.0) << "as its scene says";
    }
    // In free play vessels tear where the user wants it.
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    EXPECT_TRUE(wait_for([&] { return window_.frame().tear.has_value(); }));
    EXPECT_EQ(factor->value(), 0.3);
}

TEST_F(LessonToolsTest, a_scene_in_which_nothing_moves_is_told_of_no_tool) {
    open_built_in();
    action(ActionId::sphere_tool).trigger();
    Lesson lesson = new_lesson();
    lesson.scene.deform.reset();
    lesson.scene.flow.emplace();
    lesson.tools = {LessonTool::inject};
    lesson.steps[0].goal = {{Quantity::time_s, -1, true, 1000.0}};
    lesson.limits.clear();
    begin(lesson);
    ASSERT_TRUE(runs_for(0.3));
    EXPECT_EQ(window_.frame().statistics.message, "");
    EXPECT_FALSE(window_.view().mouse().hand().holds());
}

// Else the bar would show Pull as chosen, and the words would send one to tools that do nothing.
TEST_F(LessonToolsTest, where_nothing_moves_nothing_offers_to_move_it_also_after_the_verdict) {
    begin(soon_lost_without_motion());
    const auto told = [this] { return window_.statusBar()->currentMessage().toStdString(); };
    EXPECT_EQ(
        told(),
        "Only the flow is played here: choose Inject (2); a drag or the arrows turn the view");
    ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
    ASSERT_TRUE(wait_for([&] { return action(ActionId::inject_mode).isEnabled(); }));
    ASSERT_TRUE(wait_for([&] { return action(ActionId::edit_mode).isEnabled(); }));
    for (const ActionId id : body_actions) EXPECT_FALSE(action(id).isEnabled());
    QTest::keyClick(&window_, Qt::Key_4);
    EXPECT_EQ(told(), "Only the flow is played here: there is nothing to pull, touch or cut");
    auto* device = window_.findChild<QLabel*>("device");
    EXPECT_TRUE(wait_for([&] { return device->isHidden(); })) << "nothing makes steps";
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    for (const ActionId id : body_actions) EXPECT_TRUE(action(id).isEnabled());
    EXPECT_EQ(told(), "Drag a vessel to pull it (by keys: Enter at the cross, then arrows)");
}

// Else the key of the next tool would stand in the name.
TEST_F(LessonToolsTest, after_the_name_was_entered_keys_are_those_of_the_play) {
    begin(new_lesson());
    auto* name = window_.lessons().findChild<QLineEdit*>("lessonName");
    ASSERT_NE(name, nullptr);
    name->setFocus();
    ASSERT_EQ(window_.focusWidget(), name);
    QTest::keyClicks(name, "dr1");
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_NE(window_.focusWidget(), name);
    EXPECT_EQ(name->text(), "dr1");
}

TEST_F(LessonToolsTest, what_it_does_not_allow_cannot_be_chosen) {
    begin(new_lesson());
    EXPECT_TRUE(action(ActionId::pull_mode).isEnabled());
    for (const ActionId id :
         {ActionId::sphere_tool, ActionId::forceps_tool, ActionId::cut_mode, ActionId::inject_mode,
          ActionId::reset, ActionId::edit_mode, ActionId::choose_threshold}) {
        EXPECT_FALSE(action(id).isEnabled());
        EXPECT_TRUE(action(id).toolTip().startsWith("The lesson does not allow this"));
    }
    for (const char* control : {"vesselsTear", "speed", "gravity", "tissue"})
        EXPECT_FALSE(enabled(control)) << control;
    QTest::keyClick(&window_, Qt::Key_4);
    EXPECT_FALSE(window_.view().mouse().hand().holds());
    EXPECT_EQ(window_.statusBar()->currentMessage().toStdString(),
              "The lesson does not allow this: Probe");
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    for (const ActionId id : {ActionId::sphere_tool, ActionId::cut_mode, ActionId::reset}) {
        EXPECT_TRUE(action(id).isEnabled());
        EXPECT_FALSE(action(id).toolTip().contains("lesson"));
    }
    for (const char* control : {"vesselsTear", "speed", "gravity"})
        EXPECT_TRUE(enabled(control)) << control;
}

// Other vessels would be another play, and the attempt would be gone without a verdict.
TEST_F(LessonToolsTest, nothing_is_corrected_while_it_is_played) {
    begin(new_lesson());
    window_.view().mouse().set_mode(MouseMode::edit);
    const Vec3 mark = window_.lessons().marks_in(window_.frame()).at(0).place_mm;
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(mark));
    EXPECT_EQ(window_.messages().text(), "Nothing is corrected during a lesson: leave it first");
    EXPECT_FALSE(window_.busy());
    EXPECT_TRUE(window_.workspace().edits().empty());
    EXPECT_EQ(standing().outcome, LessonOutcome::running);
}

TEST_F(LessonToolsTest, where_nothing_may_be_pulled_nobody_is_told_to_pull) {
    Lesson lesson = new_lesson();
    lesson.tools = {LessonTool::sphere};
    begin(lesson);
    EXPECT_EQ(window_.statusBar()->currentMessage(),
              "Choose a tool; a drag or the arrows turn the view");
}

// Nothing is in hand where a lesson begins.
TEST_F(LessonToolsTest, a_click_on_a_vessel_names_the_tools_where_nothing_may_be_pulled) {
    Lesson lesson = new_lesson();
    lesson.tools = {LessonTool::forceps, LessonTool::sphere};
    begin(lesson);
    window_.statusBar()->clearMessage();
    const Vec3 mark = window_.lessons().marks_in(window_.frame()).at(0).place_mm;
    const QPoint there = on_widget(mark);
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, there);
    QTest::mouseMove(&window_.view(), there + QPoint(30, 0));
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, there + QPoint(30, 0));
    EXPECT_EQ(window_.statusBar()->currentMessage(), "") << "the view was turned";
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, QPoint(8, 8));
    EXPECT_EQ(window_.statusBar()->currentMessage(), "") << "no vessel was meant";
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(mark));
    EXPECT_EQ(window_.statusBar()->currentMessage(), "Choose a tool: Probe (4), Forceps (6)");
    window_.statusBar()->clearMessage();
    QTest::keyClick(&window_.view(), Qt::Key_Return);
    EXPECT_EQ(window_.statusBar()->currentMessage(), "Choose a tool: Probe (4), Forceps (6)");
}

// It would bleed and swing on under the verdict, and cost for nothing.
TEST_F(LessonToolsTest, its_clock_stands_from_the_verdict_on_until_something_is_done) {
    Lesson lesson = new_lesson();
    lesson.limits = {{Quantity::time_s, -1, false, 2.0}};
    begin(lesson);
    ASSERT_TRUE(wait_for([&] { return !window_.frame().statistics.paused; }));
    ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
    ASSERT_TRUE(wait_for([&] { return window_.frame().statistics.paused; }));
    EXPECT_EQ(window_.messages().text(), "") << "no drug flows in it, and none is told to stop";
    auto* clock = window_.lessons().findChild<QLabel*>("lessonClock");
    EXPECT_TRUE(wait_for([&] { return clock->text().startsWith("The play is paused as it was"); }));
    EXPECT_FALSE(clock->isHidden());
    const Vec3 mark = window_.lessons().marks_in(window_.frame()).at(0).place_mm;
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_widget(mark));
    EXPECT_TRUE(wait_for([&] { return !window_.frame().statistics.paused; }));
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_widget(mark));
    EXPECT_TRUE(wait_for([&] { return clock->isHidden(); }));
}

TEST_F(LessonToolsTest, its_play_has_the_dial_that_was_measured_on_these_vessels_before) {
    open_built_in();
    const auto own = [this] { return is_of_own_body(window_.frame().statistics.error_reference); };
    ASSERT_TRUE(wait_for(own)) << "nobody plays, so that it is measured";
    begin(new_lesson());
    EXPECT_TRUE(wait_for(own));
}

// The button would say that the drug runs while nothing moves.
TEST_F(LessonToolsTest, after_the_verdict_a_drug_that_is_to_run_on_lets_the_play_go_on) {
    Lesson lesson = new_lesson();
    lesson.limits = {{Quantity::time_s, -1, false, 0.5}};
    begin(lesson);
    ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
    auto* clock = window_.lessons().findChild<QLabel*>("lessonClock");
    ASSERT_TRUE(wait_for([&] { return clock->text().startsWith("The play is paused as it was"); }));
    EXPECT_FALSE(window_.lessons().begins_with(PlayDrug{false}));
    EXPECT_TRUE(window_.lessons().begins_with(PlayDrug{true}));
}

// Where pictures are slow, the panel would say that the clock stands while a tool presses already.
TEST_F(LessonToolsTest, that_the_clock_runs_is_said_with_the_first_thing_done) {
    const std::string file = folder_.filePath("lesson.json").toStdString();
    write_lesson(file, new_lesson());
    window_.lessons().start(file);
    const auto* clock = window_.lessons().findChild<QLabel*>("lessonClock");
    ASSERT_TRUE(wait_for([&] { return clock->text().startsWith("The clock stands"); }));
    EXPECT_TRUE(window_.lessons().begins_with(GrabPoint{}));
    EXPECT_TRUE(clock->text().startsWith("Time:")) << clock->text().toStdString();
}

// The tool is gone and the wheel has another meaning, while the eyes are on the vessels.
TEST_F(LessonToolsTest, that_the_tool_is_put_away_at_the_verdict_is_said) {
    Lesson lesson = new_lesson();
    lesson.tools = {LessonTool::sphere};
    lesson.limits = {{Quantity::time_s, -1, false, 1.0}};
    begin(lesson);
    action(ActionId::sphere_tool).trigger();
    ASSERT_EQ(window_.view().mouse().mode(), MouseMode::tool);
    ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
    EXPECT_TRUE(wait_for([&] {
        return window_.statusBar()->currentMessage() ==
               "The lesson is judged: the tool is put away, and the wheel zooms";
    }));
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::pull);
}

// "Inject so that 3 g reach the target's tissue": which that is must be seen.
TEST_F(LessonToolsTest, the_target_of_a_drug_is_seen_while_it_is_played) {
    Lesson lesson = new_lesson();
    lesson.scene.deform.reset();
    lesson.scene.flow.emplace();
    lesson.tools = {LessonTool::inject};
    lesson.limits.clear();
    lesson.steps[0].goal = {{Quantity::time_s, -1, true, 1000.0}};
    const auto lit = [this] {
        return std::ranges::count(window_.view().scene().target(), std::uint8_t{1});
    };
    begin(lesson);
    EXPECT_EQ(lit(), 0) << "it wants no drug anywhere";
    const auto in_front = [this](const char* panel) {
        return !window_.findChild<QDockWidget*>(panel)->visibleRegion().isEmpty();
    };
    window_.findChild<QDockWidget*>("Tool")->raise();  // as the lesson before left it
    ASSERT_TRUE(wait_for([&] { return in_front("Tool"); }));
    lesson.target.emplace();
    lesson.target->share_of_longest_path = 0.5;
    begin(lesson);
    EXPECT_GT(lit(), 0);
    EXPECT_LT(lit(), std::ssize(window_.view().scene().target())) << "the rest is no target";
    EXPECT_TRUE(window_.view().scene().legend().target);
    // Pointing at a vessel, as to choose where to inject, adds a highlight and takes nothing away.
    const std::vector<std::uint8_t> target = window_.view().scene().target();
    EXPECT_GT(lit_by_pointing(), 0);
    EXPECT_EQ(window_.view().scene().target(), target);
    EXPECT_TRUE(wait_for([&] { return in_front("Injection"); }));
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    EXPECT_EQ(lit(), 0);
    EXPECT_FALSE(window_.view().scene().legend().target);
}

// The drag that turned the view before the verdict would ask of the scene what it has not.
TEST_F(LessonToolsTest, what_does_not_move_is_not_pulled_after_the_verdict_either) {
    Lesson lesson = soon_lost_without_motion();
    begin(lesson);
    ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
    wait_for_figures();
    ASSERT_EQ(window_.view().mouse().mode(), MouseMode::pull);
    const QPoint at = on_widget(window_.lessons().marks_in(window_.frame()).at(0).place_mm);
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, at);
    EXPECT_FALSE(window_.view().mouse().pulling());
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, at);
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    EXPECT_TRUE(window_.view().mouse().may_pull()) << "free play moves";
}

// Just then one looks for what the drug has missed.
TEST_F(LessonToolsTest, the_target_of_a_drug_is_seen_after_the_verdict) {
    Lesson lesson = soon_lost_without_motion();
    lesson.target.emplace();
    lesson.target->share_of_longest_path = 0.5;
    begin(lesson);
    const std::vector<std::uint8_t> target = window_.view().scene().target();
    EXPECT_GT(std::ranges::count(target, std::uint8_t{1}), 0);
    ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
    wait_for_figures();
    window_.view().scene().set_highlight({});
    EXPECT_GT(lit_by_pointing(), 0);
    EXPECT_EQ(window_.view().scene().target(), target);
    window_.view().scene().set_highlight({});  // else the pointer lights all of it
    EXPECT_TRUE(window_.view().scene().legend().target);
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    lit_by_pointing();
    EXPECT_TRUE(window_.view().scene().target().empty()) << "free play wants no drug";
}

TEST_F(LessonToolsTest, a_slip_is_told_of_and_does_not_end_it) {
    begin(new_lesson());
    const Vec3 mark = window_.lessons().marks_in(window_.frame()).at(0).place_mm;
    QTest::mouseClick(&window_.view(), Qt::LeftButton, Qt::ControlModifier, on_widget(mark));
    EXPECT_EQ(window_.statusBar()->currentMessage(), "the lesson does not allow this: injecting");
    const double now_s = standing().metrics.time_s;
    ASSERT_TRUE(runs_for(now_s + 0.2));
    EXPECT_EQ(standing().outcome, LessonOutcome::running);
}

TEST_F(LessonToolsTest, where_nothing_may_be_pulled_a_drag_turns_the_view) {
    Lesson lesson = new_lesson();
    lesson.tools = {LessonTool::sphere};
    begin(lesson);
    const Vec3 mark = window_.lessons().marks_in(window_.frame()).at(0).place_mm;
    const Vec3 looked = window_.view().scene().axes().forward;
    const QPoint at = on_widget(mark);
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, at);
    QMouseEvent move(QEvent::MouseMove, at + QPoint(60, 0), window_.view().mapToGlobal(at),
                     Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window_.view(), &move);
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, at + QPoint(60, 0));
    EXPECT_NE(window_.view().scene().axes().forward, looked);
    EXPECT_EQ(standing().outcome, LessonOutcome::running);
}

// The review shows the lesson's own body; free play after it another one.
TEST_F(LessonToolsTest, its_mark_is_on_no_other_bodys_vessels) {
    Lesson lesson = soon_lost_without_motion();
    begin(lesson);
    EXPECT_EQ(window_.view().scene().marks().size(), 1u);
    ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
    wait_for_figures();
    window_.lessons().findChild<QPushButton*>("lessonLookBack")->click();
    ASSERT_TRUE(wait_for([&] { return window_.review().complete(); }));
    EXPECT_TRUE(shown("lessonClock").startsWith("The view looks back on this attempt"))
        << shown("lessonClock").toStdString();
    window_.review().findChild<QPushButton*>("reviewLeave")->click();
    paint();
    EXPECT_TRUE(window_.lessons().marks_in(window_.frame()).empty());
    EXPECT_TRUE(window_.view().scene().marks().empty());
    EXPECT_FALSE(window_.lessons().isHidden()) << "how it went can still be read";
    EXPECT_TRUE(shown("lessonClock").startsWith("The play that was judged is left"))
        << shown("lessonClock").toStdString();
}

TEST_F(LessonToolsTest, its_marks_are_numbered_and_one_that_is_done_with_is_ticked) {
    Lesson lesson = new_lesson();
    lesson.marks.push_back({"mark 2", {std::nullopt, 0.8}});
    lesson.steps[0].goal = {{Quantity::moved_mm, 0, false, 5.0}};
    lesson.steps[0].hold_s = 0.2;
    lesson.steps.push_back(lesson.steps[0]);
    lesson.steps[1].goal = {{Quantity::moved_mm, 1, true, 50.0}};
    begin(lesson);
    ASSERT_TRUE(wait_for([&] { return standing().step == 1; }));
    paint();
    const std::vector<MarkView>& marks = window_.view().scene().marks();
    ASSERT_EQ(marks.size(), 2u);
    EXPECT_EQ(marks[0].number, "1");
    EXPECT_EQ(marks[1].number, "2");
    EXPECT_TRUE(wait_for([&] { return window_.view().scene().marks()[0].reached; }));
    EXPECT_FALSE(window_.view().scene().marks()[1].reached);
}

// The goals stand beside the view; one long line would be pushed over them by the screen's edge.
TEST_F(LessonToolsTest, a_balloon_in_the_view_has_short_lines) {
    Lesson lesson = new_lesson();
    lesson.tools = {LessonTool::pull};
    begin(lesson);
    QCursor::setPos(window_.view().mapToGlobal(window_.view().rect().center()));
    ASSERT_TRUE(wait_for([this] { return window_.view().underMouse(); }));
    QTest::keyClick(&window_, Qt::Key_4);
    EXPECT_EQ(QToolTip::text(), in_short_lines("The lesson does not allow this: Probe"));
    const auto width_of = [](const QString& text) {
        QToolTip::hideText();
        QToolTip::showText({}, text);
        for (const QWidget* widget : QApplication::topLevelWidgets())
            if (widget->objectName() == "qtooltip_label" && widget->isVisible())
                return widget->width();
        return 0;
    };
    const QString words = QString("a hint ").repeated(40);
    const int in_one_line = width_of(words), wrapped = width_of(in_short_lines(words));
    EXPECT_GT(wrapped, 0);
    EXPECT_LT(wrapped, in_one_line / 2);
    QToolTip::hideText();
}

// What a hint says of the mouse, a hand without one has to look up.
TEST_F(LessonToolsTest, a_hint_names_the_keys_of_the_tools_of_the_lesson) {
    Lesson lesson = new_lesson();
    lesson.tools = {LessonTool::pull, LessonTool::sphere};
    lesson.steps[0].hint = "Gently";
    begin(lesson);
    window_.actions()[ActionId::sphere_tool].setShortcut(QKeySequence("Ctrl+8"));
    window_.lessons().findChild<QPushButton*>("lessonHintButton")->click();
    const auto* hint = window_.lessons().findChild<QLabel*>("lessonHint");
    ASSERT_TRUE(wait_for([&] { return hint->text().contains("Ctrl+8"); }))
        << hint->text().toStdString();
    EXPECT_TRUE(hint->text().startsWith("Gently\nBy keys: Pull (1), Probe (Ctrl+8)\nEnter acts"))
        << hint->text().toStdString();
    EXPECT_TRUE(hint->text().contains("Page Up and Page Down")) << "in depth";
    for (const char* other : {"Forceps", "Inject", "inject", "blade"})
        EXPECT_FALSE(hint->text().contains(other)) << other;
}

// Space starts the drug there; on "Begin again" it would end the attempt.
TEST_F(LessonToolsTest, a_control_that_is_disabled_gives_the_keyboard_back_to_the_view) {
    begin(new_lesson());
    auto* hint = window_.lessons().findChild<QPushButton*>("lessonHintButton");
    hint->setFocus();
    ASSERT_TRUE(hint->hasFocus());
    hint->click();
    EXPECT_FALSE(hint->isEnabled());
    EXPECT_TRUE(window_.view().hasFocus())
        << QApplication::focusWidget()->objectName().toStdString();
    hint->setEnabled(true);
    hint->setFocus();
    hint->hide();
    EXPECT_TRUE(window_.view().hasFocus());
}

}  // namespace
}  // namespace hepatica
