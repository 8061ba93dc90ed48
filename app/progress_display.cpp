// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress_display.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

namespace hepatica {

namespace {

std::string counted(std::size_t number, int count, const std::string& stage) {
    std::string text = "[" + std::to_string(number);
    if (count > 0) text += "/" + std::to_string(count);
    return text + "] " + stage;
}

}  // namespace

ProgressDisplay::ProgressDisplay(Job& job, bool quiet)
    : job_(job), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {
    thread_ = std::thread([this] { watch(); });
}

ProgressDisplay::~ProgressDisplay() {
    {
        const std::scoped_lock lock(mutex_);
        finished_ = true;
    }
    finish_.notify_one();
    thread_.join();
}

void ProgressDisplay::watch() {
    std::unique_lock lock(mutex_);
    while (!finished_) {
        finish_.wait_for(lock, std::chrono::milliseconds(100));
        if (Interruption::came()) job_.cancel();
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
