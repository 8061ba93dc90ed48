// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/haptics/passivity_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hepatica {
namespace {

constexpr double for_coupling = 0.3, for_braking = 0.6;  // of the device's damping
constexpr double arm_mm = 10.0;                          // lever arm between forces and torques
constexpr double smoothing_s = 4e-3;  // of the velocity, because encoder steps are coarse
constexpr double least_mm_per_s = 1e-3;

Vec6 scaled(const HapticForce& force) {
    return (Vec6() << force.force_un, force.torque_un_mm / arm_mm).finished();
}

Vec6 scaled_way(const HapticPose& from, const HapticPose& to) {
    Vec6 way = way_between(from, to);
    way.tail<3>() *= arm_mm;
    return way;
}

}  // namespace

double coupling_limit(double damping, const HapticTraits& traits) {
    return for_coupling * damping / (0.5 * traits.period_s + traits.latency_s);
}

PassivityController::PassivityController(const HapticTraits& traits)
    : period_s_(traits.period_s),
      resolution_mm_(traits.resolution_mm),
      most_damping_(for_braking * std::min(traits.damping_un_s_per_mm,
                                           traits.turn_damping_un_mm_s / (arm_mm * arm_mm))),
      under_way_(static_cast<std::size_t>(std::ceil(traits.latency_s / traits.period_s - 1e-9)),
                 Vec6::Zero()) {}

// If the handle keeps its velocity: the work that `force` and earlier forces without feedback may
// still do.
double PassivityController::under_way_nj(const Vec6& force) const {
    double power = force.dot(velocity_);
    for (const Vec6& earlier : under_way_) power += std::max(0.0, earlier.dot(velocity_));
    return period_s_ * power;
}

HapticForce PassivityController::limited(const HapticForce& wanted, const HapticSample& sample) {
    if (last_ && sample.number > last_->number) {
        const double passed_s = static_cast<double>(sample.number - last_->number) * period_s_;
        const Vec6 velocity = scaled_way(last_->pose, sample.pose) / passed_s;
        velocity_ += std::min(1.0, passed_s / smoothing_s) * (velocity - velocity_);
        credit_nj_ -= sample.work_nj - last_->work_nj;
    }
    last_ = sample;
    // The work that encoder steps may hide: half a step wherever the force changes.
    credit_nj_ -= 0.5 * resolution_mm_ * (written_ - before_).norm();
    Vec6 force = scaled(wanted);
    damping_ = 0.0;
    if (force.isZero(0.0)) {
        touch_.reset();
    } else {
        if (!touch_) touch_ = sample.pose;
        credit_nj_ = std::min(credit_nj_, force.norm() * scaled_way(*touch_, sample.pose).norm());
        const double lacking_nj = under_way_nj(force) - credit_nj_;
        const double speed_2 = velocity_.squaredNorm();
        if (lacking_nj > 0.0 && speed_2 > least_mm_per_s * least_mm_per_s) {
            const double that_gives = std::max(0.0, force.dot(velocity_)) / speed_2;
            damping_ = std::min(lacking_nj / (period_s_ * speed_2), that_gives + most_damping_);
            force -= damping_ * velocity_;
        }
    }
    before_ = std::exchange(written_, force);
    if (!under_way_.empty()) {
        under_way_[next_] = force;
        next_ = (next_ + 1) % under_way_.size();
    }
    return {force.head<3>(), arm_mm * force.tail<3>()};
}

}  // namespace hepatica
