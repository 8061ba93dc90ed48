// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/patient_keeper.h"

#include <QCoreApplication>
#include <QDate>
#include <QMetaObject>
#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/error.h"
#include "core/opening/patient_image.h"
#include "ui/core_words.h"
#include "ui/file_name.h"
#include "ui/paths.h"
#include "ui/standing_warnings.h"
#include "ui/words.h"

namespace hepatica {

PatientKeeper::PatientKeeper(Ways ways, Questions questions, Screen screen,
                             JobQueue::Watcher watcher)
    : ways_(std::move(ways)),
      questions_(std::move(questions)),
      screen_(std::move(screen)),
      jobs_({std::move(watcher.started), std::move(watcher.progress),
             [this, changed = std::move(watcher.changed)] {
                 changed();
                 go_on();
             }}) {}

void PatientKeeper::open(const OpenRequest& request) {
    const OpenRequest wanted = with_absolute_paths(request);
    ended_play_.reset();
    const auto go = [this, wanted] {
        if (!play_let_go()) return screen_.not_opened();
        leave_patient([this, wanted] { start_opening(wanted); }, screen_.not_opened);
    };
    const bool asks =
        workspace_.dirty() || !workspace_.strokes().empty() || screen_.kept_play().has_value();
    asks ? look_first(wanted, go) : go();
}

// Nobody is asked about unsaved work for the sake of a file that cannot be opened.
void PatientKeeper::look_first(const OpenRequest& request, std::function<void()> go) {
    QueuedJob job = opening_job(request);
    job.begin = [this, request, go = std::move(go)]() -> BackgroundJob::Work {
        return [this, request, go](Job& progress) -> std::function<void()> {
            ways_.look(request, progress);
            return go;
        };
    };
    jobs_.replace(std::move(job));
}

QueuedJob PatientKeeper::opening_job(const OpenRequest& request, const std::string& name) {
    opens_built_in_ = request.built_in && !request.unsaved_copy && !request.left_edits;
    QueuedJob job;
    job.kind = JobKind::open;
    job.title =
        (request.built_in ? Words::tr("Opening the built-in patient")
                          : Words::tr("Opening %1")
                                .arg(name.empty() ? to_text(request.reconstruct.ct.filename())
                                                  : QString::fromStdString(name)))
            .toStdString();
    job.failed = [this, title = job.title](const Failure& failure) {
        opening_.reset();
        screen_.failed(title, failure);
        screen_.not_opened();
    };
    job.cancelled = [this] {
        opening_.reset();
        screen_.say(Words::tr("Cancelled").toStdString());
        screen_.not_opened();
    };
    return job;
}

void PatientKeeper::start_opening(const OpenRequest& request, const std::string& name) {
    QueuedJob job = opening_job(request, name);
    job.begin = [this, request]() -> BackgroundJob::Work {
        written_.clear();
        return
            [this, request = request_that_tells(request)](Job& progress) -> std::function<void()> {
                const auto series = ways_.list_series(request, progress);
                if (!series.empty())
                    return [this, request, series] { choose_series(request, series); };
                // Before it is read: a change in between shows when it is saved.
                const std::string digest =
                    request.built_in ? std::string() : ways_.digest(request.reconstruct.ct);
                // std::function must be copyable; a LoadedPatient is not.
                auto loaded = std::make_shared<LoadedPatient>(ways_.load(request, progress));
                if (!request.built_in) loaded->asked_for = request.reconstruct.ct;
                return [this, request, loaded, digest] {
                    if (!request.built_in && !request.unsaved_copy && !request.left_edits)
                        screen_.remember(request.reconstruct.ct);
                    arrived(request, loaded, digest);
                };
            };
    };
    jobs_.replace(std::move(job));
}

OpenRequest PatientKeeper::request_that_tells(OpenRequest request) {
    opening_ = std::make_shared<int>();
    request.image_read =
        [this, newest = std::weak_ptr(opening_)](const std::shared_ptr<const Volume>& ct) {
            QMetaObject::invokeMethod(
                QCoreApplication::instance(),
                [this, newest, ct] {
                    if (!newest.expired()) screen_.image_read(ct);
                },
                Qt::QueuedConnection);
        };
    return request;
}

void PatientKeeper::choose_series(OpenRequest request,
                                  const std::vector<SeriesDescription>& series) {
    const std::optional<int> chosen = questions_.which_series(series);
    if (!chosen) {
        screen_.say(Words::tr("Cancelled").toStdString());
        return screen_.not_opened();
    }
    request.reconstruct.series = *chosen;
    start_opening(request, title_of_series(request.reconstruct.ct, series, *chosen));
}

// The former patient may have been corrected or played on while this one was prepared.
void PatientKeeper::arrived(const OpenRequest& request,
                            const std::shared_ptr<LoadedPatient>& loaded,
                            const std::string& digest) {
    opening_.reset();
    const auto show = [this, request, loaded, digest] {
        // The case was saved again after it was read, so what was read is outdated.
        if (written_.contains(loaded->folder)) return start_opening(request);
        if (!play_let_go()) return screen_.not_opened();
        jobs_.drop(JobKind::offers);
        jobs_.drop(JobKind::correct);
        jobs_.drop(JobKind::remake);
        workspace_.open(*loaded, request.reconstruct.series);
        if (!loaded->folder.empty()) workspace_.set_digest(digest);
        workspace_.set_recovered(Recovery::case_of(loaded->kept_copy));
        if (request.unsaved_copy) workspace_.set_digest(Recovery::digest_of(loaded->kept_copy));
        // Before the edits there is nothing of him worth keeping, so they come first.
        if (request.left_edits) {
            workspace_.take_up(*request.left_edits);
            workspace_.set_digest(request.left_edits->digest);
        }
        screen_.show(std::move(*loaded), false);
        correct();
    };
    ends_ = false;
    leave_if_safe(show, screen_.not_opened);
}

// A rebuild replaces the patient, so undo and redo must wait.
bool PatientKeeper::waits_for_remaking() const {
    if (!jobs_.holds(JobKind::remake)) return false;
    screen_.say(
        Words::tr("The vessels are being rebuilt: undo and redo wait for that").toStdString());
    return true;
}

void PatientKeeper::undo() {
    const std::optional<Workspace::Step> step = workspace_.next_undo();
    if (!step || waits_for_remaking()) return;
    if (step->stroke) return take_strokes_back(1);
    if (step->edits.empty()) return take_back_remaking();
    if (workspace_.undo_passes_rebuilding() &&
        std::exchange(told_of_rebuilding_, workspace_.origin()) != workspace_.origin())
        return screen_.say(
            Words::tr("The rebuilding stays: a case does not keep the vessels from before it. Undo "
                      "once more takes back the correction that was made before.")
                .toStdString());
    workspace_.undo() ? correct() : screen_.changed();
}

void PatientKeeper::add_stroke(const BrushStroke& stroke) {
    if (!workspace_.has_patient()) return;
    workspace_.add_stroke(stroke);
    screen_.changed();
}

void PatientKeeper::measure(std::vector<KeptMeasurement> measured) {
    if (workspace_.has_patient() && workspace_.measure(std::move(measured))) screen_.changed();
}

// None is removed while they are being made into vessels; screen_.changed() then shows them again.
void PatientKeeper::take_strokes_back(std::size_t strokes) {
    if (!waits_for_remaking())
        for (std::size_t i = 0; i < strokes; ++i) workspace_.undo_stroke();
    screen_.changed();
}

void PatientKeeper::undo_tumour_stroke() {
    const Workspace::Edits& edits = workspace_.edits();
    const bool is_last = workspace_.before_remaking() == nullptr && !workspace_.undo_is_of_stroke();
    if (is_last && !edits.empty() && !changes_tree(edits.back().kind)) undo();
}

void PatientKeeper::redo() {
    const std::optional<Workspace::Step> step = workspace_.next_redo();
    if (!step || waits_for_remaking()) return;
    if (step->stroke) {
        workspace_.redo_stroke();
        return screen_.changed();
    }
    if (step->edits.empty()) return redo_remaking();
    workspace_.redo() ? correct() : screen_.changed();
}

void PatientKeeper::remake(std::shared_ptr<const Volume> ct, Mask vessels) {
    if (!workspace_.has_patient()) return;
    QueuedJob job;
    job.kind = JobKind::remake;
    job.title = Words::tr("Rebuilding the vessels").toStdString();
    job.begin = [this, ct = std::move(ct),
                 painted = std::make_shared<const Mask>(std::move(vessels)),
                 strokes = workspace_.strokes().size()] { return remaking(ct, painted, strokes); };
    job.failed = [this, title = job.title](const Failure& failure) {
        go_ = nullptr;
        screen_.failed(title, failure);
    };
    job.cancelled = [this] {
        go_ = nullptr;
        screen_.say(Words::tr("Not rebuilt: what was painted is still there").toStdString());
    };
    jobs_.replace(std::move(job));
}

BackgroundJob::Work PatientKeeper::remaking(std::shared_ptr<const Volume> ct,
                                            std::shared_ptr<const Mask> vessels,
                                            std::size_t strokes) {
    return [this, ct = std::move(ct), vessels = std::move(vessels), strokes,
            patient = workspace_.patient(), edits = workspace_.made_edits(),
            folder = workspace_.folder()](Job& job) -> std::function<void()> {
        constexpr int reading_and_preparing = 3;
        job.expect_stages(reading_and_preparing + remade_stages);
        job.begin_stage(Words::id("Reading the voxels"));
        const auto before =
            std::make_shared<const PatientCase>(whole_case(*patient, folder, edits, job));
        RemadeCase made = ways_.remake(*before, *vessels, *ct, job);
        note_rebuilding(*before, strokes, made.patient);
        auto loaded = std::make_shared<LoadedPatient>(
            ways_.play_on(std::make_shared<const PatientCase>(std::move(made.patient)), job));
        const auto warnings =
            said_of_remade(*loaded->patient, loaded->flow_shares, std::move(made.warnings));
        return [this, before, loaded, strokes, warnings] {
            workspace_.show_remade(before, loaded->patient, strokes, warnings);
            loaded->warnings = workspace_.warnings();
            screen_.show(std::move(*loaded), true);
            screen_.changed();
        };
    };
}

void PatientKeeper::take_back_remaking() {
    exchange_vessels(Words::tr("Taking the rebuilding back"), &Workspace::before_remaking,
                     &Workspace::take_back_remaking);
}

void PatientKeeper::redo_remaking() {
    exchange_vessels(Words::tr("Rebuilding the vessels"), &Workspace::remaking_again,
                     &Workspace::redo_remaking);
}

void PatientKeeper::exchange_vessels(const QString& title,
                                     std::shared_ptr<const PatientCase> (Workspace::*which)() const,
                                     void (Workspace::*take)()) {
    QueuedJob queued;
    queued.kind = JobKind::remake;
    queued.title = title.toStdString();
    queued.begin = [this, which, take]() -> BackgroundJob::Work {
        return
            [this, which, take, other = (workspace_.*which)()](Job& job) -> std::function<void()> {
                if (other == nullptr) return [] {};  // something else was done meanwhile
                auto loaded = std::make_shared<LoadedPatient>(ways_.play_on(other, job));
                return [this, which, take, other, loaded] {
                    if ((workspace_.*which)() != other) return;
                    (workspace_.*take)();
                    loaded->warnings = workspace_.warnings();
                    screen_.show(std::move(*loaded), true);
                    screen_.changed();
                };
            };
    };
    queued.failed = [this, title = queued.title](const Failure& failure) {
        screen_.failed(title, failure);
    };
    queued.cancelled = [this] { screen_.say(Words::tr("Cancelled").toStdString()); };
    jobs_.replace(std::move(queued));
}

bool PatientKeeper::save(std::function<void()> written) {
    if (!workspace_.has_patient()) return false;
    if (!workspace_.home().empty()) {
        save_as(workspace_.home(), std::move(written));
        return true;
    }
    return ask_and_save(std::move(written));
}

bool PatientKeeper::ask_and_save(const std::filesystem::path& proposed,
                                 std::function<void()> written) {
    if (!workspace_.has_patient()) return false;
    const std::optional<std::filesystem::path> folder = questions_.where_to_save(proposed);
    if (folder) save_as(*folder, std::move(written));
    return folder.has_value();
}

// "ct.nii.gz" and a copy of unsaved work "ct.hep" both give "ct". A folder of DICOM slices is often
// called as the patient, whom a case does not name.
QString PatientKeeper::case_name() const {
    std::error_code unreadable;
    if (workspace_.folder().empty() && is_directory(workspace_.image(), unreadable))
        return Words::tr("case of %1").arg(QDate::currentDate().toString(Qt::ISODate));
    QString name = translated(workspace_.title());
    for (const char* ending : {".gz", ".nii", ".mha", ".mhd", ".nrrd", ".nhdr", ".hep", ".hepz"})
        if (name.endsWith(ending)) name.chop(QString(ending).size());
    return as_file_name(name, "case");
}

// Without a folder: the CT may lie in an archive or on a disc.
std::filesystem::path PatientKeeper::proposed_folder() const {
    if (!workspace_.home().empty()) return workspace_.home();
    return to_path(case_name() + ".hep");
}

void PatientKeeper::save_as(const std::filesystem::path& folder, std::function<void()> written) {
    if (!workspace_.has_patient()) return;
    add_saving({std::filesystem::absolute(folder).lexically_normal(), std::move(written), {}});
}

// Runs after all other jobs; if it fails or is cancelled, a pending leave() is dropped.
void PatientKeeper::add_writing(QueuedJob job) {
    job.failed = [this, title = job.title](const Failure& failure) {
        go_ = nullptr;
        screen_.failed(title, failure);
    };
    job.cancelled = [this] {
        go_ = nullptr;
        screen_.say(Words::tr("Not saved").toStdString());
    };
    jobs_.add(std::move(job));
}

void PatientKeeper::archive(const std::filesystem::path& ct, const std::filesystem::path& file,
                            std::function<void()> written) {
    if (!workspace_.has_patient()) return;
    QueuedJob queued;
    queued.kind = JobKind::archive;
    queued.title = Words::tr("Writing %1").arg(to_text(file.filename())).toStdString();
    // Of the patient shown now, whoever is shown when its turn comes.
    queued.begin = [this, ct, file, written = std::move(written), patient = workspace_.patient(),
                    voxels = workspace_.folder(),
                    edits = workspace_.made_edits()]() -> BackgroundJob::Work {
        return
            [this, ct, file, written, patient, voxels, edits](Job& job) -> std::function<void()> {
                constexpr int comparing_and_writing = 2;
                job.expect_stages(1 + comparing_and_writing);
                job.begin_stage(Words::id("Reading the voxels"));
                ways_.archive(whole_case(*patient, voxels, edits, job), ct, file, job);
                return [this, file, written] {
                    written();
                    screen_.say(Words::tr("Saved %1").arg(to_text(file)).toStdString());
                };
            };
    };
    add_writing(std::move(queued));
}

}  // namespace hepatica
