// SPDX-License-Identifier: GPL-3.0-or-later
// The reference back end: double precision on the CPU, deterministic for any number of threads.
#pragma once

#include <memory>

#include "core/deform/body/body.h"
#include "core/deform/stepper/step_back_end.h"

namespace hepatica {

class PotentialList;

// A StepBackEnd on the CPU, with what another back end for the same body needs from it.
class CpuBackEnd : public StepBackEnd {
  public:
    // The potentials of the body.
    virtual PotentialList& potentials() = 0;
    // Continues from the end of a step that the other back end made, and completes its report.
    virtual void follow(const BodyState& state, StepReport& report) = 0;
};

// Copies what it needs. Throws InputError where body or options are not valid (see build_body).
std::unique_ptr<CpuBackEnd> make_cpu_back_end(const BodyDescription& body,
                                              const StepperOptions& options);

}  // namespace hepatica
