// SPDX-License-Identifier: GPL-3.0-or-later
// A device that a hand moves and that pushes back: its pose comes in, a force goes out. A driver
// for a device is a class with this interface (docs/haptics.md). It knows nothing of vessels, and
// the program knows nothing of its hardware.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/vector.h"

namespace hepatica {

using Vec6 = Eigen::Matrix<double, 6, 1>;

// Pose of the device's handle, in a right-handed frame with the scene's axes: x to the left, y to
// the back, z to the head.
struct HapticPose {
    Vec3 at_mm = Vec3::Zero();
    Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();  // from any fixed posture
};

// The motion from one pose to another: mm, then a rotation vector in rad.
Vec6 way_between(const HapticPose& from, const HapticPose& to);

// Force and torque on the handle.
struct HapticForce {
    Vec3 force_un = Vec3::Zero();
    Vec3 torque_un_mm = Vec3::Zero();  // about the handle's position
    Vec6 both() const { return (Vec6() << force_un, torque_un_mm).finished(); }
};

struct HapticSample {
    HapticPose pose;
    std::uint64_t number = 0;  // increases by one with each sample of the device
    // Work that the device's force has done on the handle from the first sample to this one;
    // negative while the hand has put in more than it got back. See PortWork.
    double work_nj = 0.0;
};

// Sums that work, for drivers: call pass() whenever a sample is taken, with the force that has
// acted since the last one. Computed at the device, it is exact whatever the delay of messages.
class PortWork {
  public:
    double pass(const HapticPose& now, const HapticForce& applied);

  private:
    std::optional<HapticPose> last_;
    double work_nj_ = 0.0;
};

// What the loop must know of a device to be stable with it. Unknown values should be estimated on
// the safe side: damping low, latency high.
struct HapticTraits {
    std::string name = "haptic device";
    double period_s = 1e-3;  // between samples, > 0: that of the loop
    // The longest time from taking a pose until the force in response begins to act, without the
    // period for which a force is then held. >= 0.
    double latency_s = 0.0;
    double resolution_mm = 0.0;  // encoder step at the handle, >= 0
    // The smallest damping of the handle in a loose grip, > 0, in effect that of its joints. No
    // stiffness above 2 damping / (period + 2 latency) can be displayed stably (Colgate and
    // Schenkel).
    double damping_un_s_per_mm = 1e3;
    double turn_damping_un_mm_s = 1e5;  // the same for rotations, per rad/s
    double force_limit_un = 3e6;        // the loop never asks for more; > 0
    double torque_limit_un_mm = 1e8;    // > 0
};

// read() and write() are called by one thread, in turn, once a period each, while a tool is in
// hand; neither may wait, allocate or throw, and both together must take much less than a period.
// traits() must not change. The driver must switch the force off after the last call, and also
// where it is not written to for ten periods, because the program may have ended.
class HapticDevice {
  public:
    virtual ~HapticDevice() = default;

    virtual const HapticTraits& traits() const = 0;
    // The newest sample, which may be that of the last call. None where the device is lost:
    // unplugged, switched off, or stopped by its own safety. A pose or work that is not finite
    // counts as lost, and so does a sample that stays the same for 100 periods. The loop then ends
    // for good; the play goes on, and the device can be attached again.
    virtual std::optional<HapticSample> read() noexcept = 0;
    // Sets the force from now on, within the limits of the traits.
    virtual void write(const HapticForce& force) noexcept = 0;
};

}  // namespace hepatica
