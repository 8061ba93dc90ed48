// SPDX-License-Identifier: GPL-3.0-or-later
// The quality dial as the scene knows it: one number for the user, settings for the stepper, with
// the cost and the error that were measured for them.
#pragma once

#include "core/deform/cpu_stepper.h"
#include "core/deform/quality_dial.h"

namespace hepatica {

// quality in [0, 1]: 0 fastest, 1 most accurate; steps in between along the measured front. The
// error is that of the motion of a clamped beam, not of this body; frame_ms is that of the beam.
// Throws InputError outside the range. The reference stays valid. Thread-safe.
const QualityPoint& quality_point(double quality);
inline StepperOptions stepper_options(double quality) {
    return quality_point(quality).options;
}

}  // namespace hepatica
