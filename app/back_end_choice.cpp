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

// Reports each message once: each change of the setting makes a new back end, which would repeat
// it.
SayOfBackEnd once(const SayOfBackEnd& say) {
    return [say, said = std::make_shared<std::set<std::string>>()](const std::string& what) {
        if (said->insert(what).second) say(what);
    };
}

BackEndChoice on_machine(std::string name, std::unique_ptr<gpu::Machine> machine,
                         const SayOfBackEnd& say) {
    BackEndChoice choice;
    choice.machine = std::move(machine);
    gpu::CudaOptions cuda;
    cuda.share = choice.share;
    cuda.say = once(say);
    choice.back_end =
        device_back_end(std::move(name), choice.machine->name(),
                        [machine = choice.machine, cuda](const BodyDescription& body,
                                                         const StepperOptions& options) {
                            return gpu::make_cuda_back_end(body, options, machine, cuda);
                        });
    return choice;
}

}  // namespace

const std::vector<std::string>& back_end_names() {
    static const std::vector<std::string> names{"cpu", "cuda", "cuda-emulated", "auto"};
    return names;
}

void warn_of_back_end(const std::string& what) {
    spdlog::warn("{}", what);
}

BackEndChoice choose_back_end(const std::string& name, const SayOfBackEnd& say) {
    if (name == "cpu") return {};
    if (name == "cuda") return on_machine(name, gpu::make_device_machine(), say);
    if (name == "cuda-emulated") return on_machine(name, gpu::make_emulator(), say);
    if (name != "auto")
        throw InputError("there is no back end \"" + name + "\"", "--backend",
                         "Choose cpu, cuda, cuda-emulated or auto");
    const std::string reason = gpu::device_info().reason;
    if (!reason.empty()) {
        say("The processor makes the steps: " + reason);
        return {};
    }
    BackEndChoice device = on_machine("cuda", gpu::make_device_machine(), say);
    device.back_end.beside_processor = true;
    return device;
}

DeformBackEnd back_end_named(const std::string& name, const SayOfBackEnd& say) {
    return choose_back_end(name, say).back_end;
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
