// SPDX-License-Identifier: GPL-3.0-or-later
// The GPU's back end. It makes the steps that its kernels support. A CPU back end behind it does
// everything else (contact search, checkpoints, the repair of inverted elements) and makes the
// steps that the GPU rejects: those whose full Newton direction would increase the energy, and
// those with features that have no kernels yet. Every step is made, some more slowly; the reason is
// reported in words.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/deform/stepper/step_back_end.h"
#include "gpu/machine/machine.h"
#include "gpu/step/device_step.h"

namespace hepatica::gpu {

// Number of steps that the device and the processor made.
struct StepShare {
    long device = 0;
    long processor = 0;
    SolveCost solves{};  // sum over the device's steps
};

struct CudaOptions {
    Precision precision = Precision::single_precision;
    std::shared_ptr<StepShare> share = std::make_shared<StepShare>();
    // Called with the reason why the processor makes steps, or with what the device's steps leave
    // out, once each.
    std::function<void(const std::string&)> say = [](const std::string&) {};
};

// The reason why the processor makes all steps of such a body; none where the device makes them.
std::optional<std::string> why_not_on_device(const Body& body, const StepperOptions& options);

// As make_cpu_back_end(). The machine may be shared with other back ends of the same thread. If the
// device fails, the body continues from its last step on the processor.
std::unique_ptr<StepBackEnd> make_cuda_back_end(const BodyDescription& body,
                                                const StepperOptions& options,
                                                std::shared_ptr<Machine> machine,
                                                const CudaOptions& cuda = {});

}  // namespace hepatica::gpu
