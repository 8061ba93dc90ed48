// SPDX-License-Identifier: GPL-3.0-or-later
// Watches a job for progress that falls back: a stage that was said to be done by half is never
// done by less later.
#pragma once

#include <mutex>
#include <set>
#include <string>

#include "core/base/job.h"

namespace hepatica::test {

// Observes the job, which must report nothing once this is gone.
class FallsOfProgress {
  public:
    explicit FallsOfProgress(Job& job) {
        job.observe([this, &job](JobEvent event) {
            if (event != JobEvent::progress) return;
            const std::scoped_lock lock(mutex_);
            const JobProgress now = job.progress();
            if (now.stage_number == last_.stage_number && now.fraction < last_.fraction - 1e-9)
                stages_.insert(now.stage);
            last_ = now;
            ++reports_;
        });
    }

    // The stages in which it fell, by name.
    const std::set<std::string>& stages() const { return stages_; }
    int reports() const { return reports_; }

  private:
    std::mutex mutex_;
    JobProgress last_;
    std::set<std::string> stages_;
    int reports_ = 0;
};

}  // namespace hepatica::test
