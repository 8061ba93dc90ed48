// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of the input of a step. They are called before anything is changed, so that bad input has
// no effect. Each throws InputError unless its argument is as described.
#pragma once

#include <cstddef>
#include <span>

#include "core/base/vector.h"

namespace hepatica {

// Must be finite and greater than 0.
void validate_time_step(double dt_s);

// There must be `expected` positions and velocities, all finite.
void validate_state(std::span<const Vec3> positions_mm, std::span<const Vec3> velocities_mm_per_s,
                    std::size_t expected);

}  // namespace hepatica
