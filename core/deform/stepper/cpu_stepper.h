// SPDX-License-Identifier: GPL-3.0-or-later
// The reference stepper: double precision on the CPU, deterministic for any number of threads.
#pragma once

#include <memory>

#include "core/deform/body/body.h"
#include "core/deform/stepper/stepper.h"
#include "core/deform/stepper/stepper_options.h"

namespace hepatica {

// Copies what it needs. Throws InputError where body or options are not valid (see build_body).
// Gravity is 0 until set. For quadratic bodies, positions_mm() has the mesh vertices only.
std::unique_ptr<Stepper> make_cpu_stepper(const BodyDescription& body,
                                          const StepperOptions& options);

}  // namespace hepatica
