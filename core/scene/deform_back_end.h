// SPDX-License-Identifier: GPL-3.0-or-later
// Which back end computes the deforming body: its name in recordings and measurements, and a
// function that makes its stepper.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/deform/stepper/governed_stepper.h"
#include "core/deform/stepper/live_region.h"
#include "core/deform/stepper/stepper.h"

namespace hepatica {

struct DeformBackEnd {
    std::string name;
    // Throws InputError where body or options are not valid.
    std::function<std::unique_ptr<Stepper>(const BodyDescription&, const StepperOptions&,
                                           const LiveRegionOptions&)>
        make;
    std::string device{};  // name of the device that makes the steps; empty: the processor
    // With a device: the dial also offers the processor's settings.
    bool beside_processor = false;
};

// A GovernedStepper over `make`. Where tissue holds the vessels, only the parts near the hand and
// those that move are computed.
DeformBackEnd governed_back_end(std::string name, GovernedStepper::MakeBackEnd make);

// The same on the named device; steps with options.on_processor are made on the processor.
DeformBackEnd device_back_end(std::string name, std::string device,
                              GovernedStepper::MakeBackEnd make);

// The reference: on the processor, in double precision.
DeformBackEnd cpu_back_end();

}  // namespace hepatica
