// SPDX-License-Identifier: GPL-3.0-or-later
// A haptic device with the hand that holds it, in simulated time: each read() is one period later.
// The handle is a mass that the hand's spring pulls along a path and that joints and hand damp,
//   m v' = F + k (path - x) - b v,
// integrated exactly over each period, during which force and path are constant. Poses pass through
// an encoder; poses and forces are delayed by a latency and a random jitter of whole periods.
#pragma once

#include <deque>
#include <functional>
#include <random>

#include "core/haptics/haptic_device.h"

namespace hepatica {

struct SimulatedHand {
    double mass_g = 200.0;              // of handle and hand, > 0
    double spring_un_per_mm = 5e5;      // the hand's, >= 0
    double damping_un_s_per_mm = 5e3;   // of joints and hand, >= 0
    double encoder_mm = 0.0;            // its step; 0: exact
    std::uint64_t latency_periods = 0;  // of a pose, and again of a force
    std::uint64_t jitter_periods = 0;   // drawn for each message, added to the latency
    unsigned seed = 1;
    std::function<HapticPose(double)> path =  // position that the hand wants, by time [s]
        [](double) { return HapticPose{}; };
};

class SimulatedDevice final : public HapticDevice {
  public:
    // Its traits are the given ones, except for resolution and latency, which are the hand's.
    SimulatedDevice(const SimulatedHand& hand, HapticTraits traits);

    const HapticTraits& traits() const override { return traits_; }
    std::optional<HapticSample> read() noexcept override;
    void write(const HapticForce& force) noexcept override;

    // From now on the device behaves as if it were unplugged.
    void lose() { lost_ = true; }

    // The true state, which a driver would not know.
    double time_s() const { return static_cast<double>(period_) * traits_.period_s; }
    const Vec3& at_mm() const { return pose_.at_mm; }
    const Vec3& velocity_mm_per_s() const { return velocity_; }
    const HapticForce& acting() const { return acting_; }
    double work_nj() const { return work_nj_; }            // of its force on the hand
    double most_work_nj() const { return most_work_nj_; }  // the largest at any time

  private:
    template <class T>
    struct Message {
        std::uint64_t arrives;
        T content;
    };
    std::uint64_t arrival(std::uint64_t last);
    void move();
    HapticPose seen() const;

    SimulatedHand hand_;
    HapticTraits traits_;
    Mat3 over_period_;  // transition of (x - path, v, F) over a period
    std::mt19937 draw_;
    std::uint64_t period_ = 0;
    HapticPose pose_;
    Vec3 velocity_ = Vec3::Zero();
    HapticForce acting_;
    PortWork port_;
    double work_nj_ = 0.0, most_work_nj_ = 0.0;
    std::deque<Message<HapticSample>> samples_;
    std::deque<Message<HapticForce>> forces_;
    HapticSample newest_;
    std::uint64_t last_sample_ = 0, last_force_ = 0;  // arrival of the last ones
    bool lost_ = false;
};

}  // namespace hepatica
