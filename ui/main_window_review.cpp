// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window for looking back on recordings: connects the dock of reviews.
#include <QStatusBar>
#include <algorithm>
#include <functional>
#include <utility>

#include "ui/curves_dock.h"
#include "ui/lesson_dock.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/recovery.h"
#include "ui/review_dock.h"
#include "ui/second_view.h"
#include "ui/view_ruler.h"
#include "ui/vtk_widget.h"
#include "ui/words.h"

namespace hepatica {

void MainWindow::build_review() {
    ReviewDock::Ways ways;
    ways.patient = [this] { return patient_ ? patient_->patient : nullptr; };
    ways.open = [this](const OpenRequest& request) { open(request); };
    ways.back_end = [back_ends = back_ends_](const std::string& name) {
        return back_ends->named(name);
    };
    ways.use = [this](std::unique_ptr<Simulation> simulation) {
        const bool leaves = simulation == nullptr;
        dismiss_review_message();
        if (!leaves) stop_drawing_a_vessel();
        lessons_->play_hidden(review_->file());
        use(std::move(simulation));
        if (leaves) ruler_->hide_made(false);  // the lesson's play is over, too
        if (leaves) show_whole();
    };
    ways.lesson_runs = [this] {
        return lessons_->playing() && lessons_->standing().outcome == LessonOutcome::running;
    };
    ways.vessels_change = [this] { return keeper_->makes_vessels(); };
    ways.ask_for_other = [this] { return ask_for_recording(review_->file()); };
    ways.stopped_or_went_on = [this] { show_figures_soon(); };
    ways.beside = [this](const std::shared_ptr<const Frame>& frame, std::vector<MarkView> marks,
                         const QString& first, const QString& other) {
        make_room_beside(frame != nullptr);
        // Uses nothing of the patient, who may be about to be destroyed.
        if (frame == nullptr) {
            view_->scene().set_drug_scale(0.0);
            show_caption(translated(workspace().title()));
            return second_view_->clear();
        }
        const double end_s = std::max(this->frame().drug.end_s, frame->drug.end_s);
        view_->scene().set_drug_scale(end_s);
        second_view_->set_drug_scale(end_s);
        show_caption(first);
        view_->show_frame(this->frame());  // also if no new frame comes, for the new scale
        second_view_->show_frame(frame, std::move(marks), patient_->anatomy.vertex_systems(),
                                 other);
    };
    ways.save_film = std::bind_front(&MainWindow::ask_and_save_film, this);
    ways.save_pictures = std::bind_front(&MainWindow::ask_and_save_pictures, this);
    ways.failed = [this](const Failure& failure) {
        fail(Words::tr("Look back on a recording"), failure);
        review_message_ = messages_->text();
    };
    ways.known_case = [this](std::uint64_t hash) {
        return to_path(settings_.place_of_patient(hash));
    };
    ways.work_is_unsaved = [this] { return !recovery_->left_behind().empty(); };
    ways.choose_case = [this](const Failure& failure,
                              std::function<void(const std::filesystem::path&)> chosen) {
        fail(Words::tr("Look back on a recording"), failure);
        if (!recovery_->left_behind().empty())
            messages_->offer_first(Words::tr("Open the unsaved work"),
                                   [this] { open_unsaved_work(); });
        messages_->offer_also(Words::tr("Choose the case…"), [this, chosen = std::move(chosen)] {
            if (const auto place = which_case()) chosen(*place);
        });
    };
    ways.say = [this](const QString& text) { statusBar()->showMessage(text, 6000); };
    ways.unsay = [this](const QString& text) {
        if (statusBar()->currentMessage() == text) statusBar()->clearMessage();
    };
    review_ = new ReviewDock(std::move(ways), this);
    addDockWidget(Qt::BottomDockWidgetArea, review_);
    tabifyDockWidget(curves_, review_);
    review_->hide();
}

// Why a recording was not shown is told until another one is, or the lesson that forbade it ends.
void MainWindow::dismiss_review_message() {
    const QString message = std::exchange(review_message_, {});
    if (!message.isEmpty() && messages_->text() == message) messages_->dismiss();
}

}  // namespace hepatica
