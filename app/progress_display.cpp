// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress_display.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>

namespace hepatica {

namespace {

// A signal handler may touch nothing but this; the watching thread passes it on to the job.
volatile std::sig_atomic_t interrupted = 0;

void on_interrupt(int) {
    interrupted = 1;
}

std::string counted(const JobProgress& progress) {
    std::string text = "[" + std::to_string(progress.stage_number);
    if (progress.stage_count > 0) text += "/" + std::to_string(progress.stage_count);
    return text + "] " + progress.stage;
}

}  // namespace

ProgressDisplay::ProgressDisplay(Job& job, bool quiet)
    : job_(job), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {
    interrupted = 0;
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
    thread_ = std::thread([this] { watch(); });
}

ProgressDisplay::~ProgressDisplay() {
    {
        const std::scoped_lock lock(mutex_);
        finished_ = true;
    }
    finish_.notify_one();
    thread_.join();
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

void ProgressDisplay::watch() {
    std::unique_lock lock(mutex_);
    while (!finished_) {
        finish_.wait_for(lock, std::chrono::milliseconds(100));
        if (interrupted != 0) job_.cancel();
        if (!quiet_) show(job_.progress());
    }
    if (line_open_) std::fputs("\n", stderr);
}

void ProgressDisplay::show(const JobProgress& progress) {
    if (progress.stage_number == 0) return;
    if (terminal_) {
        std::fprintf(stderr, "\r\033[K%s  %3.0f %%", counted(progress).c_str(),
                     100.0 * progress.fraction);
        std::fflush(stderr);
        line_open_ = true;
    } else if (progress.stage_number != shown_stage_) {
        spdlog::info("{}", counted(progress));
    }
    shown_stage_ = progress.stage_number;
}

}  // namespace hepatica
