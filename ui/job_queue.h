// SPDX-License-Identifier: GPL-3.0-or-later
// The window's long work in order: one job runs, the others wait, and none of them cancels one of
// another kind. A correction that is being made and a case that is being written never get in each
// other's way.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "ui/background_job.h"

namespace hepatica {

enum class JobKind { open, correct, remake, save, archive, report };

struct QueuedJob {
    JobKind kind = JobKind::open;
    std::string title;
    // UI thread, when its turn has come: the work sees the patient as he is then.
    std::function<BackgroundJob::Work()> begin;
    // UI thread, once at most: it failed, or was cancelled by the person who waits for it. A job
    // that is dropped ends without a word.
    std::function<void(const Failure&)> failed;
    std::function<void()> cancelled;
};

// UI thread; needs Qt's event loop and nothing else of the toolkit.
class JobQueue {
  public:
    struct Watcher {
        std::function<void(const std::string& title)> started;
        std::function<void(const JobProgress&)> progress;
        // Whenever a job came or went; also after `started`.
        std::function<void()> changed;
    };
    explicit JobQueue(Watcher watcher) : watcher_(std::move(watcher)) {}

    // Behind all others.
    void add(QueuedJob job);
    // In the place of the one of its kind that runs or waits, which is dropped; else as add().
    void replace(QueuedJob job);
    // What runs or waits of this kind ends without any effect.
    void drop(JobKind kind);
    // The one that runs, or that takes its place; the others stay.
    void cancel_running();

    // Cancels the one that runs, waits for its worker, and forgets the others, without a word.
    void clear();

    bool busy() const { return running_ != nullptr; }
    int waiting() const { return static_cast<int>(waiting_.size()); }
    // One of this kind runs or waits, and was not dropped.
    bool holds(JobKind kind) const;

  private:
    void run_next();
    bool drop_running(JobKind kind);

    Watcher watcher_;
    std::deque<QueuedJob> waiting_;
    QueuedJob current_;
    std::shared_ptr<bool> dropped_;  // of the one that runs
    std::unique_ptr<BackgroundJob> running_;
};

}  // namespace hepatica
