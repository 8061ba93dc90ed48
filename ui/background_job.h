// SPDX-License-Identifier: GPL-3.0-or-later
// A long task on a thread of its own under a Job; the function that it returns runs on the UI
// thread. The window never waits for it, except when closing.
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

// A failure as the window shows it.
struct Failure {
    std::string problem;
    std::string place;
    std::string remedy;
};

// The message of an exception; one that is neither a hepatica::Error nor of the file system or the
// memory counts as an internal error.
Failure failure_of(const std::exception_ptr& error);

// UI thread only. One object runs one job.
class BackgroundJob {
  public:
    // Runs on the worker; the returned function runs on the UI thread afterwards.
    using Work = std::function<std::function<void()>(Job&)>;

    struct Callbacks {
        std::function<void(const JobProgress&)> progress =  // about 20 times a second
            [](const JobProgress&) {};
        std::function<void(const Failure&)> failed;
        std::function<void()> cancelled = [] {};
        std::function<void()> ended;  // last, after any of the others
    };

    BackgroundJob(Work work, Callbacks callbacks);
    // Cancels and waits for the worker, 0.2 s if the work polls its job as it should. No callback
    // is called afterwards.
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
