// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job_queue.h"

#include <algorithm>
#include <utility>

namespace hepatica {

void JobQueue::add(QueuedJob job) {
    waiting_.push_back(std::move(job));
    run_next();
}

void JobQueue::replace(QueuedJob job) {
    const JobKind kind = job.kind;
    const auto old = std::ranges::find(waiting_, kind, &QueuedJob::kind);
    if (old != waiting_.end()) {
        *old = std::move(job);
    } else if (drop_running(kind)) {
        watcher_.started(job.title);
        waiting_.push_front(std::move(job));
    } else {
        waiting_.push_back(std::move(job));
    }
    run_next();
}

void JobQueue::drop(JobKind kind) {
    drop_running(kind);
    std::erase_if(waiting_, [kind](const QueuedJob& job) { return job.kind == kind; });
    watcher_.changed();
}

bool JobQueue::drop_running(JobKind kind) {
    if (!running_ || current_.kind != kind) return false;
    *dropped_ = true;
    running_->cancel();
    return true;
}

void JobQueue::cancel_running() {
    if (!running_) return;
    if (!*dropped_) return running_->cancel();
    // The dropped job is ending anyway; the user means the one that takes its place.
    if (waiting_.empty() || waiting_.front().kind != current_.kind) return;
    const QueuedJob meant = std::move(waiting_.front());
    waiting_.pop_front();
    meant.cancelled();
    watcher_.changed();
}

void JobQueue::clear() {
    waiting_.clear();
    running_.reset();
    watcher_.changed();
}

std::vector<std::string> JobQueue::waiting_titles() const {
    std::vector<std::string> titles;
    for (const QueuedJob& job : waiting_) titles.push_back(job.title);
    return titles;
}

bool JobQueue::holds(JobKind kind) const {
    return (running_ && current_.kind == kind && !*dropped_) ||
           std::ranges::find(waiting_, kind, &QueuedJob::kind) != waiting_.end();
}

void JobQueue::run_next() {
    if (running_ || waiting_.empty()) return watcher_.changed();
    current_ = std::move(waiting_.front());
    waiting_.pop_front();
    dropped_ = std::make_shared<bool>(false);
    watcher_.started(current_.title);
    // A job that is dropped after its work was done has no effect either.
    BackgroundJob::Work work = [run = current_.begin(), dropped = dropped_](Job& job) {
        return [finish = run(job), dropped] {
            if (!*dropped) finish();
        };
    };
    BackgroundJob::Callbacks callbacks;
    callbacks.progress = [this](const JobProgress& now) {
        if (!*dropped_) watcher_.progress(now);
    };
    callbacks.failed = [this](const Failure& failure) {
        if (!*dropped_) current_.failed(failure);
    };
    callbacks.cancelled = [this] {
        if (!*dropped_) current_.cancelled();
    };
    callbacks.ended = [this] {
        running_.reset();
        run_next();
    };
    running_ = std::make_unique<BackgroundJob>(std::move(work), std::move(callbacks));
    watcher_.changed();
}

}  // namespace hepatica
