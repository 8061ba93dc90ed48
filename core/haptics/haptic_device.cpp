// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/haptics/haptic_device.h"

#include <cmath>

namespace hepatica {

Vec6 way_between(const HapticPose& from, const HapticPose& to) {
    const Eigen::AngleAxisd turn(to.turned * from.turned.conjugate());
    const double angle = turn.angle() > M_PI ? turn.angle() - 2.0 * M_PI : turn.angle();
    return (Vec6() << to.at_mm - from.at_mm, angle * turn.axis()).finished();
}

double PortWork::pass(const HapticPose& now, const HapticForce& applied) {
    if (last_) work_nj_ += applied.both().dot(way_between(*last_, now));
    last_ = now;
    return work_nj_;
}

}  // namespace hepatica
