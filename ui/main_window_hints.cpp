// SPDX-License-Identifier: GPL-3.0-or-later
// What the window says of the play: messages of the simulation, what the mouse does now, and why
// something did nothing.
#include <QCursor>
#include <QKeyEvent>
#include <QStatusBar>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <utility>

#include "ui/core_words.h"
#include "ui/lesson_dock.h"
#include "ui/lesson_tools.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"
#include "ui/plain_text.h"
#include "ui/review_dock.h"
#include "ui/view_ruler.h"
#include "ui/vtk_widget.h"
#include "ui/words.h"

namespace hepatica {
namespace {

QString forces_may_be_rough() {
    return Words::tr("Forces shown may be rough: the step was simplified to stay stable");
}

bool shows_force(const Frame& frame) {
    return frame.grab || frame.tool;
}

}  // namespace

// A message that stops the play stays above the view while it holds; others appear briefly below.
void MainWindow::show_message_of(const Frame& frame) {
    const FrameStatistics& statistics = frame.statistics;
    if (!shows_force(frame)) {
        rough_told_ = false;
        if (statusBar()->currentMessage() == forces_may_be_rough()) statusBar()->clearMessage();
    }
    if (statistics.message == last_message_) return say_rough_forces();
    if (messages_->text() == translated(last_message_)) messages_->dismiss();
    last_message_ = statistics.message;
    rough_told_ = false;
    const bool solver_spoke = std::exchange(solver_speaks_, statistics.message_of_solver);
    if (solver_speaks_) return tell_simplified();
    const QString text = translated(last_message_);
    if (text.isEmpty() && solver_spoke) return;  // its words go by themselves
    if (!statistics.paused || text.isEmpty()) {
        statusBar()->showMessage(text, 4000);
        return;
    }
    log_->add_warning(Words::tr("Simulation"), text);
    if (!statistics.diverged) return messages_->show_notice(text);
    messages_->show_notice(text, Words::tr("Back to the last good state"),
                           [this] { (*actions_)[ActionId::restore].trigger(); });
}

// In plain words. The solver's own are for the log, each sentence once for a patient: they come
// with single steps, again and again.
void MainWindow::tell_simplified() {
    if (solver_said_.insert(last_message_).second)
        log_->add_note(Words::tr("Simulation"),
                       Words::tr("Forces shown were rough for a moment: the step was simplified to "
                                 "stay stable (%1)")
                           .arg(translated(last_message_)));
    say_rough_forces();
}

// Also where a force appears only after the solver began to simplify.
void MainWindow::say_rough_forces() {
    if (solver_speaks_ && shows_force(frame()) && !std::exchange(rough_told_, true))
        statusBar()->showMessage(forces_may_be_rough(), 6000);
}

void MainWindow::hint(const QString& text) {
    constexpr int readable_ms = 6000;
    statusBar()->showMessage(text, readable_ms);
    if (view_->underMouse())
        QToolTip::showText(QCursor::pos() + QPoint(12, 8), in_short_lines(text), view_, {},
                           readable_ms);
}

// The action that has this key is disabled, by a lesson or because there is nothing to undo; else
// the key does not come here.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    const bool undoes = event->key() == Qt::Key_Z && event->modifiers() == Qt::ControlModifier;
    if (undoes && patient_ && !review_->reviewing() && frame().tear &&
        frame().tear->joints_broken > 0)
        return say_that_cuts_stay();
    if (const QString why = actions_->objection_to(QKeySequence(event->keyCombination()));
        !why.isEmpty())
        return hint(why);
    QMainWindow::keyPressEvent(event);
}

void MainWindow::say_that_cuts_stay() {
    if (!plays_freely())
        return hint(
            Words::tr("Undo is for corrections and takes no cut back: Begin again makes "
                      "the vessels whole"));
    messages_->show_notice(
        Words::tr("Undo is for corrections of the vessels: what was cut or torn in the play stays "
                  "so. Reset (Backspace) makes the vessels whole."),
        Words::tr("Reset"), [this] { (*actions_)[ActionId::reset].trigger(); });
    cuts_message_ = messages_->text();
}

void MainWindow::say_missed() {
    if (!patient_) return;
    const bool pulls = view_->mouse().mode() == MouseMode::pull;
    if (pulls && !view_->mouse().may_pull()) return say_tools_to_choose();
    hint(pulls ? Words::tr("No vessel there: drag one (by keys: Enter with the cross on it)")
               : Words::tr("No vessel there: click on one (by keys: Enter with the cross on it)"));
}

void MainWindow::say_tools_to_choose() {
    if (review_->reviewing()) return;
    if (!allowed_tools_) return hint(guidance_of(MouseMode::pull));
    const QString tools = in_words(*allowed_tools_, *actions_);
    hint(tools.isEmpty()
             ? Words::tr("This lesson is played without tools; a drag or the arrows turn the view")
             : Words::tr("Choose a tool: %1").arg(tools));
}

// Where a click brings the tool to a mark, nobody would learn to find its depth.
bool MainWindow::step_lets_clicks_bring() {
    const Lesson* lesson = lessons_->running();
    if (lesson == nullptr) return true;
    const std::size_t step = lessons_->standing().step;
    if (step >= lesson->steps.size()) return true;  // it has just been passed
    const bool asks = std::ranges::any_of(lesson->steps[step].goal, [](const Predicate& goal) {
        return goal.quantity == Quantity::distance_mm && !goal.at_least;
    });
    if (asks)
        hint(
            Words::tr("This step asks you to lead the tool: the wheel (by keys: Page Up/Down) "
                      "moves it in depth"));
    return !asks;
}

void MainWindow::say_empty_grip(GripWatch::Seen seen) {
    hint(
        seen == GripWatch::Seen::slipped
            ? Words::tr("The vessel slipped out of the jaws: C opens them")
            : Words::tr("The jaws closed beside the vessel: C opens them, the wheel (by keys: Page "
                        "Up/Down) moves them in depth"));
}

QString MainWindow::guidance_of(MouseMode mode) const {
    switch (mode) {
        case MouseMode::pull:
            return review_->reviewing() ? Words::tr("A drag or the arrows turn the view")
                   : view_->mouse().may_pull()
                       ? Words::tr(
                             "Drag a vessel to pull it (by keys: Enter at the cross, then arrows)")
                       : words_without_pulling();
        case MouseMode::inject:
            return Words::tr("Click on a vessel to inject there (by keys: Enter at the cross)");
        case MouseMode::edit:
            return Words::tr("Click on a vessel to correct the tree (by keys: Enter at the cross)");
        case MouseMode::place:
            return Words::tr("Click on a vessel: the place is there (by keys: Enter at the cross)");
        case MouseMode::measure:
            return ruler_->guidance();
        case MouseMode::cut:
            return Words::tr(
                "Draw a line across a vessel to cut it (by keys: Enter, arrows, Enter)");
        case MouseMode::weaken:
            return Words::tr(
                "Draw a line across a vessel: it tears there when pulled (by keys: Enter, arrows, "
                "Enter)");
        case MouseMode::tool:
            return Words::tr(
                "The mouse leads the tool, the wheel moves it in depth, a click brings it to a "
                "vessel (by keys: arrows, Page Up/Down, Enter)");
    }
    return {};
}

// Where a drag pulls nothing: the lesson forbids it, or there is no body.
QString MainWindow::words_without_pulling() const {
    const std::array inject{LessonTool::inject};
    const bool may_inject = !allowed_tools_ || allows(*allowed_tools_, LessonTool::inject);
    return !review_->reviewing() && !view_->mouse().moves() && may_inject
               ? Words::tr(
                     "Only the flow is played here: choose %1; a drag or the arrows turn "
                     "the view")
                     .arg(in_words(inject, *actions_))
               : Words::tr("Choose a tool; a drag or the arrows turn the view");
}

void MainWindow::use_body(bool moves) {
    view_->mouse().set_moves(moves);
    const QString why =
        moves ? QString()
              : Words::tr("Only the flow is played here: there is nothing to pull, touch or cut");
    for (const ActionId id : body_actions) actions_->show_lack(id, why);
}

}  // namespace hepatica
