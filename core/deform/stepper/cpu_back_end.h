// SPDX-License-Identifier: GPL-3.0-or-later
// The reference back end: double precision on the CPU, deterministic for any number of threads.
#pragma once

#include <memory>

#include "core/deform/body/body.h"
#include "core/deform/stepper/step_back_end.h"

namespace hepatica {

// Copies what it needs. Throws InputError where body or options are not valid (see build_body).
std::unique_ptr<StepBackEnd> make_cpu_back_end(const BodyDescription& body,
                                               const StepperOptions& options);

}  // namespace hepatica
