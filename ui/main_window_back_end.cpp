// SPDX-License-Identifier: GPL-3.0-or-later
// What makes the steps of what is played: the user's choice, and what there is to say of it.
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
    // On whatever thread makes steps.
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

// With the back end that plays; the case that holds this body keeps what is found.
void MainWindow::measure_dial() {
    dial_->show(patient_->patient, back_ends_->for_play());
    keep_dial();
}

}  // namespace hepatica
