// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/injection_run.h"

#include <chrono>
#include <utility>

namespace hepatica {

InjectionRun::InjectionRun(const VesselTree& tree,
                           std::shared_ptr<const std::vector<TreePoint>> places,
                           Injection injection)
    : injection_(std::move(injection)) {
    std::packaged_task<DrugArrival()> work(
        [this, &tree, places = std::move(places), options = injection_options(injection_, tree)] {
            return drug_arrival(tree, *places, options, job_);
        });
    result_ = work.get_future();
    thread_ = std::jthread(std::move(work));
}

InjectionRun::~InjectionRun() {
    cancel();
}

bool InjectionRun::ready() const {
    return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace hepatica
