// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps unsaved work in the user's data folder until it is saved or discarded: each correction,
// stroke and measurement at once in a journal, and half a second after a reconstruction or
// correction a copy of the whole case. What a program left after a crash or power cut is offered at
// the next start. A copy never replaces the case that it was made of by itself: it is opened as
// unsaved work of that case, and saving it writes there.
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

// Unsaved work of an earlier run, and how to open it.
struct UnsavedWork {
    std::string title;
    OpenRequest request;
};

// UI thread only; needs Qt's event loop and no other part of Qt. Each program has a folder of its
// own with a lock, which tells others that it runs.
class Recovery {
  public:
    using Write = std::function<void(const std::filesystem::path& place, const PatientCase&)>;
    // `folder` is common to all programs of the user. Without `write` nothing is kept.
    Recovery(std::filesystem::path folder, Write write, std::function<void(const Failure&)> failed);
    ~Recovery();

    // To be called whenever the workspace has changed.
    void follow(const Workspace& workspace);
    // Everything is saved or discarded: waits for a copy being written and removes all.
    void end();

    // What ended programs left, the newest first: a case, or a journal if that is newer. What a
    // newer journal holds whole is left out, and goes with that.
    std::vector<std::filesystem::path> left_behind() const;
    // Describes one of these.
    static UnsavedWork unsaved_work(const std::filesystem::path& left);

    // The case on disk whose unsaved work such a copy holds; empty: none, or it is gone.
    static std::filesystem::path case_of(const std::filesystem::path& left);
    // Its digest_of_case() as it was then; empty: not known.
    static std::string digest_of(const std::filesystem::path& left);

    // Nothing is being written or waiting to be.
    bool resting() const { return !job_ && !wanted_.patient; }

  private:
    // A case to copy, the folder of its voxels, and the copy that it was opened from.
    struct Copy {
        std::shared_ptr<const PatientCase> patient;
        Workspace::Edits edits;
        std::vector<KeptMeasurement> measured;
        std::string title;
        std::filesystem::path voxels, opened_from;
        std::uint64_t version = 0, origin = 0;  // of the workspace
    };

    // The present corrections, strokes and measurements, and whose they are.
    struct Wanted {
        Journalled noted;         // its base as far as known without the copy
        bool needs_copy = false;  // they need a copy as their base
        std::uint64_t origin = 0;
    };

    static Wanted wanted_of(const Workspace& workspace);
    void note(const Wanted& wanted);
    // The journal in this folder cannot be written, and so not hold this.
    void tell_of_journal(const std::filesystem::path& folder, const Journalled& lost);
    void forget_copies();
    void forget_journal();
    void write();
    void written(const Copy& copy, const std::filesystem::path& place);
    void make_own_folder();
    void remove_own_copies();

    std::filesystem::path folder_;
    Write write_;
    std::function<void(const Failure&)> failed_;
    std::filesystem::path own_;  // empty until something is to be kept
    std::unique_ptr<QLockFile> lock_;
    Copy wanted_;                     // the next copy to write; without a patient: none
    std::uint64_t kept_version_ = 0;  // of the workspace; 0: none
    std::uint64_t copy_origin_ = 0;   // of the complete copy; 0: none
    std::unique_ptr<EditJournal> journal_;
    std::optional<Wanted> newest_;  // the last one to be noted
    bool told_of_journal_ = false;
    bool needless_ = false;  // the copy being written is no longer needed
    QTimer delay_;
    QTimer noted_;  // fires when the journal should have written the last change
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
