// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of a stepper's input, common to all back ends. They are called before anything is changed,
// so that bad input has no effect. Each throws InputError unless its argument is as described.
#pragma once

#include <span>

#include "core/base/vector.h"
#include "core/deform/potentials/tool.h"
#include "core/deform/stepper/stepper.h"

namespace hepatica {

// Iterations and substeps of 1 or more, tolerances finite and not negative, a finite velocity
// error.
void validate(const StepperOptions& options);

// Finite and greater than 0.
void validate_time_step(double dt_s);

// Finite.
void validate_gravity(const Vec3& gravity_mm_per_s2);

// Nodes that exist (the first vertex of each grab at least), finite weights of sum 1, a finite
// target, stiffness and force limit finite and greater than 0.
void validate_grabs(std::span<const Grab> grabs, std::size_t nodes);

// A finite tool of one part or more with a radius, pad, pressure and force limit greater than 0 and
// a friction of 0 or more, beside a body that may be touched.
void validate_tool(const Tool& tool, bool touchable);

// As many positions and velocities as expected, all finite.
void validate_state(std::span<const Vec3> positions_mm, std::span<const Vec3> velocities_mm_per_s,
                    std::size_t expected);

// State, grabs, gravity and tools of the checkpoint pass the checks above.
void validate_checkpoint(const StepperCheckpoint& checkpoint, std::size_t nodes, bool touchable);

}  // namespace hepatica
