// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a step made or lost momentum. Of a body that nothing holds but weight that is the change
// of its momentum less the impulse of its weight. Where it is held, what holds it takes up any
// momentum, and only what its surfaces do to each other can be judged: the sum of these impulses.
#pragma once

#include "core/deform/body/body.h"
#include "core/deform/step/step_underway.h"

namespace hepatica {

struct MomentumBalance {
    double error_g_mm_per_s = 0.0;
    double exchanged_g_mm_per_s = 0.0;  // sum of the sizes of all impulses on nodes that count
};

// Of a step that has ended at `after`, where the elements answer with elastic_force_un.
MomentumBalance momentum_balance(const Body& body, const StepUnderway& step,
                                 std::span<const std::uint8_t> held, std::span<const Vec3> after,
                                 std::span<const Vec3> elastic_force_un);

}  // namespace hepatica
