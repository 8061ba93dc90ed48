// SPDX-License-Identifier: GPL-3.0-or-later
// A device that a hand moves and that pushes back: its pose comes in, a force goes out. Whoever
// owns one writes a driver: a class of this interface (docs/haptics.md). It knows nothing of
// vessels, and the program knows nothing of its hardware.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/vector.h"

namespace hepatica {

using Vec6 = Eigen::Matrix<double, 6, 1>;

// Of the device's handle, in a right-handed frame whose axes are the scene's: x to the left, y to
// the back, z to the head.
struct HapticPose {
    Vec3 at_mm = Vec3::Zero();
    Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();  // from any posture that stays
};

// The way from one pose to another: mm, then rad about the axis.
Vec6 way_between(const HapticPose& from, const HapticPose& to);

// What the handle is pushed and turned with.
struct HapticForce {
    Vec3 force_un = Vec3::Zero();
    Vec3 torque_un_mm = Vec3::Zero();  // about the handle's own place
    Vec6 both() const { return (Vec6() << force_un, torque_un_mm).finished(); }
};

struct HapticSample {
    HapticPose pose;
    std::uint64_t number = 0;  // grows by one with each sample that the device takes
    // The work that its force has done on the handle from the first sample to this one: below 0 as
    // long as the hand has put in more than it got back. See PortWork.
    double work_nj = 0.0;
};

// The account of that work, for drivers: call pass() whenever a sample is taken, with what the
// device has been pushing with since the last one. Kept at the device it is exact however late
// messages are.
class PortWork {
  public:
    double pass(const HapticPose& now, const HapticForce& applied);

  private:
    std::optional<HapticPose> last_;
    double work_nj_ = 0.0;
};

// What the loop must know of a device to be stable with it. Values that are not known are to be
// taken from the careful side: damping low, latency high.
struct HapticTraits {
    std::string name = "haptic device";
    double period_s = 1e-3;  // between samples, > 0: that of the loop
    // From the moment at which a pose is taken to that at which the force that answers it begins to
    // act, at most; without the period for which a force is then held. >= 0.
    double latency_s = 0.0;
    double resolution_mm = 0.0;  // the step of its encoders at the handle, >= 0
    // The least damping of the handle in a loose grip, > 0: that of its joints is what counts. No
    // stiffness above 2 damping / (period + 2 latency) can be shown stably (Colgate and Schenkel).
    double damping_un_s_per_mm = 1e3;
    double turn_damping_un_mm_s = 1e5;  // the same about its place, per rad/s
    double force_limit_un = 3e6;        // the loop never asks for more; > 0
    double torque_limit_un_mm = 1e8;    // > 0
};

// read() and write() are called by one thread, in turn, once a period each, while a tool is in
// hand; neither may wait, allocate or throw, and both together must take well under a period.
// traits() must not change. After the last call the driver must let the force go by itself, and it
// must do so, too, where it is not written to for ten periods: the program may have ended.
class HapticDevice {
  public:
    virtual ~HapticDevice() = default;

    virtual const HapticTraits& traits() const = 0;
    // The newest sample, which may be that of the last call. None where the device is lost: pulled
    // out, switched off, or its own safety has tripped. A pose that is not finite counts as that,
    // and so does a sample that stays the same for 100 periods. The loop then lets go for good; the
    // play goes on, and the device can be attached anew.
    virtual std::optional<HapticSample> read() noexcept = 0;
    // What to push with from now on, within the limits of the traits.
    virtual void write(const HapticForce& force) noexcept = 0;
};

}  // namespace hepatica
