// SPDX-License-Identifier: GPL-3.0-or-later
// The CUDA device of this computer, where there is one and this build supports CUDA.
#pragma once

#include <memory>
#include <string>

#include "gpu/machine/machine.h"

namespace hepatica::gpu {

struct DeviceInfo {
    bool compiled = false;      // this build supports CUDA
    std::string architectures;  // it was compiled for, such as "75;80;90"
    std::string device;         // name; empty: no usable device
    std::string driver;         // CUDA version of the driver; empty: no driver
    std::size_t memory_bytes = 0;
    std::string reason;  // why no device can be used, in words; otherwise empty
};

// The first call initialises the driver; later calls are cheap.
DeviceInfo device_info();

// Throws InputError with DeviceInfo::reason where no device can be used, and DeviceError where it
// fails.
std::unique_ptr<Machine> make_device_machine();

}  // namespace hepatica::gpu
