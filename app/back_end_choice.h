// SPDX-License-Identifier: GPL-3.0-or-later
// Selects the back end that computes the body: the processor, a CUDA device, or the device's
// kernels emulated on the processor (slow; for tests and for counting a device's work).
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/back_end_names.h"
#include "core/scene/deform_back_end.h"
#include "gpu/cuda_back_end.h"

namespace hepatica {

struct BackEndChoice {
    DeformBackEnd back_end = cpu_back_end();
    // Null for the processor.
    std::shared_ptr<gpu::Machine> machine;
    std::shared_ptr<gpu::StepShare> share = std::make_shared<gpu::StepShare>();
};

// `name` is "cpu", "cuda", "cuda-emulated" or "auto". "auto" takes the device where there is one,
// and then offers the dial's settings of the processor beside those of the device. `say` receives
// the reason when the processor makes steps, each reason once. Throws InputError where "cuda" finds
// no device, and for any other name.
BackEndChoice choose_back_end(const std::string& name, const SayOfBackEnd& say = warn_of_back_end);

// The choice and the numbers of steps: {name, device, steps_on_device, steps_on_processor,
// device_bytes}; null for the processor.
nlohmann::ordered_json facts_of(const BackEndChoice& choice);

}  // namespace hepatica
