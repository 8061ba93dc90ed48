// SPDX-License-Identifier: GPL-3.0-or-later
// Queue of the window's long jobs: one runs, the others wait, and no job cancels one of another
// kind. Thus a correction and the saving of a case never disturb each other. Reports have a queue
// of their own, which runs beside the other: a process that needs nothing of the patient shown
// writes them, so that opening a patient does not wait for one.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ui/background_job.h"

namespace hepatica {

enum class JobKind { open, offers, correct, remake, save, archive, report };

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
        // The shown job is another one now: that about the patient while one runs, else the report.
        std::function<void(const std::string& title)> started;
        std::function<void(const JobProgress&)> progress;  // of the shown job
        // Called whenever a job begins or ends; also after `started`.
        std::function<void()> changed;
    };
    explicit JobQueue(Watcher watcher) : watcher_(std::move(watcher)) {}

    // Appends a job.
    void add(QueuedJob job);
    enum class Turn { last, next };  // after or before all that wait
    // Replaces the running or waiting job of the same kind, which is dropped. Without one it takes
    // this turn.
    void replace(QueuedJob job, Turn turn = Turn::last);
    // The running and waiting jobs of this kind end without effect.
    void drop(JobKind kind);
    // Cancels the shown job, or the one that is to take its place; the others stay.
    void cancel_running();

    // Cancels the running jobs, waits for their workers and discards the others, without callbacks.
    void clear();

    bool busy() const { return patients_.running || reports_.running; }
    // Titles of what waits: jobs about the patient in their order, then reports.
    std::vector<std::string> waiting_titles() const;
    // Title of the report that is written beside the shown job; empty: none.
    std::string title_beside() const;
    // Whether a job of this kind runs or waits and was not dropped.
    bool holds(JobKind kind) const;

  private:
    struct Lane {
        std::deque<QueuedJob> waiting{};
        QueuedJob current{};
        std::shared_ptr<bool> dropped{};  // whether the running job was dropped
        std::unique_ptr<BackgroundJob> running{};
    };
    Lane& lane_of(JobKind kind) { return kind == JobKind::report ? reports_ : patients_; }
    const Lane& lane_of(JobKind kind) const {
        return kind == JobKind::report ? reports_ : patients_;
    }
    bool shows(const Lane& lane) const { return &lane == &patients_ || !patients_.running; }
    void run_next(Lane& lane);
    BackgroundJob::Callbacks callbacks_of(Lane& lane);
    bool drop_running(JobKind kind);

    Watcher watcher_;
    Lane patients_, reports_;
};

}  // namespace hepatica
