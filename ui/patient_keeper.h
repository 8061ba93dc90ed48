// SPDX-License-Identifier: GPL-3.0-or-later
// Opens, corrects and saves the patient. Never replaces a patient with unsaved corrections, or ends
// the program, without asking, not even while a correction is still being made.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "core/patient/case_digest.h"
#include "core/patient/corrections.h"
#include "core/reconstruction/remade_case.h"
#include "ui/back_ends.h"
#include "ui/job_queue.h"
#include "ui/patient_loader.h"
#include "ui/recovery.h"
#include "ui/workspace.h"

namespace hepatica {

enum class UnsavedAnswer { save, discard, cancel };
// Of a case that another program has changed on the disk.
enum class ChangedAnswer { replace, save_as, cancel };
enum class StrokesAnswer { rebuild, drop, cancel };
// Of a case that is to be copied and holds unsaved work.
enum class CopyAnswer { save, as_saved, cancel };

// UI thread only; needs Qt's event loop and no other part of Qt.
class PatientKeeper {
  public:
    // The work on patients, all on the worker thread and one at a time; tests replace it.
    struct Ways {
        std::function<LoadedPatient(const OpenRequest&, Job&)> load;
        std::function<void(const std::filesystem::path& folder, const PatientCase&)> save;
        // Prepares the play on a corrected patient.
        std::function<LoadedPatient(std::shared_ptr<const PatientCase>, Job&)> play_on = play;
        std::function<PatientCase(const PatientCase&, const std::vector<TreeEdit>&, Job&)> correct =
            with_edits;
        // The corrections after these that build what is offered.
        std::function<std::vector<TreeEdit>(const PatientCase&, const std::vector<TreeEdit>&,
                                            double confidence, Job&)>
            offers = acceptances_after;
        // Rebuilds the vessels from another mask.
        std::function<RemadeCase(const PatientCase&, Mask, const Volume&, Job&)> remake = remade;
        // Throws InputError if the last of these corrections cannot be made after the others.
        std::function<void(const PatientCase&, const std::vector<TreeEdit>&)> check =
            with_edited_tree;
        // Series to ask the user about before reading; empty: there is no choice.
        std::function<std::vector<SeriesDescription>(const OpenRequest&, Job&)> list_series =
            series_to_choose_from;
        // Throws if it cannot be opened, before the user is asked about the former patient.
        std::function<void(const OpenRequest&, Job&)> look = look_at;
        // Writes a DICOM segmentation of the CT in a folder, for the archive; set by the program.
        std::function<void(const PatientCase&, const std::filesystem::path& ct,
                           const std::filesystem::path& file, Job&)>
            archive{};
        // Writes copies of unsaved work, see Recovery; empty: none.
        Recovery::Write keep{};
        // Back ends for everything played; load and play_on must use them too.
        std::shared_ptr<BackEnds> back_ends = std::make_shared<BackEnds>();
        // Tells whether a case on disk is still the one that was opened or saved.
        std::function<std::string(const std::filesystem::path& place)> digest = digest_of_case;
    };
    // Questions to the user, answered synchronously; tests answer them themselves.
    struct Questions {
        std::function<UnsavedAnswer(const std::string& title)> unsaved;
        // This many strokes at the vessels wait for a rebuild; a case cannot hold them.
        std::function<StrokesAnswer(const std::string& title, std::size_t strokes)> strokes;
        // Before a case is replaced that is not the one that was opened or last saved here.
        std::function<ChangedAnswer(const std::filesystem::path& place)> changed_on_disk =
            [](const std::filesystem::path&) { return ChangedAnswer::cancel; };
        // Before a copy of the case on disk, which lacks what is not saved.
        std::function<CopyAnswer(const std::string& title)> copy_of_unsaved =
            [](const std::string&) { return CopyAnswer::cancel; };
        // Number of the chosen series, from 1, which is the best; nullopt: cancelled.
        std::function<std::optional<int>(const std::vector<SeriesDescription>&)> which_series;
        // Folder of the case; nullopt: cancelled. `proposed`: its present folder, or just a name.
        std::function<std::optional<std::filesystem::path>(const std::filesystem::path& proposed)>
            where_to_save;
        // Whether a play that waits behind what is shown may end: it is lost with its patient.
        std::function<bool()> end_play = [] { return true; };
        // Whether the window may close although this lesson is being played.
        std::function<bool(const std::string& lesson)> end_lesson = [](const std::string&) {
            return true;
        };
    };
    struct Screen {
        // Shows this patient; `corrected`: the same one with other corrections.
        std::function<void(LoadedPatient, bool corrected)> show;
        // The workspace has changed: corrections or whether they are saved.
        std::function<void()> changed;
        // `doing`: the job that failed.
        std::function<void(const std::string& doing, const Failure&)> failed;
        std::function<void(const std::string&)> say;
        // An opening failed or was cancelled. Not called if a newer opening replaces it.
        std::function<void()> not_opened = [] {};
        // The CT being reconstructed, once it is read; shown until show() or not_opened().
        std::function<void(std::shared_ptr<const Volume>)> image_read =
            [](const std::shared_ptr<const Volume>&) {};
        // This file was opened or saved and can be opened again.
        std::function<void(const std::filesystem::path&)> remember;
        // A case was written there.
        std::function<void(const std::filesystem::path&)> case_written =
            [](const std::filesystem::path&) {};
        // Which play waits behind what is shown, and ends where another patient is; nullopt: none.
        std::function<std::optional<int>()> kept_play = [] { return std::optional<int>(); };
        // Should call remake() with the voxels and the pending strokes; may refuse.
        std::function<void()> remake_painted = [] {};
    };

    PatientKeeper(Ways ways, Questions questions, Screen screen, JobQueue::Watcher watcher);

    const Workspace& workspace() const { return workspace_; }
    const JobQueue& jobs() const { return jobs_; }
    // Whether other vessels of the patient are being computed.
    bool makes_vessels() const {
        return jobs_.holds(JobKind::offers) || jobs_.holds(JobKind::correct) ||
               jobs_.holds(JobKind::remake);
    }

    // Whether the built-in patient, without edits, is on his way.
    bool opens_built_in() const { return opens_built_in_ && jobs_.holds(JobKind::open); }

    // Each returns at once. A newer opening replaces one under way.
    void open(const OpenRequest& request);
    // Adds a correction; one of the tree is then computed.
    void add(const TreeEdit& edit) { add_all({edit}); }
    // Likewise, as one step of undo.
    void add_all(const std::vector<TreeEdit>& edits);
    // Adds, as one step, what builds all gaps and branches that are offered with this confidence
    // or more.
    void accept_offers(double confidence);
    // Adds a stroke at the vessel mask, which waits for a rebuild.
    void add_stroke(const BrushStroke& stroke);
    // All that was measured on the patient, to be kept with the case.
    void measure(std::vector<KeptMeasurement> measured);
    // Undoes the last step: a correction, a rebuild or a stroke.
    void undo();
    void redo();
    // Undoes the last correction if it is a stroke at a tumour.
    void undo_tumour_stroke();
    // Removes the last strokes at vessels, whatever was corrected since.
    void take_strokes_back(std::size_t strokes);
    // Rebuilds the vessels from these voxels, which lie in the frame of the patient's CT; can be
    // undone. Replaces an earlier request.
    void remake(std::shared_ptr<const Volume> ct, Mask vessels);
    // save() writes to the case that he belongs to (Workspace::home()), or asks for a place if
    // there is none; ask_and_save() always asks. False: cancelled. `written` is called once the
    // case is written, and not if that fails. Where another case lies there than was opened or
    // saved here, it asks first; one that is gone is made anew.
    bool save(std::function<void()> written = {});
    bool ask_and_save(std::function<void()> written = {}) {
        return ask_and_save(proposed_folder(), std::move(written));
    }
    // What files about the patient are called after: his title without an ending or a path.
    QString case_name() const;
    void save_as(const std::filesystem::path& folder, std::function<void()> written = {});
    // Writes a DICOM segmentation of the CT in this folder; calls `written` when done.
    void archive(const std::filesystem::path& ct, const std::filesystem::path& file,
                 std::function<void()> written);
    // Appends the writing of a report. If it fails while the program waits for it to end, the
    // program does not end.
    void add_report(QueuedJob job);
    // Cancels the running job; corrections that wait for it are then taken back and can be redone.
    // What was undone before them is not cancelled by that: the next cancel brings it back.
    void cancel() {
        opens_built_in_ = false;
        jobs_.cancel_running();
    }

    // For the end of the program: calls `go` once nothing can be lost: at once, or when everything
    // is made and saved and no report is being written any more. Calls `stay` if the user chooses
    // to stay or a report fails; drops `go` if saving or correcting fails. Only the newest `go`
    // counts.
    void leave(
        std::function<void()> go, std::function<void()> stay = [] {});
    // Cancels all jobs and waits for the running one; a case being written is finished.
    void end() { jobs_.clear(); }

  private:
    // As leave(), for another patient, who needs no report to be written before.
    void leave_patient(std::function<void()> go, std::function<void()> stay);
    void leave_if_safe(std::function<void()> go, std::function<void()> stay);
    void go_when_archived(std::function<void()> go, std::function<void()> stay);
    void go_when_reported(const std::function<void()>& go, const std::function<void()>& stay);
    void look_first(const OpenRequest& request, std::function<void()> go);
    // With its title and the reactions to failure and cancellation. `name`: of what is opened;
    // empty: that of its file.
    QueuedJob opening_job(const OpenRequest& request, const std::string& name = {});
    void start_opening(const OpenRequest& request, const std::string& name = {});
    // Adds a callback that shows the CT on the UI thread while this opening is the newest.
    OpenRequest request_that_tells(OpenRequest request);
    void choose_series(OpenRequest request, const std::vector<SeriesDescription>& series);
    void arrived(const OpenRequest& request, const std::shared_ptr<LoadedPatient>& loaded,
                 const std::string& digest);
    BackgroundJob::Work accepting(double confidence);
    void correct(JobQueue::Turn turn = JobQueue::Turn::last);
    struct Possible {
        Workspace::Edits edits;
        std::vector<Failure> refused;
    };
    Possible possible_edits(const PatientCase& patient, const Workspace::Edits& wanted,
                            const Job& job) const;
    BackgroundJob::Work correction();
    BackgroundJob::Work remaking(std::shared_ptr<const Volume> ct,
                                 std::shared_ptr<const Mask> vessels, std::size_t strokes);
    std::filesystem::path proposed_folder() const;
    // Asks what to do with pending strokes; true if they do not keep the user from leaving.
    bool strokes_let_go(const std::function<void()>& stay);
    // Likewise about the play that waits behind what is shown.
    bool play_let_go();
    void wait_to_go(std::function<void()> go, std::function<void()> stay);
    void take_back_remaking();
    void redo_remaking();
    // Exchanges the patient for `which`, if that is still the next step once his play is there.
    void exchange_vessels(const QString& title,
                          std::shared_ptr<const PatientCase> (Workspace::*which)() const,
                          void (Workspace::*take)());
    bool waits_for_remaking() const;
    void add_writing(QueuedJob job);
    // A case to write; `replaces`: the digest of the case there that may be replaced, or nullopt:
    // the one that was opened or last saved.
    struct Saving {
        std::filesystem::path folder;
        std::function<void()> written;
        std::optional<std::string> replaces;
    };
    void add_saving(const Saving& saving);
    BackgroundJob::Work writing(const Saving& saving);
    bool ask_and_save(const std::filesystem::path& proposed, std::function<void()> written);
    void ask_about_changed(Saving saving);
    // The body that is being made will not come; see Workspace::give_up_edits(). What still waits
    // then is computed.
    Workspace::GivenUp give_up_what_waits();
    void go_on();

    Ways ways_;
    Questions questions_;
    Screen screen_;
    Workspace workspace_;
    std::function<void()> go_, stay_;  // waiting for a save, a rebuild or a report to end
    bool ends_ = false;                // whether the newest `go` ends the program
    // Version of the workspace whose changes the user discarded.
    std::optional<std::uint64_t> discarded_version_;
    std::optional<std::uint64_t> dropped_strokes_;  // likewise, strokes_version()
    std::optional<int> ended_play_;                 // likewise, kept_play()
    // The workspace's origin of which was said that its rebuilding stays.
    std::uint64_t told_of_rebuilding_ = 0;
    std::set<std::filesystem::path> written_;  // cases written since the last opening began to read
    std::shared_ptr<int> opening_;             // a new one for each opening
    bool opens_built_in_ = false;              // of the newest, unless it was cancelled
    JobQueue jobs_;
};

}  // namespace hepatica
