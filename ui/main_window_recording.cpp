// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window for recordings: whether that of a lesson can be written, and File > Record
// play: a free play is recorded from the first request to the second, or until another patient or
// play is shown.
#include <QStatusBar>

#include "core/base/room_on_disk.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/play_recorder.h"
#include "ui/review_dock.h"
#include "ui/status_line.h"
#include "ui/words.h"

namespace hepatica {

void MainWindow::connect_recording() {
    recorder_ = std::make_unique<PlayRecorder>();
    actions_->on(ActionId::record_play,
                 [this] { recorder_->recording() ? end_recording() : begin_recording(); });
}

bool MainWindow::may_record_lesson() {
    constexpr std::size_t bytes_of_beginning = 1 << 20;
    try {
        require_room(to_path(settings_.recordings_folder()), bytes_of_beginning);
        return true;
    } catch (...) {
        fail(Words::tr("Begin the lesson"), failure_of(std::current_exception()));
        return false;
    }
}

void MainWindow::begin_recording() {
    attempt(Words::tr("Record the play"), [this] {
        if (patient_)
            recorder_->begin(*patient_->simulation, to_path(settings_.recordings_folder()));
    });
    if (recorder_->recording()) remember_recorded_patient();
    show_recording();
}

void MainWindow::remember_recorded_patient() {
    const std::filesystem::path& folder = workspace().folder();
    if (patient_ && !folder.empty())
        settings_.remember_patient(hash_of(*patient_->patient), to_text(folder));
}

void MainWindow::end_recording() {
    if (!recorder_->recording()) return;
    attempt(Words::tr("Record the play"), [this] {
        const bool recorded = recorder_->end(patient_ ? patient_->simulation.get() : nullptr);
        if (!recorded)
            return messages_->show_notice(Words::tr("Nothing moved: nothing was recorded."));
        const std::filesystem::path file = recorder_->file();
        messages_->show_notice(Words::tr("The play was recorded: %1").arg(to_text(file)),
                               Words::tr("Look back on the play"),
                               [this, file] { review_->open(file); });
    });
    show_recording();
}

void MainWindow::show_recording() {
    (*actions_)[ActionId::record_play].setChecked(recorder_->recording());
    status_->show_recording(recorder_->recording());
}

}  // namespace hepatica
