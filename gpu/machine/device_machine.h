// SPDX-License-Identifier: GPL-3.0-or-later
// The CUDA device of this computer, where there is one and this build knows CUDA.
#pragma once

#include <memory>
#include <string>

#include "gpu/machine/machine.h"

namespace hepatica::gpu {

struct DeviceInfo {
    bool compiled = false;      // this build knows CUDA
    std::string architectures;  // that it was compiled for, such as "75;80;90"
    std::string device;         // name; empty: none that can be used
    std::string driver;         // version of CUDA that the driver knows; empty: none
    std::size_t memory_bytes = 0;
    std::string reason;  // why no device can be used, in words; empty where one can
};

// Costs the start of the driver the first time it is called.
DeviceInfo device_info();

// Throws InputError with that reason where no device can be used.
std::unique_ptr<Machine> make_device_machine();

}  // namespace hepatica::gpu
