// SPDX-License-Identifier: GPL-3.0-or-later
// One injection that is computed on a thread of its own during play, because it takes longer than a
// step. Its result does not depend on when it is taken.
#pragma once

#include <future>
#include <memory>
#include <thread>
#include <vector>

#include "core/scene/drug_arrival.h"

namespace hepatica {

class InjectionRun {
  public:
    // Starts at once. The tree must outlive it. Throws std::system_error where no thread can be
    // created.
    InjectionRun(const VesselTree& tree, std::shared_ptr<const std::vector<TreePoint>> places,
                 Injection injection);
    // Cancels and joins, which waits for at most one step of the front, some milliseconds.
    ~InjectionRun();
    InjectionRun(const InjectionRun&) = delete;
    InjectionRun& operator=(const InjectionRun&) = delete;

    const Injection& injection() const { return injection_; }
    // Whether it has ended, with a result or an error.
    bool ready() const;
    // Waits for the end; may be called once. Throws what the computation threw.
    DrugArrival take() { return result_.get(); }
    // Asks it to end soon and does not wait; see ready().
    void cancel() { job_.cancel(); }

  private:
    Injection injection_;
    Job job_;
    std::future<DrugArrival> result_;
    std::jthread thread_;
};

}  // namespace hepatica
