// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons and reviews in the window: the docks that play and show them, and their ways to the rest.
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <utility>

#include "ui/curves_dock.h"
#include "ui/lesson_dock.h"
#include "ui/main_window.h"
#include "ui/paths.h"
#include "ui/review_dock.h"
#include "ui/second_view.h"
#include "ui/theme.h"

namespace hepatica {

void MainWindow::build_lessons() {
    LessonDock::Ways ways;
    ways.patient = [this] { return patient_ ? patient_->patient : nullptr; };
    ways.open_built_in = [this] { open(OpenRequest{true, {}}); };
    ways.open_case = [this](const QString& folder) { open(folder); };
    ways.use = [this](std::unique_ptr<Simulation> simulation) {
        review_->end();
        use(std::move(simulation));
    };
    ways.failed = [this](const std::string& doing, const std::exception_ptr& error) {
        fail(doing, failure_of(error));
    };
    ways.report = [this](const std::filesystem::path& recording, const std::string& lesson) {
        write_report(recording, lesson);
    };
    ways.look_back = [this](const std::filesystem::path& recording, const std::string& lesson) {
        review_->open(recording, lesson);
    };
    ways.save_attempts = [this](const std::string& csv) { save_table("attempts", csv); };
    lessons_ = new LessonDock(std::move(ways), to_path(settings_.recordings_folder()), this);
    addDockWidget(Qt::LeftDockWidgetArea, lessons_);
    auto* menu = new QMenu("&Lesson", menuBar());
    lessons_->fill(*menu);
    menuBar()->insertMenu(menuBar()->actions().back(), menu);  // before Help
}

void MainWindow::build_review() {
    ReviewDock::Ways ways;
    ways.patient = [this] { return patient_ ? patient_->patient : nullptr; };
    ways.open = [this](const OpenRequest& request) { open(request); };
    ways.use = [this](std::unique_ptr<Simulation> simulation) { use(std::move(simulation)); };
    ways.lesson_runs = [this] {
        return lessons_->playing() && lessons_->standing().outcome == LessonOutcome::running;
    };
    ways.ask_for_other = [this] { return ask_for_recording(); };
    ways.beside = [this](const std::shared_ptr<const Frame>& frame, const QString& caption) {
        // Nothing is asked of the patient then: he may be on his way out.
        if (frame == nullptr) return second_view_->clear();
        second_view_->show_frame(frame, patient_->anatomy.vertex_systems(),
                                 theme_named(settings_.theme()).view, caption);
    };
    ways.save_film = [this](double end_s, const std::function<void(double)>& go_to) {
        ask_and_save_film(end_s, go_to);
    };
    ways.failed = [this](const Failure& failure) { fail("Look back on a recording", failure); };
    ways.say = [this](const QString& text) { statusBar()->showMessage(text, 6000); };
    review_ = new ReviewDock(std::move(ways), this);
    addDockWidget(Qt::BottomDockWidgetArea, review_);
    tabifyDockWidget(curves_, review_);
    review_->hide();
}

}  // namespace hepatica
