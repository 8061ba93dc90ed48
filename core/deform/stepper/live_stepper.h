// SPDX-License-Identifier: GPL-3.0-or-later
// A stepper that computes only what the scene requires: the stretches of the tree near a tool and
// those that move (see live_region.h), with the frozen rest as their support.
#pragma once

#include <memory>

#include "core/deform/body/body.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_region.h"
#include "core/deform/stepper/stepper.h"

namespace hepatica {

class LiveStepper : public Stepper {
  public:
    // Elements and vertices that are computed at present, of how many.
    struct Extent {
        int live_elements = 0;
        int elements = 0;
        int live_vertices = 0;
        int vertices = 0;
    };
    virtual Extent extent() const = 0;
};

// As make_cpu_stepper. A body without skeleton gets one from its mesh. Energies in the report are
// those of the whole body; the little motion that freezing ends is booked as integrator_loss.
// Throws InputError as make_cpu_stepper does.
std::unique_ptr<LiveStepper> make_live_stepper(const BodyDescription& body,
                                               const StepperOptions& options,
                                               const LiveRegionOptions& region = {});

}  // namespace hepatica
