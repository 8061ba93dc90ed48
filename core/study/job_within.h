// SPDX-License-Identifier: GPL-3.0-or-later
// A job for work whose stages are not those of the caller, such as meshing a body before it is
// measured: it is held up and cancelled together with the caller's job.
#pragma once

#include "core/base/job.h"

namespace hepatica {

class JobWithin {
  public:
    // The caller's job must outlive this one.
    explicit JobWithin(const Job& callers) {
        job_.observe([&callers](JobEvent) { callers.throw_if_cancelled(); });
    }
    JobWithin(const JobWithin&) = delete;
    JobWithin& operator=(const JobWithin&) = delete;

    // Wherever this job is asked whether it is cancelled, the caller's is asked, too: throws
    // Cancelled with it.
    Job& job() { return job_; }

  private:
    Job job_;
};

}  // namespace hepatica
