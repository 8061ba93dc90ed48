// SPDX-License-Identifier: GPL-3.0-or-later
// Patients, a disk and answers that a test holds in its hand: corrections and files without any
// geometry, each made only when the test lets it be made.
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ui/patient_keeper.h"

namespace hepatica::testing {

// Qt's event loop, without a display; made once.
void need_event_loop();

// A correction that can be told from others by its number; a negative one cannot be made, and one
// from 100 on not on vessels that were made anew.
TreeEdit edit(int number);
std::vector<int> numbers_of(const std::vector<TreeEdit>& edits);

// The keeper with a world around it. What runs on the worker is guarded.
class FakeWard {
  public:
    FakeWard();

    PatientKeeper& keeper() { return *keeper_; }
    const Workspace& workspace() const { return keeper_->workspace(); }
    // Handles events until no job runs; false where that takes too long.
    bool finish();

    // A path named "ct..." is a CT, "ct of two..." one of two series, every other one a case on the
    // disk.
    void open(const std::string& name);
    void open_built_in();
    // True once `go` was called.
    void leave() {
        keeper_->leave([this] { left = true; });
    }
    std::vector<int> on_disk(const std::string& name) const;
    std::vector<TreeEdit> edits_on_disk(const std::string& name) const;
    bool disk_holds(const std::string& name) const;
    std::string digest(const std::string& name) const;  // empty: not on the disk
    // As another program would.
    void save_by_another(const std::string& name, const std::vector<TreeEdit>& edits);
    void remove_by_another(const std::string& name);
    static std::filesystem::path path_of(const std::string& name);

    // Jobs of this kind wait while it is set, but hear a cancel.
    std::atomic<bool> hold_corrections{false};
    std::atomic<bool> hold_offers{false};
    std::atomic<bool> hold_remakings{false};
    std::atomic<bool> hold_saves{false};
    std::atomic<bool> hold_openings{false};
    std::atomic<bool> hold_archiving{false};
    std::atomic<bool> disk_full{false};
    std::atomic<int> corrections_begun{0};
    std::atomic<int> slowness_us{0};     // of every job
    std::vector<TreeEdit> offered;       // what takes all that is offered
    std::vector<TreeEdit> offers_asked;  // the corrections that they were asked for after

    // What a person answers, and was asked and shown.
    UnsavedAnswer answer = UnsavedAnswer::cancel;
    StrokesAnswer strokes_answer = StrokesAnswer::cancel;
    ChangedAnswer changed_answer = ChangedAnswer::cancel;
    std::vector<std::string> changed_asked;  // of which cases
    std::vector<std::size_t> strokes_asked;  // how many waited, each time
    // Whoever shows the voxels, asked to make vessels of them.
    std::function<void()> remake_painted = [] {};
    std::optional<std::string> place;
    std::optional<int> series;
    bool left = false;
    std::vector<std::string> archived;  // "CT to FILE with corrections"
    std::vector<std::string> written;   // cases
    int questions = 0;
    int places_asked = 0;
    std::filesystem::path proposed;  // for a case, when it was asked last
    int series_asked = 0;
    std::vector<std::string> titles;  // of jobs that were begun
    std::vector<std::string> failures;
    std::vector<std::string> said;
    std::vector<std::string> shown;  // titles of patients, one each time; "+" for a corrected one
    // For tests that want to look closer.
    std::function<void(const std::string&)> on_question;
    std::function<void(bool corrected)> before_show;
    std::function<void()> on_word;  // something was said, or a failure told

  private:
    PatientKeeper::Ways ways();
    void hold(const std::atomic<bool>& held, Job& job) const;
    LoadedPatient load(const OpenRequest& request, Job& job);
    std::string digest_at(const std::filesystem::path& place) const;

    mutable std::mutex mutex_;
    std::map<std::filesystem::path, PatientCase> disk_;
    std::unique_ptr<PatientKeeper> keeper_;
};

}  // namespace hepatica::testing
