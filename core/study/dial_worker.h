// SPDX-License-Identifier: GPL-3.0-or-later
// Measures a patient's dial on its own thread, only while nobody plays: it pauses between two steps
// as soon as somebody does.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "core/study/dial_study.h"

namespace hepatica {

class DialWorker {
  public:
    // Receives all points so far, on the worker's thread after each setting. Must not throw.
    using Tell = std::function<void(const std::vector<QualityPoint>&)>;

    // Continues from what was measured before, once it is allowed to run. A body that cannot be
    // measured is silently given up and keeps its dial. Only the worker's thread uses the back end.
    DialWorker(std::shared_ptr<const PatientCase> patient, std::vector<QualityPoint> measured,
               Tell tell, DeformBackEnd back_end = cpu_back_end());
    // Ends after the current step at the latest; `tell` is not called afterwards.
    ~DialWorker();
    DialWorker(const DialWorker&) = delete;
    DialWorker& operator=(const DialWorker&) = delete;

    // Allows it to run (nobody plays) or not; not at first. Callable from any thread; returns at
    // once.
    void allow(bool allowed);

    // State of its thread. Callable from any thread.
    enum class State {
        waits,     // pauses until it is allowed to run
        measures,  // measures, or is about to pause
        ended      // has measured everything, or given up
    };
    State state() const;

  private:
    void wait_until_allowed();
    void measure(std::shared_ptr<const PatientCase> patient, std::vector<QualityPoint> measured,
                 DeformBackEnd back_end);

    Tell tell_;
    Job job_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    bool allowed_ = false;
    bool waiting_ = false;  // whether its thread waits
    bool ended_ = false;    // whether its thread has ended
    std::jthread thread_;   // last, because it uses the others
};

}  // namespace hepatica
