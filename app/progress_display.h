// SPDX-License-Identifier: GPL-3.0-or-later
// Shows a job's stages on standard error while it runs, and turns Ctrl-C into a cancel.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

#include "core/base/job.h"

namespace hepatica {

// Lives as long as the work does. On a terminal one line is rewritten ten times a second; in a log
// file each stage gets a line, also one that was over between two looks. One at a time in a
// program: it owns the handler of SIGINT.
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
    bool line_open_ = false;
    std::size_t shown_stages_ = 0;
    bool finished_ = false;
    std::mutex mutex_;
    std::condition_variable finish_;
    std::thread thread_;
};

}  // namespace hepatica
