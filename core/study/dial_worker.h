// SPDX-License-Identifier: GPL-3.0-or-later
// Measures a patient's dial on a thread of its own, and only while nobody plays: it runs once for a
// body, and stands still between two steps as soon as somebody does.
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
    // On the worker's thread, after each setting: all points so far. It must not throw.
    using Tell = std::function<void(const std::vector<QualityPoint>&)>;

    // Goes on behind what was measured before. Waits until it is allowed to run. A body that cannot
    // be measured is given up without a word: it has the dial it had. The back end is used by the
    // worker's thread alone.
    DialWorker(std::shared_ptr<const PatientCase> patient, std::vector<QualityPoint> measured,
               Tell tell, DeformBackEnd back_end = cpu_back_end());
    // Ends within the step under way; `tell` is not called any more.
    ~DialWorker();
    DialWorker(const DialWorker&) = delete;
    DialWorker& operator=(const DialWorker&) = delete;

    // Whether nobody plays. Any thread; returns at once. At first somebody does.
    void allow(bool allowed);

    // What its thread is at. Any thread.
    enum class State {
        waits,     // stands still until it is allowed to run
        measures,  // or is about to stand still
        ended      // has measured all, or given up
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
    bool waiting_ = false;  // its thread does
    bool ended_ = false;    // its thread has
    std::jthread thread_;   // last: it uses the others
};

}  // namespace hepatica
