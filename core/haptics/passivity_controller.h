// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the loop from creating energy. A spring that is sampled, held and delayed gives back more
// than was put in, at the rate stiffness (T/2 + latency) v^2. The part of that beyond the
// coupling's limit, and what new models of the patch add, is removed here (time-domain passivity
// control, Hannaford and Ryu 2002). The observer keeps a credit, the work that the hand has put in;
// the controller adds the least damping that keeps the credit from being overdrawn until the work
// of the forces under way has been reported.
//
// The coupling's limit is that of Colgate and Schenkel (1997): a device of damping b displays a
// spring K and a damper B stably if b > K T/2 + |B|; with the latency L, K (T/2 + L) replaces K
// T/2.
#pragma once

#include <vector>

#include "core/haptics/haptic_device.h"

namespace hepatica {

// The stiffest coupling of a device, which uses 3/10 of its damping; 6/10 are left to the
// controller. [uN/mm], and for rotations [uN mm/rad].
double coupling_limit(double damping, const HapticTraits& traits);

// Not thread-safe.
class PassivityController {
  public:
    explicit PassivityController(const HapticTraits& traits);

    // The force to write instead of the wanted one. A wanted force of 0 (no contact) stays 0 and
    // ends the touch. The credit is limited to what the force can have stored since the touch
    // began, so that energy lost to friction does not pay for energy created later.
    HapticForce limited(const HapticForce& wanted, const HapticSample& sample);

    double credit_nj() const { return credit_nj_; }
    double damping_un_s_per_mm() const { return damping_; }  // that was added last

  private:
    double under_way_nj(const Vec6& force) const;

    double period_s_, resolution_mm_;
    double most_damping_;
    std::vector<Vec6> under_way_;  // a ring: forces whose work is not reported yet
    std::size_t next_ = 0;
    Vec6 written_ = Vec6::Zero(), before_ = Vec6::Zero();
    std::optional<HapticSample> last_;
    std::optional<HapticPose> touch_;
    Vec6 velocity_ = Vec6::Zero();
    double credit_nj_ = 0.0, damping_ = 0.0;
};

}  // namespace hepatica
