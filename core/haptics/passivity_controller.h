// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the loop from making energy. A spring that is sampled, held and answered late gives back
// more than was put in, by stiffness (T/2 + latency) v^2 in time; what is left of that after the
// coupling's limit, and what new models of the patch bring, is caught here (time-domain passivity
// control, Hannaford and Ryu 2002): the observer keeps the credit, which is the work that the hand
// has put in; the controller adds the least damping that keeps it from being overdrawn until the
// account of the forces now under way has come in.
//
// The coupling's limit is that of Colgate and Schenkel (1997): a device of damping b shows a spring
// K and a damper B stably if b > K T/2 + |B|; with the latency L, K (T/2 + L) stands for K T/2.
#pragma once

#include <vector>

#include "core/haptics/haptic_device.h"

namespace hepatica {

// The stiffest coupling of a device, with 3/10 of its damping; 6/10 are the controller's to brake
// with. [uN/mm], and [uN mm/rad].
double coupling_limit(double damping, const HapticTraits& traits);

// Not thread-safe.
class PassivityController {
  public:
    explicit PassivityController(const HapticTraits& traits);

    // What may be written now instead of what is wanted, which is 0 where nothing is touched: then
    // it stays 0, and the touch begins anew. The credit is at most what the force can have stored
    // on the way since the touch began: what was rubbed away does not pay for energy made later.
    HapticForce limited(const HapticForce& wanted, const HapticSample& sample);

    double credit_nj() const { return credit_nj_; }
    double damping_un_s_per_mm() const { return damping_; }  // that was added last

  private:
    double under_way_nj(const Vec6& force) const;

    double period_s_, resolution_mm_;
    double most_damping_;
    std::vector<Vec6> under_way_;  // a ring: forces of which no work has been heard yet
    std::size_t next_ = 0;
    Vec6 written_ = Vec6::Zero(), before_ = Vec6::Zero();
    std::optional<HapticSample> last_;
    std::optional<HapticPose> touch_;
    Vec6 velocity_ = Vec6::Zero();
    double credit_nj_ = 0.0, damping_ = 0.0;
};

}  // namespace hepatica
