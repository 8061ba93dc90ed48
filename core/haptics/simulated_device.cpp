// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/haptics/simulated_device.h"

#include <algorithm>
#include <cmath>

namespace hepatica {
namespace {

// Sums the power series; meant for matrices whose norm is small compared to 1.
Mat3 exponential(const Mat3& matrix) {
    constexpr int terms = 20;
    Mat3 sum = Mat3::Identity(), term = Mat3::Identity();
    for (int n = 1; n <= terms; ++n) {
        term = term * matrix / n;
        sum += term;
    }
    return sum;
}

}  // namespace

SimulatedDevice::SimulatedDevice(const SimulatedHand& hand, HapticTraits traits)
    : hand_(hand), traits_(std::move(traits)), draw_(hand.seed), pose_(hand.path(0.0)) {
    traits_.latency_s =
        2.0 * traits_.period_s * static_cast<double>(hand_.latency_periods + hand_.jitter_periods);
    traits_.resolution_mm = hand_.encoder_mm;
    Mat3 motion = Mat3::Zero();
    motion(0, 1) = 1.0;
    motion.row(1) << -hand_.spring_un_per_mm / hand_.mass_g,
        -hand_.damping_un_s_per_mm / hand_.mass_g, 1.0 / hand_.mass_g;
    over_period_ = exponential(traits_.period_s * motion);
}

std::uint64_t SimulatedDevice::arrival(std::uint64_t last) {
    std::uint64_t late = hand_.latency_periods;
    if (hand_.jitter_periods > 0) late += draw_() % (hand_.jitter_periods + 1);
    return std::max(last, period_ + late);
}

HapticPose SimulatedDevice::seen() const {
    HapticPose pose = pose_;
    if (hand_.encoder_mm > 0.0)
        pose.at_mm = hand_.encoder_mm * (pose.at_mm / hand_.encoder_mm).array().round().matrix();
    return pose;
}

// The wrist's rotation is prescribed; the force moves only the handle's position.
void SimulatedDevice::move() {
    const HapticPose before = pose_, wanted = hand_.path(time_s());
    const Mat3& e = over_period_;
    const Vec3 from = pose_.at_mm - wanted.at_mm, v = velocity_, f = acting_.force_un;
    pose_.at_mm = wanted.at_mm + e(0, 0) * from + e(0, 1) * v + e(0, 2) * f;
    velocity_ = e(1, 0) * from + e(1, 1) * v + e(1, 2) * f;
    pose_.turned = wanted.turned;
    work_nj_ += acting_.both().dot(way_between(before, pose_));
    most_work_nj_ = std::max(most_work_nj_, work_nj_);
    ++period_;
}

std::optional<HapticSample> SimulatedDevice::read() noexcept {
    if (lost_) return std::nullopt;
    while (!forces_.empty() && forces_.front().arrives <= period_) {
        acting_ = forces_.front().content;
        forces_.pop_front();
    }
    move();
    const HapticPose pose = seen();
    last_sample_ = arrival(last_sample_);
    samples_.push_back({last_sample_, {pose, period_, port_.pass(pose, acting_)}});
    while (!samples_.empty() && samples_.front().arrives <= period_) {
        newest_ = samples_.front().content;
        samples_.pop_front();
    }
    return newest_;
}

void SimulatedDevice::write(const HapticForce& force) noexcept {
    last_force_ = arrival(last_force_);
    forces_.push_back({last_force_, force});
}

}  // namespace hepatica
