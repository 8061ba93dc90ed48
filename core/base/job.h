// SPDX-License-Identifier: GPL-3.0-or-later
// A long computation as seen by its caller: named stages, progress and cancellation. The worker
// holds a Job&; other threads hold the same Job and may query or cancel it at any time.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace hepatica {

struct JobProgress {
    std::string stage;      // the current stage, in words for the user
    double fraction = 0.0;  // share of this stage that is done, in [0, 1]
    int stage_number = 0;   // from 1; 0 before the first stage
    int stage_count = 0;    // as announced; 0 if not announced
};

struct StageTime {
    std::string name;
    double seconds = 0.0;
};

// Events in the worker that an observer receives.
enum class JobEvent {
    check,     // asked whether it is cancelled
    progress,  // reported progress or began a stage, which also checks
};

// Thread-safe, except observe(). The first three functions are for the worker, the others for all.
class Job {
  public:
    // Announces the number of stages that follow; ignored while stages of an earlier call remain.
    void expect_stages(int count);
    // Ends the previous stage and starts this one. Throws Cancelled if the job is cancelled.
    void begin_stage(const std::string& name);
    // Reports the share of the stage, or of the present JobPart, that is done. Throws Cancelled if
    // the job is cancelled. Cheap enough for every slice or every few thousand voxels; call it at
    // least every 0.1 s.
    void advance(double fraction);

    void cancel() { stop_.request_stop(); }
    bool cancelled() const { return stop_.stop_requested(); }
    void throw_if_cancelled() const;
    // For code that takes no job: stop is requested when the job is cancelled.
    std::stop_token stop_token() const { return stop_.get_token(); }

    // For measurements: called at every event, on the thread where it happens, before the worker
    // learns of a cancellation. Set it before the work begins.
    void observe(std::function<void(JobEvent)> observer) { observer_ = std::move(observer); }

    JobProgress progress() const;
    // Stages so far with their wall time; the last one is the current one.
    std::vector<StageTime> stage_times() const;

  private:
    friend class JobPart;
    using Clock = std::chrono::steady_clock;

    // In shares of the stage.
    struct Span {
        double begin = 0.0;
        double end = 1.0;
    };

    void notify(JobEvent event) const {
        if (observer_) observer_(event);
    }

    std::stop_source stop_;
    std::function<void(JobEvent)> observer_;
    mutable std::mutex mutex_;
    JobProgress progress_;
    std::optional<Span> part_;  // what advance() fills; none: the whole stage
    std::vector<StageTime> finished_;
    Clock::time_point stage_start_{};
};

// The share from `begin` to `end` of the present stage, or of the part that encloses this one.
// While it lives, advance() reports the share of this part that is done, so that a step need not
// know what else the stage does, and what is reported never falls. The worker makes parts itself,
// one in the other, never in a parallel loop. Begin no stage while one lives.
class JobPart {
  public:
    // Reports the beginning. Throws Cancelled.
    JobPart(Job& job, double begin, double end);
    ~JobPart();
    JobPart(const JobPart&) = delete;
    JobPart& operator=(const JobPart&) = delete;

  private:
    Job& job_;
    std::optional<Job::Span> around_;
    int stage_number_ = 0;
};

// What work() returns; its progress is that of a JobPart.
template <class Work>
auto in_part(Job& job, double begin, double end, const Work& work) {
    const JobPart part(job, begin, end);
    return work();
}

}  // namespace hepatica
