// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a step conserved momentum. For a free body under its weight, the error is the change of
// momentum minus the impulse of weight. A held body exchanges momentum with its surroundings, so
// that only the sum of the impulses between its own surfaces can be checked.
#pragma once

#include "core/deform/body/body.h"
#include "core/deform/step/step_underway.h"

namespace hepatica {

struct MomentumBalance {
    double error_g_mm_per_s = 0.0;
    double exchanged_g_mm_per_s = 0.0;  // sum of the norms of all impulses that count
};

// For a step that ended with the velocities `after` and the elastic forces elastic_force_un.
MomentumBalance momentum_balance(const Body& body, const StepUnderway& step,
                                 std::span<const std::uint8_t> held, std::span<const Vec3> after,
                                 std::span<const Vec3> elastic_force_un);

}  // namespace hepatica
