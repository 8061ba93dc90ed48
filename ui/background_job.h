// SPDX-License-Identifier: GPL-3.0-or-later
// One long piece of work beside the window: it runs on a thread of its own under a Job, and what it
// hands back runs on the UI thread. The window never waits for it, except to end.
#pragma once

#include <QTimer>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <thread>

#include "core/base/job.h"

namespace hepatica {

// A failure as the window shows it: what, where, remedy.
struct Failure {
    std::string problem;
    std::string place;
    std::string remedy;
};

// What an exception says to the user; a foreign one names itself as an internal error.
Failure failure_of(const std::exception_ptr& error);

// UI thread. Not reusable: one object, one job.
class BackgroundJob {
  public:
    // On the worker; what it returns runs on the UI thread when the work is done.
    using Work = std::function<std::function<void()>(Job&)>;

    struct Callbacks {
        std::function<void(const JobProgress&)> progress =  // about 20 times a second
            [](const JobProgress&) {};
        std::function<void(const Failure&)> failed;
        std::function<void()> cancelled = [] {};
        std::function<void()> ended;  // last, after any of the others
    };

    BackgroundJob(Work work, Callbacks callbacks);
    // Cancels and waits for the worker (0.2 s where the work asks its job as it should). No
    // callback is called.
    ~BackgroundJob();

    void cancel() { job_->cancel(); }

  private:
    void poll();

    std::shared_ptr<Job> job_ = std::make_shared<Job>();
    Callbacks callbacks_;
    std::future<std::function<void()>> result_;
    QTimer timer_;
    std::jthread thread_;
};

}  // namespace hepatica
