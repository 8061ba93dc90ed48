// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress_display.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

namespace hepatica {

namespace {

// The only variable that the signal handler touches; the watching thread passes it on to the job.
volatile std::sig_atomic_t interrupted = 0;

void on_interrupt(int) {
    interrupted = 1;
}

constexpr std::array handled_signals{SIGINT, SIGTERM, SIGHUP};

std::string counted(std::size_t number, int count, const std::string& stage) {
    std::string text = "[" + std::to_string(number);
    if (count > 0) text += "/" + std::to_string(count);
    return text + "] " + stage;
}

}  // namespace

ProgressDisplay::ProgressDisplay(Job& job, bool quiet)
    : job_(job), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {
    interrupted = 0;
    for (std::size_t i = 0; i < handled_signals.size(); ++i) {
        handlers_before_[i] = std::signal(handled_signals[i], on_interrupt);
        if (handlers_before_[i] == SIG_IGN) std::signal(handled_signals[i], SIG_IGN);
    }
    thread_ = std::thread([this] { watch(); });
}

ProgressDisplay::~ProgressDisplay() {
    {
        const std::scoped_lock lock(mutex_);
        finished_ = true;
    }
    finish_.notify_one();
    thread_.join();
    for (std::size_t i = 0; i < handled_signals.size(); ++i)
        std::signal(handled_signals[i], handlers_before_[i]);
}

void ProgressDisplay::watch() {
    std::unique_lock lock(mutex_);
    while (!finished_) {
        finish_.wait_for(lock, std::chrono::milliseconds(100));
        if (interrupted != 0) job_.cancel();
        if (!quiet_) show();
    }
    if (!quiet_ && !terminal_) show();  // the work may have ended before this thread began
    if (line_open_) std::fputs("\n", stderr);
}

void ProgressDisplay::show() {
    const std::vector<StageTime> stages = job_.stage_times();
    if (stages.empty()) return;
    const JobProgress progress = job_.progress();
    if (terminal_) {
        const auto number = static_cast<std::size_t>(progress.stage_number);
        std::fprintf(stderr, "\r\033[K%s  %3.0f %%",
                     counted(number, progress.stage_count, progress.stage).c_str(),
                     100.0 * progress.fraction);
        std::fflush(stderr);
        line_open_ = true;
        return;
    }
    for (; shown_stages_ < stages.size(); ++shown_stages_)
        spdlog::info("{}",
                     counted(shown_stages_ + 1, progress.stage_count, stages[shown_stages_].name));
}

}  // namespace hepatica
