// SPDX-License-Identifier: GPL-3.0-or-later
// Shows a job's stages on standard error while it runs, and cancels it on Ctrl-C, when it is told
// to end, or when its terminal is closed.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

#include "app/interruption.h"
#include "core/base/job.h"

namespace hepatica {

// Must live as long as the work. On a terminal one line is rewritten ten times a second; in a log
// file each stage gets a line, even a very short one. Only one may exist at a time, because it owns
// the handlers of signals (interruption.h).
class ProgressDisplay {
  public:
    ProgressDisplay(Job& job, bool quiet);
    ~ProgressDisplay();
    ProgressDisplay(const ProgressDisplay&) = delete;
    ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  private:
    void watch();
    void show();

    Job& job_;
    bool quiet_;
    bool terminal_;
    Interruption interruption_;
    bool line_open_ = false;
    std::size_t shown_stages_ = 0;
    bool finished_ = false;
    std::mutex mutex_;
    std::condition_variable finish_;
    std::thread thread_;
};

}  // namespace hepatica
