// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces device_machine.cu where this build has no CUDA.
#include "core/base/error.h"
#include "gpu/machine/device_machine.h"

namespace hepatica::gpu {

DeviceInfo device_info() {
    DeviceInfo info;
    info.reason = "this build has no CUDA";
    return info;
}

std::unique_ptr<Machine> make_device_machine() {
    throw InputError(device_info().reason, "the CUDA back end",
                     "Use the processor, or build with HEPATICA_CUDA=ON where nvcc is");
}

}  // namespace hepatica::gpu
