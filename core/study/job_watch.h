// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how long a user who wants to cancel a job, or to see its progress, may have to wait: the
// longest time between two checks of the job by its worker, stage by stage.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "core/base/job.h"

namespace hepatica {

// Wall time is what a user waits, and grows when other programs are busy. Processor time, of all
// threads of this program, does not; where one thread works, it is the time on an idle machine.
struct WatchedTime {
    double wall_s = 0.0;
    double cpu_s = 0.0;
};

struct WatchedStage {
    std::string name;
    WatchedTime whole;
    WatchedTime longest_check;     // between two moments at which a cancel would be noticed
    WatchedTime longest_progress;  // between two reports of progress
    std::size_t checks = 0;
    std::size_t reports = 0;
};

// Watches a job from now on; the job must outlive it and must not have run before.
class JobWatch {
  public:
    explicit JobWatch(Job& job);
    ~JobWatch();
    JobWatch(const JobWatch&) = delete;
    JobWatch& operator=(const JobWatch&) = delete;

    // The stages so far; the last one lasts until now. Callable from any thread.
    std::vector<WatchedStage> stages() const;

  private:
    void record(JobEvent event);

    Job& job_;
    mutable std::mutex mutex_;
    std::vector<WatchedStage> stages_;
    int stage_number_ = 0;
    WatchedTime stage_start_;
    WatchedTime last_check_;
    WatchedTime last_progress_;
};

// Peak resident memory of this process in bytes.
std::size_t peak_memory_bytes();

}  // namespace hepatica
