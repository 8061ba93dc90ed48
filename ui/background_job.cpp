// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/background_job.h"

#include <filesystem>
#include <new>
#include <utility>

#include "core/base/error.h"
#include "ui/window_words.h"
#include "ui/words.h"

namespace hepatica {

Failure failure_of(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const Error& known) {
        return {in_window_words(known.problem()), in_window_words(known.place()),
                in_window_words(known.remedy())};
    } catch (const std::filesystem::filesystem_error& refused) {  // the system's own words
        return {refused.code().message(), refused.path1().string(),
                Words::id("Check that the folder exists, may be written and has free space")};
    } catch (const std::bad_alloc&) {
        return {Words::id("not enough memory"), "",
                Words::id("close other programs, or use a smaller image")};
    } catch (const std::exception& unknown) {
        return {std::string("internal error: ") + unknown.what(), "",
                Words::id("please report it with what you did before")};
    } catch (...) {
        return {Words::id("internal error"), "",
                Words::id("please report it with what you did before")};
    }
}

BackgroundJob::BackgroundJob(Work work, Callbacks callbacks) : callbacks_(std::move(callbacks)) {
    std::packaged_task<std::function<void()>()> task(
        [job = job_, run = std::move(work)] { return run(*job); });
    result_ = task.get_future();
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { poll(); });
    timer_.start(50);
    thread_ = std::jthread([this, run_task = std::move(task)]() mutable {
        run_task();
        QMetaObject::invokeMethod(
            &timer_, [this] { poll(); }, Qt::QueuedConnection);
    });
}

BackgroundJob::~BackgroundJob() {
    job_->cancel();
    if (thread_.joinable()) thread_.join();
}

void BackgroundJob::poll() {
    if (!result_.valid()) return;  // the timer and the worker's own call may both come
    if (result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        callbacks_.progress(job_->progress());
        return;
    }
    timer_.stop();
    const Callbacks callbacks = callbacks_;  // `ended` may destroy this object
    try {
        result_.get()();
    } catch (const Cancelled&) {
        callbacks.cancelled();
    } catch (...) {
        callbacks.failed(failure_of(std::current_exception()));
    }
    callbacks.ended();
}

}  // namespace hepatica
