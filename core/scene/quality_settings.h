// SPDX-License-Identifier: GPL-3.0-or-later
// The quality dial as the scene knows it: one number for the user, settings for the stepper.
#pragma once

#include "core/deform/cpu_stepper.h"

namespace hepatica {

// quality in [0, 1]: 0 fastest, 1 most accurate; steps in between, so that a small turn of the dial
// changes the solver's settings or nothing. Throws InputError outside the range.
StepperOptions stepper_options(double quality);

}  // namespace hepatica
