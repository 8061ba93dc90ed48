// SPDX-License-Identifier: GPL-3.0-or-later
// Opens, corrects and saves the patient, and never leaves one behind with unsaved corrections
// without asking: not for another patient, not for the end of the program, and not while a
// correction is still being made.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "core/patient/corrections.h"
#include "core/reconstruction/remade_case.h"
#include "ui/back_ends.h"
#include "ui/job_queue.h"
#include "ui/patient_loader.h"
#include "ui/recovery.h"
#include "ui/workspace.h"

namespace hepatica {

enum class UnsavedAnswer { save, discard, cancel };
enum class StrokesAnswer { rebuild, drop, cancel };

// UI thread; needs Qt's event loop and nothing else of the toolkit.
class PatientKeeper {
  public:
    // How patients come and go, all on the worker thread and one at a time: load_patient() and
    // write_case() in the program, whatever a test needs in a test.
    struct Ways {
        std::function<LoadedPatient(const OpenRequest&, Job&)> load;
        std::function<void(const std::filesystem::path& folder, const PatientCase&)> save;
        // Of one that was corrected.
        std::function<LoadedPatient(std::shared_ptr<const PatientCase>, Job&)> play_on = play;
        std::function<PatientCase(const PatientCase&, const std::vector<TreeEdit>&, Job&)> correct =
            with_edits;
        // From other voxels of his vessels.
        std::function<RemadeCase(const PatientCase&, Mask, const Volume&, Job&)> remake = remade;
        // Throws InputError where the last of these corrections cannot be made on the others.
        std::function<void(const PatientCase&, const std::vector<TreeEdit>&)> check =
            with_edited_tree;
        // Those that the person is asked about before one is read; none: there is no choice.
        std::function<std::vector<SeriesDescription>(const OpenRequest&, Job&)> list_series =
            series_to_choose_from;
        // Whether it can be opened at all, before anybody is asked to leave for it.
        std::function<void(const OpenRequest&, Job&)> look = look_at;
        // A DICOM segmentation of the CT in a folder, for the archive; the program sets it.
        std::function<void(const PatientCase&, const std::filesystem::path& ct,
                           const std::filesystem::path& file, Job&)>
            archive{};
        // Copies of what is not saved, see Recovery; none: there are none.
        Recovery::Write keep{};
        // What makes the steps of all that is played; load and play_on are to use it, too.
        std::shared_ptr<BackEnds> back_ends = std::make_shared<BackEnds>();
    };
    // Answered by a person, at once; a test answers them itself.
    struct Questions {
        std::function<UnsavedAnswer(const std::string& title)> unsaved;
        // So many strokes at his vessels wait for a remaking: no case can hold them.
        std::function<StrokesAnswer(const std::string& title, std::size_t strokes)> strokes;
        // The number of one of these series, from 1, which is the best; none: not after all.
        std::function<std::optional<int>(const std::vector<SeriesDescription>&)> which_series;
        // The folder of the case; none: not after all. `proposed`: where it lies, or else only
        // what it may be called.
        std::function<std::optional<std::filesystem::path>(const std::filesystem::path& proposed)>
            where_to_save;
        // A lesson of this name is being played: whether the window may close all the same.
        std::function<bool(const std::string& lesson)> end_lesson = [](const std::string&) {
            return true;
        };
    };
    struct Screen {
        // To be seen from now on; `corrected`: it is the patient before, with other corrections.
        std::function<void(LoadedPatient, bool corrected)> show;
        // Of the workspace: what is wanted, what is saved.
        std::function<void()> changed;
        // `doing`: the job that failed.
        std::function<void(const std::string& doing, const Failure&)> failed;
        std::function<void(const std::string&)> say;
        // An opening came to nothing: it failed, or the person gave it up. Not told of one whose
        // place a newer one takes.
        std::function<void()> not_opened = [] {};
        // The CT that is being reconstructed, once it is read: until show() or not_opened().
        std::function<void(std::shared_ptr<const Volume>)> image_read =
            [](const std::shared_ptr<const Volume>&) {};
        // A file that was opened or saved, and can be opened again.
        std::function<void(const std::filesystem::path&)> remember;
        // Shall call remake() with the voxels as the strokes that wait have left them; may refuse.
        std::function<void()> remake_painted = [] {};
    };

    PatientKeeper(Ways ways, Questions questions, Screen screen, JobQueue::Watcher watcher);

    const Workspace& workspace() const { return workspace_; }
    const JobQueue& jobs() const { return jobs_; }
    // Other vessels of the patient are computed.
    bool makes_vessels() const {
        return jobs_.holds(JobKind::correct) || jobs_.holds(JobKind::remake);
    }

    // Each returns at once. An opening that is under way is given up for a newer one.
    void open(const OpenRequest& request);
    void add(const TreeEdit& edit);
    // A stroke at the vessels' voxels, which waits for a remaking of them all.
    void add_stroke(const BrushStroke& stroke);
    // All that was measured on him, to be kept with the case.
    void measure(std::vector<KeptMeasurement> measured);
    // Of whatever was done last: a correction, a remaking or a stroke.
    void undo();
    void redo();
    // The last correction back, where it is a stroke at a tumour.
    void undo_tumour_stroke();
    // So many of the last strokes at vessels back, whatever was corrected since.
    void take_strokes_back(std::size_t strokes);
    // The vessels anew from these voxels of theirs, which lie in the frame of the patient's CT; an
    // undo takes it back. What was asked before and is not begun is given up.
    void remake(std::shared_ptr<const Volume> ct, Mask vessels);
    // Where the patient lies already, or where the person says; ask_and_save() asks always. False:
    // not after all.
    bool save();
    bool ask_and_save();
    void save_as(const std::filesystem::path& folder);
    // Writes him as a DICOM segmentation of the CT in this folder; `written` once that is done.
    void archive(const std::filesystem::path& ct, const std::filesystem::path& file,
                 std::function<void()> written);
    // Work that leaves the patient as he is, behind all other.
    void add_job(QueuedJob job) { jobs_.add(std::move(job)); }
    // Cancels the job that runs; a correction is then taken back.
    void cancel();

    // Does `go` once nothing is lost by it: at once, or when all is made and saved. Not at all
    // where the person chose to stay (then `stay`), or where saving or correcting failed; only the
    // newest `go` counts.
    void leave(
        std::function<void()> go, std::function<void()> stay = [] {});
    // Cancels all jobs and waits for the one that runs; a case that is being written is finished.
    void end() { jobs_.clear(); }

  private:
    void leave_if_safe(std::function<void()> go, std::function<void()> stay);
    void go_when_archived(std::function<void()> go, std::function<void()> stay);
    void look_first(const OpenRequest& request, std::function<void()> go);
    // With what it is called, and what is said where it comes to nothing.
    QueuedJob opening_job(const OpenRequest& request);
    void start_opening(const OpenRequest& request);
    // Brings the CT to the screen's thread, while this opening is the newest.
    OpenRequest request_that_tells(OpenRequest request);
    void choose_series(OpenRequest request, const std::vector<SeriesDescription>& series);
    void arrived(const OpenRequest& request, const std::shared_ptr<LoadedPatient>& loaded);
    void correct();
    struct Possible {
        Workspace::Edits edits;
        std::vector<Failure> refused;
    };
    Possible possible_edits(const PatientCase& patient, const Workspace::Edits& wanted) const;
    BackgroundJob::Work correction();
    BackgroundJob::Work remaking(std::shared_ptr<const Volume> ct,
                                 std::shared_ptr<const Mask> vessels, std::size_t strokes);
    // What is to become of strokes that wait; true: nothing that keeps one here.
    std::filesystem::path proposed_folder() const;
    bool strokes_let_go(const std::function<void()>& stay);
    void wait_to_go(std::function<void()> go, std::function<void()> stay);
    void take_back_remaking();
    bool waits_for_remaking() const;
    void add_writing(QueuedJob job);
    BackgroundJob::Work writing(const std::filesystem::path& folder);
    void stay_with_shown_body();
    void go_on();

    Ways ways_;
    Questions questions_;
    Screen screen_;
    Workspace workspace_;
    std::function<void()> go_, stay_;                 // wait for saving to end
    std::optional<std::uint64_t> discarded_version_;  // of the workspace: the person let it go
    std::optional<std::uint64_t> dropped_strokes_;    // likewise, strokes_version()
    std::uint64_t told_of_rebuilding_ = 0;            // the workspace's origin: that it stays
    std::set<std::filesystem::path> written_;         // cases, since the last opening began to read
    std::shared_ptr<int> opening_;                    // another one with each opening
    JobQueue jobs_;
};

}  // namespace hepatica
