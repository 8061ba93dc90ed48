// SPDX-License-Identifier: GPL-3.0-or-later
// The one law of all contacts: a compressible pad whose force grows without bound as the gap
// closes. With the compression s = 1 - gap / pad,
//   energy = strength pad (-s - ln(1 - s)),  force = strength s / (1 - s).
// Both start at zero, without a jump, at s = 0. See docs/contact.md. For host and device.
#pragma once

#include <limits>

#include "core/base/small_matrix.h"

namespace hepatica {

struct PadBarrier {
    double energy_nj = 0.0;  // infinite where the gap is closed
    double force_un = 0.0;   // repulsive; finite even where the gap is closed
    double stiffness_un_per_mm = 0.0;
};

// Requires gap_mm < pad_mm and pad_mm > 0; `strength_un` is the pad's pressure times its area.
HEPATICA_HOST_DEVICE PadBarrier pad_barrier(double gap_mm, double pad_mm, double strength_un) {
    constexpr double deepest = 1.0 - 1e-12;
    double pressed = 1.0 - gap_mm / pad_mm;
    if (deepest < pressed) pressed = deepest;
    const double left = 1.0 - pressed;
    return {gap_mm > 0.0 ? strength_un * pad_mm * (-pressed - std::log1p(-pressed))
                         : std::numeric_limits<double>::infinity(),
            strength_un * pressed / left, strength_un / (pad_mm * left * left)};
}

}  // namespace hepatica
