// SPDX-License-Identifier: GPL-3.0-or-later
// A long piece of work as its caller sees it: named stages, progress, and a way to stop it.
// The worker holds a Job&, the other threads hold the same Job and ask or cancel it at any time.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

namespace hepatica {

struct JobProgress {
    std::string stage;      // what is being done now, in words for the user
    double fraction = 0.0;  // of this stage, in [0, 1]
    int stage_number = 0;   // from 1; 0 before the first stage
    int stage_count = 0;    // as announced; 0 if it was not
};

struct StageTime {
    std::string name;
    double seconds = 0.0;
};

// What the worker has just done with its job.
enum class JobEvent {
    check,     // asked whether to stop
    progress,  // reported progress, or began a stage; asked as well
};

// Thread-safe: the worker calls the first three, anybody calls the rest.
class Job {
  public:
    // Announces how many stages are to begin; void while those of an earlier call are to come.
    void expect_stages(int count);
    // Ends the stage before, starts this one. Throws Cancelled if the user has asked to stop.
    void begin_stage(const std::string& name);
    // Reports how much of the stage is done. Throws Cancelled if the user has asked to stop.
    // Cheap enough for every slice or every few thousand voxels; call it at least every 0.1 s.
    void advance(double fraction);

    void cancel() { stop_.request_stop(); }
    bool cancelled() const { return stop_.stop_requested(); }
    void throw_if_cancelled() const;
    // For work that knows no job: its stop is asked for when the job is cancelled.
    std::stop_token stop_token() const { return stop_.get_token(); }

    // For measurements: called at every event, on whatever thread it happens, before the worker
    // learns whether to stop. Set it before the work begins.
    void observe(std::function<void(JobEvent)> observer) { observer_ = std::move(observer); }

    JobProgress progress() const;
    // Stages so far with their wall time; the last one is still running.
    std::vector<StageTime> stage_times() const;

  private:
    using Clock = std::chrono::steady_clock;

    void notify(JobEvent event) const {
        if (observer_) observer_(event);
    }

    std::stop_source stop_;
    std::function<void(JobEvent)> observer_;
    mutable std::mutex mutex_;
    JobProgress progress_;
    std::vector<StageTime> finished_;
    Clock::time_point stage_start_{};
};

}  // namespace hepatica
