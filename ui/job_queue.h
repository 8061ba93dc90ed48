// SPDX-License-Identifier: GPL-3.0-or-later
// Queue of the window's long jobs: one runs, the others wait, and no job cancels one of another
// kind. Thus a correction and the saving of a case never disturb each other.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ui/background_job.h"

namespace hepatica {

enum class JobKind { open, correct, remake, save, archive, report };

struct QueuedJob {
    JobKind kind = JobKind::open;
    std::string title;
    // UI thread, when the job's turn has come, so that it works on the patient as he is then.
    std::function<BackgroundJob::Work()> begin;
    // UI thread, at most one of them, once: the job failed, or the user cancelled it. A dropped job
    // calls neither.
    std::function<void(const Failure&)> failed;
    std::function<void()> cancelled;
};

// UI thread only; needs Qt's event loop and no other part of Qt.
class JobQueue {
  public:
    struct Watcher {
        std::function<void(const std::string& title)> started;
        std::function<void(const JobProgress&)> progress;
        // Called whenever a job begins or ends; also after `started`.
        std::function<void()> changed;
    };
    explicit JobQueue(Watcher watcher) : watcher_(std::move(watcher)) {}

    // Appends a job.
    void add(QueuedJob job);
    // Replaces the running or waiting job of the same kind, which is dropped; without one as add().
    void replace(QueuedJob job);
    // The running and waiting jobs of this kind end without effect.
    void drop(JobKind kind);
    // Cancels the running job, or the one that is to take its place; the others stay.
    void cancel_running();

    // Cancels the running job, waits for its worker and discards the others, without callbacks.
    void clear();

    bool busy() const { return running_ != nullptr; }
    int waiting() const { return static_cast<int>(waiting_.size()); }
    std::vector<std::string> waiting_titles() const;  // in their order
    // Whether a job of this kind runs or waits and was not dropped.
    bool holds(JobKind kind) const;

  private:
    void run_next();
    bool drop_running(JobKind kind);

    Watcher watcher_;
    std::deque<QueuedJob> waiting_;
    QueuedJob current_;
    std::shared_ptr<bool> dropped_;  // whether the running job was dropped
    std::unique_ptr<BackgroundJob> running_;
};

}  // namespace hepatica
