// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/deform_back_end.h"

#include <utility>

#include "core/deform/stepper/cpu_back_end.h"

namespace hepatica {

DeformBackEnd governed_back_end(std::string name, GovernedStepper::MakeBackEnd make) {
    return {std::move(name),
            [make = std::move(make)](const BodyDescription& body, const StepperOptions& options,
                                     const LiveRegionOptions& region) -> std::unique_ptr<Stepper> {
                const bool held = body.tether_pa_per_mm2 > 0.0;
                return std::make_unique<GovernedStepper>(
                    body, options, held ? std::optional(region) : std::nullopt, make);
            }};
}

DeformBackEnd device_back_end(std::string name, std::string device,
                              GovernedStepper::MakeBackEnd make) {
    DeformBackEnd back_end = governed_back_end(
        std::move(name),
        [make = std::move(make)](const BodyDescription& body,
                                 const StepperOptions& options) -> std::unique_ptr<StepBackEnd> {
            if (options.on_processor) return make_cpu_back_end(body, options);
            return make(body, options);
        });
    back_end.device = std::move(device);
    return back_end;
}

DeformBackEnd cpu_back_end() {
    return governed_back_end("cpu", make_cpu_back_end);
}

}  // namespace hepatica
