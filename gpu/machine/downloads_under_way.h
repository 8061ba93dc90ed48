// SPDX-License-Identifier: GPL-3.0-or-later
// Downloads that were begun and go on beside other work (Machine::begin_download): they are over
// when this ends, however it ends, so that nothing is copied to or from memory that is gone.
#pragma once

#include <exception>

#include "gpu/machine/machine.h"

namespace hepatica::gpu {

class DownloadsUnderWay {
  public:
    explicit DownloadsUnderWay(Machine& machine) : machine_(machine) {}
    ~DownloadsUnderWay() {
        if (finished_) return;
        try {
            machine_.finish_downloads();
        } catch (const std::exception&) {
            // The device failed, and what brought the step here says so.
        }
    }
    DownloadsUnderWay(const DownloadsUnderWay&) = delete;
    DownloadsUnderWay& operator=(const DownloadsUnderWay&) = delete;

    void finish() {
        finished_ = true;
        machine_.finish_downloads();
    }

  private:
    Machine& machine_;
    bool finished_ = false;
};

}  // namespace hepatica::gpu
