// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a job behind one mutex; cancellation by a stop token.
#include "core/base/job.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace hepatica {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

void Job::throw_if_cancelled() const {
    notify(JobEvent::check);
    if (cancelled()) throw Cancelled();
}

void Job::expect_stages(int count) {
    const std::scoped_lock lock(mutex_);
    // The caller has announced all stages.
    if (progress_.stage_number < progress_.stage_count) return;
    progress_.stage_count = progress_.stage_number + count;
}

void Job::begin_stage(const std::string& name) {
    throw_if_cancelled();
    {
        const std::scoped_lock lock(mutex_);
        if (progress_.stage_number > 0)
            finished_.push_back({progress_.stage, seconds_since(stage_start_)});
        progress_.stage = name;
        progress_.fraction = 0.0;
        part_.reset();
        ++progress_.stage_number;
        stage_start_ = Clock::now();
    }
    notify(JobEvent::progress);
}

void Job::advance(double fraction) {
    throw_if_cancelled();
    {
        const std::scoped_lock lock(mutex_);
        // Threads of one loop may report in another order than they counted.
        if (part_)
            progress_.fraction =
                std::max(progress_.fraction,
                         std::lerp(part_->begin, part_->end, std::clamp(fraction, 0.0, 1.0)));
        else
            progress_.fraction = fraction;
    }
    notify(JobEvent::progress);
}

JobProgress Job::progress() const {
    const std::scoped_lock lock(mutex_);
    return progress_;
}

std::vector<StageTime> Job::stage_times() const {
    const std::scoped_lock lock(mutex_);
    std::vector<StageTime> times = finished_;
    if (progress_.stage_number > 0) times.push_back({progress_.stage, seconds_since(stage_start_)});
    return times;
}

JobPart::JobPart(Job& job, double begin, double end) : job_(job) {
    job.throw_if_cancelled();
    {
        const std::scoped_lock lock(job.mutex_);
        around_ = job.part_;
        stage_number_ = job.progress_.stage_number;
        const Job::Span whole = around_.value_or(Job::Span{});
        const double from = std::lerp(whole.begin, whole.end, begin);
        job.part_ = Job::Span{from, std::lerp(whole.begin, whole.end, end)};
        // What came before a part of a whole stage may be a step that knew of no parts.
        job.progress_.fraction = around_ ? std::max(job.progress_.fraction, from) : from;
    }
    job.notify(JobEvent::progress);
}

JobPart::~JobPart() {
    const std::scoped_lock lock(job_.mutex_);
    if (job_.progress_.stage_number == stage_number_) job_.part_ = around_;
}

}  // namespace hepatica
