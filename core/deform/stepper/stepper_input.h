// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of a stepper's input, common to all back ends. They are called before anything is changed,
// so that bad input has no effect. Each throws InputError unless its argument is as described.
#pragma once

#include <cstddef>

#include "core/deform/stepper/stepper_checkpoint.h"

namespace hepatica {

// Iterations and substeps must be at least 1, tolerances finite and not negative (Newton's greater
// than 0), the velocity error finite.
void validate(const StepperOptions& options);

// State, grabs, gravity and tools of the checkpoint must pass the checks of step_input.h and
// load_input.h.
void validate_checkpoint(const StepperCheckpoint& checkpoint, std::size_t nodes, bool touchable);

}  // namespace hepatica
