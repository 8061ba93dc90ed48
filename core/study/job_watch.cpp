// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/job_watch.h"

#include <sys/resource.h>

#include <algorithm>
#include <ctime>

namespace hepatica {

namespace {

double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

WatchedTime now() {
    return {seconds_of(CLOCK_MONOTONIC), seconds_of(CLOCK_PROCESS_CPUTIME_ID)};
}

WatchedTime since(const WatchedTime& start, const WatchedTime& end) {
    return {end.wall_s - start.wall_s, end.cpu_s - start.cpu_s};
}

void lengthen(WatchedTime& longest, const WatchedTime& time) {
    longest.wall_s = std::max(longest.wall_s, time.wall_s);
    longest.cpu_s = std::max(longest.cpu_s, time.cpu_s);
}

}  // namespace

JobWatch::JobWatch(Job& job) : job_(job) {
    job_.observe([this](JobEvent event) { record(event); });
}

JobWatch::~JobWatch() {
    job_.observe({});
}

void JobWatch::record(JobEvent event) {
    const JobProgress progress = job_.progress();
    const std::scoped_lock lock(mutex_);
    const WatchedTime time = now();
    if (progress.stage_number > stage_number_) {
        if (!stages_.empty())
            lengthen(stages_.back().longest_progress, since(last_progress_, time));
        stage_number_ = progress.stage_number;
        stages_.emplace_back().name = progress.stage;
        stage_start_ = last_check_ = last_progress_ = time;
    }
    if (stages_.empty()) return;
    WatchedStage& stage = stages_.back();
    stage.whole = since(stage_start_, time);
    lengthen(stage.longest_check, since(last_check_, time));
    last_check_ = time;
    ++stage.checks;
    if (event != JobEvent::progress) return;
    lengthen(stage.longest_progress, since(last_progress_, time));
    last_progress_ = time;
    ++stage.reports;
}

std::vector<WatchedStage> JobWatch::stages() const {
    const std::scoped_lock lock(mutex_);
    std::vector<WatchedStage> stages = stages_;
    if (stages.empty()) return stages;
    const WatchedTime end = now();
    WatchedStage& last = stages.back();
    last.whole = since(stage_start_, end);
    lengthen(last.longest_check, since(last_check_, end));
    lengthen(last.longest_progress, since(last_progress_, end));
    return stages;
}

std::size_t peak_memory_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace hepatica
