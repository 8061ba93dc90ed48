// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window that opens and saves: dialogs, dropped files, and closing.
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDateTime>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QProgressBar>
#include <QProgressDialog>
#include <QStatusBar>
#include <QTimer>
#include <algorithm>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/lesson/attempts.h"
#include "ui/branch_dock.h"
#include "ui/core_words.h"
#include "ui/curves_dock.h"
#include "ui/date_words.h"
#include "ui/dial_keeper.h"
#include "ui/lesson_dock.h"
#include "ui/lesson_editor/lesson_editor.h"
#include "ui/library_dialog.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"
#include "ui/on_screen.h"
#include "ui/open_case_dialog.h"
#include "ui/paths.h"
#include "ui/plain_text.h"
#include "ui/plot_panel.h"
#include "ui/progress_strip.h"
#include "ui/questions.h"
#include "ui/recording_dialog.h"
#include "ui/recording_guard.h"
#include "ui/review_dock.h"
#include "ui/save_case_dialog.h"
#include "ui/save_file_dialog.h"
#include "ui/second_view.h"
#include "ui/slices/view_layout.h"
#include "ui/time_of_play.h"
#include "ui/video_export.h"
#include "ui/vtk_widget.h"
#include "ui/words.h"

namespace hepatica {
namespace {

QString film_of_pictures() {
    return Words::tr(
        "A film in one file needs the program ffmpeg, which is not installed (apt "
        "install ffmpeg): it is saved as a folder of pictures.");
}

// Both pictures side by side.
QImage beside(const QImage& first, const QImage& second) {
    QImage both(first.width() + second.width(), std::max(first.height(), second.height()),
                QImage::Format_RGB32);
    both.fill(Qt::black);
    QPainter painter(&both);
    painter.drawImage(first.rect(), first, first.rect());
    painter.drawImage(QRect(QPoint(first.width(), 0), second.size()), second, second.rect());
    return both;
}

}  // namespace

void MainWindow::open(const QString& path) {
    if (path.endsWith(".hrec", Qt::CaseInsensitive)) return review_->open(to_path(path));
    OpenRequest request;
    request.reconstruct.ct = to_path(path);
    open(request);
}

void MainWindow::open(const OpenRequest& request) {
    messages_->dismiss();
    before_lesson_.reset();
    keeper_->open(request);
}

void MainWindow::save_case(const QString& folder) {
    keeper_->save_as(case_folder(folder));
}

void MainWindow::cancel_job() {
    if (!busy()) return;
    progress_->say_cancelling();
    keeper_->cancel();
}

void MainWindow::show_jobs() {
    tell_dial_keeper();
    if (busy()) {
        QStringList waiting;
        for (const std::string& title : keeper_->jobs().waiting_titles())
            waiting << QString::fromStdString(title);
        progress_->show_others(waiting, QString::fromStdString(keeper_->jobs().title_beside()));
    } else {
        progress_->finish();
    }
    // It waited for a patient.
    if (!report_to_offer_.empty() && !keeper_->jobs().holds(JobKind::open))
        offer_report(std::exchange(report_to_offer_, {}));
    look_back_when_opened();
}

// Once his vessels are as they were left, so that no other ones are opened for the recording.
void MainWindow::look_back_when_opened() {
    if (play_to_look_back_on_.empty() || keeper_->jobs().holds(JobKind::open) ||
        keeper_->makes_vessels())
        return;
    // The job that called this still exists.
    QTimer::singleShot(
        0, this, [this, play = std::exchange(play_to_look_back_on_, {})] { review_->open(play); });
}

void MainWindow::remember(const std::filesystem::path& path) {
    settings_.add_recent_file(to_text(path));
    if (!is_case(path)) return;  // what is made of a CT is not proposed beside it
    settings_.set_last_folder(to_text(path.parent_path()));
    settings_.set_case_folder(to_text(path.parent_path()));
}

void MainWindow::fail(const QString& doing, const Failure& failure) {
    messages_->show_failure(failure);
    log_->add_failure(doing, failure);
}

std::optional<std::filesystem::path> MainWindow::which_case() {
    OpenCaseDialog dialog(
        settings_.last_folder(),
        [&dialog](const QString& why) { QMessageBox::warning(&dialog, "Hepatica", as_plain(why)); },
        this);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return dialog.chosen();
}

void MainWindow::ask_for_case() {
    if (const auto place = which_case()) open(to_text(*place));
}

// Of a file about the patient, such as "NAME picture.png".
QString MainWindow::proposed_file(const QString& called) const {
    return settings_.last_folder() + "/" + keeper_->case_name() + " " + called;
}

void MainWindow::ask_where_to_save_picture() {
    const QString file = ask_where_to_save_file(*this, Words::tr("Save picture"),
                                                proposed_file("picture.png"), "PNG (*.png)");
    if (!file.isEmpty()) attempt(Words::tr("Save picture"), [&] { save_picture(file); });
}

// Asks for the CT only if the settings do not know its place.
void MainWindow::ask_where_to_archive() {
    namespace fs = std::filesystem;
    if (!ask_export_with_name(*this)) return;
    // A copy: dialogs follow.
    const std::string digest = workspace().patient()->source.image_sha256;
    fs::path ct = to_path(settings_.place_of_image(digest));
    std::error_code ignored;
    if (!fs::is_directory(ct, ignored)) {  // a volume file is no DICOM folder
        const auto place = ask_where_ct_lies(*this, settings_);
        if (!place) return;
        ct = *place;
    }
    if (!fs::is_directory(ct, ignored)) ct = ct.parent_path();
    const QString file =
        ask_where_to_save_file(*this, Words::tr("Save the vessels as a DICOM segmentation"),
                               settings_.last_folder() + "/" + keeper_->case_name() + ".dcm",
                               Words::tr("DICOM segmentations (*.dcm)"));
    if (file.isEmpty()) return;
    keeper_->archive(ct, to_path(file),
                     [this, digest, ct] { settings_.remember_image(digest, to_text(ct)); });
}

void MainWindow::save_plots(bool picture) {
    const QString file = ask_where_to_save_file(
        *this, Words::tr("Save curves"), proposed_file(picture ? "curves.png" : "curves.csv"),
        picture ? "PNG (*.png)" : Words::tr("Tables (*.csv)"));
    if (file.isEmpty()) return;
    attempt(Words::tr("Save curves"), [&] {
        require_folder_of(file);
        PlotPanel& plots = curves_->plots();
        picture ? plots.save_picture(file) : plots.save_table(file);
        statusBar()->showMessage(Words::tr("Saved %1").arg(file), 6000);
    });
}

void MainWindow::save_table(QWidget& asks, const QString& proposed, const std::string& csv) {
    const QString doing = Words::tr("Save the table");
    const QString file = ask_where_to_save_file(asks, doing, proposed, Words::tr("Tables (*.csv)"));
    if (file.isEmpty()) return;
    try {
        require_folder_of(file);
        write_text_atomically(to_path(file), csv);
        statusBar()->showMessage(Words::tr("Saved %1").arg(file), 6000);
    } catch (...) {
        const Failure failure = failure_of(std::current_exception());
        if (&asks == this) return fail(doing, failure);
        log_->add_failure(doing, failure);
        tell_failure(asks, doing, failure);  // the message bar lies behind it
    }
}

void MainWindow::offer_unsaved_work() {
    const auto left = recovery_->left_behind();
    const auto interrupted = interrupted_recordings(to_path(settings_.recordings_folder()));
    for (const std::filesystem::path& recording : interrupted)
        attempt(Words::tr("Keep the result"), [&] { keep_interrupted(recording); });
    QStringList texts;
    if (!left.empty())
        texts << Words::tr(
                     "The program ended without saving %1 (%2)%3. The work is not lost: it "
                     "stays under File > Open unsaved work until it is saved or let go.")
                     .arg(translated(Recovery::unsaved_work(left.front()).title),
                          date_words(QFileInfo(to_text(left.front())).lastModified()),
                          left.size() > 1 ? Words::tr(", and %n more", nullptr,
                                                      static_cast<int>(left.size() - 1))
                                          : QString());
    if (!interrupted.empty())
        texts << Words::tr(
                     "The last lesson or recorded play was interrupted (%1). Its recording "
                     "goes up to that moment. A lesson that was interrupted counts as no attempt.")
                     .arg(words_on_time_of_play(interrupted.front()));
    if (texts.isEmpty()) return;
    if (!left.empty())
        messages_->show_notice(texts.join("\n"), Words::tr("Open it"),
                               [this] { open_unsaved_work(); });
    // The vessels that were played on may be those of the unsaved work.
    const auto look_back = [this, interrupted, unsaved = !left.empty()] {
        std::ranges::for_each(interrupted, forget_interruption);
        if (!unsaved) return review_->open(interrupted.front());
        play_to_look_back_on_ = interrupted.front();
        open_unsaved_work();
        look_back_when_opened();
    };
    const QString looks_back = Words::tr("Look back on the play");
    if (interrupted.empty()) return;
    if (!left.empty()) return messages_->offer_also(looks_back, look_back);
    messages_->show_notice(texts.join("\n"), looks_back, look_back);
    // Of the one that is named; earlier ones stay in the list of recordings.
    messages_->offer_also(Words::tr("Forget it"), [interrupted] {
        forget_attempt(interrupted.front());
        std::ranges::for_each(interrupted, forget_interruption);
    });
}

// Who opens a case after a crash may not think of File > Open unsaved work.
void MainWindow::tell_unsaved_work_of_case() {
    const std::filesystem::path& folder = workspace().folder();
    if (folder.empty() || !workspace().kept_copy().empty()) return;
    for (const std::filesystem::path& left : recovery_->left_behind()) {
        const UnsavedWork work = Recovery::unsaved_work(left);
        if (Recovery::case_of(left) != folder && work.request.reconstruct.ct != folder) continue;
        const QString text =
            Words::tr(
                "The program ended without saving %1 (%2). What is shown is this case "
                "without that work.")
                .arg(translated(work.title), date_words(QFileInfo(to_text(left)).lastModified()));
        const auto act = [this, request = work.request] { open(request); };
        if (messages_->text().isEmpty())
            return messages_->show_notice(text, Words::tr("Open it"), act);
        const bool warns = messages_->text() == warnings_text_;
        messages_->put_before(text);
        messages_->offer_also(Words::tr("Open it"), act);
        if (warns) warnings_text_ = messages_->text();
        return;
    }
}

void MainWindow::open_unsaved_work() {
    try {
        const auto left = recovery_->left_behind();
        if (left.empty())
            return messages_->show_notice(Words::tr("No earlier run left unsaved work."));
        open(Recovery::unsaved_work(left.front()).request);
    } catch (...) {
        fail(Words::tr("Open the unsaved work"), failure_of(std::current_exception()));
    }
}

// Another program may end, and this one take over its work, at any time.
void MainWindow::connect_unsaved_work() {
    const auto look = [this] {
        bool none = false;
        try {
            none = recovery_->left_behind().empty();
        } catch (const std::exception&) {
            // A folder that cannot be read: choosing the entry says what is wrong.
        }
        actions_->show_lack(ActionId::open_unsaved,
                            none ? Words::tr("No earlier run left unsaved work.") : QString());
    };
    actions_->on(ActionId::open_unsaved, [this] { open_unsaved_work(); });
    actions_->before_menu_of(ActionId::open_unsaved, look);
    look();
}

void MainWindow::ask_for_ct(bool folder) {
    const QString path = settings_.choose(Settings::Kind::ct, [&](const QString& start) {
        return folder ? QFileDialog::getExistingDirectory(this, Words::tr("Open CT folder (DICOM)"),
                                                          start)
                      : QFileDialog::getOpenFileName(this, Words::tr("Open CT file"), start,
                                                     openable_filter());
    });
    if (!path.isEmpty()) open(path);
}

std::optional<std::filesystem::path> MainWindow::ask_for_recording(
    const std::filesystem::path& shown) {
    RecordingDialog dialog(to_path(settings_.recordings_folder()), this, shown);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return dialog.chosen();
}

void MainWindow::save_picture(const QString& file) {
    require_folder_of(file);
    const QImage shown = view_layout_->picture(view_->picture());
    const QImage picture =
        second_view_->shown() ? beside(shown, second_view_->view().picture()) : shown;
    write_file_atomically(to_path(file), [&](const std::filesystem::path& temporary) {
        if (!picture.save(to_text(temporary), "PNG")) {
            throw InputError(Words::id("the picture cannot be written"), file.toStdString(),
                             Words::id("choose a folder you may write to, on a disk with room"));
        }
    });
    settings_.set_last_folder(QFileInfo(file).absolutePath());
    statusBar()->showMessage(Words::tr("Saved %1").arg(file), 6000);
}

void MainWindow::tell_other_user() {
    const std::optional<QString> computer = case_lock_.follow(workspace().folder());
    if (!computer) return;
    const QString title = translated(workspace().title());
    const QString text =
        Words::tr(
            "%1 is open in another program, too (on the computer %2). Who saves last is "
            "asked before the other's work is replaced.")
            .arg(title, *computer);
    log_->add_warning(title, text);
    if (messages_->text().isEmpty()) return messages_->show_notice(text);
    const bool warnings_stand = messages_->text() == warnings_text_;
    messages_->put_before(text);
    if (warnings_stand) warnings_text_ = messages_->text();
}

// Work that is not saved in the case of this folder.
bool MainWindow::shows_more_than(const std::filesystem::path& folder) const {
    return workspace().has_patient() && workspace().home() == folder && workspace().unsaved();
}

void MainWindow::copy_case(const std::filesystem::path& place,
                           const std::function<void(bool lacks_work)>& copy) {
    if (!shows_more_than(place)) return copy(false);
    const CopyAnswer answer = copy_of_unsaved_(workspace().title());
    if (answer == CopyAnswer::as_saved) return copy(true);
    // Strokes at vessels are in no case, and recovered work may be saved elsewhere.
    if (answer == CopyAnswer::save)
        keeper_->save(
            [this, place, copy] { copy(workspace().unsaved() || workspace().folder() != place); });
}

void MainWindow::ask_and_save_film(double end_s, const std::function<void(double)>& go_to) {
    const QString start = settings_.last_folder();
    const bool as_pictures = ffmpeg_program().isEmpty();
    if (as_pictures) messages_->show_notice(film_of_pictures());
    const QString place =
        as_pictures ? ask_where_to_save_folder(
                          *this, Words::tr("Save a film as a folder of pictures"), start + "/film")
                    : ask_where_to_save_file(*this, Words::tr("Save a film"), start + "/play.mp4",
                                             Words::tr("Films (*.mp4)"));
    if (place.isEmpty()) return say_no_film();
    attempt(Words::tr("Save a film"), [&] {
        require_folder_of(place);
        save_film(to_path(place), end_s, go_to);
    });
}

void MainWindow::save_film(const std::filesystem::path& place, double end_s,
                           const std::function<void(double)>& go_to) {
    QProgressDialog progress(Words::tr("Saving the film…"), Words::tr("Cancel"), 0, 1000, this);
    progress.setWindowModality(Qt::WindowModal);
    progress.setMinimumDuration(0);
    progress.findChild<QProgressBar*>()->setTextVisible(false);
    Film film;
    film.end_s = end_s;
    film.picture = [&](double at_s) {
        if (!review_->complete())
            throw InputError(Words::id("the review ended before the film did"), place.string(),
                             Words::id("Open the recording again"));
        go_to(at_s);
        patient_->simulation->update_frame();
        show_marks();
        view_->show_frame(frame());
        const QImage first = view_->picture();
        return second_view_->shown() ? beside(first, second_view_->view().picture()) : first;
    };
    try {
        write_film(film, place, ffmpeg_program(), [&](double share) {
            progress.setValue(static_cast<int>(1000.0 * share));
            QCoreApplication::processEvents();
            return !progress.wasCanceled();
        });
    } catch (const Cancelled&) {
        return say_no_film();
    }
    settings_.set_last_folder(to_text(place.parent_path()));
    const QString saved = Words::tr("The film was saved: %1").arg(to_text(place));
    messages_->text() == film_of_pictures() ? messages_->put_before(saved)
                                            : messages_->show_notice(saved);
}

void MainWindow::say_no_film() {
    if (messages_->text() == film_of_pictures()) messages_->dismiss();
    statusBar()->showMessage(Words::tr("No film was saved"), 6000);
}

void MainWindow::attempt(const QString& doing, const std::function<void()>& task) {
    try {
        task();
    } catch (...) {
        fail(doing, failure_of(std::current_exception()));
    }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    for (const QUrl& url : event->mimeData()->urls()) {
        if (!url.isLocalFile()) continue;
        event->acceptProposedAction();
        return open(url.toLocalFile());
    }
    messages_->show_failure({Words::id("only files and folders of this computer can be opened"), "",
                             Words::id("save it to a folder and drop that")});
}

// The simulation is paused while the user is asked.
bool MainWindow::may_end_lesson() {
    const Lesson* lesson = lessons_->running();
    if (lesson == nullptr) return true;  // judged since it was looked
    const bool runs = !frame().statistics.paused;
    if (runs) patient_->simulation->post(SetPaused{true});
    const bool may = end_lesson_(lesson->name);
    if (runs && !may) patient_->simulation->post(SetPaused{false});
    return may;
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const auto stay = [this] { begins_anew_ = false; };
    if (!may_close_ && lessons_->begun() && !may_end_lesson()) {
        stay();
        return event->ignore();
    }
    if (lesson_editor_ && !may_close_ && !lesson_editor_->may_end()) {
        stay();
        return event->ignore();
    }
    in_close_event_ = true;
    if (!may_close_) {
        const bool ended = lessons_->begun();
        keeper_->leave(
            [this, ended, stay] {
                // One that was begun while a report was waited for is asked about as well.
                if (!ended && lessons_->begun() && !may_end_lesson()) return stay();
                may_close_ = true;
                if (!in_close_event_) close();
            },
            stay);
    }
    in_close_event_ = false;
    if (!may_close_) return event->ignore();
    case_lock_.follow({});
    if (begins_anew_) begin_anew_(patient_from_where());
    lessons_->give_up();
    end_recording();
    review_->end();
    settings_.set_window(saveGeometry(), saveState(), unframed_place(*this));
    keeper_->end();
    recovery_->end();
    view_layout_->clear();
    branches_->clear();
    curves_->clear();
    kept_play_.drop();
    patient_.reset();
    QMainWindow::closeEvent(event);
}

}  // namespace hepatica
