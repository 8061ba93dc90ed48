// SPDX-License-Identifier: GPL-3.0-or-later
// A stepper that computes only the live part of the tree (see live_region.h); the frozen rest acts
// as a fixed boundary.
#pragma once

#include <memory>

#include "core/deform/body/body.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_region.h"
#include "core/deform/stepper/stepper.h"

namespace hepatica {

class LiveStepper : public Stepper {
  public:
    // How many elements and vertices are computed now, and how many there are.
    struct Extent {
        int live_elements = 0;
        int elements = 0;
        int live_vertices = 0;
        int vertices = 0;
    };
    virtual Extent extent() const = 0;
};

// Like make_cpu_stepper. A body without a skeleton gets one from its mesh. The report has the
// energies of the whole body; the kinetic energy of nodes that freeze is booked as integrator_loss.
// Throws InputError as make_cpu_stepper does.
std::unique_ptr<LiveStepper> make_live_stepper(const BodyDescription& body,
                                               const StepperOptions& options,
                                               const LiveRegionOptions& region = {});

}  // namespace hepatica
