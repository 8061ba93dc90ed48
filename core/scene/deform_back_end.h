// SPDX-License-Identifier: GPL-3.0-or-later
// Which program computes the body that deforms: a name for recordings and measurements, and a way
// to make its stepper.
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
    std::string device{};  // that makes the steps, by its own name; empty: the processor makes them
    // On a device: the dial offers settings of the processor beside the device's.
    bool beside_processor = false;
};

// Steps by `make`, governed alike for all. Where tissue holds the vessels only the stretches near
// the hand and those that move are computed.
DeformBackEnd governed_back_end(std::string name, GovernedStepper::MakeBackEnd make);

// The same on a device of that name; steps whose options want the processor are made there.
DeformBackEnd device_back_end(std::string name, std::string device,
                              GovernedStepper::MakeBackEnd make);

// The reference: on the processor, in double precision.
DeformBackEnd cpu_back_end();

}  // namespace hepatica
