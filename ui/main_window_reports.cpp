// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window for reports of plays: asked for here, written in the background, offered
// by a button.

#include <QCoreApplication>
#include <QDesktopServices>
#include <QFileInfo>
#include <QLocale>
#include <QStatusBar>
#include <QUrl>
#include <utility>

#include "core/lesson/lesson_file.h"
#include "ui/core_words.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/report_writing.h"
#include "ui/save_file_dialog.h"
#include "ui/time_of_play.h"
#include "ui/words.h"

namespace hepatica {

void MainWindow::write_report(const std::filesystem::path& recording, const std::string& lesson) {
    attempt(Words::tr("Write the report"), [&] {
        const QString called = translated(find_lesson(lesson).name);
        const QString folder = ask_where_to_save_folder(
            *this, Words::tr("Folder for the report"),
            settings_.last_folder() + "/" + report_name(called, time_of_play(recording)));
        if (folder.isEmpty()) return;
        settings_.set_last_folder(QFileInfo(folder).isDir() ? folder
                                                            : QFileInfo(folder).absolutePath());
        write_report_into(to_path(folder), recording, lesson);
    });
}

void MainWindow::write_report_into(const std::filesystem::path& chosen,
                                   const std::filesystem::path& recording,
                                   const std::string& lesson) {
    ReportOrder order{recording,
                      QString::fromStdString(lesson),
                      patient_->patient,
                      {},
                      flow_units_named(settings_.flow_units())};
    const bool built_in = patient_->title == built_in_title;
    if (patient_->patient->source.name.empty() && (built_in || !workspace().folder().empty()))
        order.patient_name = QFileInfo(QString::fromStdString(patient_->title)).completeBaseName();
    const QString called = translated(find_lesson(lesson).name);
    QueuedJob queued;
    queued.kind = JobKind::report;
    // Told apart from another report that waits: of another lesson, or of another play of it.
    const QDateTime played = time_of_play(recording);
    const bool is_there = std::filesystem::exists(chosen);
    const QString title = Words::tr("Writing the report on %1 (%2)")
                              .arg(called, played.isValid() ? QLocale().toString(played, "HH:mm:ss")
                                                            : words_on_time_of_play(recording));
    queued.title = title.toStdString();
    queued.begin = [this, order, chosen, is_there, called, played]() -> BackgroundJob::Work {
        const QString program =
            report_program_.isEmpty() ? QCoreApplication::applicationFilePath() : report_program_;
        // Now that the reports before it are there, and have their folders.
        const auto place =
            is_there ? report_folder(chosen, called, played) : numbered_folder(chosen);
        return [this, program, order, place](Job& job) -> std::function<void()> {
            order_report(program, order, place, job);
            return [this, place] { offer_report(place); };
        };
    };
    queued.failed = [this](const Failure& failure) {
        fail(Words::tr("Write the report"), failure);
    };
    queued.cancelled = [this, title] {
        statusBar()->showMessage(Words::tr("Cancelled: %1").arg(title), 6000);
    };
    keeper_->add_report(std::move(queued));
}

void MainWindow::offer_report(const std::filesystem::path& folder) {
    if (keeper_->jobs().holds(JobKind::open)) {
        report_to_offer_ = folder;  // show_jobs() offers it
        report_waited_ = true;
        return;
    }
    const auto show = [folder] {
        QDesktopServices::openUrl(QUrl::fromLocalFile(to_text(folder / "report.html")));
    };
    const QString text = Words::tr("The report is in %1").arg(to_text(folder));
    // Neither the warnings of a patient nor the failure of an opening give way to it.
    if (std::exchange(report_waited_, false) && !messages_->text().isEmpty()) {
        const bool warnings_stand = messages_->text() == warnings_text_;
        if (warnings_stand) messages_->put_before(text);
        messages_->offer_also(Words::tr("Open the report"), show);
        if (warnings_stand) warnings_text_ = messages_->text();
        return;
    }
    messages_->show_notice(text, Words::tr("Open"), show);
    report_message_ = messages_->text();
}

void MainWindow::dismiss_offered_report() {
    const QString message = std::exchange(report_message_, {});
    if (!message.isEmpty() && messages_->text() == message) messages_->dismiss();
}

}  // namespace hepatica
