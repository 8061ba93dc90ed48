// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/back_end_choice.h"

#include <spdlog/spdlog.h>

#include <set>
#include <utility>

#include "core/base/error.h"
#include "gpu/machine/device_machine.h"
#include "gpu/machine/emulator.h"

namespace hepatica {
namespace {

// Warns once in the same words: each change of the setting makes a new back end, which warns again.
std::function<void(const std::string&)> warn_once() {
    return [said = std::make_shared<std::set<std::string>>()](const std::string& what) {
        if (said->insert(what).second) spdlog::warn("{}", what);
    };
}

BackEndChoice on_machine(std::string name, std::unique_ptr<gpu::Machine> machine) {
    BackEndChoice choice;
    choice.machine = std::move(machine);
    gpu::CudaOptions cuda;
    cuda.share = choice.share;
    cuda.say = warn_once();
    choice.back_end = governed_back_end(
        std::move(name), [machine = choice.machine, cuda](const BodyDescription& body,
                                                          const StepperOptions& options) {
            return gpu::make_cuda_back_end(body, options, machine, cuda);
        });
    return choice;
}

}  // namespace

BackEndChoice choose_back_end(const std::string& name) {
    if (name == "cpu") return {};
    if (name == "cuda") return on_machine(name, gpu::make_device_machine());
    if (name == "cuda-emulated") return on_machine(name, gpu::make_emulator());
    if (name != "auto")
        throw InputError("there is no back end \"" + name + "\"", "--backend",
                         "Choose cpu, cuda, cuda-emulated or auto");
    const std::string reason = gpu::device_info().reason;
    if (reason.empty()) return on_machine("cuda", gpu::make_device_machine());
    spdlog::warn("The processor makes the steps: {}", reason);
    return {};
}

nlohmann::ordered_json facts_of(const BackEndChoice& choice) {
    if (!choice.machine) return nullptr;
    return {{"name", choice.back_end.name},
            {"device", choice.machine->name()},
            {"steps_on_device", choice.share->device},
            {"steps_on_processor", choice.share->processor},
            {"device_bytes", choice.machine->held_bytes()}};
}

}  // namespace hepatica
