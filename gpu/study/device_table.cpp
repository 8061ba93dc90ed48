// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/study/device_table.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"

namespace hepatica::gpu {

// Links: of their 16, 32 and 64 GB/s, PCIe 3, 4 and 5 with 16 lanes reach about 12, 25 and 50.
std::span<const PlannedDevice> planned_devices() {
    static const std::array<PlannedDevice, 5> devices{{
        {"T4", 320e9, 12e9, "NVIDIA T4 data sheet: 320 GB/s, PCIe 3"},
        {"RTX 4090", 1008e9, 25e9, "NVIDIA Ada architecture paper: 1008 GB/s, PCIe 4"},
        {"A100", 2039e9, 25e9, "NVIDIA A100 80 GB SXM data sheet: 2039 GB/s, PCIe 4"},
        {"H100", 3350e9, 50e9, "NVIDIA H100 SXM data sheet: 3.35 TB/s, PCIe 5"},
        {"H200", 4800e9, 50e9, "NVIDIA H200 data sheet: 4.8 TB/s, PCIe 5"},
    }};
    return devices;
}

const PlannedDevice& planned_device(const std::string& name) {
    const auto devices = planned_devices();
    const auto found = std::ranges::find(devices, name, &PlannedDevice::name);
    if (found != devices.end()) return *found;
    std::string names;
    for (const PlannedDevice& device : devices) names += (names.empty() ? "" : ", ") + device.name;
    throw InputError("there are no figures for \"" + name + "\"", "the device of a plan",
                     "Choose one of " + names);
}

double planned_seconds(const Traffic& traffic, const PlannedDevice& device) {
    return static_cast<double>(traffic.launches) * launch_s +
           static_cast<double>(traffic.barriers) * barrier_s +
           static_cast<double>(traffic.copies) * copy_s +
           static_cast<double>(traffic.kernel_bytes) / device.bytes_per_s +
           static_cast<double>(traffic.copied_bytes) / device.link_bytes_per_s;
}

}  // namespace hepatica::gpu
