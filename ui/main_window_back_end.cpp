// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window for the back end: the user's choice and its messages.
#include <QStatusBar>

#include "ui/back_ends.h"
#include "ui/core_words.h"
#include "ui/dial_keeper.h"
#include "ui/lesson_dock.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"
#include "ui/quality_panel.h"
#include "ui/review_dock.h"
#include "ui/words.h"

namespace hepatica {

void MainWindow::connect_back_ends() {
    quality_->show_back_end(back_ends_->chosen());
    quality_->on_back_end = [this](const std::string& name) { choose_back_end(name); };
    // Called on the thread that makes steps.
    back_ends_->on_words([this](const std::string& words) {
        QMetaObject::invokeMethod(
            this, [this, words] { say_of_back_end(words); }, Qt::QueuedConnection);
    });
}

void MainWindow::say_of_back_end(const std::string& words) {
    log_->add_warning(Words::tr("Simulation"), translated(words));
    messages_->show_notice(translated(words));
}

void MainWindow::choose_back_end(const std::string& name) {
    if (name == back_ends_->chosen()) return;
    // A play that waits behind what is shown would be computed anew.
    if (kept_play_.kept() && !end_play_()) return quality_->show_back_end(back_ends_->chosen());
    kept_play_.drop();
    settings_.set_back_end(QString::fromStdString(name));
    back_ends_->choose(name);
    if (!patient_) return;
    measure_dial();
    if (lessons_->playing() || review_->reviewing())
        return statusBar()->showMessage(
            Words::tr("What is shown now goes on as it began: the next play is computed by it"),
            6000);
    attempt(Words::tr("Computed by"), [this] { use(nullptr); });
}

// Measures with the back end of the play; the case that holds this body keeps the result.
void MainWindow::measure_dial() {
    dial_->show(patient_->patient, back_ends_->for_play());
    keep_dial();
}

}  // namespace hepatica
