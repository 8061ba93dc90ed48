// SPDX-License-Identifier: GPL-3.0-or-later
// What is not saved yet, kept on disk all the same among the user's data, and removed when all is
// saved or let go: each correction and each stroke at the vessels at once, in a journal, and half a
// second after a reconstruction or a correction's body a copy of the whole case. What a program has
// left that ended without that, by a crash or a power cut, is offered at the next start.
#pragma once

#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/opening/open_patient.h"
#include "core/patient/patient_case.h"
#include "ui/background_job.h"
#include "ui/edit_journal.h"
#include "ui/workspace.h"

class QLockFile;

namespace hepatica {

// Work that a program left, as it is opened again.
struct UnsavedWork {
    std::string title;
    OpenRequest request;
};

// UI thread; needs Qt's event loop and nothing else of the toolkit. Each program has a folder of
// its own with a lock, by which others see that it still runs.
class Recovery {
  public:
    using Write = std::function<void(const std::filesystem::path& place, const PatientCase&)>;
    // `folder`: of all programs of this user. Without a way to write nothing is kept.
    Recovery(std::filesystem::path folder, Write write, std::function<void(const Failure&)> failed);
    ~Recovery();

    // To be called whenever the workspace has changed.
    void follow(const Workspace& workspace);
    // All is saved or let go. Waits for a copy that is being written, and removes it.
    void end();

    // What programs left that do not run any more, the newest first: a case, or the journal of
    // edits where that is newer.
    std::vector<std::filesystem::path> left_behind() const;
    // One of these.
    static UnsavedWork unsaved_work(const std::filesystem::path& left);

    // Nothing is being written or waits for it.
    bool resting() const { return !job_ && !wanted_.patient; }

  private:
    // A case, and where its voxels and the copy that it was opened from lie.
    struct Copy {
        std::shared_ptr<const PatientCase> patient;
        Workspace::Edits edits;
        std::vector<KeptMeasurement> measured;
        std::string title;
        std::filesystem::path voxels, opened_from;
        std::uint64_t version = 0, origin = 0;  // of the workspace
    };

    // The corrections and strokes that are wanted, of which patient.
    struct Wanted {
        Journalled noted;         // its base as far as it can be said without the copy
        bool needs_copy = false;  // they can be made again on a copy alone
        std::uint64_t origin = 0;
    };

    static Wanted wanted_of(const Workspace& workspace);
    void note(const Wanted& wanted);
    void forget_copies();
    void forget_journal();
    void write();
    void written(const Copy& copy, const std::filesystem::path& place);
    void make_own_folder();
    void remove_own_copies();

    std::filesystem::path folder_;
    Write write_;
    std::function<void(const Failure&)> failed_;
    std::filesystem::path own_;  // empty until something was to be kept
    std::unique_ptr<QLockFile> lock_;
    Copy wanted_;                     // waits for its turn; without a patient: none
    std::uint64_t kept_version_ = 0;  // of the workspace; 0: none
    std::uint64_t copy_origin_ = 0;   // of the whole copy; 0: there is none
    std::unique_ptr<EditJournal> journal_;
    std::optional<Wanted> newest_;  // that was to be noted
    bool told_of_journal_ = false;  // that it cannot be written
    bool needless_ = false;         // what is being written is not wanted any more
    QTimer delay_;
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
