// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/deform_back_end.h"

#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"

namespace hepatica {

DeformBackEnd cpu_back_end() {
    return {"cpu",
            [](const BodyDescription& body, const StepperOptions& options,
               const LiveRegionOptions& region) -> std::unique_ptr<Stepper> {
                if (body.tether_pa_per_mm2 > 0.0) return make_live_stepper(body, options, region);
                return make_cpu_stepper(body, options);
            }};
}

}  // namespace hepatica
