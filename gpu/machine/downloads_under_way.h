// SPDX-License-Identifier: GPL-3.0-or-later
// Scope of asynchronous downloads (Machine::begin_download). They are finished when the scope ends,
// by whatever path, so that nothing is copied to or from freed memory.
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
            // The device failed; the error that ended the scope already reports it.
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
