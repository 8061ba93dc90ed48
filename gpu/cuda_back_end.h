// SPDX-License-Identifier: GPL-3.0-or-later
// The GPU's back end. It makes the steps that its kernels know; behind it stands the CPU's, which
// keeps everything else (what is searched, checkpoints, the repair of inverted elements) and makes
// the steps that the GPU leaves: those that would make energy if taken whole, and those with
// something that has no kernels yet. So nothing is left out, only slower; why, is said in words.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/deform/stepper/step_back_end.h"
#include "gpu/machine/machine.h"
#include "gpu/step/device_step.h"

namespace hepatica::gpu {

// How many steps either has made.
struct StepShare {
    long device = 0;
    long processor = 0;
    SolveCost solves{};  // of the device's steps, added up
};

struct CudaOptions {
    Precision precision = Precision::single_precision;
    std::shared_ptr<StepShare> share = std::make_shared<StepShare>();
    // Told why steps are made by the processor, each reason once.
    std::function<void(const std::string&)> say = [](const std::string&) {};
};

// Why steps of such a body are made by the processor throughout; none where they are not.
std::optional<std::string> why_not_on_device(const Body& body, const StepperOptions& options);

// As make_cpu_back_end. The machine is shared with other back ends of the same thread. Where the
// device fails, the body goes on from its last step on the processor.
std::unique_ptr<StepBackEnd> make_cuda_back_end(const BodyDescription& body,
                                                const StepperOptions& options,
                                                std::shared_ptr<Machine> machine,
                                                const CudaOptions& cuda = {});

}  // namespace hepatica::gpu
