// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/dial_worker.h"

#include <exception>
#include <utility>

#include "core/base/error.h"

namespace hepatica {

DialWorker::DialWorker(std::shared_ptr<const PatientCase> patient,
                       std::vector<QualityPoint> measured, Tell tell, DeformBackEnd back_end)
    : tell_(std::move(tell)) {
    // The study checks its job between steps; that is where it waits.
    job_.observe([this](JobEvent) { wait_until_allowed(); });
    thread_ = std::jthread([this, body = std::move(patient), known = std::move(measured),
                            by = std::move(back_end)]() mutable {
        measure(std::move(body), std::move(known), std::move(by));
        const std::scoped_lock lock(mutex_);
        ended_ = true;
    });
}

DialWorker::~DialWorker() {
    job_.cancel();
    const std::scoped_lock lock(mutex_);
    changed_.notify_all();
}

void DialWorker::allow(bool allowed) {
    const std::scoped_lock lock(mutex_);
    allowed_ = allowed;
    changed_.notify_all();
}

void DialWorker::wait_until_allowed() {
    std::unique_lock lock(mutex_);
    waiting_ = true;
    changed_.wait(lock, [this] { return allowed_ || job_.cancelled(); });
    waiting_ = false;
}

DialWorker::State DialWorker::state() const {
    const std::scoped_lock lock(mutex_);
    if (ended_) return State::ended;
    return waiting_ && !allowed_ ? State::waits : State::measures;
}

void DialWorker::measure(std::shared_ptr<const PatientCase> patient,
                         std::vector<QualityPoint> measured, DeformBackEnd back_end) {
    try {
        job_.throw_if_cancelled();
        DialStudy study(std::move(patient), std::move(measured), std::move(back_end));
        while (study.measure_next(job_)) {
            job_.throw_if_cancelled();
            tell_(study.points());
        }
    } catch (const Cancelled&) {
        return;
    } catch (const std::exception&) {
        return;
    }
}

}  // namespace hepatica
