// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job_queue.h"

#include <algorithm>
#include <utility>

namespace hepatica {

void JobQueue::add(QueuedJob job) {
    Lane& lane = lane_of(job.kind);
    lane.waiting.push_back(std::move(job));
    run_next(lane);
}

void JobQueue::replace(QueuedJob job, Turn turn) {
    const JobKind kind = job.kind;
    Lane& lane = lane_of(kind);
    const auto old = std::ranges::find(lane.waiting, kind, &QueuedJob::kind);
    if (old != lane.waiting.end()) {
        *old = std::move(job);
    } else if (drop_running(kind)) {
        if (shows(lane)) watcher_.started(job.title);
        lane.waiting.push_front(std::move(job));
    } else if (turn == Turn::next) {
        lane.waiting.push_front(std::move(job));
    } else {
        lane.waiting.push_back(std::move(job));
    }
    run_next(lane);
}

void JobQueue::drop(JobKind kind) {
    drop_running(kind);
    std::erase_if(lane_of(kind).waiting, [kind](const QueuedJob& job) { return job.kind == kind; });
    watcher_.changed();
}

bool JobQueue::drop_running(JobKind kind) {
    Lane& lane = lane_of(kind);
    if (!lane.running || lane.current.kind != kind) return false;
    *lane.dropped = true;
    lane.running->cancel();
    return true;
}

void JobQueue::cancel_running() {
    Lane& lane = patients_.running ? patients_ : reports_;
    if (!lane.running) return;
    if (!*lane.dropped) return lane.running->cancel();
    // The dropped job is ending anyway; the user means the one that takes its place.
    if (lane.waiting.empty() || lane.waiting.front().kind != lane.current.kind) return;
    const QueuedJob meant = std::move(lane.waiting.front());
    lane.waiting.pop_front();
    meant.cancelled();
    watcher_.changed();
}

void JobQueue::clear() {
    for (Lane* lane : {&patients_, &reports_}) lane->waiting.clear();
    for (Lane* lane : {&patients_, &reports_}) lane->running.reset();
    watcher_.changed();
}

std::vector<std::string> JobQueue::waiting_titles() const {
    std::vector<std::string> titles;
    for (const Lane* lane : {&patients_, &reports_})
        for (const QueuedJob& job : lane->waiting) titles.push_back(job.title);
    return titles;
}

std::string JobQueue::title_beside() const {
    return patients_.running && reports_.running ? reports_.current.title : std::string();
}

bool JobQueue::holds(JobKind kind) const {
    const Lane& lane = lane_of(kind);
    return (lane.running && lane.current.kind == kind && !*lane.dropped) ||
           std::ranges::find(lane.waiting, kind, &QueuedJob::kind) != lane.waiting.end();
}

void JobQueue::run_next(Lane& lane) {
    if (lane.running || lane.waiting.empty()) return watcher_.changed();
    lane.current = std::move(lane.waiting.front());
    lane.waiting.pop_front();
    lane.dropped = std::make_shared<bool>(false);
    if (shows(lane)) watcher_.started(lane.current.title);
    // A job that is dropped after its work was done has no effect either.
    BackgroundJob::Work work = [run = lane.current.begin(), dropped = lane.dropped](Job& job) {
        return [finish = run(job), dropped] {
            if (!*dropped) finish();
        };
    };
    lane.running = std::make_unique<BackgroundJob>(std::move(work), callbacks_of(lane));
    watcher_.changed();
}

BackgroundJob::Callbacks JobQueue::callbacks_of(Lane& lane) {
    BackgroundJob::Callbacks callbacks;
    callbacks.progress = [this, &lane](const JobProgress& now) {
        if (shows(lane) && !*lane.dropped) watcher_.progress(now);
    };
    callbacks.failed = [&lane](const Failure& failure) {
        if (!*lane.dropped) lane.current.failed(failure);
    };
    callbacks.cancelled = [&lane] {
        if (!*lane.dropped) lane.current.cancelled();
    };
    callbacks.ended = [this, &lane] {
        lane.running.reset();
        // The report that went on beside it is shown again.
        if (&lane == &patients_ && lane.waiting.empty() && reports_.running)
            watcher_.started(reports_.current.title);
        run_next(lane);
    };
    return callbacks;
}

}  // namespace hepatica
