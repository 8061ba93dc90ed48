// SPDX-License-Identifier: GPL-3.0-or-later
// Which back end computes the body: the processor, a CUDA device, or the device's kernels emulated
// on the processor (for tests and for counting what a device would do; slow).
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

// Takes "cpu", "cuda", "cuda-emulated" or "auto": the device where there is one, and on the dial
// settings of the processor beside those of the device. Why steps are made by the processor is
// said, each reason once. Throws InputError where "cuda" finds no device, and for any other name.
BackEndChoice choose_back_end(const std::string& name, const SayOfBackEnd& say = warn_of_back_end);

// What was chosen and who made the steps: {name, device, steps_on_device, steps_on_processor,
// device_bytes}; null where the processor was chosen.
nlohmann::ordered_json facts_of(const BackEndChoice& choice);

}  // namespace hepatica
