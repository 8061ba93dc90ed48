// SPDX-License-Identifier: GPL-3.0-or-later
// How long a user who wants to stop a job, or to see it move, may have to wait: the longest time
// between two of the worker's looks at its job, stage by stage.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "core/base/job.h"

namespace hepatica {

// Wall time is what a user waits, and grows when other programs are busy. Processor time, of all
// threads of this program together, does not; where one thread works, it is what an idle machine
// would take.
struct WatchedTime {
    double wall_s = 0.0;
    double cpu_s = 0.0;
};

struct WatchedStage {
    std::string name;
    WatchedTime whole;
    WatchedTime longest_check;     // between two moments at which a cancel would have been heard
    WatchedTime longest_progress;  // between two reports of progress
    std::size_t checks = 0;
    std::size_t reports = 0;
};

// Watches a job from its making on; the job must outlive it and run nothing before.
class JobWatch {
  public:
    explicit JobWatch(Job& job);
    ~JobWatch();
    JobWatch(const JobWatch&) = delete;
    JobWatch& operator=(const JobWatch&) = delete;

    // The stages so far; the last one reaches until now. Any thread.
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

// The most memory that this process has held so far, in bytes.
std::size_t peak_memory_bytes();

}  // namespace hepatica
