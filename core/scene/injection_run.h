// SPDX-License-Identifier: GPL-3.0-or-later
// One injection that is computed beside the play, on a thread of its own, because no step has the
// time for it. What it gives does not depend on when it is taken.
#pragma once

#include <future>
#include <memory>
#include <thread>
#include <vector>

#include "core/scene/drug_arrival.h"

namespace hepatica {

class InjectionRun {
  public:
    // Begins at once. The tree must outlive it. Throws std::system_error where no thread is to be
    // had.
    InjectionRun(const VesselTree& tree, std::shared_ptr<const std::vector<TreePoint>> places,
                 Injection injection);
    // Cancels and joins: at most one step of the front, some milliseconds.
    ~InjectionRun();
    InjectionRun(const InjectionRun&) = delete;
    InjectionRun& operator=(const InjectionRun&) = delete;

    const Injection& injection() const { return injection_; }
    // It has ended, with a result or an error.
    bool ready() const;
    // Waits for the end; once only. Throws what computing it threw.
    DrugArrival take() { return result_.get(); }
    // Ends it soon; ready() says when. Does not wait.
    void cancel() { job_.cancel(); }

  private:
    Injection injection_;
    Job job_;
    std::future<DrugArrival> result_;
    std::jthread thread_;
};

}  // namespace hepatica
