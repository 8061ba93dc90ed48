// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of external loads on a body. They are called before anything is changed, so that bad input
// has no effect. Each throws InputError unless its argument is as described.
#pragma once

#include <cstddef>
#include <span>

#include "core/base/vector.h"
#include "core/deform/potentials/grab.h"
#include "core/deform/potentials/tool.h"

namespace hepatica {

// Gravity must be finite.
void validate_gravity(const Vec3& gravity_mm_per_s2);

// Existing vertices (negative ones are unused, except the first), finite weights of sum 1, a finite
// target, stiffness and force limit finite and greater than 0.
void validate_grabs(std::span<const Grab> grabs, std::size_t nodes);

// The tool must be finite, have at least one part, radius, pad, pressure and force limit greater
// than 0 and a friction of 0 or more; the body must be touchable.
void validate_tool(const Tool& tool, bool touchable);

}  // namespace hepatica
